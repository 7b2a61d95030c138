#include "engine/reference/level.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>

#include "engine/reference/edge_mender.h"

namespace oblong::reference {

namespace {

// Lumps by their index in the header, as far as pictures need them.
enum Lump { kPlanes = 1, kTextures = 2, kVertices = 3, kTexInfos = 6, kFaces = 7, kLighting = 8, kEdges = 12 };
enum MoreLumps { kSurfEdges = 13, kModels = 14 };

constexpr std::uint32_t kWideVersions[] = {'B' | 'S' << 8 | 'P' << 16 | '2' << 24,
                                           '2' | 'P' << 8 | 'S' << 16 | 'B' << 24};

[[noreturn]] void fail(const std::string& where, const std::string& what) {
    throw std::runtime_error(where + ": " + what);
}

/// Little-endian numbers, one after the other.
class Reader {
  public:
    Reader(std::span<const std::uint8_t> bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    std::span<const std::uint8_t> bytes(std::int64_t count) {
        if (count < 0 || count > left()) fail(name_, "needs " + std::to_string(count) + " bytes more than it has left");
        at_ += static_cast<std::size_t>(count);
        return bytes_.subspan(at_ - static_cast<std::size_t>(count), static_cast<std::size_t>(count));
    }
    std::uint32_t number(int size) {
        std::uint32_t value = 0;
        const auto from = bytes(size);
        for (int i = size; i-- > 0;) value = value << 8 | from[static_cast<std::size_t>(i)];
        return value;
    }
    int i32() { return static_cast<int>(number(4)); }
    double real() {
        const std::uint32_t bits = number(4);
        float value = 0;
        static_assert(sizeof value == sizeof bits);
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) fail(name_, "a number that is not finite");
        return value;
    }
    Vec vec() {
        const double x = real(), y = real(), z = real();
        return {x, y, z};
    }
    int index(int value, std::size_t count, const char* what) const {
        if (value < 0 || static_cast<std::size_t>(value) >= count)
            fail(name_, std::string(what) + " " + std::to_string(value) + ", expected one of " + std::to_string(count));
        return value;
    }
    void seek(std::int64_t place) {
        at_ = 0;
        bytes(place);
    }
    std::int64_t left() const { return static_cast<std::int64_t>(bytes_.size() - at_); }

  private:
    std::span<const std::uint8_t> bytes_;
    std::string name_;
    std::size_t at_ = 0;
};

struct File {
    std::span<const std::uint8_t> bytes;
    bool is_wide = false;

