#include "engine/files/turning_brushes.h"

#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/mesh/brush_mesh.h"
#include "engine/scene/placed_models.h"

namespace oblong {
namespace {

constexpr World kFastestTurn = World::from_int(3600);  // degrees a second
constexpr std::int64_t kAboutX = 4, kDoorAboutX = 64;  // spawnflags; twice as much: about y

// The origin, or the middle of the brushes; nothing if they are too large for a mesh.
std::optional<Vec3<World>> place_of_axis(const SubModel& brushes, bool is_door, const EntityValues& values) {
    const std::string named = values.text("origin");
    const std::optional<Vec3<World>> origin = parse_world_vector(named);
    if (origin && is_within_mesh(brushes, *origin)) return origin;
    const Vec3<World> middle = middle_of(brushes);
    if (!is_within_mesh(brushes, middle)) {
        values.warn("it is larger than 65,535 units: it is left out");
        return {};
    }
    if (is_door || !named.empty())
        values.warn("origin is \"" + named + "\", expected x y z near its brushes: it turns about their middle");
    return middle;
}

}  // namespace

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
