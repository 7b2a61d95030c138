#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/costs/costs.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/errors.h"
#include "tools/accuracy/frame_times.h"
#include "tools/accuracy/measured_level.h"

namespace oblong {

/// The events of one setting's frames.
struct CountedCost {
    Events drawing{};   ///< once their surfaces are lit
    Events lighting{};  ///< of building all their surfaces
    std::int64_t frames = 1;

    /// Of the mean frame.
    double of_drawing(Currency currency) const { return mean(cost_of(drawing, currency)); }
    double mean(std::int64_t sum) const { return static_cast<double>(sum) / static_cast<double>(frames); }
};

struct SettingResult {
    ErrorSummaries errors;
    std::vector<ErrorSummaries> by_level;
    CountedCost cost;
};

/// The errors of a frame as a picture: an indexed PNG.
struct HeatMap {
    std::string setting, level;
    std::size_t camera = 0;
    double rms = 0;
    std::vector<std::uint8_t> png;
};

/// A level that was measured.
struct LevelSummary {
    std::string name, about;
    std::size_t cameras = 0, faces = 0;
    double close_calls_per_mille = 0;
};

/// All measurements, and how they were made.
struct Report {
    Configurations configurations;
    std::vector<SettingResult> results;  ///< by accuracy
    FrameTimes times;
    std::vector<std::vector<HeatMap>> heat_maps;  ///< of each dial
    std::vector<LevelSummary> levels;
    std::size_t frames = 0;
    int samples_per_axis = 0;
    bool is_quick = false;
    std::string machine, compiler;
    double seconds = 0;
};

/// The extent of the measurements.
struct Effort {
    int rounds = 31;
    int samples_per_axis = 4;
    bool is_quick = false;
    std::size_t most_trials = 0;  ///< of combinations of dials
};

/// A level to measure, with the palette and colormap that it is drawn with.
struct MeasuredPlace {
    const MeasuredLevel& level;
    const Palette& palette;
    const Colormap& colormap;
};
/// Tells `progress`, if not null.
Report measure_all(const Configurations& settings, std::span<const MeasuredPlace> places, const Effort& effort,
                   map::Progress* progress = nullptr);

/// A number for readers: three significant digits without exponent, "0.0213", "375", "12,400"; "0" for 0.
std::string number_text(double value);

/// Sentences on each setting of a dial whose rms error is larger than that of the coarser setting before it by more
/// than 2 %: by how much, and why, from the measurements.
std::vector<std::string> notes_on_order(const Report& report, const Configurations::DialRows& dial);

/// The errors with a division for each pixel and all other dials at their defaults: no setting of a dial of
/// displacement has less. For other dials, the errors of the most exact setting.
const ErrorSummaries& floor_of(const Report& report, const Configurations::DialRows& dial);

/// Sentences on presets that are less exact than another one and slower here, by more than half of the spread of their
/// times.
std::vector<std::string> notes_on_presets(const Report& report);

/// accuracy.json: `dials` and `tiers` (the presets), each with settings by name, their errors and costs; then the
/// levels, and how they were measured. Costs are of a mean frame. Pictures of errors are PNG files in hexadecimal
/// digits.
std::string report_json(const Report& report);

/// accuracy.html: page.html with accuracy.json in it, which its script draws; a single file.
std::string report_page(std::string json);

/// A table of the presets in Markdown: errors and modelled frame rates, which are the same on every machine.
std::string preset_table(const Report& report);

/// A page with the text between its lines `<!-- oblong-accuracy -->` and `<!-- end -->` replaced. Throws InputError
/// that names the file if it lacks these lines.
std::string with_table(const std::string& page, const std::string& file, const std::string& table);

}  // namespace oblong
