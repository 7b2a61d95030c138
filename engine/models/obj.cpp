#include "engine/models/obj.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <unordered_map>
#include <unordered_set>

#include "engine/base/table.h"
#include "engine/io/doubles.h"
#include "engine/io/files.h"
#include "engine/mesh/triangulate.h"
#include "engine/models/obj_parts.h"

namespace oblong {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
constexpr Texel kHalfTexel = Texel::from_raw(1 << (Texel::kFractionBits - 1));

Vec3<World> world_position(const std::vector<double>& numbers, std::size_t vertex, const ObjOptions& options) {
    const auto coordinate = [&](std::size_t axis) {
        return fixed_of<World>(numbers[vertex * 3 + axis] * options.scale);
    };
    const World x = coordinate(0), y = coordinate(1), z = coordinate(2);
    return options.is_z_up ? Vec3<World>{x, y, z} : Vec3<World>{z, x, y};
}

/// A normal of the file; zero if it has no direction.
Vec3<Unit> unit_normal(const std::vector<double>& numbers, std::size_t normal, const ObjOptions& options) {
    const double x = numbers[normal * 3], y = numbers[normal * 3 + 1], z = numbers[normal * 3 + 2];
    const double length = std::hypot(x, y, z);
    if (length == 0) return {};
    const auto part = [&](double value) { return fixed_of<Unit>(value / length); };
    return options.is_z_up ? Vec3<Unit>{part(x), part(y), part(z)} : Vec3<Unit>{part(z), part(x), part(y)};
}

/// A vertex of the mesh, shared by corners with the same values.
struct ObjVertex {
    std::int32_t position, texcoord, normal;  ///< of the file; -1: none
    std::uint32_t smooth;                     ///< without a normal: the number of its SmoothVertex
    std::uint32_t skin;
    bool operator==(const ObjVertex&) const = default;
    std::array<std::int64_t, 5> numbers() const { return {position, texcoord, normal, smooth, skin}; }
};

/// A vertex for computed normals: one for each position and smoothing group.
struct SmoothVertex {
    std::int32_t position;
    std::int64_t group;
    bool operator==(const SmoothVertex&) const = default;
    std::array<std::int64_t, 2> numbers() const { return {position, group}; }
};

/// Assigns numbers to different records, from 0.
template <class Record>
class Numbering {
  public:
    explicit Numbering(std::size_t expected) {
        numbers_.reserve(expected);
        records_.reserve(expected);
    }
    std::uint32_t number_of(const Record& record) {
        const auto [known, is_new] = numbers_.emplace(record, static_cast<std::uint32_t>(records_.size()));
        if (is_new) records_.push_back(record);
        return known->second;
    }
    const std::vector<Record>& records() const { return records_; }

  private:
    struct Hash {
        std::size_t operator()(const Record& record) const {
            std::uint64_t hash = 0;
            for (const std::int64_t number : record.numbers()) {
                hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15;
                hash ^= hash >> 32;
            }
            return hash;
        }
    };
    std::unordered_map<Record, std::uint32_t, Hash> numbers_;
    std::vector<Record> records_;
};

/// Makes a mesh from the faces of a checked file.
class ObjMeshBuilder {
  public:
    ObjMeshBuilder(const tinyobj::attrib_t& file, const ObjOptions& options)
        : file_(file), vertices_(file.vertices.size() / 3), smooth_vertices_(file.vertices.size() / 3) {
        for (std::size_t i = 0; i < file.vertices.size() / 3; ++i)
            positions_.push_back(world_position(file.vertices, i, options));
        for (std::size_t i = 0; i < file.normals.size() / 3; ++i)
            normals_.push_back(unit_normal(file.normals, i, options));
    }

