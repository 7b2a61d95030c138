#pragma once

#include "engine/accuracy/accuracy.h"
#include "engine/frame/frame.h"
#include "engine/frame/mirror_pass.h"
#include "engine/frame/texture_spans.h"
#include "engine/view/texture_gradients.h"
#include "engine/view/view_context.h"

namespace oblong {

class SharedDrawing;

/// Everything that is constant while a frame is drawn.
struct FrameContext {
    const Scene& scene;
    const Settings& settings;
    ViewContext view;
    InverseProjection inverse_projection;
    SpanTexturing texturing;
    Framebuffer out;
    std::int32_t eye_contents = contents::kEmpty;  ///< of the leaf that the eye is in
    const MirrorView* mirror = nullptr;            ///< the frame is what this mirror shows
    std::vector<WalkLimit> limits;                 ///< parts of the level beyond them are left out
    SharedDrawing* shared = nullptr;               ///< draws it by several threads; null: one

    const Accuracy& accuracy() const { return settings.accuracy; }
    bool allows(Effect effect) const { return settings.allowed_effects.has(effect); }
};

}  // namespace oblong
