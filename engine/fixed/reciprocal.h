#pragma once

#include <array>
#include <cstdint>

namespace oblong {

/// Methods for 1 / n, from the coarsest, with their largest relative error over all mantissas. Results fall
/// monotonically as n grows, except Table256Newton's, which rises by a relative 2^-25 from one entry to the next.
enum class ReciprocalMethod {
    Table256,           ///< 256 entries: 2^-9
    Table256Newton,     ///< 256 entries and a Newton step: 2^-18
    Table1024Newton,    ///< 1,024 entries and a Newton step: 2^-21
    Table256TwoNewton,  ///< 256 entries and two Newton steps: 1 step of 2^-31
    Exact               ///< a division: half a step of 2^-31
};

inline constexpr std::array kReciprocalMethods = {ReciprocalMethod::Table256, ReciprocalMethod::Table256Newton,
                                                  ReciprocalMethod::Table1024Newton,
                                                  ReciprocalMethod::Table256TwoNewton, ReciprocalMethod::Exact};

/// 2^62 / mantissa for a mantissa from 2^31 to 2^32 - 1: a number from 2^30 + 1 to 2^31; of the tables from 2^30
/// less their error.
std::uint32_t mantissa_reciprocal(std::uint32_t mantissa, ReciprocalMethod method);

}  // namespace oblong