    /// `smoothing` is a group's number; touching faces of a group share normals.
    void add_face(std::span<const tinyobj::index_t> corners, std::uint32_t skin, std::int64_t smoothing) {
        const std::size_t first = numbers_.size();
        for (const tinyobj::index_t& corner : corners) add_corner(corner, skin, smoothing);
        if (corners.size() == 3) add_triangle(first, {0, 1, 2}, skin);
        if (corners.size() > 3)
            for (const CornerTriple& triple : triangulated(corners)) add_triangle(first, triple, skin);
        numbers_.resize(first);
        smooth_numbers_.resize(first);
        if (mesh_.triangles.size() > kMostMeshTriangles || vertices_.records().size() > kMostMeshVertices)
            throw InputError("faces", "more than " + std::to_string(kMostMeshTriangles) + " triangles or " +
                                          std::to_string(kMostMeshVertices) + " vertices, expected a smaller model");
    }

    /// `used`: the number of skins of faces; further skins replace these, and have the same sizes. `maps`: how their
    /// pictures lie on faces, or null.
    Mesh finish(std::vector<Skin> skins, std::size_t used, std::vector<const tinyobj::texture_option_t*> maps,
                std::int64_t& texels_left, std::vector<std::string>& warnings) {
        mesh_.skins = std::move(skins);
        maps_ = std::move(maps);
        set_texels(used, texels_left, warnings);
        const std::vector<MeshVertex> smooth = smooth_vertices();
        MeshFrame frame;
        frame.vertices.reserve(vertices_.records().size());
        for (const ObjVertex& vertex : vertices_.records()) {
            const Vec3<Unit> normal =
                vertex.normal < 0 ? item(smooth, vertex.smooth).normal : item(normals_, vertex.normal);
            frame.vertices.push_back({item(positions_, vertex.position), normal});
        }
        mesh_.triangles.shrink_to_fit();
        set_boxes(frame, mesh_.triangles);
        mesh_.frames.push_back(std::move(frame));
        mesh_.frame_sequences = {{}};
        return std::move(mesh_);
    }

  private:
    std::vector<CornerTriple> triangulated(std::span<const tinyobj::index_t> corners) const {
        std::vector<Vec3<World>> polygon;
        for (const tinyobj::index_t& corner : corners) polygon.push_back(item(positions_, corner.vertex_index));
        return triangulate_by_diagonals(polygon);
    }

    void add_corner(const tinyobj::index_t& corner, std::uint32_t skin, std::int64_t smoothing) {
        const std::uint32_t smooth = smooth_vertices_.number_of({corner.vertex_index, smoothing});
        const bool has_normal = corner.normal_index >= 0 && as_size(corner.normal_index) < normals_.size() &&
                                item(normals_, corner.normal_index) != Vec3<Unit>{};
        numbers_.push_back(vertices_.number_of({corner.vertex_index, corner.texcoord_index,
                                                has_normal ? corner.normal_index : -1, has_normal ? 0 : smooth, skin}));
        smooth_numbers_.push_back(smooth);
    }

    /// `corners` count from `first` in numbers_: counter-clockwise in the file, clockwise in the mesh.
    void add_triangle(std::size_t first, const CornerTriple& corners, std::uint32_t skin) {
        const std::size_t a = first + corners[0], b = first + corners[2], c = first + corners[1];
        mesh_.triangles.push_back({{numbers_[a], numbers_[b], numbers_[c]}, skin});
        smooth_triangles_.push_back({smooth_numbers_[a], smooth_numbers_[b], smooth_numbers_[c]});
    }

    std::vector<MeshVertex> smooth_vertices() const {
        std::vector<MeshVertex> smooth;
        for (const SmoothVertex& vertex : smooth_vertices_.records())
            smooth.push_back({item(positions_, vertex.position), {}});
        set_normals(smooth, smooth_triangles_);
        return smooth;
    }

