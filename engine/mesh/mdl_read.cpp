#include <algorithm>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/level/bsp_floats.h"
#include "engine/mesh/mesh.h"

namespace oblong {

namespace {

constexpr std::int32_t kMostSkins = 1024, kLargestSkinSide = 4096, kMostMdlFrames = 65536;
constexpr std::int32_t kLongestGroup_s = 3600;
constexpr int kMdlBits = 32;  ///< fraction bits of coordinates before rounding
constexpr std::size_t kMdlNameSize = 16;
constexpr std::uint32_t kTurningFlag = 8;

/// Reads little-endian numbers in sequence. Throws InputError at the end of the file.
class MdlBytes {
  public:
    explicit MdlBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    /// Names the part of the file that follows, for messages: "frame 3".
    void begin_part(const std::string& part) { part_ = part; }

    std::span<const std::uint8_t> read_bytes(std::size_t size) {
        field_ = position_;
        if (size > left())
            fail(std::to_string(size) + " bytes needed, expected them in the " + std::to_string(left()) +
                 " left in the file");
        position_ += size;
        return bytes_.subspan(field_, size);
    }
    std::uint32_t read_u32() { return little_endian_u32(read_bytes(4).data()); }
    std::int32_t read_i32() { return static_cast<std::int32_t>(read_u32()); }

    std::int32_t read_number(const char* what, std::int32_t least, std::int32_t most) {
        const std::int32_t number = read_i32();
        if (number < least || number > most)
            fail(std::string(what) + " " + std::to_string(number) + ", expected " + bounds_text(least, most));
        return number;
    }
    std::int64_t read_fixed(const char* what, int fraction_bits, std::int32_t limit) {
        const FloatBits value{read_u32()};
        if (const auto fixed = to_fixed(value, fraction_bits, limit)) return *fixed;
        fail(std::string(what) + " " + describe(value) + ", expected between -" + std::to_string(limit) + " and " +
             std::to_string(limit));
    }
    std::string read_name(std::size_t size) {
        const auto bytes = read_bytes(size);
        const std::string name(bytes.begin(), bytes.end());
        return name.substr(0, name.find('\0'));
    }

    /// Throws unless this many records of this size are left; called before memory is allocated for them.
    void expect_records(std::int32_t count, std::size_t size, const char* what) {
        if (as_size(count) <= left() / size) return;
        field_ = position_;
        fail(std::to_string(count) + " " + what + " of " + std::to_string(size) +
             " bytes or more, expected them in the " + std::to_string(left()) + " bytes left in the file");
    }

    [[noreturn]] void fail(const std::string& what_is_wrong) const {
        throw InputError(part_ + ", offset " + std::to_string(field_), what_is_wrong);
    }

  private:
    std::size_t left() const { return bytes_.size() - position_; }

    std::span<const std::uint8_t> bytes_;
    std::size_t position_ = 0, field_ = 0;
    std::string part_ = "header";
};

struct MdlHeader {
    std::array<std::int64_t, 3> scale{}, origin{};  ///< of kMdlBits
    std::int32_t skins = 0, skin_width = 0, skin_height = 0, vertices = 0, triangles = 0, frames = 0;
    bool turns = false;
};

struct SkinPlace {
    bool is_on_seam = false;
    std::int32_t u = 0, v = 0;
};

MdlHeader read_mdl_header(MdlBytes& in) {
    if (in.read_name(4) != "IDPO") in.fail("no model of Quake, expected \"IDPO\"");
    in.read_number("version", 6, 6);
    MdlHeader header;
    for (std::int64_t& part : header.scale) part = in.read_fixed("scale", kMdlBits, kMeshLimit);
    for (std::int64_t& part : header.origin) part = in.read_fixed("origin", kMdlBits, kMeshLimit);
    in.read_bytes(4 * 4);  // the radius around the origin, the place of the eyes
    header.skins = in.read_number("skins", 1, kMostSkins);
    header.skin_width = in.read_number("skin width", 1, kLargestSkinSide);
    header.skin_height = in.read_number("skin height", 1, kLargestSkinSide);
    header.vertices = in.read_number("vertices", 1, static_cast<std::int32_t>(kMostMeshVertices));
    header.triangles = in.read_number("triangles", 1, static_cast<std::int32_t>(kMostMeshTriangles));
    header.frames = in.read_number("frames", 1, kMostMdlFrames);
    in.read_bytes(4);  // whether models of a kind move together
    header.turns = (in.read_u32() & kTurningFlag) != 0;
    in.read_bytes(4);  // a size for level of detail
    return header;
}

/// Reads one model, part by part in the file's order.
class MdlReader {
  public:
    MdlReader(std::span<const std::uint8_t> bytes, World scale)
        : in_(bytes), scale_(scale), header_(read_mdl_header(in_)) {}

