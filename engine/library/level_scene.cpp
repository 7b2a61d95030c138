#include <algorithm>
#include <memory>
#include <optional>

#include "engine/base/text.h"
#include "engine/effects/palette_effects.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/level/trace.h"
#include "engine/library/conversions.h"
#include "engine/models/level_models.h"

namespace oblong {
namespace {

// Of a body's eye above its origin (Quake's).
constexpr World kEyeHeight = World::from_int(22);

// As in the game: passable brushes do not stop a body, and open gates are missing.
bool is_solid(ClassRole role) {
    return role != ClassRole::Passable && role != ClassRole::OpenGate;
}

const Entity* find_first(const Level& level, ClassRole role) {
    const auto found = std::find_if(level.entities.begin(), level.entities.end(),
                                    [&](const Entity& entity) { return role_of(entity) == role; });
    return found == level.entities.end() ? nullptr : &*found;
}

/// The obstacles of a body of the player's size (Hull::Player): the level, and its brush models at their current
/// places.
struct Surroundings {
    const Level& level;
    std::span<const PlacedModel> models;
};

constexpr World kStep = World::from_int(18);
// The least z of a floor's normal (Quake's 0.7).
constexpr Unit kLeastFloor = Unit::from_raw(751'619'277);

// The shortest trace in the world and in each brush model.
TraceResult trace_body(const Surroundings& around, const Vec3<World>& from, const Vec3<World>& to) {
    TraceResult nearest = trace_hull(around.level, around.level.world(), Hull::Player, from, to);
    for (const PlacedModel& model : around.models) {
        TraceResult hit = trace_hull(around.level, around.level.models[model.model], Hull::Player, from - model.offset,
                                     to - model.offset);
        if (!hit.is_all_solid && hit.fraction >= nearest.fraction) continue;
        hit.end = hit.end + model.offset;
        nearest = hit;
    }
    return nearest;
}

// A way without its component into a plane.
Vec3<World> along_plane(const Vec3<World>& way, const Vec3<Unit>& normal) {
    const World into = convert<World>(dot(way, normal), Rounding::Floor);
    const auto part = [&](Unit component) { return product<World>(into, component); };
    return {way.x - part(normal.x), way.y - part(normal.y), way.z - part(normal.z)};
}

Vec3<World> slide(const Surroundings& around, Vec3<World> at, Vec3<World> way) {
    constexpr int kMostPlanes = 4;
    for (int plane = 0; plane < kMostPlanes; ++plane) {
        const TraceResult hit = trace_body(around, at, at + way);
        if (hit.is_all_solid) return at;
        const Vec3<World> rest = at + way - hit.end;
        at = hit.end;
        if (!hit.is_hit) return at;
        way = along_plane(rest, hit.normal);
    }
    return at;
}

WorldWide distance_2d(const Vec3<World>& a, const Vec3<World>& b) {
    const WorldWide x = widening_difference(a.x, b.x), y = widening_difference(a.y, b.y);
    return (x < WorldWide{} ? -x : x) + (y < WorldWide{} ? -y : y);
}

/// Moves a body by `way`: it slides along obstacles, and climbs steps of 18 units. Returns its place.
Vec3<World> walk_body(const Surroundings& around, const Vec3<World>& from, const Vec3<World>& way) {
    const Vec3<World> along_ground = slide(around, from, way);
    if (way.x == World{} && way.y == World{}) return along_ground;
    // The way over a step, up, ahead and down, is taken if it leads farther.
    const Vec3<World> up = trace_body(around, from, from + Vec3<World>{{}, {}, kStep}).end;
    const Vec3<World> over = slide(around, up, {way.x, way.y, {}});
    const TraceResult down = trace_body(around, over, over - Vec3<World>{{}, {}, up.z - from.z});
    const bool is_floor = down.is_hit && down.normal.z >= kLeastFloor;
    return is_floor && distance_2d(down.end, from) > distance_2d(along_ground, from) ? down.end : along_ground;
}

/// Whether there is a floor less than a unit below.
bool stands_on_floor(const Surroundings& around, const Vec3<World>& at) {
    const TraceResult below = trace_body(around, at, at - Vec3<World>{{}, {}, World::from_int(1)});
    return below.is_hit && below.normal.z >= kLeastFloor;
}

}  // namespace

struct LevelScene::State {
    State(const std::string& bsp_file, const Palette& its_palette, const ScreenMode& its_mode)
        : file(bsp_file),
          mode(checked(its_mode)),
          level(read_parsed(bsp_file, read_bsp)),
          colormap(make_colormap(its_palette)),
          models(read_level_models(level, its_palette, {bsp_file, ""})),
          turned(models.models.size()),
          brushes(models_at_rest(level)),
          work(level, mode) {}

