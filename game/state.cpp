#include "game/state.h"

namespace oblong {
namespace {

constexpr std::uint64_t kFnvStart = 14'695'981'039'346'656'037u, kFnvPrime = 1'099'511'628'211u;

struct Hash {
    std::uint64_t value = kFnvStart;

    void add(std::int64_t number) {
        for (int byte = 0; byte < 8; ++byte)
            value = (value ^ ((static_cast<std::uint64_t>(number) >> (8 * byte)) & 0xff)) * kFnvPrime;
    }
    void add(World number) { add(std::int64_t{number.raw}); }
    void add(const Vec3<World>& v) {
        for (const std::int64_t number : raw_of(v)) add(number);
    }
};

void add_player(Hash& hash, const Player& player) {
    hash.add(player.position);
    hash.add(player.velocity);
    hash.add(player.yaw.bam);
    hash.add(player.pitch);
    hash.add(player.eye_lag);
    hash.add(player.ground);
    hash.add(static_cast<std::int64_t>(player.depth));
    hash.add(std::int64_t{player.holds_jump});
}

}  // namespace

// Active movers follow from the movers' states.
std::uint64_t hash_of(const GameState& state) {
    Hash hash;
    hash.add(state.tick);
    add_player(hash, state.player);
    for (const MoverState& mover : state.movers) {
        hash.add(static_cast<std::int64_t>(mover.phase));
        hash.add(mover.travelled);
        hash.add(mover.wait_ticks);
    }
    for (const std::int64_t tick : state.teleporter_ends) hash.add(tick);
    if (state.dark_styles != 0) hash.add(static_cast<std::int64_t>(state.dark_styles));
    for (const std::uint32_t trigger : state.touched_switches) hash.add(trigger);
    hash.add(std::int64_t{state.has_ended});
    return hash.value;
}

}  // namespace oblong
