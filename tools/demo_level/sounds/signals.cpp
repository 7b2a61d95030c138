#include <array>

#include "tools/demo_level/sounds/grains.h"
#include "tools/demo_level/sounds/sounds.h"

namespace oblong::sound_source {
namespace {

using namespace synth;

// A note of partials, each with its own half-life.
Samples note(std::int32_t ms, std::int64_t chz, std::initializer_list<Mode> partials_of_1000) {
    Samples sum = silence(ms);
    for (const Mode& partial : partials_of_1000) {
        const std::int64_t frequency = chz * partial.hz / 1000;
        add(sum, shaped(tone(ms, frequency, frequency), 2, partial.half_life_ms), 0, partial.percent);
    }
    return sum;
}

// A glass that is struck: its partials are no harmonics, and each is two that are nearly the same.
Samples glass(std::int32_t ms, std::int64_t chz) {
    Samples sum = note(ms, chz, {{1'000, 420, 100}, {2'320, 230, 45}, {4'250, 120, 26}, {6'630, 60, 12}});
    add(sum, note(ms, chz + 140, {{1'000, 420, 70}, {2'320, 230, 30}}), 0);
    return sum;
}

Samples bell(std::int32_t ms, std::int64_t chz) {
    return note(ms, chz, {{500, 300, 22}, {1'000, 260, 100}, {2'000, 150, 42}, {3'010, 90, 22}, {4'160, 55, 14}});
}

struct TimedNote {
    std::int32_t at_ms;
    std::int64_t chz;
    std::int32_t percent;
};

template <class Voice>
Samples melody(std::int32_t ms, std::initializer_list<TimedNote> notes, Voice voice) {
    Samples sum = silence(ms);
    for (const TimedNote& one : notes) add(sum, voice(ms - one.at_ms, one.chz), one.at_ms, one.percent);
    return sum;
}

// A, E and A above it.
Samples lens() {
    return melody(2'950, {{0, 88'000, 100}, {110, 131'851, 85}, {230, 176'000, 90}}, glass);
}

Samples keys() {
    Samples sum = silence(1'150);
    Chance chance(71);
    for (std::int32_t i = 0; i < 9; ++i) {
        const std::int32_t at_ms = i * 85 + chance.between(0, 40);
        const Samples one = struck(strike(240, 1, 10'000, 500 + static_cast<std::uint32_t>(i)),
                                   {{2'870, 45, 60}, {4'130, 50, 70}, {5'910, 34, 50}}, chance.between(90, 116));
        add(sum, one, at_ms, 100 - i * 8);
    }
    return sum;
}

Samples teleport() {
    constexpr std::int32_t kLength_ms = 1'580;
    Samples sum = silence(kLength_ms);
    const Samples rise = swell(kLength_ms, 1, 0, 2);
    for (std::int32_t n = 1; n <= 5; ++n)
        add(sum, times(tone(kLength_ms, 11'000 * n, 44'000 * n + 700 * n), rise), 0, 70 / n);
    add(sum, times(high_passed(noise(kLength_ms, 75), 1'200), rise), 0, 24);
    add(sum, glass(700, 105'000), 800, 22);
    return sum;
}

// A phrase of bells that rises: C E G B D.
Samples secret() {
    return melody(1'980, {{0, 52'325, 80}, {120, 65'926, 80}, {240, 78'399, 80}, {360, 98'777, 85}, {510, 117'466, 95}},
                  bell);
}

// C G E C G, from the bass up, that rings out.
Samples level_end() {
    return melody(3'950,
                  {{0, 13'081, 110},
                   {60, 19'600, 80},
                   {180, 32'963, 75},
                   {340, 52'325, 75},
                   {540, 78'399, 65},
                   {1'500, 98'777, 30},
                   {1'800, 104'650, 50}},
                  [](std::int32_t ms, std::int64_t chz) {
                      return note(ms, chz, {{1'000, 850, 100}, {2'000, 520, 40}, {3'000, 330, 20}, {4'000, 200, 10}});
                  });
}

Samples soft(std::int32_t ms, std::int64_t chz) {
    return note(ms, chz, {{1'000, 60, 100}, {2'000, 35, 20}});
}

}  // namespace

std::vector<NamedSound> make_signals() {
    return {{"lens", finished(lens(), false, 75)},
            {"key", finished(keys(), false, 65)},
            {"teleport", finished(teleport(), false, 75)},
            {"secret", finished(secret(), false, 75)},
            {"level_end", finished(level_end(), false, 80)},
            {"message", finished(melody(780, {{0, 65'926, 70}, {130, 98'777, 90}}, soft), false, 60)},
            {"menu_move", finished(note(95, 120'000, {{1'000, 9, 100}, {500, 12, 60}}), false, 60)},
            {"menu_accept", finished(melody(290, {{0, 65'926, 80}, {75, 98'777, 90}}, soft), false, 65)},
            {"menu_back", finished(melody(290, {{0, 65'926, 80}, {75, 44'000, 95}}, soft), false, 65)}};
}

}  // namespace oblong::sound_source
