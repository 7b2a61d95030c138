#include "tools/gallery/level_scene.h"

#include "engine/fixed/trig.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"

namespace oblong {

Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, int yaw, int pitch, int field_of_view) {
    return {{World::from_int(x), World::from_int(y), World::from_int(z)},
            degrees_to_angle(Degrees::from_int(yaw)),
            degrees_to_angle(Degrees::from_int(pitch)),
            {},
            Degrees::from_int(field_of_view)};
}

void draw_demo_level(const RowInput& input, const ViewSpec& view, Framebuffer canvas) {
    const Level& level = input.assets.demo_level;
    const std::vector<PlacedModel> models = models_at_rest(level);
    FrameWorkspace work(level, input.mode);
    draw_frame({level, input.assets.colormap, models, input.time_ms}, view, input.mode, input.settings, work, canvas);
}

void draw_demo_level(const RowInput& input, const Camera& camera, const ScreenMode& mode, Framebuffer canvas) {
    const Level& level = input.assets.demo_level;
    const std::vector<PlacedModel> models = models_at_rest(level);
    FrameWorkspace work(level, mode);
    draw_frame({level, input.assets.colormap, models, input.time_ms}, camera, mode, input.settings, work, canvas);
}

}  // namespace oblong