    Mesh read() {
        mesh_.turns = header_.turns;
        read_skins();
        read_skin_places();
        read_triangles();
        for (std::int32_t i = 0; i < header_.frames; ++i) read_frame_or_group("frame " + std::to_string(i));
        return std::move(mesh_);
    }

  private:
    void read_skins() {
        for (std::int32_t i = 0; i < header_.skins; ++i) {
            in_.begin_part("skin " + std::to_string(i));
            const bool is_group = in_.read_number("type", 0, 1) == 1;
            MeshSequence sequence{static_cast<std::uint32_t>(mesh_.skins.size()), {}};
            const std::int32_t count = is_group ? in_.read_number("skins in the group", 1, kMostSkins) : 1;
            if (is_group) sequence.ends_ms = read_ends(count);
            for (std::int32_t j = 0; j < count; ++j) read_skin(i, j);
            mesh_.skin_sequences.push_back(std::move(sequence));
        }
    }

    void read_skin(std::int32_t number, std::int32_t in_group) {
        const auto texels = in_.read_bytes(as_size(header_.skin_width * header_.skin_height));
        mesh_.skins.push_back({"skin " + std::to_string(number) + "." + std::to_string(in_group),
                               header_.skin_width,
                               header_.skin_height,
                               {texels.begin(), texels.end()}});
    }

    /// When each frame or skin of a group ends, converted from seconds to milliseconds.
    std::vector<std::int32_t> read_ends(std::int32_t count) {
        in_.expect_records(count, 4, "times");
        std::vector<std::int32_t> ends_ms;
        for (std::int32_t i = 0; i < count; ++i) {
            const std::int64_t seconds_20 = in_.read_fixed("time", 20, kLongestGroup_s);
            const auto end_ms =
                static_cast<std::int32_t>(rounded_shift(seconds_20 * 1000, 20, Rounding::NearestHalfUp));
            if (end_ms < 1 || (i > 0 && end_ms < ends_ms.back()))
                in_.fail("the group's times do not rise, expected seconds above 0, each after the one before");
            ends_ms.push_back(end_ms);
        }
        return ends_ms;
    }

    void read_skin_places() {
        in_.begin_part("skin places");
        in_.expect_records(header_.vertices, 12, "places");
        for (std::int32_t i = 0; i < header_.vertices; ++i) {
            const bool is_on_seam = in_.read_i32() != 0;
            const std::int32_t u = in_.read_number("s", -header_.skin_width, 2 * header_.skin_width);
            const std::int32_t v = in_.read_number("t", -header_.skin_height, 2 * header_.skin_height);
            places_.push_back({is_on_seam, u, v});
            add_texel(u, v);
            source_.push_back(static_cast<std::uint32_t>(i));
        }
    }

    void add_texel(std::int32_t u, std::int32_t v) {
        const auto middle = [](std::int32_t texel, std::int32_t size) {
            return Texel::from_int(std::clamp(texel, 0, size - 1)) + Texel::from_raw(1 << (Texel::kFractionBits - 1));
        };
        mesh_.texels.push_back({middle(u, header_.skin_width), middle(v, header_.skin_height)});
    }

