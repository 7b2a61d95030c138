#pragma once

#include "engine/effects/things_in_view.h"
#include "engine/frame/claims.h"

namespace oblong {

/// What the claimed faces of a view hide, asked before a thing is computed.
class FaceCover : public Cover {
  public:
    /// The arguments outlive it, and the claims do not change.
    FaceCover(const FrameContext& frame, const ViewScratch& scratch) : frame_(frame), scratch_(scratch) {}

    bool hides(const PlacedBox& place) const override;
    bool hides(const ScreenRectangle& pixels, InverseDepth nearest) const override;

  private:
    const FrameContext& frame_;
    const ViewScratch& scratch_;
};

/// 1/z of the corner of a box that is nearest along the view.
InverseDepth nearest_depth_of(const LevelBox& box, const ViewContext& view);

}  // namespace oblong
