#include "game/simulation/tick_report.h"

#include <array>
#include <utility>

namespace oblong {

std::vector<std::string_view> TickReport::left() const {
    const std::array<std::pair<bool, std::string_view>, 5> kinds{{
        {has_left_activations, "activations wait for later ticks"},
        {has_dropped_firings, "activations beyond 16,384 that wait are dropped"},
        {has_left_movers, "movers wait for later ticks"},
        {has_left_touches, "triggers and items are touched in later ticks"},
        {has_left_obstacles, "brush models beyond 256 in one place are not solid"},
    }};
    std::vector<std::string_view> texts;
    for (const auto& [is_left, text] : kinds)
        if (is_left) texts.push_back(text);
    return texts;
}

}  // namespace oblong