    const Entity& entity(std::int32_t number) const {
        if (number < 0 || as_size(number) >= level.entities.size())
            throw FileError(
                file, "entity " + std::to_string(number),
                "is not there, expected " + (level.entities.empty() ? "none: the level has no entities"
                                                                    : bounds_text(0, std::ssize(level.entities) - 1)));
        return item(level.entities, number);
    }
    ModelIndex brushes_of(std::int32_t number) const {
        const std::optional<ModelIndex> model = brush_model_of(entity(number), level);
        if (!model)
            throw FileError(file, "entity " + std::to_string(number), "has no brushes, expected a door or its like");
        return *model;
    }
    /// The index in `models` of the model of a turning door.
    std::optional<std::size_t> turning_door(std::int32_t number) const {
        for (std::size_t i = 0; i < models.models.size(); ++i)
            if (models.models[i].is_door && models.models[i].entity == as_size(number)) return i;
        return {};
    }
    Surroundings surroundings() const { return {level, solid_brushes}; }

    std::string file;
    ScreenMode mode;
    Level level;
    Colormap colormap;
    LevelModels models;
    std::vector<Angle> turned;               // of turning doors, in the order of `models`
    std::vector<PlacedModel> brushes;        // all visible ones, except turning doors
    std::vector<PlacedModel> solid_brushes;  // the solid ones of these
    std::vector<PlacedMesh> shown;           // in the next picture
    std::vector<std::shared_ptr<const Mesh>> shown_meshes;
    Settings settings;
    FrameWorkspace work;  // of the level above
    std::vector<std::string> warnings;
};

LevelScene::LevelScene(const std::string& bsp_file, const Palette& palette, ScreenMode mode)
    : state_(new State(bsp_file, palette, mode)) {
    State& state = *state_;
    LevelCache& cache = state.work.cache;
    for (const auto* found : {&cache.effects.warnings, &cache.things.warnings, &state.models.warnings})
        state.warnings.insert(state.warnings.end(), found->begin(), found->end());
    for (const Entity& entity : state.level.entities) {
        const std::optional<ModelIndex> model = brush_model_of(entity, state.level);
        const auto shown = std::find_if(state.brushes.begin(), state.brushes.end(),
                                        [&](const PlacedModel& one) { return model && one.model == *model; });
        if (shown != state.brushes.end() && is_solid(role_of(entity))) state.solid_brushes.push_back(*shown);
    }
    for (const LevelModel& model : state.models.models) {
        if (!model.is_door) continue;
        const auto door = brush_model_of(state.level.entities[model.entity], state.level);
        std::erase_if(state.brushes, [&](const PlacedModel& one) { return one.model == *door; });
    }
}

LevelScene::~LevelScene() {
    delete state_;
}

Pose LevelScene::start() const {
    const Entity* start = find_first(state_->level, ClassRole::Start);
    if (!start) start = find_first(state_->level, ClassRole::DeathmatchStart);
    if (!start) return {};
    const auto origin = parse_world_vector(start->value("origin")).value_or(Vec3<World>{});
    const auto angles = parse_world_vector(start->value("angles"));
    const World yaw = angles ? angles->y : parse_world_number(start->value("angle")).value_or(World{});
    constexpr World kLift = World::from_int(1);  // as in the game
    return {to_256(origin.x), to_256(origin.y), to_256(origin.z + kLift + kEyeHeight), to_256(yaw)};
}

void LevelScene::draw(const Pose& eye, std::int64_t time_ms, Framebuffer canvas, std::int32_t field_of_view) {
    State& state = *state_;
    check_size(canvas, state.mode);
    std::vector<PlacedMesh> meshes;
    place_models(state.models, time_ms, {{}, state.turned}, meshes);
    meshes.insert(meshes.end(), state.shown.begin(), state.shown.end());
    Scene scene{state.level, state.colormap, state.brushes, std::max<std::int64_t>(time_ms, 0)};
    scene.meshes = meshes;
    draw_frame(scene, camera_of(eye, field_of_view), state.mode, state.settings, state.work, canvas);
    state.shown.clear();
    state.shown_meshes.clear();
}

Palette LevelScene::palette_at(const Pose& eye, std::int64_t time_ms) const {
    const State& state = *state_;
    const Palette& palette = state.colormap.palette;
    return apply_palette_effects(
        palette,
        palette_effects_at(state.level, state.work.cache.effects, palette, place_of(eye), state.settings.flashes),
        std::max<std::int64_t>(time_ms, 0));
}

void LevelScene::show(const Model& model, const Pose& pose, std::int32_t frame) {
    state_->shown.push_back(placed_at(*model.state_->mesh, pose, frame));
    state_->shown_meshes.push_back(model.state_->mesh);
}

namespace {

// Places of bodies, their ways and offsets of brushes stay so near that their sums fit: levels do not reach as far.
constexpr World kFarthestMoved = World::from_int(100'000);
World within_walks(World along) {
    constexpr World kFarthest = World::from_int(200'000);
    return std::clamp(along, -kFarthest, kFarthest);
}

Vec3<World> walker_of(const Pose& eye) {
    const Vec3<World> place = place_of(eye);
    return {within_walks(place.x), within_walks(place.y), within_walks(place.z)};
}

}  // namespace

Pose LevelScene::walked(const Pose& eye, const Pose& wanted) const {
    const Vec3<World> below_eye{{}, {}, kEyeHeight};
    const auto part = [](std::int64_t from, std::int64_t to) { return within_walks(world_from_256(to - from)); };
    const Vec3<World> way{part(eye.x_256, wanted.x_256), part(eye.y_256, wanted.y_256), part(eye.z_256, wanted.z_256)};
    const Vec3<World> at = walk_body(state_->surroundings(), walker_of(eye) - below_eye, way) + below_eye;
    Pose after = wanted;
    after.x_256 = to_256(at.x);
    after.y_256 = to_256(at.y);
    after.z_256 = to_256(at.z);
    return after;
}

bool LevelScene::stands(const Pose& eye) const {
    return stands_on_floor(state_->surroundings(), walker_of(eye) - Vec3<World>{{}, {}, kEyeHeight});
}

std::int32_t LevelScene::find_entity(const std::string& key, const std::string& value, std::int32_t after) const {
    const std::vector<Entity>& entities = state_->level.entities;
    const auto begin =
        entities.begin() + std::clamp<std::ptrdiff_t>(std::ptrdiff_t{after} + 1, 0, std::ssize(entities));
    const auto found =
        std::find_if(begin, entities.end(), [&](const Entity& entity) { return entity.value(key) == value; });
    return found == entities.end() ? -1 : static_cast<std::int32_t>(found - entities.begin());
}

std::string LevelScene::entity_value(std::int32_t entity, const std::string& key) const {
    return state_->entity(entity).value(key);
}

void LevelScene::move_entity(std::int32_t entity, std::int32_t east_256, std::int32_t north_256, std::int32_t up_256) {
    State& state = *state_;
    const ModelIndex model = state.brushes_of(entity);
    const auto within = [](std::int32_t offset_256) {
        return std::clamp(world_from_256(offset_256), -kFarthestMoved, kFarthestMoved);
    };
    if (state.turning_door(entity))
        throw FileError(state.file, "entity " + std::to_string(entity), "turns, expected a door that moves");
    for (std::vector<PlacedModel>* list : {&state.brushes, &state.solid_brushes})
        for (PlacedModel& placed : *list)
            if (placed.model == model) placed.offset = {within(east_256), within(north_256), within(up_256)};
}

void LevelScene::turn_entity(std::int32_t entity, std::int32_t degrees_256) {
    State& state = *state_;
    const ModelIndex model = state.brushes_of(entity);
    const std::optional<std::size_t> door = state.turning_door(entity);
    if (!door)
        throw FileError(state.file, "entity " + std::to_string(entity), "does not turn, expected a func_door_rotating");
    state.turned[*door] = angle_from_256(degrees_256);
    std::erase_if(state.solid_brushes, [&](const PlacedModel& one) { return one.model == model; });
    if (state.turned[*door] == Angle{}) state.solid_brushes.push_back({model, {}});
}

void LevelScene::set_accuracy(const std::string& preset) {
    const std::optional<Preset> named = preset_named(preset);
    if (!named) throw argument_error("accuracy", "'" + preset + "', expected " + std::string(kPresetNames));
    state_->settings.accuracy = accuracy_of(*named);
}

Settings& LevelScene::settings() {
    return state_->settings;
}

const Level& LevelScene::level() const {
    return state_->level;
}

const std::vector<std::string>& LevelScene::warnings() const {
    return state_->warnings;
}

}  // namespace oblong
