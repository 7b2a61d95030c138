#include "engine/fixed/sine_methods.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/sine_series.h"
#include "engine/fixed/trig.h"

namespace oblong {

namespace {

using namespace detail;

constexpr int kQuarterEntries = 1024;

/// Sines of a quarter turn in 1,024 steps, both ends included, 2.30.
constexpr auto kQuarterSines = [] {
    std::array<std::int32_t, kQuarterEntries + 1> table{};
    for (int i = 0; i <= kQuarterEntries; ++i) {
        const std::int64_t sine_62 = quarter_sine_series_62(i * (kQuarterHalves / kQuarterEntries));
        item(table, i) = static_cast<std::int32_t>(rounded_shift(sine_62, 32, Rounding::NearestHalfUp));
    }
    return table;
}();

constexpr int kTurnEntries = 256;

/// Sines of a whole turn in 256 steps.
constexpr auto kTurnSines = [] {
    constexpr int kHalf = kTurnEntries / 2, kSpacing = 4 * kQuarterEntries / kTurnEntries;
    std::array<std::int32_t, kTurnEntries> table{};
    for (int i = 0; i < kTurnEntries; ++i) {
        const int in_half = i % kHalf;
        const std::int32_t size = item(kQuarterSines, std::min(in_half, kHalf - in_half) * kSpacing);
        item(table, i) = i < kHalf ? size : -size;
    }
    return table;
}();

/// Entry `index` modulo 256.
std::int32_t entry(int index) {
    return kTurnSines[as_size(index) % kTurnEntries];
}

std::int32_t nearest_entry(Angle angle) {
    return entry((angle.bam + 128) >> 8);
}

std::int32_t between_entries(Angle angle) {
    const int index = angle.bam >> 8, along = angle.bam & 0xff;
    const std::int64_t rise = std::int64_t{entry(index + 1)} - entry(index);
    return static_cast<std::int32_t>(entry(index) + floor_shift(rise * along, 8));
}

std::int32_t between_quarter_entries(Angle angle) {
    const int in_half = angle.bam & 0x7fff, in_quarter = std::min(in_half, 0x8000 - in_half);
    const auto index = as_size(in_quarter >> 4);
    const int along = in_quarter & 15;
    std::int32_t size = kQuarterSines[index];
    if (along != 0) size += ((kQuarterSines[index + 1] - size) * along) >> 4;
    return angle.bam < kHalfTurn.bam ? size : -size;
}

constexpr int kMostRotations = 30;

/// arctan 2^-i in 2^-32 of a turn, by x - x^3 / 3 + x^5 / 5 - ...
constexpr auto kArctangents = [] {
    constexpr std::int64_t kTurnsPerRadian64 = 2935890503282001226;  // 2^64 / (2 pi)
    std::array<std::int32_t, kMostRotations> table{1 << 29};         // arctan 1 is an eighth of a turn
    for (int i = 1; i < kMostRotations; ++i) {
        std::int64_t radians_62 = 0;
        for (int n = 1; i * n <= 62; n += 2) radians_62 += (n % 4 == 1 ? 1 : -1) * ((kOne62 >> (i * n)) / n);
        item(table, i) = static_cast<std::int32_t>(mul_shift(radians_62, kTurnsPerRadian64, 62 + 64 - 32));
    }
    return table;
}();

/// The product of cos(arctan 2^-i) over all i, 2.30: compensates the rotations' lengthening of the vector. Equal for
/// all counts of 16 rotations or more.
constexpr std::int32_t kShortened = 652032874;

/// Volder's CORDIC: rotates (1, 0) by the angle, a sum of signed arctangents of powers of two.
std::int32_t cordic_sine(Angle angle, int rotations) {
    std::int32_t x = kShortened, y = 0;
    std::int32_t rest = (angle.bam & 0x3fff) << 16;
    for (int i = 0; i < rotations; ++i) {
        const std::int32_t sign = rest >= 0 ? 1 : -1;
        const std::int32_t turned_x = x - sign * floor_shift(y, i);
        y += sign * floor_shift(x, i);
        x = turned_x;
        rest -= sign * item(kArctangents, i);
    }
    const std::int32_t size = (angle.bam & kQuarterTurn.bam) == 0 ? y : x;
    return angle.bam < kHalfTurn.bam ? size : -size;
}

std::int32_t raw_sine(Angle angle, SineMethod method) {
    switch (method) {
        case SineMethod::Nearest256:
            return nearest_entry(angle);
        case SineMethod::Lerp256:
            return between_entries(angle);
        case SineMethod::Quarter1024Lerp:
            return between_quarter_entries(angle);
        case SineMethod::Cordic16:
            return cordic_sine(angle, 16);
        case SineMethod::Cordic30:
            return cordic_sine(angle, 30);
        case SineMethod::NearestStep:
            break;
    }
    return sine(angle).raw;
}

}  // namespace

Unit sine(Angle angle, SineMethod method) {
    return Unit::from_raw(raw_sine(angle, method));
}

Unit cosine(Angle angle, SineMethod method) {
    return sine(angle + kQuarterTurn, method);
}

}  // namespace oblong
