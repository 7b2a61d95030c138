#include "engine/frame/world_pass.h"

#include "engine/frame/draw_face.h"
#include "engine/visibility/box_rectangle.h"

namespace oblong {

void draw_world(const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    work.vertices.start_frame();
    work.span_buffer.reset();
    work.sky_spans.clear();
    work.brush_models.start_frame();

    const bool has_models = frame.plan.effects.has(Effect::BrushModels);
    const auto on_leaf = [&](LeafIndex leaf) {
        if (has_models) draw_fragments_in(leaf, frame, work);
    };
    const auto on_face = [&](FaceIndex face) { draw_world_face(face, frame, work); };
    const auto is_hidden = [&](const LevelBox& box) {
        const std::optional<ScreenRectangle> rectangle = rectangle_of(box, frame.view);
        return rectangle && !work.span_buffer.may_be_free(*rectangle);
    };
    const auto is_done = [&] { return work.span_buffer.is_full(); };
    walk_front_to_back(level, frame.view.eye, frame.view.frustum, work.visible, work.walk, on_leaf, on_face, is_hidden,
                       is_done);
    walk_all_faces(level, frame.view.eye, frame.view.frustum, work.walk, on_face, is_hidden, is_done);
}

}  // namespace oblong
