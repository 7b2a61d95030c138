#pragma once

#include "engine/effects/things_in_view.h"
#include "engine/frame/claims.h"

namespace oblong {

/// A face that owns pixels, as a cover looks at it.
struct CoveringFace {
    InverseDepth farthest;    ///< or farther
    ScreenRectangle bounds;   ///< hold its spans
    const VisibleFace* face;  ///< null: the sky
    std::span<const Span> spans;
};

/// What the claimed faces of a view hide, asked before a thing is computed. Pixels that nothing owns, in a mirror's
/// picture those beside the mirror, hide everything.
class FaceCover : public Cover {
  public:
    /// The arguments outlive it, and the claims do not change. `faces` is scratch.
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
InverseDepth nearest_depth_of(const LevelBox& box, const ViewContext& view);

}  // namespace oblong
