#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/frame/claims.h"
#include "engine/frame/frame_counts.h"
#include "engine/methods/painter.h"
#include "engine/methods/ray_casting.h"

namespace oblong {

/// How a frame finds out which face owns which pixel. All but the span buffer are there to be compared with it.
enum class HiddenSurfaces : std::uint8_t {
    SpanBuffer,     ///< visibility/span_buffer.h: the engine's
    ZBuffer,        ///< methods/z_buffer.h
    Painter,        ///< methods/painter.h: back to front by the tree
    PainterSorted,  ///< by the farthest z of each face: wrong for some scenes
    PainterMean,    ///< by the mean of its nearest and farthest z: wrong for others
    RayCasting      ///< methods/ray_casting.h
};
inline constexpr std::array<std::string_view, 6> kHiddenSurfaceNames{"span-buffer",    "z-buffer",     "painter",
                                                                     "painter-sorted", "painter-mean", "ray-casting"};

/// Whether a method works in parallel views too.
constexpr bool serves_parallel_views(HiddenSurfaces method) {
    return method == HiddenSurfaces::SpanBuffer || method == HiddenSurfaces::Painter;
}

/// Claims the pixels of frames by one of these methods (FrameWorkspace::claimer). Faces of the first walk are kept, all
/// of them scanned; then the method finds the owner of each pixel, and what has none is left to the second walk. A
/// parallel view is drawn with the span buffer whatever the method.
class HiddenSurfaceMethod final : public FaceClaimer {
  public:
    explicit HiddenSurfaceMethod(HiddenSurfaces method) : method_(method) {}

    void claim(const FrameContext& frame, ViewScratch& scratch) override;

    HiddenSurfaces method() const { return method_; }
    /// What the frame drawn last took, without what is in mirrors; all 0 for the span buffer.
    const HiddenSurfaceCounts& counts() const { return counts_; }
    /// What the view drawn last was worked out from.
    const ScannedFaces& scanned() const { return scanned_; }
    const PixelOwners& owners() const { return owners_; }
    const std::vector<InverseZ>& depths() const { return depths_; }  ///< of each pixel's owner; of the z-buffer alone
    const RayTargets& targets() const { return targets_; }           ///< of rays alone

  private:
    void keep(const VisibleFace& face, const FrameContext& frame, ViewScratch& scratch);
    void find_owners(const FrameContext& frame);
    void paint_by(SortDepth depth);
    void claim_owned(const FrameContext& frame, ViewScratch& scratch);
    void claim_runs(const ScannedFace& face, std::span<const OwnedRun> runs, const FrameContext& frame,
                    ViewScratch& scratch);

    HiddenSurfaces method_;
    HiddenSurfaceCounts counts_;
    ScannedFaces scanned_;
    PixelOwners owners_;
    std::vector<InverseZ> depths_;
    RayTargets targets_;
};

/// Its counts by name, for reports.
std::vector<NamedCount> named_counts(const HiddenSurfaceCounts& counts);

}  // namespace oblong
