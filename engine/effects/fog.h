#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/effects/colour_tables.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// The density of a fog as in FitzQuake's key `fog`: 32.32.
using FogDensity = Fixed<std::int64_t, 32>;

/// The depths at which the levels of a fog begin: level k where 1/z is at most entry k, but above entry k + 1.
struct FogDepths {
    /// Falls from level to level. Entry 0 is the highest number; a level that begins nowhere has the lowest.
    std::array<InverseZ, FogTable::kLevels> greatest_inverse_z{};

    std::int32_t level_at(InverseZ inverse_z) const;
};

/// Fog hides 1 - exp(-(density / 64 (z - start))^2) of what is z units deep (FitzQuake), and from `end` on no more than
/// there (DarkPlaces' mindist and maxdist). Level k begins where k - 1/2 of 63 parts are hidden. Without a density
/// above 0 everything is clear; a start below 0 counts as 0.
FogDepths make_fog_depths(FogDensity density, View start = {}, View end = View::highest());

/// Pixels that one level of fog covers.
struct FogRun {
    Span span;
    std::int32_t level;
};

/// Appends a run; one that continues the last run becomes part of it.
void append_fog_run(const FogRun& run, std::vector<FogRun>& runs);

/// Appends the runs of a span along which 1/z is linear, left to right, clear ones too: one division a run.
void append_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const FogDepths& depths,
                     std::vector<FogRun>& runs);

/// The level over the whole sky, which has no depth, for FitzQuake's key `skyfog` (0 to 256 for a share of 0 to 1,
/// most often 1/2): for FogRuns of the sky's spans.
constexpr std::int32_t sky_fog_level(std::int32_t share_256) {
    return (share_256 * (FogTable::kLevels - 1) + 128) / 256;
}

/// Colours the pixels of runs that are not clear.
void draw_fog(std::span<const FogRun> runs, const FogTable& table, Framebuffer out);

}  // namespace oblong
