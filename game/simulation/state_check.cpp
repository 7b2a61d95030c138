#include "game/simulation/state_check.h"

#include <algorithm>
#include <vector>

#include "game/simulation/slide_move.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

constexpr std::int64_t kMostTicks = std::int64_t{1} << 40;  // a thousand years
constexpr World kFastest = World::from_int(4096);           // along an axis; the player's own bound is half of that

bool is_within(auto value, auto least, auto most) {
    return least <= value && value <= most;
}

bool is_within(const Vec3<World>& v, World most) {
    return is_within(v.x, -most, most) && is_within(v.y, -most, most) && is_within(v.z, -most, most);
}

// Indices below `count`, ascending, none of them twice.
bool are_ascending(const std::vector<std::uint32_t>& indices, std::size_t count) {
    const auto descends = [](std::uint32_t a, std::uint32_t b) { return a >= b; };
    return std::adjacent_find(indices.begin(), indices.end(), descends) == indices.end() &&
           (indices.empty() || indices.back() < count);
}

bool is_index_or_none(std::int32_t index, std::size_t count) {
    return index >= -1 && index < static_cast<std::int64_t>(count);
}

bool is_consistent(const GameLevel& level, const Player& player) {
    return is_within(player.position, kFarthestPlayer) && is_within(player.velocity, kFastest) &&
           is_within(player.pitch, -Player::kSteepestPitch, Player::kSteepestPitch) &&
           is_within(player.eye_lag, -World::from_int(kStepHeight), World::from_int(kStepHeight)) &&
           is_index_or_none(player.ground, level.bsp->models.size()) && player.depth <= Depth::Eyes;
}

bool is_consistent(const Mover& mover, const MoverState& state) {
    return state.phase <= MoverState::Phase::Returning && is_within(state.travelled, World{}, mover.length) &&
           is_within(state.wait_ticks, std::min(mover.wait_ticks, 0), std::max(mover.wait_ticks, 0));
}

bool are_consistent(const GameLevel& level, const std::vector<MoverState>& states) {
    return std::equal(level.movers.begin(), level.movers.end(), states.begin(), states.end(),
                      [](const Mover& mover, const MoverState& state) { return is_consistent(mover, state); });
}

bool are_consistent(const GameLevel& level, const std::vector<ItemState>& items) {
    return items.size() == level.items.size() &&
           std::all_of(items.begin(), items.end(), [](ItemState item) { return item <= ItemState::Removed; });
}

}  // namespace

bool is_consistent(const GameLevel& level, const GameState& state) {
    return is_within(state.tick, std::int64_t{0}, kMostTicks) && is_consistent(level, state.player) &&
           are_consistent(level, state.movers) && are_ascending(state.active_movers, level.movers.size()) &&
           state.teleporter_ends.size() == level.targeted_teleporters &&
           are_ascending(state.touched_switches, level.triggers.size()) && are_consistent(level, state.items) &&
           is_within(state.respawn.position, kFarthestPlayer) &&
           is_index_or_none(state.shown_message, level.messages.size()) &&
           is_within(state.message_tick, std::int64_t{0}, state.tick) &&
           is_index_or_none(state.exit, level.triggers.size());
}

}  // namespace oblong
