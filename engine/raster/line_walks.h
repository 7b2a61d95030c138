#pragma once

#include <array>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/fixed/root.h"
#include "engine/fixed/wide.h"
#include "engine/view/screen.h"

// The four line algorithms. Each is a walk: it steps along the major axis of the screen, one pixel at a time, and gives
// the coordinate on the minor axis. minor_at(n) is minor() after n steps; it is monotone, so that lines can be clipped
// with it. `Number` is std::int64_t, or a type that counts operations.

namespace oblong {

/// A line between two pixels; the order of its ends does not depend on the order of the arguments.
struct LinePath {
    bool is_steep = false;        ///< the major axis is y
    std::int64_t major = 0;       ///< of the first pixel
    std::int64_t steps = 0;       ///< to the last pixel: 0 to 2^32 - 1
    std::int64_t minor = 0;       ///< of the first pixel
    std::int64_t minor_rise = 0;  ///< to the last pixel
};

/// The path whose major axis is the longer one (x if equal); or always x.
constexpr LinePath make_line_path(PixelPosition from, PixelPosition to, bool always_along_x) {
    const std::int64_t dx = std::int64_t{to.column} - from.column, dy = std::int64_t{to.row} - from.row;
    const bool is_steep = !always_along_x && (dy < 0 ? -dy : dy) > (dx < 0 ? -dx : dx);
    const std::int64_t steps = is_steep ? dy : dx, rise = is_steep ? dx : dy;
    const bool is_swapped = steps < 0 || (steps == 0 && rise < 0);
    const PixelPosition first = is_swapped ? to : from;
    return {is_steep, is_steep ? first.row : first.column, is_swapped ? -steps : steps,
            is_steep ? first.column : first.row, is_swapped ? -rise : rise};
}

/// Rise over steps, 16.16, rounded to nearest; 0 for a line of one pixel.
template <class Number>
constexpr Number line_slope_16(const LinePath& path) {
    if (path.steps == 0) return Number{0};
    const std::int64_t half = path.minor_rise < 0 ? -path.steps : path.steps;
    return Number{path.minor_rise * (1 << 17) + half} / Number{2 * path.steps};
}

/// y = m x + b, b at the line's start: one multiplication a pixel. For paths along x.
template <class Number>
class NaiveWalk {
  public:
    explicit constexpr NaiveWalk(const LinePath& path)
        : slope_16_(line_slope_16<Number>(path)), start_16_(path.minor * 65536 + 32768) {}

    constexpr Number minor_at(Number step) const { return floor_shift(slope_16_ * step + start_16_, 16); }
    constexpr void move_to(Number step) { step_ = step; }
    constexpr Number minor() const { return minor_at(step_); }
    constexpr void next() { step_ = step_ + Number{1}; }

  private:
    Number slope_16_, start_16_, step_{0};  ///< the start is moved half a pixel, so that the floor rounds
};

/// Digital differential analyser: adds the slope at each step. The slope is rounded by up to 2^-17 pixel, and the error
/// grows by that at each step: one pixel after 2^17.
template <class Number>
class DdaWalk {
  public:
    explicit constexpr DdaWalk(const LinePath& path)
        : slope_16_(line_slope_16<Number>(path)), start_16_(path.minor * 65536 + 32768), minor_16_(start_16_) {}

    constexpr Number minor_at(Number step) const { return floor_shift(slope_16_ * step + start_16_, 16); }
    constexpr void move_to(Number step) { minor_16_ = slope_16_ * step + start_16_; }
    constexpr Number minor() const { return floor_shift(minor_16_, 16); }
    constexpr void next() { minor_16_ = minor_16_ + slope_16_; }

  private:
    Number slope_16_, start_16_, minor_16_;
};

/// Bresenham's algorithm: the pixel nearest to the line, by additions. With dx steps and a rise of dy, the line is at
/// n |dy| / dx after n steps. If k pixels were climbed so far,
///     error = 2 n |dy| - dx - 2 k dx
/// reaches 0 when the next pixel is nearer. A tie goes to the larger coordinate, so the error of a falling line is 1
/// lower. J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 4 (1965).
/// Starting the line at any step: Kuzmin, "Bresenham's Line Generation Algorithm with Built-in Clipping", Computer
/// Graphics Forum 14 (1995).
template <class Number>
class BresenhamWalk {
  public:
    explicit constexpr BresenhamWalk(const LinePath& path)
        : steps_2_(2 * path.steps),
          rise_2_(path.minor_rise < 0 ? -2 * path.minor_rise : 2 * path.minor_rise),
          direction_(path.minor_rise < 0 ? -1 : 1),
          first_error_(-path.steps - (path.minor_rise < 0)),
          first_minor_(path.minor),
          error_(first_error_),
          minor_(first_minor_) {}

