#pragma once

#include <array>
#include <cstdint>

namespace oblong {

/// Methods for 1 / n, from the cheapest. Errors are relative, worst over all mantissas; no result rises as n grows.
enum class ReciprocalMethod {
    Table256,           ///< a table of 256 entries: 2^-9
    Table1024Newton,    ///< 1,024 entries and a step of Newton's: 2^-21
    Table256TwoNewton,  ///< 256 entries and two steps: 1 step of 2^-31
    Exact               ///< a division: half a step of 2^-31
};

inline constexpr std::array kReciprocalMethods = {ReciprocalMethod::Table256, ReciprocalMethod::Table1024Newton,
                                                  ReciprocalMethod::Table256TwoNewton, ReciprocalMethod::Exact};

/// "table 256", "table 1024, Newton", ...
const char* name_of(ReciprocalMethod method);

/// 2^62 / mantissa for a mantissa from 2^31 to 2^32 - 1: a number from 2^30 + 1 (2^30 for the tables) to 2^31.
std::uint32_t mantissa_reciprocal(std::uint32_t mantissa, ReciprocalMethod method);

/// 1 / n = mantissa / 2^shift, with 31 bits in the mantissa.
struct ScaledReciprocal {
    std::uint32_t mantissa = 0;
    int shift = 0;
};

/// The reciprocal of an integer above 0. The bits of n beyond the highest 32 are dropped, which adds 2^-31 to the
/// method's error.
ScaledReciprocal scaled_reciprocal(std::uint64_t n, ReciprocalMethod method);

}  // namespace oblong
