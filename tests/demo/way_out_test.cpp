#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "game/simulation/step.h"
#include "tests/demo/demo_level.h"

namespace oblong {
namespace {

constexpr std::int32_t kCell = 48;  ///< world units; what is in one cell counts as one place
constexpr int kDirections = 8;
constexpr std::int64_t kPatience = 10 * kTicksPerSecond;

using Cell = std::array<std::int32_t, 3>;

Cell cell_of(const Position& p) {
    const auto part = [](World w) { return static_cast<std::int32_t>(floor_of(w)) / kCell; };
    return {part(p.x + World::from_int(16'384)), part(p.y + World::from_int(16'384)),
            part(p.z + World::from_int(16'384))};
}

bool swims(const GameState& state) {
    return state.player.depth >= Depth::Waist;
}

/// All places that a player gets to by walking, jumping and swimming, and from which to which: by the game itself.
class Explorer {
  public:
    Explorer(const GameLevel& level, const GameState& start) : level_(level) {
        note(start);
        for (std::size_t at = 0; at < states_.size(); ++at)
            for (int way = 0; way < 2 * kDirections; ++way) try_way(at, way);
    }

    const std::vector<GameState>& states() const { return states_; }

    /// Those from which the player can get to a cell, or to the level's end.
    std::vector<bool> with_a_way_to(const Cell& home) const {
        std::vector<bool> has_way(states_.size());
        std::vector<std::size_t> found;
        const auto find = [&](std::size_t state) {
            if (!has_way[state]) found.push_back(state);
            has_way[state] = true;
        };
        for (std::size_t i = 0; i < states_.size(); ++i)
            if (states_[i].has_ended || cell_of(states_[i].player.position) == home) find(i);
        for (std::size_t next = 0; next < found.size(); ++next)
            for (const std::size_t from : came_from_[found[next]]) find(from);
        return has_way;
    }

  private:
    std::size_t note(const GameState& state) {
        const auto [place, is_new] = places_.emplace(cell_of(state.player.position), states_.size());
        if (is_new) {
            states_.push_back(state);
            came_from_.emplace_back();
        }
        return place->second;
    }

    /// A cell's width in one of eight directions; the second eight ways begin with a jump.
    void try_way(std::size_t from, int way) {
        GameState state = states_[from];
        const bool jumps = way >= kDirections;
        if (state.has_ended || (jumps && (swims(state) || way % 2 != 0))) return;
        state.player.yaw = Angle::from_bam(way % kDirections * 65'536 / kDirections);
        state.player.pitch = 0;
        const Position start = state.player.position;
        const int longest = swims(state) ? 24 : 12;
        for (int tick = 0; tick < longest && !state.has_ended; ++tick) {
            TickInput input;
            input.forward = 127;
            if (swims(state) || (jumps && tick == 0)) input.buttons = kJumpButton;
            step(level_, state, input);
            const Vec3<World> way_there = state.player.position - start;
            if (!jumps && length_of({way_there.x, way_there.y, World{}}) >= World::from_int(kCell)) break;
        }
        come_to_rest(state);
        came_from_[note(state)].push_back(from);
    }

    /// Until the player stands and a lift has brought him where it goes.
    void come_to_rest(GameState& state) {
        const auto is_at_rest = [&] {
            const std::int32_t ground = state.player.ground;
            const bool is_carried = ground > 0 && !state.active_movers.empty();
            return state.has_ended || swims(state) || (ground != Player::kNoGround && !is_carried);
        };
        for (std::int64_t tick = 0; tick < kPatience && !is_at_rest(); ++tick) step(level_, state, {});
        state.player.velocity = {};
    }

    const GameLevel& level_;
    std::vector<GameState> states_;
    std::vector<std::vector<std::size_t>> came_from_;
    std::map<Cell, std::size_t> places_;
};

/// The state of the recorded walk in which all lenses are found and the tower is open.
GameState open_tower(const GameLevel& level) {
    GameState state = start_of(level);
    for (const DemoTick& tick : test::recorded_walk().ticks) {
        const bool found_all = std::ranges::count(state.items, ItemState::There) == 0;
        const bool is_in_corridor =
            state.player.position.x > World::from_int(100) && state.player.position.y > World::from_int(2300);
        if (found_all && is_in_corridor) return state;
        step(level, state, tick.input);
    }
    ADD_FAILURE() << "the walk does not find all lenses";
    return state;
}

/// A place that the player must have got to, and its name.
struct Known {
    const char* name;
    std::int32_t x, y, z_low, z_high;
};

TEST(DemoWaysOut, LeadFromEveryPlaceThatCanBeReached) {
    const Level bsp = test::read_level("demo");
    const GameLevel level = make_game_level(bsp);
    const Explorer explorer(level, open_tower(level));
    const Cell courtyard = cell_of(world_vector(512, 1420, 24));
    const std::vector<bool> has_way = explorer.with_a_way_to(courtyard);
    for (std::size_t i = 0; i < has_way.size(); ++i)
        if (const test::Point place = test::to_point(explorer.states()[i].player.position); !has_way[i])
            ADD_FAILURE() << "no way out of " << place.x << ' ' << place.y << ' ' << place.z;
    EXPECT_GT(has_way.size(), 1000u);
    for (const Known& known : {Known{"the entrance", 0, -300, 0, 40},
                               {"the canal", 300, 1264, -96, -30},
                               {"the lava in the south", -472, 2208, -32, 30},
                               {"the lava in the north", -472, 2432, -32, 30},
                               {"the rain's basin", 1392, 1616, -48, 0},
                               {"the fog garden", 1392, 2300, -208, -170},
                               {"the balcony", 1060, 900, 160, 200},
                               {"the top of the tower", 512, 1776, 464, 500}})
        EXPECT_TRUE(std::ranges::any_of(explorer.states(), [&](const GameState& state) {
            const test::Point p = test::to_point(state.player.position);
            return std::abs(p.x - known.x) < 60 && std::abs(p.y - known.y) < 60 && p.z >= known.z_low &&
                   p.z <= known.z_high;
        })) << known.name;
}

}  // namespace
}  // namespace oblong
