#pragma once

#include "engine/effects/things.h"
#include "engine/frame/claims.h"

namespace oblong {

/// Tests what the claimed faces of a view hide, before a thing is computed. Pixels without owner, such as those beside
/// the mirror in its picture, hide everything.
class FaceCover : public Cover {
  public:
    /// The arguments must outlive it.
    FaceCover(const FrameContext& frame, const Claims& claims) : frame_(frame), claims_(claims) {}

    bool hides(const LevelBox& box) override;
    bool hides(const ScreenRectangle& pixels, InverseDepth nearest) override;

  private:
    const FrameContext& frame_;
    const Claims& claims_;
};

/// 1/z of the corner of a box that is nearest along the view.
InverseDepth nearest_inverse_depth_of(const LevelBox& box, const ViewContext& view);

}  // namespace oblong