    constexpr Number minor_at(Number step) const { return first_minor_ + direction_ * climbed_at(step).pixels; }
    constexpr void move_to(Number step) {
        const Climbed climbed = climbed_at(step);
        minor_ = first_minor_ + direction_ * climbed.pixels;
        error_ = first_error_ + climbed.rest_2;
    }
    constexpr Number minor() const { return minor_; }
    /// Returns whether it climbed a pixel.
    constexpr bool next() {
        error_ = error_ + rise_2_;
        if (error_ < Number{0}) return false;
        minor_ = minor_ + direction_;
        error_ = error_ - steps_2_;
        return true;
    }
    /// The line minus minor(), in the line's direction of climb; 2 dx is one pixel.
    constexpr Number offset_2() const { return error_ - first_error_; }

  private:
    struct Climbed {
        Number pixels, rest_2;
    };

    /// 2 n |dy| = 2 dx pixels + rest. The product may have 66 bits; the rest has 34 and is exact modulo 2^64.
    constexpr Climbed climbed_at(Number step) const {
        if (step == 0) return {0, 0};
        const Number pixels = mul_div(step, rise_2_, steps_2_, Rounding::Floor);
        const auto wrapped = [](Number value) { return static_cast<std::uint64_t>(value); };
        const auto rest = static_cast<Number>(wrapped(step) * wrapped(rise_2_) - wrapped(pixels) * wrapped(steps_2_));
        if (rest + first_error_ < 0) return {pixels, rest};
        return {pixels + 1, rest - steps_2_};
    }

    Number steps_2_, rise_2_, direction_, first_error_, first_minor_, error_, minor_;
};

/// The coverage of a pixel, of 256, by a line one pixel wide at a distance of i / 16 pixel from its centre: the volume
/// of a cone of radius 1 over the line. tests/raster/lines_test.cpp integrates it numerically.
inline constexpr std::array<std::uint8_t, 25> kLineCoverage_256{
    200, 198, 195, 188, 180, 169, 157, 143, 128, 113, 98, 84, 71, 58, 47, 37, 28, 21, 14, 9, 5, 3, 1, 0, 0};

/// Gupta and Sproull's algorithm: Bresenham's walk with the line's distance from the pixel and its two neighbours, also
/// by additions. Pixels farther off, of which a diagonal would cover up to 8 %, are left out, and the ends are cut off
/// along a row or column. S. Gupta, R. F. Sproull, "Filtering Edges for Gray-Scale Displays", SIGGRAPH 1981; Foley et
/// al., "Computer Graphics", 3.17.
template <class Number>
class GuptaSproullWalk {
  public:
    explicit constexpr GuptaSproullWalk(const LinePath& path) : walk_(path) {
        const std::int64_t scale = distance_scale(path);
        const std::int64_t rise = path.minor_rise < 0 ? -path.minor_rise : path.minor_rise;
        side_ = path.minor_rise < 0 ? -1 : 1;
        scale_ = Number{scale};
        rise_60_ = Number{2 * rise * scale};
        pixel_60_ = Number{path.steps == 0 ? std::int64_t{1} << 60 : 2 * path.steps * scale};
    }

    constexpr Number minor_at(Number step) const { return walk_.minor_at(step); }
    constexpr void move_to(Number step) {
        walk_.move_to(step);
        distance_60_ = walk_.offset_2() * scale_;
    }
    constexpr Number minor() const { return walk_.minor(); }
    constexpr void next() {
        distance_60_ = distance_60_ + rise_60_;
        if (walk_.next()) distance_60_ = distance_60_ - pixel_60_;
    }

    struct Neighbours {
        std::array<Number, 3> distance_60;  ///< at minor() - 1, minor(), minor() + 1
    };
    /// Distances from the line, pixels; negative on one side.
    constexpr Neighbours neighbours() const {
        const Number before = distance_60_ + pixel_60_, after = distance_60_ - pixel_60_;
        if (side_ < 0) return {{after, distance_60_, before}};
        return {{before, distance_60_, after}};
    }

    /// kLineCoverage_256 of a distance.
    static constexpr std::int32_t coverage_256(std::int64_t distance_60) {
        const std::int64_t sixteenths =
            rounded_shift(distance_60 < 0 ? -distance_60 : distance_60, 56, Rounding::NearestHalfUp);
        return sixteenths < 24 ? item(kLineCoverage_256, sixteenths) : 0;
    }

  private:
    /// 2^60 / (2 sqrt(dx^2 + dy^2)): converts BresenhamWalk::offset_2() to a distance. Lengths are scaled to 31 bits
    /// before squaring.
    static constexpr std::int64_t distance_scale(const LinePath& path) {
        if (path.steps == 0) return 0;
        const int shift = 30 - log2_floor(static_cast<std::uint64_t>(path.steps));  // -1 to 30
        const auto scaled = [shift](std::int64_t way) {
            return static_cast<std::uint64_t>((way < 0 ? -way : way) * (std::int64_t{1} << (shift + 1)) / 2);
        };
        const std::uint64_t dx = scaled(path.steps), dy = scaled(path.minor_rise);
        return mul_div(std::int64_t{1} << 58, std::int64_t{1} << (shift + 1), integer_root(dx * dx + dy * dy));
    }

    BresenhamWalk<Number> walk_;
    std::int32_t side_ = 1;
    Number scale_{0}, rise_60_{0}, pixel_60_{0}, distance_60_{0};
};

}  // namespace oblong
