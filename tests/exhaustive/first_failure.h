#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

namespace oblong {

/// The smallest of the inputs first, ..., end - 1 for which `holds` is false, if there is one.
template <class Predicate>
std::optional<std::uint64_t> first_failure(std::uint64_t first, std::uint64_t end, Predicate holds) {
    for (std::uint64_t input = first; input < end; ++input)
        if (!holds(input)) return input;
    return std::nullopt;
}

/// The smallest of the inputs first, ..., end - 1 whose value is greater than that of the input before, or is not near:
/// is_near(input, value). No value is asked for before that of `first`.
template <class Value, class IsNear>
std::optional<std::uint64_t> first_rise_or_far(std::uint64_t first, std::uint64_t end, Value value_of, IsNear is_near) {
    auto before = value_of(first);
    return first_failure(first, end, [&](std::uint64_t input) {
        const auto value = value_of(input);
        const bool falls = value <= before;
        before = value;
        return falls && is_near(input, value);
    });
}

/// Expects `holds` of all the inputs first, ..., end - 1.
template <class Predicate>
void expect_all(std::uint64_t first, std::uint64_t end, Predicate holds) {
    EXPECT_EQ(first_failure(first, end, holds), std::nullopt);
}

inline constexpr std::uint64_t kAll32 = std::uint64_t{1} << 32;

}  // namespace oblong
