#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/frame/claim_faces.h"
#include "engine/frame/frame_counts.h"
#include "engine/methods/pixel_owners.h"

namespace oblong {

/// How a frame finds the owner face of each pixel. The engine uses the span buffer; the others are for comparison.
enum class HiddenSurfaces : std::uint8_t {
    SpanBuffer,     ///< visibility/span_buffer.h: the engine's
    ZBuffer,        ///< this and the following: methods/pixel_owners.h
    Painter,        ///< back to front by the tree
    PainterSorted,  ///< by the farthest z of each face: wrong for some scenes
    PainterMean,    ///< by the mean of its nearest and farthest z: wrong for others
    RayCasting
};
inline constexpr std::array<std::string_view, 6> kHiddenSurfaceNames{"span-buffer",    "z-buffer",     "painter",
                                                                     "painter-sorted", "painter-mean", "ray-casting"};

/// Whether a method works in parallel views too.
constexpr bool serves_parallel_views(HiddenSurfaces method) {
    return method == HiddenSurfaces::SpanBuffer || method == HiddenSurfaces::Painter;
}

/// Claims the pixels of frames by one of these methods (FrameWorkspace::claimer). All faces of the first walk are
/// scanned and kept; then the method finds the owner of each pixel; pixels without an owner are left to the second
/// walk. A parallel view is drawn with the span buffer whatever the method.
class HiddenSurfaceMethod final : public FaceClaimer {
  public:
    explicit HiddenSurfaceMethod(HiddenSurfaces method) : method_(method) {}

    void claim(const FrameContext& frame, ViewScratch& scratch) override;

    HiddenSurfaces method() const { return method_; }
    /// The work of the last frame, without its mirrors; all 0 for the span buffer.
    const HiddenSurfaceCounts& counts() const { return counts_; }
    /// The faces of the last view.
    const ScannedFaces& scanned() const { return scanned_; }
    const PixelOwners& owners() const { return owners_; }
    const std::vector<InverseZ>& depths() const { return depths_; }  ///< of each pixel's owner; z-buffer only
    const RayTargets& targets() const { return targets_; }           ///< ray casting only

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

/// The counts by name, for reports.
std::vector<NamedCount> named_counts(const HiddenSurfaceCounts& counts);

}  // namespace oblong
