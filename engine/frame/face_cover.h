#pragma once

#include <span>
#include <vector>

#include "engine/effects/sight.h"
#include "engine/frame/claims.h"

namespace oblong {

struct FrameContext;

/// A face that may leave pixels open to a thing.
struct OpenFace {
    std::span<const Span> spans;
    LinearQuantity<InverseZ> inverse_z;
    ScreenRectangle pixels;  ///< holds those of its pixels that the thing may reach
};

/// Finds what the claimed faces of a view leave open, before a thing is computed or any depth is filled. Pixels without
/// owner, such as those beside the mirror in its picture, hide everything.
class FaceCover : public Cover {
  public:
    /// The arguments must outlive it. `open` is scratch.
    FaceCover(const FrameContext& frame, const Claims& claims, std::vector<OpenFace>& open)
        : frame_(frame), claims_(claims), open_(open) {}

    bool begin(const ScreenRectangle& pixels, InverseDepth nearest, Hidden hidden) override;
    bool shows(const ScreenOutline& outline, InverseDepth nearest) const override;
    bool narrow(const ScreenOutline& outline, InverseDepth nearest) override;

  private:
    const FrameContext& frame_;
    const Claims& claims_;
    std::vector<OpenFace>& open_;  ///< of the thing begun last
    ScreenRectangle around_{};     ///< their pixels
};

}  // namespace oblong