    bool has_place(const ObjVertex& vertex) const {
        return vertex.texcoord >= 0 && item(mesh_.skins, vertex.skin).texels.size() > 1;
    }
    /// In repetitions of the skin, by its material's options; the file's v goes up it.
    SkinPlace place_of(const ObjVertex& vertex) const {
        const auto place = [&](int axis) {
            const double of_file = item(file_.texcoords, vertex.texcoord * 2 + axis);
            if (maps_[vertex.skin] == nullptr) return of_file;
            const double moved = of_file * maps_[vertex.skin]->scale[axis] + maps_[vertex.skin]->origin_offset[axis];
            return std::clamp(moved, -kFarthestTexcoord, kFarthestTexcoord);
        };
        return {place(0), 1 - place(1)};
    }

    /// Sets texels from places on skins, and repeats the skins as often as needed.
    void set_texels(std::size_t used, std::int64_t& texels_left, std::vector<std::string>& warnings) {
        std::vector<PlaceRange> ranges(used);
        for (const ObjVertex& vertex : vertices_.records())
            if (has_place(vertex)) item(ranges, vertex.skin).include(place_of(vertex));
        mesh_.texels.reserve(vertices_.records().size());
        std::vector<SkinScale> scales;
        for (std::size_t i = 0; i < mesh_.skins.size(); ++i)
            scales.push_back(repeat_skin(mesh_.skins[i], ranges[i % used], texels_left, warnings));
        for (const ObjVertex& vertex : vertices_.records())
            mesh_.texels.push_back(has_place(vertex) ? item(scales, vertex.skin).texel_at(place_of(vertex))
                                                     : MeshTexel{kHalfTexel, kHalfTexel});
    }

    const tinyobj::attrib_t& file_;
    std::vector<const tinyobj::texture_option_t*> maps_;
    std::vector<Vec3<World>> positions_;
    std::vector<Vec3<Unit>> normals_;
    Mesh mesh_;
    Numbering<ObjVertex> vertices_;
    Numbering<SmoothVertex> smooth_vertices_;
    std::vector<Triangle> smooth_triangles_;               ///< the mesh's triangles, of smooth vertices
    std::vector<std::uint32_t> numbers_, smooth_numbers_;  ///< of a face's corners: vertices and smooth vertices
};

constexpr const char* kGlass = "glass";

/// The skins of materials, made at their first use by a face.
class ObjSkins {
  public:
    ObjSkins(const std::vector<tinyobj::material_t>& materials, std::filesystem::path folder, const Palette& palette,
             const ObjOptions& options, std::vector<std::string>& warnings)
        : maker(std::move(folder), palette, options.dither, warnings),
          materials_(materials),
          plain_(options.plain.texels.empty() ? grey_skin(palette) : options.plain) {}

    std::uint32_t number_of(int material) {
        const auto [known, is_new] = numbers_.emplace(material, static_cast<std::uint32_t>(skins.size()));
        if (!is_new) return known->second;
        skins.push_back(material < 0 ? plain_ : made_of(material));
        maps.push_back(material < 0 ? nullptr : &item(materials_, material).diffuse_texopt);
        return known->second;
    }

    /// Adds all skins again for each of these materials that exists, which then replaces glass. The first sequence is
    /// of glass itself.
    std::vector<MeshSequence> add_for_glass(const std::vector<std::string>& names) {
        std::vector<MeshSequence> sequences(names.size() + 1);
        const std::size_t used = skins.size();
        const auto glass = numbers_.find(find(kGlass));
        for (std::size_t k = 0; k < names.size(); ++k) {
            const int other = find(names[k]);
            if (other < 0 || glass == numbers_.end()) continue;
            std::size_t texels = 0;
            for (std::size_t i = 0; i < used; ++i) texels += skins[i].texels.size();
            if (!maker.takes(texels)) break;  // glass stays glass
            sequences[k + 1].first = static_cast<std::uint32_t>(skins.size());
            for (std::size_t i = 0; i < used; ++i)
                skins.push_back(i == glass->second ? resized(made_of(other), skins[i]) : Skin(skins[i]));
        }
        return sequences;
    }

