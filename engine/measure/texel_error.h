#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/frame/frame_record.h"
#include "engine/measure/error_summary.h"
#include "engine/measure/exact.h"
#include "engine/reference/frame.h"
#include "engine/reference/view.h"
#include "engine/scene/placed_models.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// Measures frames of one camera. Levels and models must outlive it.
class TexelErrorMeter {
  public:
    /// `level`: the reference's reading of the level that was drawn; `models`: those of the scene.
    TexelErrorMeter(const reference::Level& level, std::span<const PlacedModel> models, const Camera& camera,
                    const ScreenMode& mode, bool correct_aspect = true);

    /// The error of each pixel, rows top to bottom without the framebuffer's pitch. Some milliseconds at 320x200.
    std::vector<TexelError> measure(const FrameRecord& record);

  private:
    const reference::PlaneView& plane_of(const PixelRecord& pixel);
    TexelError error_of(const PixelRecord& pixel, const reference::PlaneView& plane,
                        reference::ScreenPoint centre) const;

    const reference::Level& level_;
    std::span<const PlacedModel> models_;
    reference::Camera camera_;
    std::int32_t width_px_, height_px_;
    double diagonal_px_;
    std::unordered_map<std::int64_t, reference::PlaneView> planes_;  ///< by face and model
};

/// The face that each pixel of a view should show, by the reference; -1 where it has none or an edge is too near the
/// pixel's centre to tell. Takes as long as a hundred frames.
std::vector<std::int32_t> true_faces(const reference::Level& level, std::span<const PlacedModel> models,
                                     const Camera& camera, const ScreenMode& mode, bool correct_aspect = true);
/// How many pixels show another face.
std::int64_t wrong_faces(const FrameRecord& record, std::span<const std::int32_t> faces);

/// The engine's view for the reference renderer. `correct_aspect`: Settings::correct_aspect.
reference::View reference_view(const Camera& camera, const ScreenMode& mode, bool correct_aspect = true);
std::vector<reference::PlacedModel> reference_models(std::span<const PlacedModel> models);

}  // namespace oblong
