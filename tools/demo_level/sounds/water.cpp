#include "tools/demo_level/sounds/grains.h"
#include "tools/demo_level/sounds/sounds.h"

namespace oblong::sound_source {
namespace {

using namespace synth;

void add_bubbles(Samples& to, int count, std::int32_t from_ms, std::int32_t until_ms, std::int32_t lowest_hz,
                 std::int32_t highest_hz, std::int32_t percent, std::uint32_t seed) {
    Chance chance(seed);
    for (int i = 0; i < count; ++i) {
        const Grain grain{chance.between(from_ms, until_ms), percent * chance.between(40, 100) / 100,
                          chance.between(lowest_hz, highest_hz), chance.between(35, 110)};
        add(to, bubble(grain.length_ms, grain.hz), grain.at_ms, grain.percent);
    }
}

Samples splash() {
    Samples sum = silence(1'150);
    add(sum, struck(strike(500, 25, 300, 3), {{58, 55, 30}, {97, 35, 30}}), 0);
    add(sum, high_passed(low_passed(shaped(noise(1'000, 21), 12, 130), 3'200), 250), 0, 160);
    add(sum, high_passed(shaped(noise(900, 22), 90, 150), 2'500), 60, 28);
    add_bubbles(sum, 26, 120, 1'000, 260, 900, 26, 9);
    return sum;
}

Samples leaving_water() {
    Samples sum = silence(1'150);
    add(sum, high_passed(low_passed(shaped(noise(700, 31), 110, 120), 2'600), 400), 0, 110);
    Chance chance(13);
    for (int i = 0; i < 20; ++i) {
        const Grain drop{250 + chance.between(0, 800), chance.between(8, 22), chance.between(1'100, 2'600)};
        add(sum, shaped(tone(50, drop.hz * 100, drop.hz * 135), 1, 9), drop.at_ms, drop.percent);
    }
    return sum;
}

Samples stroke(std::uint32_t seed) {
    Samples sum = silence(760);
    add(sum, high_passed(low_passed(shaped(noise(700, seed), 190, 110), 1'300), 160), 0, 120);
    add(sum, high_passed(low_passed(shaped(noise(500, seed + 1), 140, 90), 2'800), 900), 120, 30);
    add_bubbles(sum, 9, 180, 620, 240, 620, 22, seed);
    return sum;
}

}  // namespace

std::vector<NamedSound> make_water() {
    return {{"water_in", finished(splash(), false, 85)},
            {"water_out", finished(leaving_water(), false, 75)},
            {"swim1", finished(stroke(41), false, 70)},
            {"swim2", finished(stroke(57), false, 70)}};
}

}  // namespace oblong::sound_source
