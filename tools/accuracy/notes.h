#pragma once

#include <string>
#include <vector>

#include "tools/accuracy/report.h"

namespace oblong {

/// Error and cost of a setting that can be compared: to have less of one takes more of the other.
struct Tradeoff {
    std::size_t index = 0;  ///< the setting, into Configurations::accuracies
    double error = 0, cost = 0;
};

/// Those than which no other has both a smaller error and a lower cost, by rising cost.
std::vector<Tradeoff> pareto_front(std::vector<Tradeoff> all);

/// Sentences on each setting of a dial whose rms error is larger than that of the coarser one before it by more than 2
/// %: how much, and what of the measurements explains it.
std::vector<std::string> notes_on_order(const Report& report, const Configurations::DialRows& dial);

/// The error that is left at a division a pixel and the defaults of all other dials: what no setting of a dial of
/// displacement goes below. Of other dials that of their most exact setting.
const ErrorSummary& floor_of(const Report& report, const Configurations::DialRows& dial);

/// A sentence on that floor, and on the bound that hides what a dial adds; empty where neither is of any interest.
std::string note_on_floor(const Report& report, const Configurations::DialRows& dial);

/// Sentences on what a dial's settings cost and how far off they are, from the first to the last.
std::string summary_of_dial(const Report& report, const Configurations::DialRows& dial);

/// Sentences on presets that are further off than another one and slower here, by more than half of their times spread.
std::vector<std::string> notes_on_presets(const Report& report);

/// The time of a frame, ns: of one whose surfaces are all built, for a dial of light or mip levels. None if modelled.
std::optional<TimeSpread> time_of(const Report& report, const Configurations::DialRows& dial,
                                  const Configurations::Row& row);
/// Milliseconds that a 486 at 66 MHz takes for the same frame: modelled.
double milliseconds_of(const Report& report, const Configurations::DialRows& dial, const Configurations::Row& row);
double milliseconds_on(Processor processor, double cycles);
/// Whether a dial's cost lies in building lit surfaces.
bool is_about_surfaces(Measure measure);

}  // namespace oblong
