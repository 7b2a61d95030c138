// Of a saved walk on standard input: its tick, where the player is, and where they look.
#include <cinttypes>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <vector>

#include "engine/programs/arguments.h"
#include "game/saves/saved_game.h"

int main() {
    return oblong::run_program("saved_place", [] {
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(std::cin), {}};
        const oblong::GameState state = oblong::decode_save(bytes).state;
        const oblong::Player& player = state.player;
        std::printf("%" PRId64 " %d %d %d %u %d\n", state.tick, player.position.x.raw, player.position.y.raw,
                    player.position.z.raw, static_cast<unsigned>(player.yaw.bam), player.pitch);
    });
}
