#pragma once

#include <vector>

#include "engine/scene/light_styles.h"
#include "engine/scene/moving_lights.h"

namespace oblong {

struct FrameContext;
struct ViewScratch;

/// The light of a view.
struct FrameLight {
    LightStyles styles{};
    std::vector<MovingLight> moving;  ///< that may touch something in view
};

/// Finds how bright the light styles of the claimed faces are, and which moving lights touch them: none are kept if
/// they touch no face. What these change is built again when it is drawn.
void find_light(const FrameContext& frame, ViewScratch& scratch);

/// The same before any face has claimed its pixels, if that makes no difference: where no lights move. Else false.
bool find_light_beforehand(const FrameContext& frame, ViewScratch& scratch);

/// Surfaces are lit for this view again, whose light is known, after another one was drawn.
void restore_light(const FrameContext& frame, const ViewScratch& scratch);

}  // namespace oblong