    void read_triangles() {
        in_.begin_part("triangles");
        in_.expect_records(header_.triangles, 16, "triangles");
        for (std::int32_t i = 0; i < header_.triangles; ++i) {
            const bool is_front = in_.read_i32() != 0;
            MeshTriangle triangle;
            for (std::uint32_t& vertex : triangle.vertices)
                vertex = static_cast<std::uint32_t>(in_.read_number("vertex", 0, header_.vertices - 1));
            corners_.push_back(triangle.vertices);
            if (!is_front)
                for (std::uint32_t& vertex : triangle.vertices) vertex = on_back(vertex);
            mesh_.triangles.push_back(triangle);
        }
    }

    /// The vertex to use with the skin's back half.
    std::uint32_t on_back(std::uint32_t vertex) {
        const SkinPlace& place = item(places_, vertex);
        if (!place.is_on_seam) return vertex;
        back_copies_.resize(places_.size());
        std::uint32_t& copy = item(back_copies_, vertex);
        if (copy == 0) {
            copy = static_cast<std::uint32_t>(source_.size());
            add_texel(place.u + header_.skin_width / 2, place.v);
            source_.push_back(vertex);
        }
        return copy;
    }

    void read_frame_or_group(const std::string& part) {
        in_.begin_part(part);
        const bool is_group = in_.read_number("type", 0, 1) == 1;
        MeshSequence sequence{static_cast<std::uint32_t>(mesh_.frames.size()), {}};
        const std::int32_t count = is_group ? in_.read_number("frames in the group", 1, kMostMdlFrames) : 1;
        if (is_group) {
            in_.read_bytes(2 * 4);  // the group's box
            sequence.ends_ms = read_ends(count);
        }
        for (std::int32_t i = 0; i < count; ++i) read_frame();
        mesh_.frame_sequences.push_back(std::move(sequence));
    }

    void read_frame() {
        in_.read_bytes(2 * 4);  // the frame's box
        MeshFrame frame;
        frame.name = in_.read_name(kMdlNameSize);
        in_.expect_records(header_.vertices, 4, "vertices");
        if ((mesh_.frames.size() + 1) * source_.size() > kMostFrameVertices)
            in_.fail("the frames before have " + std::to_string(mesh_.frames.size() * source_.size()) +
                     " vertices, expected " + std::to_string(kMostFrameVertices) + " in all at most");
        for (std::int32_t i = 0; i < header_.vertices; ++i) frame.vertices.push_back({read_position(), {}});
        set_normals(frame.vertices, corners_);
        for (std::size_t i = frame.vertices.size(); i < source_.size(); ++i)
            frame.vertices.push_back(item(frame.vertices, source_[i]));
        set_boxes(frame, mesh_.triangles);
        mesh_.frames.push_back(std::move(frame));
    }

    Vec3<World> read_position() {
        const auto steps = in_.read_bytes(4);  // the last: the normal's number
        return {coordinate(0, steps[0]), coordinate(1, steps[1]), coordinate(2, steps[2])};
    }

    World coordinate(std::size_t axis, std::uint8_t step) const {
        const std::int64_t exact = header_.scale[axis] * step + header_.origin[axis];
        const auto scaled = product<WorldWide>(Fixed<std::int64_t, kMdlBits>::from_raw(exact), scale_);
        if (!is_within(scaled, WorldWide::from_int(kMeshLimit)))
            in_.fail("a vertex is " + std::to_string(scaled / WorldWide::from_int(1)) +
                     " units from the origin, expected less than " + std::to_string(kMeshLimit));
        return convert<World>(scaled);
    }

    MdlBytes in_;
    World scale_;
    MdlHeader header_;
    Mesh mesh_;
    std::vector<SkinPlace> places_;                      ///< of the file's vertices
    std::vector<std::array<std::uint32_t, 3>> corners_;  ///< the triangles' vertices in the file
    std::vector<std::uint32_t> source_;                  ///< for each of the mesh's vertices, that of the file
    std::vector<std::uint32_t> back_copies_;             ///< of the file's vertices; 0: none
};

}  // namespace

Mesh read_mdl(std::span<const std::uint8_t> bytes, World scale) {
    return MdlReader(bytes, scale).read();
}

}  // namespace oblong
