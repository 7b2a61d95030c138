#pragma once

#include <algorithm>
#include <cstddef>

/// Checks the arithmetic for overflow: note_range names the largest intermediate values. The build with
/// OBLONG_RECORD_RANGES (tests/ranges) records their ranges, to show how many bits are left; in other builds note_range
/// does nothing.
namespace oblong {

/// A string as a template argument.
template <std::size_t Size>
struct RangeName {
    char text[Size];
    consteval RangeName(const char (&literal)[Size]) { std::copy_n(literal, Size, text); }
};

}  // namespace oblong

#if defined(OBLONG_RECORD_RANGES)

#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace oblong {

struct SeenRange;

/// All quantities of a program, recorded or not. This is the engine's only global variable, and exists in the recording
/// build only: passing a recorder through every signature would change the measured code.
inline std::vector<const SeenRange*>& recorded_ranges() {
    static std::vector<const SeenRange*> ranges;
    return ranges;
}

struct SeenRange {
    const char* name;
    int bits, fraction_bits;     ///< of the format, without the sign
    const char* file = nullptr;  ///< where it was recorded; null: never
    std::int64_t least = std::numeric_limits<std::int64_t>::max(), greatest = std::numeric_limits<std::int64_t>::min();

    SeenRange(const char* its_name, int its_bits, int its_fraction_bits)
        : name(its_name), bits(its_bits), fraction_bits(its_fraction_bits) {
        recorded_ranges().push_back(this);
    }
};

template <RangeName Name, class Number>
inline SeenRange seen_range{Name.text, std::numeric_limits<typename Number::Raw>::digits, Number::kFractionBits};

/// `value` is a Fixed.
template <RangeName Name, class Number>
constexpr void note_range(Number value, const char* file = __builtin_FILE()) {
    if (std::is_constant_evaluated()) return;
    SeenRange& seen = seen_range<Name, Number>;
    seen.file = file;
    seen.least = std::min<std::int64_t>(seen.least, value.raw);
    seen.greatest = std::max<std::int64_t>(seen.greatest, value.raw);
}

}  // namespace oblong

#else

namespace oblong {

template <RangeName Name, class Number>
constexpr void note_range(Number) {}

}  // namespace oblong

#endif
