#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "engine/base/table.h"
#include "tools/accuracy/report.h"

namespace oblong {

namespace {

constexpr double kSameError = 1.02;

std::string with_commas(std::string digits) {
    for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
    return digits;
}

const SettingResult& result_of(const Report& report, const Configurations::Row& row) {
    return report.results[row.index];
}

std::string percent_more(double more, double less) {
    return number_text(100 * (more / less - 1)) + " %";
}

/// Explains, from the measurements, why `exact`, meant to be closer, has a larger error than `coarse`.
std::string reason_for(const Report& report, Measure measure, const Configurations::Row& coarse,
                       const Configurations::Row& exact) {
    const ErrorSummaries &a = report.results[coarse.alone].errors, &b = report.results[exact.alone].errors;
    const ErrorSummary &before = item(a, measure), &after = item(b, measure);
    const double texels_before = item(a, Measure::Texels).rms, texels_after = item(b, Measure::Texels).rms;
    if (measure == Measure::PixelColour || measure == Measure::LightColour)
        return "It is compared with a mean of many samples: what is sharper or smoother is not always nearer to that "
               "mean. The largest errors: " +
               number_text(before.max) + " and " + number_text(after.max) + ".";
    if (after.max < before.max)
        return "Its largest error is smaller: " + number_text(after.max) + " instead of " + number_text(before.max) +
               ". It bounds the worst and spends less on what is within the bound.";
    if (measure == Measure::Displacement && texels_after < texels_before)
        return "By texels it is closer: rms " + number_text(texels_after) + " instead of " +
               number_text(texels_before) +
               ". It bounds the error on the texture; where texels are many pixels wide, "
               "that lets more pixels pass.";
    if (measure == Measure::Displacement && before.rms < 1.0 / 256)
        return "Both are below 1/256 pixel, the step of the screen's coordinates: roundings that this dial does not "
               "set "
               "remain.";
    return "The largest errors: " + number_text(before.max) + " and " + number_text(after.max) +
           ". Settings of this dial are not ordered by this measure.";
}

}  // namespace

std::string number_text(double value) {
    if (value == 0) return "0";
    const double size = std::abs(value);
    if (size < 1e-5) return "below 0.00001";
    char rounded[16];
    std::snprintf(rounded, sizeof rounded, "%.2e", size);  // 9.999 has two digits before the point, not one
    const int digits = std::atoi(rounded + 5) + 1;
    if (digits >= 3) {
        const double unit = std::pow(10, digits - 3);
        const std::string whole =
            std::to_string(static_cast<long long>(std::llround(size / unit) * std::llround(unit)));
        return (value < 0 ? "-" : "") + with_commas(whole);
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", 3 - digits, value);
    return text;
}

std::vector<std::string> notes_on_order(const Report& report, const Configurations::DialRows& dial) {
    std::vector<std::string> notes;
    for (std::size_t i = 1; i < dial.rows.size(); ++i) {
        const Configurations::Row &coarse = dial.rows[i - 1], &exact = dial.rows[i];
        const double before = item(report.results[coarse.alone].errors, dial.measure).rms;
        const double after = item(report.results[exact.alone].errors, dial.measure).rms;
        if (after <= before * kSameError) continue;
        notes.push_back((dial.is_below_bound ? "Alone, by its rms error " : "By its rms error ") + exact.name +
                        " is further off than " + coarse.name + ": " + number_text(after) + ", not " +
                        number_text(before) + " or less. " + reason_for(report, dial.measure, coarse, exact));
    }
    return notes;
}

const ErrorSummaries& floor_of(const Report& report, const Configurations::DialRows& dial) {
    const bool is_placed = dial.measure == Measure::Displacement;
    return result_of(report, is_placed ? report.configurations.presets.back() : dial.rows.back()).errors;
}

std::vector<std::string> notes_on_presets(const Report& report) {
    std::vector<std::string> notes;
    for (const Configurations::Row& row : report.configurations.presets)
        for (const Configurations::Row& other : report.configurations.presets) {
            const auto &time = report.times.settings[row.index]->frame,
                       &other_time = report.times.settings[other.index]->frame;
            const SettingResult &mine = result_of(report, row), &theirs = result_of(report, other);
            const bool is_slower = time.low > other_time.median;
            const auto error_of = [](const SettingResult& result) {
                return item(result.errors, Measure::Displacement).rms;
            };
            if (error_of(theirs) >= error_of(mine) || !is_slower) continue;
            const double cycles = mine.cost.of_drawing(Currency::Cycles486),
                         other_cycles = theirs.cost.of_drawing(Currency::Cycles486);
            const std::string on_486 =
                cycles < other_cycles ? "on a 486 the other would take " + percent_more(other_cycles, cycles) + " more"
                                      : "on a 486 it would take " + percent_more(cycles, other_cycles) + " more, too";
            notes.push_back(row.name + " is further off than " + other.name + " and takes " +
                            percent_more(time.median, other_time.median) + " more time on this machine; " + on_486 +
                            ".");
        }
    return notes;
}

}  // namespace oblong