    SkinMaker maker;
    std::vector<Skin> skins;
    std::vector<const tinyobj::texture_option_t*> maps;  ///< of the skins without those for glass

  private:
    static constexpr int kNone = -2;  ///< no such material; -1: faces without a material

    int find(const std::string& name) const {
        const auto found =
            std::find_if(materials_.begin(), materials_.end(), [&](const auto& one) { return one.name == name; });
        return found == materials_.end() ? kNone : static_cast<int>(found - materials_.begin());
    }
    Skin made_of(int material) { return maker.skin_of(item(materials_, material)); }

    const std::vector<tinyobj::material_t>& materials_;
    const Skin plain_;  ///< of faces without a material
    std::map<int, std::uint32_t> numbers_;
};

/// A file as tinyobjloader reads it.
struct ObjFile {
    tinyobj::attrib_t numbers;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warnings;
};

ObjFile load_obj(const std::string& text, const std::filesystem::path& folder) {
    ObjFile file;
    std::istringstream in(text);
    ObjMaterialReader materials(folder);
    std::string error;
    if (!tinyobj::LoadObj(&file.numbers, &file.shapes, &file.materials, &file.warnings, &error, &in, &materials, false,
                          false))
        throw InputError("file", error + ", expected lines of OBJ (tinyobjloader)");
    return file;
}

std::vector<std::string> lines_without_repetition(const std::string& text) {
    std::vector<std::string> lines;
    std::unordered_set<std::string> known;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        // Of normals that are missing check_obj() says more.
        if (!line.empty() && !line.starts_with("Vertex normal indices out of bounds") && known.insert(line).second)
            lines.push_back(line);
    return lines;
}

ObjModel parse_obj(const std::string& text, const std::filesystem::path& folder, const Palette& palette,
                   const ObjOptions& options) {
    const ObjSummary summary = check_obj(text, options.scale);
    const ObjFile file = load_obj(text, folder);
    ObjModel model{{}, lines_without_repetition(name_of_word(file.warnings))};
    model.warnings.insert(model.warnings.end(), summary.warnings.begin(), summary.warnings.end());
    ObjSkins skins(file.materials, folder, palette, options, model.warnings);
    ObjMeshBuilder builder(file.numbers, options);
    std::int64_t flat_faces = 0;
    for (const tinyobj::shape_t& shape : file.shapes) {
        std::span<const tinyobj::index_t> corners(shape.mesh.indices);
        for (std::size_t face = 0; face < shape.mesh.num_face_vertices.size(); ++face) {
            const std::size_t count = shape.mesh.num_face_vertices[face];
            const std::int64_t group = summary.has_smoothing_groups ? shape.mesh.smoothing_group_ids[face] : 1;
            builder.add_face(corners.first(count), skins.number_of(shape.mesh.material_ids[face]),
                             group != 0 ? group : --flat_faces);
            corners = corners.subspan(count);
        }
    }
    const std::size_t used = skins.skins.size();
    std::vector<MeshSequence> sequences = skins.add_for_glass(options.glasses);
    model.mesh =
        builder.finish(std::move(skins.skins), used, std::move(skins.maps), skins.maker.texels_left, model.warnings);
    model.mesh.skin_sequences = std::move(sequences);
    return model;
}

}  // namespace

ObjOptions scaled_256(std::int32_t scale_256) {
    ObjOptions options;
    options.scale = scale_256 / 256.0;
    return options;
}

ObjModel read_obj(const std::string& path, const Palette& palette, const ObjOptions& options) {
    return read_parsed(path,
                       [&](std::span<const std::uint8_t> bytes) { return read_obj(bytes, path, palette, options); });
}

ObjModel read_obj(std::span<const std::uint8_t> bytes, const std::string& path, const Palette& palette,
                  const ObjOptions& options) {
    return parse_obj(simple_obj({bytes.begin(), bytes.end()}), std::filesystem::path(path).parent_path(), palette,
                     options);
}

}  // namespace oblong
