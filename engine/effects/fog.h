#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/effects/colour_tables.h"
#include "engine/math/vec.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"

namespace oblong {

/// The density in FitzQuake's key `fog`: 32.32.
using FogDensity = Fixed<std::int64_t, 32>;

/// The depths at which the levels of a fog begin: a pixel has level k if its 1/z is at most entry k, but above entry k
/// + 1.
struct FogDepths {
    /// Descending. Entry 0 is the format's highest number; a level that is never reached has the lowest.
    std::array<InverseZ, FogTable::kLevels> greatest_inverse_z{};

    /// Ascending: the greatest depth whose rounded 1/z is above entry k.
    std::array<View, FogTable::kLevels> greatest_before{};

    std::int32_t level_at(InverseZ inverse_z) const;
    /// level_at() of the depth's rounded 1/z, without a division; fast if `guess` is near.
    std::int32_t level_at(View depth, std::int32_t guess) const {
        std::int32_t level = guess;
        while (level > 0 && depth <= greatest_before[as_size(level)]) --level;
        while (level + 1 < FogTable::kLevels && depth > greatest_before[as_size(level) + 1]) ++level;
        return level;
    }
};

/// At depth z fog hides a share of 1 - exp(-(density / 64 (z - start))^2) (FitzQuake), constant from `end` on (`start`
/// and `end` are DarkPlaces' mindist and maxdist). Level k begins where the share is (k - 1/2) / 63. Without a density
/// above 0 everything is clear; a negative start counts as 0.
FogDepths make_fog_depths(FogDensity density, View start = {}, View end = View::highest());

/// Pixels with one level of fog: a span of the screen, in half its size, as fog may fill the screen with runs.
struct FogRun {
    std::int16_t y, first, end, level;

    FogRun(const Span& span, std::int32_t level_of_fog)
        : y(static_cast<std::int16_t>(span.y)),
          first(static_cast<std::int16_t>(span.first)),
          end(static_cast<std::int16_t>(span.end)),
          level(static_cast<std::int16_t>(level_of_fog)) {}
    Span span() const { return {y, first, end}; }
};
static_assert(kLargestMode_px <= std::numeric_limits<std::int16_t>::max());

/// The number of pixels in runs.
std::int64_t pixels_of(std::span<const FogRun> runs);

/// Appends a run, or extends the last one if the run continues it.
void append_fog_run(const FogRun& run, std::vector<FogRun>& runs);

/// Appends the runs of a span with linear 1/z, left to right, including clear ones; one division a run.
void append_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const FogDepths& depths,
                     std::vector<FogRun>& runs);

/// The level of the whole sky, which has no depth, from FitzQuake's key `skyfog` (0 to 256 for a share of 0 to 1).
constexpr std::int32_t sky_fog_level(std::int32_t share_256) {
    return (share_256 * (FogTable::kLevels - 1) + 128) / 256;
}

void draw_fog(std::span<const FogRun> runs, const FogTable& table, Framebuffer out);

/// Low fog (DarkPlaces): none above `top`, full density below top - fade_depth, linear between. A negative fade depth
/// counts as 0.
struct HeightFog {
    World top, fade_depth;
};

/// The same relative to an eye.
struct HeightFogView {
    View top_above_eye, fade_depth;
    InverseZ half_inverse_fade;          ///< 1 / (2 fade_depth)
    View density_above_eye;              ///< the integral of the density from the top down to the eye
    LinearQuantity<DirectionPart> rise;  ///< a ray's climb for each unit of depth
};

HeightFogView make_height_fog_view(const HeightFog& fog, const Vec3<World>& eye, const ViewDirections& directions);

/// Whether a pixel at this depth is certainly clear, seen from above the fog.
bool is_clear(std::int32_t column, std::int32_t row, InverseZ inverse_z, const HeightFogView& view);
/// The same for every pixel of a rectangle on a plane. False if 1/z is not usable at the corners, which may be outside
/// the polygon.
bool is_clear(const ScreenRectangle& pixels, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view);

/// Appends the runs of a span with linear 1/z, left to right, including clear ones. The level depends on the length of
/// the ray in fog, weighted by density: a ray wholly in full fog has the level of distance fog at its depth. Levels are
/// computed every 16 pixels; where two differ, bisection finds where they change. They are wrong only where a level
/// changes and changes back within 16 pixels.
void append_height_fog_runs(const Span& span, const LinearQuantity<InverseZ>& inverse_z, const HeightFogView& view,
                            const FogDepths& depths, std::vector<FogRun>& runs);

}  // namespace oblong
