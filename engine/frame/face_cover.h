#pragma once

#include "engine/effects/things.h"
#include "engine/frame/claims.h"

namespace oblong {

/// A face that owns pixels, as used by FaceCover.
struct CoveringFace {
    InverseDepth farthest;    ///< the least 1/z, or a lower bound
    ScreenRectangle bounds;   ///< holds its spans
    const VisibleFace* face;  ///< null: the sky
    std::span<const Span> spans;
};

/// Tests what the claimed faces of a view hide, before a thing is computed. Pixels without owner, such as those beside
/// the mirror in its picture, hide everything.
class FaceCover : public Cover {
  public:
    /// The arguments must outlive it; the claims must not change. `faces` is scratch.
    FaceCover(const FrameContext& frame, const Claims& claims, std::vector<CoveringFace>& faces)
        : frame_(frame), claims_(claims), faces_(faces) {}

    bool hides(const LevelBox& box) override;
    bool hides(const ScreenRectangle& pixels, InverseDepth nearest) override;

  private:
    void list_faces();

    const FrameContext& frame_;
    const Claims& claims_;
    std::vector<CoveringFace>& faces_;
    InverseDepth farthest_ = 0;  ///< of all faces
    bool is_listed_ = false;
};

/// 1/z of the corner of a box that is nearest along the view.
InverseDepth nearest_inverse_depth_of(const LevelBox& box, const ViewContext& view);

}  // namespace oblong
