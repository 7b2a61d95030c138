#include <algorithm>
#include <optional>

#include "engine/library/conversions.h"
#include "engine/mesh/draw_mesh.h"
#include "engine/raster/lines.h"
#include "engine/view/clip.h"
#include "engine/view/views.h"

namespace oblong {
namespace {

Vec3<World> in_world(const MeshTransform& transform, const Vec3<World>& p) {
    const Vec4 at = transform.to_world * Vec4{convert<Entry>(p.x), convert<Entry>(p.y), convert<Entry>(p.z)};
    return saturating_convert<World>(Vec3<Entry>{at.x, at.y, at.z});
}

}  // namespace

struct Stage::State {
    State(const Palette& palette, const ScreenMode& its_mode)
        : mode(checked(its_mode)),
          colormap(make_colormap(palette, palette.colours.size())),
          depth(mode.width_px, mode.height_px),
          scratch(mode.height_px) {}

    PlacedMesh placed(const Model& model, const Pose& pose, std::int32_t frame) const {
        PlacedMesh placed = placed_at(*model.state_->mesh, pose, frame);
        if (model.state_->turns_to_eye) placed.yaw = towards_eye(eye_yaw_256);
        return placed;
    }

    ScreenMode mode;
    Colormap colormap;
    ViewContext view;
    MeshLight light;
    std::int32_t eye_yaw_256 = 0;
    DepthBuffer depth;
    MeshScratch scratch;
};

Stage::Stage(const Palette& palette, ScreenMode mode) : state_(new State(palette, mode)) {
    look({});
}

Stage::~Stage() = default;
Stage::Stage(Stage&& other) noexcept = default;
Stage& Stage::operator=(Stage&& other) noexcept = default;

void Stage::look(const Pose& eye, std::int32_t field_of_view) {
    State& state = *state_;
    state.eye_yaw_256 = eye.yaw_256;
    state.view = make_view_context(first_person_view(camera_of(eye, field_of_view)), state.mode);
    state.depth.start_frame();
    state.depth.want({0, state.mode.width_px, 0, state.mode.height_px});
    state.depth.clear();
}

void Stage::set_light(std::int32_t ambient_256, std::int32_t from_side_256, std::int32_t x, std::int32_t y,
                      std::int32_t z) {
    const auto strength = [](std::int32_t light_256) {
        return static_cast<std::int32_t>(
            std::clamp<std::int64_t>(std::int64_t{light_256} * kFullLight / 256, 0, MeshLight::kMostLight));
    };
    const auto along = [](std::int32_t units) { return World::from_int(std::clamp(units, -100'000, 100'000)); };
    state_->light.ambient = strength(ambient_256);
    state_->light.directional = {normalised(Vec3<World>{along(x), along(y), along(z)}), strength(from_side_256)};
}

void Stage::set_mode(const ScreenMode& mode) {
    State& state = *state_;
    state.mode = checked(mode);
    state.depth = DepthBuffer(mode.width_px, mode.height_px);
    state.scratch = MeshScratch(mode.height_px);
    look({});
}

void Stage::draw(const Model& model, const Pose& pose, Framebuffer canvas, std::int32_t frame) {
    State& state = *state_;
    check_size(canvas, state.mode);
    const MeshDrawing drawing{state.view, state.colormap, state.light, nullptr, false};
    draw_mesh(state.placed(model, pose, frame), drawing,
              {state.depth, canvas, {0, canvas.width_px, 0, canvas.height_px}}, state.scratch);
}

void Stage::draw_edges(const Model& model, const Pose& pose, std::int32_t colour, Framebuffer canvas,
                       std::int32_t frame) {
    const State& state = *state_;
    check_size(canvas, state.mode);
    const PlacedMesh placed = state.placed(model, pose, frame);
    const std::optional<MeshTransform> transform = make_mesh_transform(placed);
    if (!transform || placed.mesh->frames.empty()) return;
    const ViewVolume volume = make_view_volume(state.view.frustum, View::from_raw(1 << 12), View::from_int(1 << 21));
    std::vector<Vec3<View>> corners;
    for (const MeshVertex& vertex : frame_of(placed).vertices)
        corners.push_back(to_view(in_world(*transform, vertex.position), state.view));
    const LineStyle style{LineMethod::Bresenham, static_cast<std::uint8_t>(colour), nullptr};
    for (const MeshTriangle& triangle : placed.mesh->triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3<View>&from = item(corners, triangle.vertices[i]),
                  &to = item(corners, triangle.vertices[(i + 1) % 3]);
            const auto line = project_line(volume, state.view.projection, {from, to});
            if (line) draw_line(line->from, line->to, style, canvas);
        }
}

std::optional<PixelPosition> project(const Pose& place, const Pose& eye, const ScreenMode& mode,
                                     std::int32_t field_of_view) {
    const ViewContext view = make_view_context(first_person_view(camera_of(eye, field_of_view)), checked(mode));
    const Vec3<View> at = to_view(place_of(place), view);
    if (at.z <= View::from_raw(1 << 12)) return {};
    const ScreenPosition screen = project(at, view.projection);
    const auto pixel = [](ScreenWide along) {
        constexpr std::int64_t kFarthest = 1 << 28;
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(floor_of<0>(along), -kFarthest, kFarthest));
    };
    return PixelPosition{pixel(screen.x), pixel(screen.y)};
}

}  // namespace oblong
