#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/costs/costs.h"
#include "engine/surface/palette.h"
#include "tools/accuracy/errors.h"
#include "tools/accuracy/measured_level.h"

namespace oblong {

/// An eye as the article's page gives it: world units, degrees (pitch positive looking down).
struct ArticleEye {
    double x = 0, y = 0, z = 0, yaw = 0, pitch = 0, roll = 0, field_of_view = 90;
};

/// What the article's figures show: frames of one level by any setting, beside what is exact, with errors and costs by
/// the measures of the report (tools/accuracy). Pictures are of kMeasuredMode, a pixel 0xAABBGGRR.
class Article {
  public:
    /// From the bytes of a level and of a palette. Throws InputError.
    Article(std::span<const std::uint8_t> level, std::span<const std::uint8_t> palette);

    /// A value of all_dials()[dial].
    void set_dial(std::size_t dial, std::int32_t value);
    /// Whether pictures are drawn for tall pixels; truths but displacement's are for these alone.
    void correct_aspect(bool corrects);
    /// False, and without effect, for an eye in a wall or outside.
    bool look_from(const ArticleEye& eye);

    /// Draws the frame, and counts what it costs once its surfaces are lit.
    const std::vector<std::uint32_t>& draw();
    /// What the view should show: each pixel the colour at its centre, by the renderer in doubles.
    const std::vector<std::uint32_t>& draw_reference();
    /// The frame's errors by a measure as a map. The first of a view but displacement takes as long as hundreds of
    /// frames.
    const std::vector<std::uint32_t>& draw_errors(Measure measure);

    /// JSON: of draw(), the instructions of both builds and the cycles of kProcessors; of draw_errors(), rms, p99 and
    /// max.
    std::string figures() const;
    /// JSON: what there is to choose: dials with their settings and measures, presets, measures, processors.
    static std::string choices();

  private:
    void paint(std::span<const std::uint8_t> pixels, const Palette& palette);
    const FrameTruth& truth();

    Palette palette_;
    reference::Palette exact_palette_;
    Colormap colormap_;
    MeasuredLevel level_;
    LevelFrames frames_{level_, colormap_};
    Accuracy accuracy_;
    Camera camera_;
    bool corrects_aspect_ = true;
    std::optional<FrameTruth> truth_;  ///< of the camera, once it was asked for
    Events events_{};
    ErrorSummary errors_;
    std::vector<std::uint32_t> shown_;
};

}  // namespace oblong
