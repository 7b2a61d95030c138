// Replays a demo as the game does, and prints the hash of the state after every 35th tick and at the end, a line each.
// Ten times on the way it saves the game, goes on from what it reads of that, and prints a hash of the file, too.
//   replay_demo LEVEL.bsp WALK.demo
// Fails at the first tick whose state is another than the one recorded.
#include <cinttypes>
#include <cstdio>

#include "engine/base/checksum.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/programs/arguments.h"
#include "game/saves/saved_game.h"
#include "game/simulation/demo.h"
#include "game/simulation/step.h"

namespace {

using namespace oblong;

void print(const char* kind, std::int64_t tick, std::uint64_t hash) {
    std::printf("%s %" PRId64 " %016" PRIx64 "\n", kind, tick, hash);
}

// The state as it is read from a file that it is saved in.
GameState saved_and_loaded(const GameLevel& level, std::uint64_t level_hash, const GameState& state) {
    SavedGame game;
    game.level.file_hash = level_hash;
    game.level.start_hash = hash_of(start_of(level));
    game.state = state;
    const std::vector<std::uint8_t> bytes = encode_save(game);
    print("saved", state.tick, fnv1a_of(bytes));
    const SavedGame loaded = decode_save(bytes);
    check_level(loaded, level_hash, level);
    return loaded.state;
}

void replay(const std::string& level_path, const std::string& demo_path) {
    const std::vector<std::uint8_t> level_bytes = read_file(level_path);
    const Level bsp = naming_file(level_path, [&] { return read_bsp(level_bytes); });
    const GameLevel level = make_game_level(bsp);
    const Demo demo = read_parsed(demo_path, decode_demo);
    GameState state = start_of(level);
    if (hash_of(state) != demo.start_hash) throw FileError(demo_path, "start", "another state than this level's");
    const std::size_t save_ticks = demo.ticks.size() / 10 + 1;
    for (std::size_t tick = 0; tick < demo.ticks.size(); ++tick) {
        step(level, state, demo.ticks[tick].input);
        if (tick % save_ticks == save_ticks / 2) state = saved_and_loaded(level, fnv1a_of(level_bytes), state);
        const std::uint64_t hash = hash_of(state);
        if (hash != demo.ticks[tick].state_hash)
            throw FileError(demo_path, "tick " + std::to_string(tick + 1), "another state than the one recorded");
        if (state.tick % kTicksPerSecond == 0) print("state", state.tick, hash);
    }
    print(state.has_ended ? "end" : "stop", state.tick, hash_of(state));
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("replay_demo", [&] {
        if (argc != 3) throw UsageError("expected LEVEL.bsp WALK.demo");
        replay(argv[1], argv[2]);
    });
}
