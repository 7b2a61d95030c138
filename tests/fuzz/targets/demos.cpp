// Recorded games: what is read is written as it was, and its inputs are played.

#include "game/simulation/demo.h"
#include "game/simulation/step.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/support/bsp_writer.h"

namespace oblong::fuzz {

// With the number of ticks that there are.
void mutate(Bytes& input, std::minstd_rand& random) {
    constexpr std::size_t kVersionAt = 8, kCountAt = 24, kHeader = 28, kTick = 23, kTickOfVersion1 = 15;
    mutate_bytes(input, 2 * kTick);
    if (input.size() < kHeader || below(16, random) == 0) return;
    const std::size_t each = input[kVersionAt] == 1 ? kTickOfVersion1 : kTick, ticks = (input.size() - kHeader) / each;
    input.resize(kHeader + ticks * each);
    test::put_number(input, kCountAt, 4, static_cast<std::int64_t>(ticks));
}

void run(Input input) {
    static const GameLevel level = make_game_level(stage_level());
    const Demo demo = decode_demo(input);
    expect(decode_demo(encode_demo(demo)) == demo, "a demo that is written as it was read");
    GameState state = start_of(level);
    for (const DemoTick& tick : demo.ticks) step(level, state, tick.input);
    check_state(level, state);
}

}  // namespace oblong::fuzz
