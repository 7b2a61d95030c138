#include "engine/models/turning_brushes.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/mesh/mesh_stages.h"
#include "engine/scene/placed_models.h"

namespace oblong {

namespace {

std::int32_t wrapped(std::int64_t texel, std::int32_t size) {
    const std::int64_t rest = texel % size;
    return static_cast<std::int32_t>(rest < 0 ? rest + size : rest);
}

/// The range of whole texels in one direction that holds all corners of a face.
struct TexelWindow {
    std::int64_t first = 0;
    std::int32_t count = 1;

    explicit TexelWindow(std::span<const Texel> corners) {
        const auto [least, most] = std::minmax_element(corners.begin(), corners.end());
        first = floor_of(*least);
        count = static_cast<std::int32_t>(std::clamp<std::int64_t>(floor_of(*most) + 1 - first, 1, kMostTexel));
    }
};

class BrushMeshBuilder {
  public:
    BrushMeshBuilder(const Level& level, const Vec3<World>& about, std::int64_t& texels_left)
        : level_(level), about_(about), texels_left_(texels_left) {
        mesh_.frames.emplace_back();
    }

    void add(const Face& face) {
        const TexInfo& texinfo = level_.texinfos[face.texinfo];
        std::vector<Texel> across, down;
        for (const SurfEdge edge : level_.edges_of(face)) {
            const Vec3<World>& corner = level_.vertices[level_.start_of(edge)];
            across.push_back(convert<Texel>(dot(texinfo.s, corner)) + texinfo.s_offset);
            down.push_back(convert<Texel>(dot(texinfo.t, corner)) + texinfo.t_offset);
        }
        TexelWindow u(across), v(down);
        if (std::int64_t{u.count} * v.count > texels_left_) u.count = v.count = 1;
        texels_left_ -= std::int64_t{u.count} * v.count;
        add_skin(level_.texture_of(face), u, v);
        add_corners(face, across, down, Texel::from_int(u.first), Texel::from_int(v.first));
    }

    Mesh finish() {
        MeshFrame& frame = mesh_.frames.front();
        std::vector<std::array<std::uint32_t, 3>> corners;
        for (const MeshTriangle& triangle : mesh_.triangles) corners.push_back(triangle.vertices);
        set_normals(frame.vertices, corners);
        set_boxes(frame, mesh_.triangles);
        mesh_.frame_sequences.emplace_back();
        mesh_.skin_sequences.emplace_back();
        return std::move(mesh_);
    }

  private:
    void add_skin(const MipTexture& texture, const TexelWindow& u, const TexelWindow& v) {
        Skin skin{texture.name, u.count, v.count, {}};
        skin.texels.reserve(as_size(u.count) * as_size(v.count));
        for (std::int32_t row = 0; row < v.count; ++row) {
            const std::uint8_t* const texels =
                texture.mips[0].data() + std::ptrdiff_t{wrapped(v.first + row, texture.height)} * texture.width;
            for (std::int32_t column = 0; column < u.count; ++column)
                skin.texels.push_back(texels[wrapped(u.first + column, texture.width)]);
        }
        mesh_.skins.push_back(std::move(skin));
    }

    /// Adds a fan: faces are convex, and clockwise as a mesh's triangles are.
    void add_corners(const Face& face, std::span<const Texel> across, std::span<const Texel> down, Texel first_u,
                     Texel first_v) {
        std::vector<MeshVertex>& vertices = mesh_.frames.front().vertices;
        const auto first = static_cast<std::uint32_t>(vertices.size());
        std::size_t corner = 0;
        for (const SurfEdge edge : level_.edges_of(face)) {
            vertices.push_back({level_.vertices[level_.start_of(edge)] - about_, {}});
            mesh_.texels.push_back({across[corner] - first_u, down[corner] - first_v});
            ++corner;
        }
        const auto skin = static_cast<std::uint32_t>(mesh_.skins.size() - 1);
        for (std::uint32_t next = 2; next < corner; ++next)
            mesh_.triangles.push_back({{first, first + next - 1, first + next}, skin});
    }

    const Level& level_;
    const Vec3<World> about_;
    std::int64_t& texels_left_;
    Mesh mesh_;
};

constexpr World kFastestTurn = World::from_int(3600);  // degrees a second
constexpr std::int64_t kAboutX = 4, kDoorAboutX = 64;  // spawnflags; twice as much: about y

// The origin, or the middle of the brushes; nothing if they are too large for a mesh.
std::optional<Vec3<World>> place_of_axis(const SubModel& brushes, bool is_door, const EntityValues& values) {
    const std::string named = values.text("origin");
    const std::optional<Vec3<World>> origin = parse_world_vector(named);
    if (origin && is_within_mesh(brushes, *origin)) return origin;
    const Vec3<World> middle = middle_of(brushes.box);
    if (!is_within_mesh(brushes, middle)) {
        values.warn("it is larger than 65,535 units: it is left out");
        return {};
    }
    if (is_door || !named.empty())
        values.warn("origin is \"" + named + "\", expected x y z near its brushes: it turns about their middle");
    return middle;
}

}  // namespace

bool is_within_mesh(const SubModel& model, const Vec3<World>& about) {
    const auto is_near = [](std::int32_t side, World middle) {
        return is_within(WorldWide::from_int(side) - convert<WorldWide>(middle), WorldWide::from_int(kMeshLimit));
    };
    const LevelBox& box = model.box;
    const std::array<World, 3> middle{about.x, about.y, about.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (!is_near(box.mins[axis], middle[axis]) || !is_near(box.maxs[axis], middle[axis])) return false;
    return true;
}

Mesh make_brush_mesh(const Level& level, ModelIndex model, const Vec3<World>& about, std::int64_t& texels_left) {
    BrushMeshBuilder builder(level, about, texels_left);
    for (const FaceIndex face : level.models[model].faces) builder.add(level.faces[face]);
    return builder.finish();
}

std::optional<LevelModel> TurningBrushes::read(const Level& level, const Entity& entity, const EntityValues& values,
                                               std::vector<std::unique_ptr<const Mesh>>& meshes) {
    const std::optional<ModelIndex> brushes = brush_model_of(entity, level);
    if (!brushes) return {};
    LevelModel model;
    model.is_door = role_of(entity) == ClassRole::TurningDoor;
    if (!read_.insert(*brushes).second) {
        values.warn("another entity has the same brush model: it is left out");
        return {};
    }
    const auto about = place_of_axis(level.models[*brushes], model.is_door, values);
    if (!about) return {};
    model.placed.position = *about;
    model.placed.least_light = values.whole_number("_minlight", 0, 255);
    const std::int64_t flags = parse_decimal(values.text("spawnflags"), 0).value_or(0),
                       about_x = model.is_door ? kDoorAboutX : kAboutX;
    if ((flags & about_x) != 0) model.turns = &PlacedMesh::roll;
    if ((flags & about_x * 2) != 0) model.turns = &PlacedMesh::pitch;
    const World speed = model.is_door ? World{} : values.number("speed", {-kFastestTurn, kFastestTurn});
    if (speed != World{})
        model.turn_ms = static_cast<std::int32_t>(WorldWide::from_int(360'000) / convert<WorldWide>(speed));
    meshes.push_back(std::make_unique<const Mesh>(make_brush_mesh(level, *brushes, *about, texels_left_)));
    model.placed.mesh = meshes.back().get();
    return model;
}

}  // namespace oblong
