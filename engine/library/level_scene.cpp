#include <algorithm>

#include "engine/effects/palette_effects.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/library/level_state.h"

namespace oblong {
namespace {

// As in the game: passable brushes do not stop a body, and open gates are missing.
bool is_solid(ClassRole role) {
    return role != ClassRole::Passable && role != ClassRole::OpenGate;
}

const Entity* find_first(const Level& level, ClassRole role) {
    const auto found = std::find_if(level.entities.begin(), level.entities.end(),
                                    [&](const Entity& entity) { return role_of(entity) == role; });
    return found == level.entities.end() ? nullptr : &*found;
}

}  // namespace

Vec3<World> entity_origin(const Entity& entity) {
    return parse_world_vector(entity.value("origin")).value_or(Vec3<World>{});
}

std::int32_t entity_yaw_256(const Entity& entity) {
    const auto angles = parse_world_vector(entity.value("angles"));
    return to_256(angles ? angles->y : parse_world_number(entity.value("angle")).value_or(World{}));
}

void LevelScene::State::list_brushes() {
    seen.clear();
    solid.clear();
    for (const EntityBrushes& each : brushes) {
        if (each.is_hidden) continue;
        if (!each.is_door) seen.push_back(each.placed);
        if (each.is_solid && !each.is_open) solid.push_back(each.placed);
    }
}

LevelScene::LevelScene(const File& bsp_file, const Palette& palette, ScreenMode mode)
    : state_(new State(bsp_file, palette, mode)) {
    State& state = *state_;
    LevelCache& cache = state.work->cache;
    for (const auto* found : {&cache.effects.warnings, &cache.things.warnings, &state.models.warnings})
        state.warnings.insert(state.warnings.end(), found->begin(), found->end());
    for (std::size_t i = 0; i < state.level.entities.size(); ++i) {
        const ClassRole role = role_of(state.level.entities[i]);
        const auto model = brush_model_of(state.level.entities[i], state.level);
        const auto number = static_cast<std::int32_t>(i);
        if (model && !is_trigger(role) && role != ClassRole::Rotating)
            state.brushes.push_back({{*model, {}}, number, is_solid(role), state.turning_door(number).has_value()});
    }
    state.list_brushes();
}

LevelScene::~LevelScene() = default;
LevelScene::LevelScene(LevelScene&& other) noexcept = default;
LevelScene& LevelScene::operator=(LevelScene&& other) noexcept = default;

void LevelScene::set_mode(const ScreenMode& mode) {
    state_->mode = checked(mode);
    state_->work = std::make_unique<FrameWorkspace>(state_->level, mode);
}

Pose LevelScene::start() const {
    const Entity* start = find_first(state_->level, ClassRole::Start);
    if (!start) start = find_first(state_->level, ClassRole::DeathmatchStart);
    if (!start) return {};
    const Vec3<World> origin = entity_origin(*start);
    constexpr World kLift = World::from_int(1);  // as in the game
    return {to_256(origin.x), to_256(origin.y), to_256(origin.z + kLift + kEyeAboveOrigin), entity_yaw_256(*start)};
}

void LevelScene::draw(const Pose& eye, std::int64_t time_ms, Framebuffer canvas, std::int32_t field_of_view) {
    State& state = *state_;
    check_size(canvas, state.mode);
    for (const std::size_t sprite : state.shown_sprites) state.shown[sprite].yaw = towards_eye(eye.yaw_256);
    std::vector<PlacedMesh> meshes;
    place_models(state.models, time_ms, {state.is_model_hidden, state.turned}, meshes);
    meshes.insert(meshes.end(), state.shown.begin(), state.shown.end());
    Scene scene{state.level, state.colormap, state.seen, std::max<std::int64_t>(time_ms, 0)};
    scene.meshes = meshes;
    draw_frame(scene, camera_of(eye, field_of_view), state.mode, state.settings, *state.work, canvas);
    state.shown.clear();
    state.shown_sprites.clear();
    state.shown_meshes.clear();
}

Palette LevelScene::palette_at(const Pose& eye, std::int64_t time_ms) const {
    const State& state = *state_;
    const Palette& palette = state.colormap.palette;
    return apply_palette_effects(
        palette,
        palette_effects_at(state.level, state.work->cache.effects, palette, place_of(eye), state.settings.flashes),
        std::max<std::int64_t>(time_ms, 0));
}

void LevelScene::show(const Model& model, const Pose& pose, std::int32_t frame) {
    if (model.state_->turns_to_eye) state_->shown_sprites.push_back(state_->shown.size());
    state_->shown.push_back(placed_at(*model.state_->mesh, pose, frame));
    state_->shown_meshes.push_back(model.state_->mesh);
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
