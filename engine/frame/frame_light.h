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

/// The same before faces have claimed their pixels. False if that is too early, as lights move: then nothing is found.
bool find_light_beforehand(const FrameContext& frame, ViewScratch& scratch);

/// Lights surfaces for this view again, whose light find_light() has found, after another view was drawn.
void restore_light(const FrameContext& frame, const ViewScratch& scratch);

}  // namespace oblong
