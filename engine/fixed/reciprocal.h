#pragma once

#include <array>
#include <cstdint>

namespace oblong {

/// Methods for 1 / n, from the coarsest. Errors are relative, worst over all mantissas. No result but Table256Newton's
/// rises as n grows; that one does where one entry ends and the next begins, by 2^-25 of itself.
enum class ReciprocalMethod {
    Table256,           ///< a table of 256 entries: 2^-9
    Table256Newton,     ///< 256 entries and a step of Newton's: 2^-18
    Table1024Newton,    ///< 1,024 entries and a step of Newton's: 2^-21
    Table256TwoNewton,  ///< 256 entries and two steps: 1 step of 2^-31
    Exact               ///< a division: half a step of 2^-31
};

inline constexpr std::array kReciprocalMethods = {ReciprocalMethod::Table256, ReciprocalMethod::Table256Newton,
                                                  ReciprocalMethod::Table1024Newton,
                                                  ReciprocalMethod::Table256TwoNewton, ReciprocalMethod::Exact};

/// 2^62 / mantissa for a mantissa from 2^31 to 2^32 - 1: a number from 2^30 + 1 (2^30 for the tables) to 2^31.
std::uint32_t mantissa_reciprocal(std::uint32_t mantissa, ReciprocalMethod method);

}  // namespace oblong
