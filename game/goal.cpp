#include "game/goal.h"

#include "game/simulation/items.h"

namespace oblong {
namespace {

constexpr std::int32_t kFew = 4;
constexpr std::int64_t kTangent_12 = 29;  // 12 times that of 67.5 degrees

bool is_lens(const GameLevel& level, std::size_t item) {
    return level.items[item].item_class == ItemClass::Lens;
}

std::string name_of(const GameLevel& level, std::size_t item) {
    const std::string name = level.bsp->entities[level.items[item].entity].value("netname");
    return name.empty() ? "a lens" : name;
}

}  // namespace

std::string direction_of(const Position& from, const Position& to) {
    const std::int64_t east = std::int64_t{to.x.raw} - from.x.raw, north = std::int64_t{to.y.raw} - from.y.raw,
                       up = std::int64_t{to.z.raw} - from.z.raw;
    const std::int64_t across = std::abs(east), along = std::abs(north);
    if (std::abs(up) > std::max(across, along)) return up > 0 ? "above" : "below";
    const std::string first = north >= 0 ? "north" : "south", second = east >= 0 ? "east" : "west";
    if (12 * along > kTangent_12 * across) return first;
    return 12 * across > kTangent_12 * along ? second : first + "-" + second;
}

std::vector<std::size_t> last_lenses(const GameLevel& level, const GameState& state) {
    const ItemCount count = count_items(level, state, ItemClass::Lens);
    std::vector<std::size_t> missing;
    if (count.all - count.taken > std::min(kFew, count.all / 2)) return missing;
    for (std::size_t i = 0; i < level.items.size(); ++i)
        if (is_lens(level, i) && is_there(state, i)) missing.push_back(i);
    return missing;
}

Goal goal_of(const GameLevel& level, const GameState& state) {
    const ItemCount count = count_items(level, state, ItemClass::Lens);
    Goal goal;
    if (count.all == 0) return goal;
    const auto where = [&](std::size_t item) {
        return direction_of(state.player.position, level.items[item].position);
    };
    goal.count = std::to_string(count.taken) + " of " + std::to_string(count.all);
    for (const std::size_t lens : last_lenses(level, state))
        goal.hint += (goal.hint.empty() ? "Missing: " : ", ") + name_of(level, lens) + " (" + where(lens) + ")";
    for (std::size_t i = 0; i < level.items.size(); ++i)
        if (is_lens(level, i))
            goal.list += (goal.list.empty() ? "" : "\n") + name_of(level, i) +
                         (is_there(state, i) ? ": " + where(i) + " of here" : ": found");
    return goal;
}

}  // namespace oblong
