#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/frame/frame_record.h"
#include "engine/scene/placed_models.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"
#include "tools/measure/exact.h"
#include "tools/reference/frame.h"
#include "tools/reference/view.h"

namespace oblong {

/// A summary of errors, none negative: the root mean square, the 99th percentile (the least error that 99 % of them do
/// not exceed) and the largest. All 0 if there are none.
struct ErrorSummary {
    std::int64_t count = 0;
    double rms = 0, p99 = 0, max = 0;
};

ErrorSummary summarize_errors(std::vector<float> errors);

/// How far the texel shown at a pixel is from its exact place. Both are negative if there is nothing to measure: sky,
/// one colour, no face, or a plane that is not in front of the eye there.
struct TexelError {
    /// From the pixel's centre to the place on the screen where the texel belongs, pixels; at most the picture's
    /// diagonal, which also stands for a texel behind the eye.
    float pixels = -1;
    /// From the texel that belongs at the pixel's centre to the one shown, texels of mip level 0.
    float texels = -1;
    bool is_measured() const { return pixels >= 0; }
};

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

/// Of the pixels that were measured.
ErrorSummary summarize_pixels(std::span<const TexelError> errors);

/// The engine's view for the reference renderer. `correct_aspect`: Settings::correct_aspect.
reference::View reference_view(const Camera& camera, const ScreenMode& mode, bool correct_aspect = true);
std::vector<reference::PlacedModel> reference_models(std::span<const PlacedModel> models);

}  // namespace oblong