    int index_size() const { return is_wide ? 4 : 2; }
    Reader lump(int number, const char* name) const {
        Reader header(bytes, "header");
        header.seek(4 + number * 8);
        const int offset = header.i32(), size = header.i32();
        Reader whole(bytes, std::string("lump '") + name + "'");
        whole.seek(offset);
        return {whole.bytes(size), std::string("lump '") + name + "'"};
    }
};

template <class Read>
auto read_all(Reader in, Read read) {
    std::vector<decltype(read(in))> records;
    while (in.left() > 0) records.push_back(read(in));
    return records;
}

File open_file(std::span<const std::uint8_t> bytes) {
    const std::uint32_t version = Reader(bytes, "header").number(4);
    const bool is_wide = std::count(std::begin(kWideVersions), std::end(kWideVersions), version) > 0;
    if (version != 29 && !is_wide) fail("header", "version " + std::to_string(version) + ", expected 29, BSP2 or 2PSB");
    return {bytes, is_wide};
}

/// Squares of an eighth of its 64 texels: the engine's replacement for a texture that the file lacks, or that has
/// another size than the engine draws.
Texture make_checkerboard(std::string name) {
    Texture texture{std::move(name), 64, 64, {}};
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column) texture.texels.push_back((row / 8 + column / 8) % 2 == 0 ? 15 : 0);
    return texture;
}

Texture read_texture(Reader& in, std::int64_t start) {
    in.seek(start);
    const auto letters = in.bytes(16);
    Texture texture{{letters.begin(), std::find(letters.begin(), letters.end(), 0)}, in.i32(), in.i32(), {}};
    std::array<int, 4> mips{};
    for (int& mip : mips) mip = in.i32();
    const auto is_drawn = [](int size) { return size > 0 && size <= 1 << 14 && size % 16 == 0; };
    if (mips == std::array<int, 4>{} || !is_drawn(texture.width) || !is_drawn(texture.height))
        return make_checkerboard(texture.name);
    in.seek(start + mips[0]);
    const auto texels = in.bytes(std::int64_t{texture.width} * texture.height);
    texture.texels.assign(texels.begin(), texels.end());
    return texture;
}

std::vector<Texture> read_textures(const File& file) {
    Reader in = file.lump(kTextures, "textures");
    std::vector<Texture> textures;
    if (in.left() == 0) return textures;
    const int count = in.i32();
    for (int i = 0; i < count; ++i) {
        in.seek(4 + std::int64_t{i} * 4);
        const int start = in.i32();
        textures.push_back(start == -1 ? make_checkerboard("") : read_texture(in, start));
    }
    return textures;
}

TexInfo read_texinfo(Reader& in, std::size_t texture_count) {
    TexInfo texinfo;
    texinfo.s = in.vec();
    texinfo.s_offset = in.real();
    texinfo.t = in.vec();
    texinfo.t_offset = in.real();
    texinfo.texture = in.index(in.i32(), texture_count, "texture");
    texinfo.is_special = (in.number(4) & 1) != 0;
    return texinfo;
}

/// The parts of faces in the file.
struct Parts {
    std::vector<Plane> planes;
    std::vector<std::array<int, 2>> edges;
    std::vector<int> surf_edges;  ///< an edge, or its negative if it runs from its end
};

Parts read_parts(const File& file, std::size_t vertex_count) {
    Parts parts;
    parts.planes = read_all(file.lump(kPlanes, "planes"), [](Reader& in) {
        const Plane plane{in.vec(), in.real()};
        in.bytes(4);
        return plane;
    });
    parts.edges = read_all(file.lump(kEdges, "edges"), [&](Reader& in) {
        const auto end = [&] {
            return in.index(static_cast<int>(in.number(file.index_size())), vertex_count, "vertex");
        };
        const int from = end();
        return std::array{from, end()};
    });
    parts.surf_edges = read_all(file.lump(kSurfEdges, "surfedges"), [&](Reader& in) {
        const int edge = in.i32();
        in.index(edge == std::numeric_limits<int>::min() ? -1 : std::abs(edge), parts.edges.size(), "edge");
        return edge;
    });
    return parts;
}

Material material_of(const Level& level, const Face& face) {
    const std::string& name = level.texture_of(face).name;
    if (name.starts_with("sky")) return Material::Sky;
    if (name.starts_with('*')) return Material::Liquid;
    return level.texinfo_of(face).is_special ? Material::Unlit : Material::Lit;
}

/// Flagged faces of which one has light are lit.
void light_special_faces(Level& level) {
    std::set<int> lit;
    for (const Face& face : level.faces)
        if (face.light_offset >= 0) lit.insert(face.texinfo);
    for (Face& face : level.faces)
        if (face.material == Material::Unlit && lit.contains(face.texinfo)) face.material = Material::Lit;
}

Face read_face(Reader& in, const File& file, const Parts& parts, const Level& level) {
    const int size = file.index_size();
    const auto index = [&](std::size_t count, const char* what) {
        return in.index(static_cast<int>(in.number(size)), count, what);
    };
    Face face;
    face.plane = parts.planes[static_cast<std::size_t>(index(parts.planes.size(), "plane"))];
    if (in.number(size) != 0) face.plane = {face.plane.normal * -1, -face.plane.offset};
    const int first = in.i32(), count = static_cast<int>(in.number(size));
    for (std::int64_t i = first; i < std::int64_t{first} + count; ++i) {
        const int step = parts.surf_edges[static_cast<std::size_t>(
            in.index(static_cast<int>(i), parts.surf_edges.size(), "surfedge"))];
        const auto& edge = parts.edges[static_cast<std::size_t>(std::abs(step))];
        face.corners.push_back(step < 0 ? edge[1] : edge[0]);
    }
    face.texinfo = index(level.texinfos.size(), "texinfo");
    for (std::uint8_t& style : face.styles) style = static_cast<std::uint8_t>(in.number(1));
    face.light_offset = in.i32();
    face.material = material_of(level, face);
    return face;
}

/// Texel coordinates of all corners, in cells of 16 texels: the first cell and one past the last. Rounded to floats
/// first, as the light compilers do, which decides the number of samples for a face that ends on a cell's border.
std::array<int, 2> cells_along(const Level& level, const Face& face, const Vec& axis, double offset) {
    double least = std::numeric_limits<double>::max(), most = -least;
    for (const int corner : face.corners) {
        const double texel = static_cast<float>(dot(level.vertex(corner), axis) + offset);
        least = std::min(least, texel);
        most = std::max(most, texel);
    }
    if (!(std::max(std::abs(least), std::abs(most)) < 1 << 30))
        fail("lump 'faces'", "a texture coordinate beyond 2^30");
    return {static_cast<int>(std::floor(least / 16)), static_cast<int>(std::ceil(most / 16))};
}

void place_light(const Level& level, Face& face) {
    const TexInfo& texinfo = level.texinfo_of(face);
    const auto u = cells_along(level, face, texinfo.s, texinfo.s_offset);
    const auto v = cells_along(level, face, texinfo.t, texinfo.t_offset);
    face.first_u = u[0] * 16;
    face.first_v = v[0] * 16;
    face.light_columns = u[1] - u[0] + 1;
    face.light_rows = v[1] - v[0] + 1;
    if (face.material != Material::Lit || level.lighting.empty()) face.light_offset = -1;
    const std::int64_t size = std::int64_t{face.light_columns} * face.light_rows * face.style_count();
    if (face.light_offset >= 0 && face.light_offset + size > static_cast<std::int64_t>(level.lighting.size()))
        fail("lump 'faces'", "light samples beyond the lump 'lighting'");
}

void mend(Level& level) {
    std::vector<int> used;
    for (const Face& face : level.faces) used.insert(used.end(), face.corners.begin(), face.corners.end());
    const EdgeMender mender(level.vertices, used);
    for (Face& face : level.faces) face.corners = mender.mended(face.corners);
}

Model read_model(Reader& in, std::size_t face_count) {
    Model model;
    model.mins = in.vec();
    model.maxs = in.vec();
    in.bytes(3 * 4 + 4 * 4 + 4);  // origin, trees, visible leaves
    model.first_face = in.i32();
    model.face_count = in.i32();
    if (model.face_count > 0) {
        in.index(model.first_face, face_count, "face");
        in.index(model.face_count - 1, face_count - static_cast<std::size_t>(model.first_face), "face");
    }
    return model;
}

/// Three numbers a sample, of the lump RGBLIGHTING behind all others; nothing without it.
std::vector<std::uint8_t> read_colours(std::span<const std::uint8_t> bytes, std::size_t samples) {
    constexpr char kList[] = "BSPX", kName[] = "RGBLIGHTING";
    const auto list = std::search(bytes.begin(), bytes.end(), kList, kList + 4);
    const auto name = std::search(list, bytes.end(), kName, kName + sizeof kName);
    if (name == bytes.end()) return {};
    Reader whole(bytes, "lump 'RGBLIGHTING'");
    whole.seek(name - bytes.begin() + 24);
    const int offset = whole.i32(), size = whole.i32();
    if (size != 3 * static_cast<std::int64_t>(samples)) return {};
    whole.seek(offset);
    const auto colours = whole.bytes(size);
    return {colours.begin(), colours.end()};
}

}  // namespace

int Face::style_count() const {
    return static_cast<int>(std::find(styles.begin(), styles.end(), 255) - styles.begin());
}

Level read_level(std::span<const std::uint8_t> bytes) {
    const File file = open_file(bytes);
    Level level;
    level.vertices = read_all(file.lump(kVertices, "vertices"), [](Reader& in) { return in.vec(); });
    level.textures = read_textures(file);
    level.texinfos =
        read_all(file.lump(kTexInfos, "texinfos"), [&](Reader& in) { return read_texinfo(in, level.textures.size()); });
    level.lighting =
        read_all(file.lump(kLighting, "lighting"), [](Reader& in) { return static_cast<std::uint8_t>(in.number(1)); });
    level.coloured_lighting = read_colours(bytes, level.lighting.size());
    const Parts parts = read_parts(file, level.vertices.size());
    level.faces = read_all(file.lump(kFaces, "faces"), [&](Reader& in) { return read_face(in, file, parts, level); });
    light_special_faces(level);
    for (Face& face : level.faces) place_light(level, face);
    level.models =
        read_all(file.lump(kModels, "models"), [&](Reader& in) { return read_model(in, level.faces.size()); });
    mend(level);
    return level;
}

}  // namespace oblong::reference
