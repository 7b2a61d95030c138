// Saved games: what is read is written as it was, and one of the level is played on.

#include "engine/base/checksum.h"
#include "engine/base/little_endian.h"
#include "game/saves/saved_game.h"
#include "game/simulation/game_level.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/support/bsp_writer.h"

namespace oblong::fuzz {
namespace {

constexpr std::size_t kSizeAt = 12, kHashBytes = 8;

const GameLevel& stage() {
    static const GameLevel level = make_game_level(stage_level());
    return level;
}

SavedGame new_game() {
    SavedGame game;
    game.level.name = "stage";
    game.state = start_of(stage());
    return game;
}

void put_hash(Bytes& bytes, std::size_t at, std::uint64_t hash) {
    test::put_number(bytes, at, 8, static_cast<std::int64_t>(hash));
}

// As a save has it: its size, and the checksum at its end.
void seal(Bytes& save) {
    if (save.size() < kSizeAt + 4 + kHashBytes) return;
    test::put_number(save, kSizeAt, 4, static_cast<std::int64_t>(save.size()));
    const std::size_t end = save.size() - kHashBytes;
    put_hash(save, end, fnv1a_of(std::span(save).first(end)));
}

// A state of other numbers, with its own hash.
void alter_state(SavedGame& game, std::minstd_rand& random) {
    Bytes bytes;
    append_state(bytes, game.state);
    if (below(4, random) == 0)
        mutate_bytes(bytes);
    else
        test::put_number(bytes, below(bytes.size() - 8, random), 1 << below(4, random), odd_number(random));
    LittleEndianReader reader(bytes);
    game.state = read_state(reader);
}

}  // namespace

// Files in the corpus are of a version whose states were others: a save of this one takes their place.
void mutate(Bytes& input, std::minstd_rand& random) {
    try {
        if (below(8, random) == 0) input = encode_save(new_game());
        SavedGame game = decode_save(input);
        if (below(3, random) != 0) {
            alter_state(game, random);
            input = encode_save(game);
            return;
        }
    } catch (const InputError&) {  // altered as it is
    }
    mutate_bytes(input);
    if (below(16, random) != 0) seal(input);
}

void run(Input input) {
    const GameLevel& level = stage();
    SavedGame game = decode_save(input);
    expect(encode_save(game) == Bytes(input.begin(), input.end()), "a save that is written as it was read");
    constexpr std::int64_t kLate_ticks = std::int64_t{1} << 39;  // 242 years; after twice as many a save is refused
    if (!find_inconsistency(level, game.state).empty() || game.state.tick > kLate_ticks) return;
    play(level, game.state, 40, fnv1a_of(input));
    check_state(level, game.state);
}

}  // namespace oblong::fuzz
