#include "game/view/game_renderer.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/wireframe.h"
#include "game/simulation/items.h"

namespace oblong {
namespace {

constexpr World kTorchRadius = World::from_int(240);

LightStyles light_styles_of(const GameState& state) {
    LightStyles styles = plain_light_styles();
    for (std::size_t style = 0; style < styles.size(); ++style)
        if ((state.dark_styles >> style & 1) != 0) styles[style] = 0;
    return styles;
}

// The model that shows an entity, into LevelModels::models; none if its file is missing.
std::optional<std::size_t> model_of(std::size_t entity, const LevelModels& models) {
    const auto model = std::find_if(models.models.begin(), models.models.end(),
                                    [&](const LevelModel& one) { return one.entity == entity; });
    return model == models.models.end() ? std::nullopt : std::optional(as_size(model - models.models.begin()));
}

}  // namespace

GameRenderer::GameRenderer(const GameData& data, const GameLevel& level, const ScreenMode& picture, Workers* workers,
                           const ViewSize& size)
    : data_(data),
      level_(level),
      picture_(picture),
      size_(size),
      placed_(place_view(picture, size)),
      border_(data.palette),
      work_(data.level, mode(), workers) {
    pixels_.resize(pixel_count(picture.width_px, picture.height_px));
    if (size.doubles_columns) columns_.resize(pixel_count(mode().width_px, mode().height_px));
    for (const Item& item : level.items) item_models_.push_back(model_of(item.entity, data.models));
    for (std::uint32_t i = 0; i < level.movers.size(); ++i)
        if (const auto model =
                level.movers[i].turns == 0 ? std::nullopt : model_of(level.movers[i].entity, data.models))
            turning_.push_back({i, *model});
    if (!item_models_.empty() || !turning_.empty()) is_gone_.resize(data.models.models.size());
    if (!turning_.empty()) turned_.resize(data.models.models.size());
}

// A taken item is not in the scene, so that it costs nothing.
void GameRenderer::note_models(const InterpolatedState& state) {
    for (std::size_t i = 0; i < item_models_.size(); ++i)
        if (item_models_[i]) is_gone_[*item_models_[i]] = is_there(state.after, i) ? 0 : 1;
    for (const TurningModel& door : turning_) {
        const MoverState &before = state.before.movers[door.mover], &after = state.after.movers[door.mover];
        is_gone_[door.model] = is_removed(after) ? 1 : 0;
        turned_[door.model] = turn_of(level_.movers[door.mover], state.between(before.travelled, after.travelled));
    }
}

template <class Use>
void GameRenderer::use_scene(const GameView& view, Use use) {
    const std::vector<PlacedModel> models = placed_models(level_, view.state);
    const MovingLight torch{view.camera.eye, kTorchRadius};
    Scene scene{data_.level, data_.colormap, models, time_ms_at(view.state)};
    scene.light_styles = light_styles_of(view.state.after);
    if (view.has_torch) scene.moving_lights = std::span(&torch, 1);
    note_models(view.state);
    place_models(data_.models, scene.time_ms, {is_gone_, turned_}, meshes_);
    scene.meshes = meshes_;
    use(scene);
}

void GameRenderer::draw(const GameView& view, const Settings& settings) {
    use_scene(view, [&](const Scene& scene) {
        draw_frame(scene, spec_of(view, settings), mode(), settings, work_, drawn());
    });
    finish();
}

void GameRenderer::note(const GameView& view, const Settings& settings, std::uint64_t now_us, FrameLog& log) {
    use_scene(view, [&](const Scene& scene) {
        const ViewSpec spec = spec_of(view, settings);
        log.note_each_second({scene, spec, mode(), settings, work_}, now_us);
    });
}

void GameRenderer::draw_edges(const GameView& view, const Settings& settings, const LineStyle& style) {
    draw_wireframe(data_.level, spec_of(view, settings), mode(), settings, work_, style, drawn());
    finish();
}

void GameRenderer::draw_path(std::span<const Vec3<World>> points, const GameView& view, const Settings& settings,
                             const LineStyle& style) {
    oblong::draw_path(points, spec_of(view, settings), mode(), settings, style, drawn());
    finish();
}

FrameCounts GameRenderer::draw_and_count(const GameView& view, const Settings& settings) {
    FrameCounts counts;
    work_.observers.counts = &counts;
    draw(view, settings);
    work_.observers.counts = nullptr;
    return counts;
}

FrameRecord GameRenderer::draw_and_record(const GameView& view, const Settings& settings) {
    FrameRecord record;
    work_.observers.record = &record;
    draw(view, settings);
    work_.observers.record = nullptr;
    return record;
}

void GameRenderer::draw_and_time(const GameView& view, const Settings& settings, RenderingTimes& times) {
    use_scene(view, [&](const Scene& scene) {
        const ViewSpec spec = spec_of(view, settings);
        times.time(work_, [&] { draw_frame(scene, spec, mode(), settings, work_, drawn()); });
    });
    finish();
}

Framebuffer GameRenderer::drawn() {
    return columns_.empty() ? shown()
                            : Framebuffer{columns_.data(), mode().width_px, mode().height_px, mode().width_px};
}

// Each time, since text may be over the border.
void GameRenderer::finish() {
    if (!columns_.empty()) double_columns(drawn(), shown());
    if (size_ != ViewSize{}) draw_around(placed_.area, border_, canvas());
}

void ViewTimes::time(const GameView& view, const Settings& settings, GameRenderer& renderer) {
    const ViewSpec spec = spec_of(view, settings);
    if (spec != view_ || settings != settings_) times_.clear();
    view_ = spec;
    settings_ = settings;
    renderer.draw_and_time(view, settings, times_);
}

}  // namespace oblong
