#include "game/simulation/tick_report.h"

#include <array>
#include <utility>

namespace oblong {

std::string TickReport::left() const {
    const std::array<std::pair<bool, const char*>, 5> kinds{{
        {has_left_activations, "activations wait for later ticks"},
        {has_dropped_firings, "activations beyond 16,384 that wait are dropped"},
        {has_left_movers, "movers wait for later ticks"},
        {has_left_touches, "triggers and items are touched in later ticks"},
        {has_left_obstacles, "brush models beyond 256 in one place are not solid"},
    }};
    std::string text;
    for (const auto& [is_left, what] : kinds)
        if (is_left) text += (text.empty() ? "" : "; ") + std::string(what);
    return text;
}

}  // namespace oblong
