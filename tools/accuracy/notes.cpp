#include "tools/accuracy/notes.h"

#include <algorithm>

#include "tools/accuracy/numbers.h"

namespace oblong {

namespace {

constexpr double kSameError = 1.02;

const SettingResult& result_of(const Report& report, const Configurations::Row& row) {
    return report.results[row.index];
}

std::string percent_more(double more, double less) {
    return number_text(100 * (more / less - 1)) + " %";
}

/// What of the measurements explains that `exact`, the setting meant to be closer, is further off than `coarse`.
std::string reason_for(const Report& report, Measure measure, const Configurations::Row& coarse,
                       const Configurations::Row& exact) {
    const ErrorSummaries &a = report.results[coarse.alone].errors, &b = report.results[exact.alone].errors;
    const ErrorSummary &before = summary_of(a, measure), &after = summary_of(b, measure);
    if (measure == Measure::PixelColour || measure == Measure::LightColour)
        return "It is compared with a mean of many samples: what is sharper or smoother is not always nearer to that "
               "mean. The largest errors: " +
               number_text(before.max) + " and " + number_text(after.max) + ".";
    if (after.max < before.max)
        return "Its largest error is smaller: " + number_text(after.max) + " instead of " + number_text(before.max) +
               ". It bounds the worst and spends less on what is within the bound.";
    if (measure == Measure::Displacement && b.texels.rms < a.texels.rms)
        return "By texels it is closer: rms " + number_text(b.texels.rms) + " instead of " + number_text(a.texels.rms) +
               ". It bounds the error on the texture; where texels are many pixels wide, "
               "that lets more pixels pass.";
    if (measure == Measure::Displacement && before.rms < 1.0 / 256)
        return "Both are below 1/256 pixel, the step of the screen's coordinates: roundings that this dial does not "
               "set "
               "remain.";
    return "The largest errors: " + number_text(before.max) + " and " + number_text(after.max) +
           ". Settings of this dial are not ordered by this measure.";
}

std::string cost_text(const Report& report, const Configurations::DialRows& dial, const Configurations::Row& row) {
    if (const auto time = time_of(report, dial, row)) return microseconds_text(time->median) + " a frame here";
    return number_text(milliseconds_of(report, dial, row)) + " ms on a 486 (modelled)";
}

}  // namespace

std::vector<Tradeoff> pareto_front(std::vector<Tradeoff> all) {
    std::sort(all.begin(), all.end(), [](const Tradeoff& a, const Tradeoff& b) {
        return a.cost < b.cost || (a.cost == b.cost && a.error < b.error);
    });
    std::vector<Tradeoff> front;
    for (const Tradeoff& next : all)
        if (front.empty() || next.error < front.back().error) front.push_back(next);
    return front;
}

bool is_about_surfaces(Measure measure) {
    return measure == Measure::LightColour || measure == Measure::PixelColour;
}

std::optional<TimeSpread> time_of(const Report& report, const Configurations::DialRows& dial,
                                  const Configurations::Row& row) {
    if (!dial.dial->changes_work) return std::nullopt;
    const auto& times = report.times.settings[row.index];
    if (!times) return std::nullopt;
    return is_about_surfaces(dial.measure) && times->unlit ? *times->unlit : times->frame;
}

double milliseconds_on(Processor processor, double cycles) {
    return 1000 / frame_rate(processor, cycles);
}

double milliseconds_of(const Report& report, const Configurations::DialRows& dial, const Configurations::Row& row) {
    const CountedCost& cost = result_of(report, row).cost;
    const auto i486 = static_cast<std::size_t>(Processor::I486);
    return milliseconds_on(Processor::I486,
                           cost.cycles[i486] + (is_about_surfaces(dial.measure) ? cost.lighting_cycles[i486] : 0));
}

std::vector<std::string> notes_on_order(const Report& report, const Configurations::DialRows& dial) {
    std::vector<std::string> notes;
    for (std::size_t i = 1; i < dial.rows.size(); ++i) {
        const Configurations::Row &coarse = dial.rows[i - 1], &exact = dial.rows[i];
        const double before = summary_of(report.results[coarse.alone].errors, dial.measure).rms;
        const double after = summary_of(report.results[exact.alone].errors, dial.measure).rms;
        if (after <= before * kSameError) continue;
        notes.push_back((dial.is_below_bound ? "Alone, by its rms error " : "By its rms error ") + exact.name +
                        " is further off than " + coarse.name + ": " + number_text(after) + ", not " +
                        number_text(before) + " or less. " + reason_for(report, dial.measure, coarse, exact));
    }
    return notes;
}

const ErrorSummary& floor_of(const Report& report, const Configurations::DialRows& dial) {
    if (dial.measure != Measure::Displacement)
        return summary_of(result_of(report, dial.rows.back()).errors, dial.measure);
    return result_of(report, report.configurations.presets.back()).errors.displacement;
}

std::string note_on_floor(const Report& report, const Configurations::DialRows& dial) {
    if (dial.measure != Measure::Displacement) return "";
    const ErrorSummary& floor = floor_of(report, dial);
    const std::string note =
        "With a division a pixel, and all other dials at their most exact, rms " + number_text(floor.rms) +
        ", largest " + number_text(floor.max) +
        " are left, and no setting goes below that: texture coordinates are rounded by up to 2^-13 texel, a tenth of a "
        "pixel next to a wall whose texels are hundreds of pixels wide; and a pixel whose centre lies beyond its "
        "face's "
        "edge, by what corners are rounded by, shows the surface's last texel.";
    if (!dial.is_below_bound) return note;
    return "Around the default the blocks of perspective=bounded are off by more than most settings of this dial add, "
           "one way or the other: their order there means nothing. What the dial itself adds shows alone, at a "
           "division "
           "a pixel. " +
           note;
}

std::string summary_of_dial(const Report& report, const Configurations::DialRows& dial) {
    const Configurations::Row &first = dial.rows.front(), &last = dial.rows.back();
    const auto rms = [&](const Configurations::Row& row) {
        return number_text(summary_of(result_of(report, row).errors, dial.measure).rms);
    };
    return "From " + first.name + " to " + last.name + " the rms error goes from " + rms(first) + " to " + rms(last) +
           " (" + std::string(unit_of(dial.measure)) + "), the cost from " + cost_text(report, dial, first) + " to " +
           cost_text(report, dial, last) + ".";
}

std::vector<std::string> notes_on_presets(const Report& report) {
    std::vector<std::string> notes;
    const auto i486 = static_cast<std::size_t>(Processor::I486);
    for (const Configurations::Row& row : report.configurations.presets)
        for (const Configurations::Row& other : report.configurations.presets) {
            const auto &time = report.times.settings[row.index]->frame,
                       &other_time = report.times.settings[other.index]->frame;
            const SettingResult &mine = result_of(report, row), &theirs = result_of(report, other);
            const bool is_slower = time.low > other_time.median;
            if (theirs.errors.displacement.rms >= mine.errors.displacement.rms || !is_slower) continue;
            const double cycles = mine.cost.cycles[i486], other_cycles = theirs.cost.cycles[i486];
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
