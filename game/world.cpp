#include "game/world.h"

#include "engine/fixed/trig.h"
#include "game/movers.h"
#include "game/player.h"

namespace oblong {
namespace {

constexpr World kExitSpeed = World::from_int(300);
constexpr World kEndOfTheWorld = World::from_int(40'000);

void teleport(Player& player, const Trigger::Exit& exit) {
    const auto part = [](Unit direction) { return convert<World>(widening_product(kExitSpeed, direction)); };
    player.place = exit.place;
    player.yaw = exit.yaw;
    player.pitch = 0;
    player.velocity = {part(cosine(exit.yaw)), part(sine(exit.yaw)), World{}};
    player.ground = Player::kNoGround;
}

void touch_triggers(const Stage& stage, GameState& state) {
    for (const Trigger& trigger : stage.triggers) {
        if (!trigger.box.overlaps(player_box(state.player.place))) continue;
        state.has_ended |= trigger.ends_level;
        for (const std::int32_t mover : trigger.starts) set_off(stage, state, mover);
        if (trigger.teleports_to) teleport(state.player, *trigger.teleports_to);
    }
}

// Who falls out of a level that leaks begins anew.
void return_the_lost(const Stage& stage, Player& player) {
    const auto is_beyond = [](World w) { return w > kEndOfTheWorld || w < -kEndOfTheWorld; };
    if (!is_beyond(player.place.x) && !is_beyond(player.place.y) && !is_beyond(player.place.z)) return;
    player = start_of(stage).player;
}

}  // namespace

void step(const Stage& stage, GameState& state, const TickInput& input) {
    ++state.tick;
    if (state.has_ended) return;
    step_movers(stage, state);
    step_player(stage, state, input);
    return_the_lost(stage, state.player);
    touch_movers(stage, state);
    touch_triggers(stage, state);
}

}  // namespace oblong
