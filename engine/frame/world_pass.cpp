#include "engine/frame/world_pass.h"

#include "engine/frame/draw_face.h"
#include "engine/visible/box_rectangle.h"

namespace oblong {

void draw_world(const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    work.vertices.start_frame();
    work.coverage.reset();
    work.sky_spans.clear();
    work.brush_models.start_frame();

    const bool has_models = frame.plan.effects.has(Effect::BrushModels);
    walk_front_to_back(
        level, frame.view.eye, frame.view.frustum, work.visible,
        both_sides_distance_42(frame.settings.accuracy.subpixel_bits), work.walk,
        [&](std::int32_t leaf) {
            if (has_models) draw_fragments_in(leaf, frame, work);
        },
        [&](std::int32_t face) { draw_world_face(face, frame, work); },
        [&](const LevelBox& box) {
            const std::optional<ScreenRectangle> rectangle = rectangle_of(box, frame.view);
            return rectangle && !work.coverage.may_be_free(*rectangle);
        },
        [&] { return work.coverage.is_full(); });
}

}  // namespace oblong
