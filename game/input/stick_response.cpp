#include <algorithm>

#include "engine/fixed/root.h"
#include "game/input/controls.h"

namespace oblong {
namespace {

constexpr std::int64_t kFullReach = std::int64_t{kFullAxis} * 97 / 100;

std::int64_t length_of(Stick stick) {
    const std::int64_t x = stick.x, y = stick.y;
    return static_cast<std::int64_t>(integer_root(static_cast<std::uint64_t>(x * x + y * y)));
}

Stick scaled(Stick stick, std::int64_t numerator, std::int64_t denominator) {
    return {static_cast<std::int32_t>(stick.x * numerator / denominator),
            static_cast<std::int32_t>(stick.y * numerator / denominator)};
}

}  // namespace

Stick without_dead_zone(Stick stick, std::int32_t dead_zone_100) {
    const std::int64_t length = length_of(stick), dead = std::int64_t{kFullAxis} * dead_zone_100 / 100;
    if (length <= dead) return {};
    if (length >= kFullReach) return scaled(stick, std::max<std::int64_t>(length, kFullAxis), length);
    return scaled(stick, (length - dead) * kFullAxis, (kFullReach - dead) * length);
}

Stick squared(Stick stick) {
    return scaled(stick, std::min<std::int64_t>(length_of(stick), kFullAxis), kFullAxis);
}

}  // namespace oblong
