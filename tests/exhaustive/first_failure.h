#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <thread>

namespace oblong {

/// The smallest of the inputs first, ..., end - 1 for which `holds` is false, if there is one. Two threads, half of the
/// inputs each.
template <class Predicate>
std::optional<std::uint64_t> first_failure(std::uint64_t first, std::uint64_t end, Predicate holds) {
    constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
    const auto search = [&holds](std::uint64_t from, std::uint64_t to) {
        for (std::uint64_t input = from; input < to; ++input)
            if (!holds(input)) return input;
        return kNone;
    };
    const std::uint64_t middle = first + (end - first) / 2;
    std::uint64_t in_first_half = kNone;
    std::thread other([&] { in_first_half = search(first, middle); });
    const std::uint64_t in_second_half = search(middle, end);
    other.join();
    const std::uint64_t smallest = std::min(in_first_half, in_second_half);
    return smallest == kNone ? std::nullopt : std::optional(smallest);
}

inline constexpr std::uint64_t kAll32 = std::uint64_t{1} << 32;

}  // namespace oblong
