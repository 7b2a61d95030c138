#include "tools/demo_level/sounds/grains.h"
#include "tools/demo_level/sounds/sounds.h"

namespace oblong::sound_source {
namespace {

using namespace synth;

// Grinding, rolling, rattling: what goes on while something moves, as a loop of 2 s.
constexpr std::int32_t kMove_ms = 2'000, kBlend_ms = 300;

Samples noise_loop(std::uint32_t seed, std::int32_t above_hz, std::int32_t below_hz) {
    return looped(high_passed(low_passed(low_passed(noise(kMove_ms + kBlend_ms, seed), below_hz), below_hz), above_hz),
                  kBlend_ms);
}

// Whole cycles in the loop, at frequencies in hertz.
Samples hum_loop(std::initializer_list<Mode> partials) {
    Samples sum = silence(kMove_ms);
    for (const Mode& partial : partials)
        add(sum, tone(kMove_ms, partial.hz * 100, partial.hz * 100), 0, partial.percent);
    return sum;
}

Samples latch(std::uint32_t seed) {
    return struck(strike(160, 2, 8'000, seed), {{1'340, 12, 60}, {2'210, 16, 70}, {3'480, 9, 40}, {310, 14, 60}});
}

Samples door_start() {
    Samples sum = silence(580);
    add(sum, latch(3), 0, 70);
    add(sum, latch(4), 55, 45);
    // Wood that sticks and slips, faster and faster.
    Samples ticks = silence(400);
    std::int32_t at_ms = 0;
    for (std::int32_t gap_ms = 26; at_ms<380; at_ms += gap_ms, gap_ms = gap_ms> 9 ? gap_ms - 1 : 9)
        add(ticks, strike(9, 2, 3'000, 60 + static_cast<std::uint32_t>(at_ms)), at_ms, 45);
    add(sum, shaped(struck(ticks, {{286, 15, 70}, {644, 10, 60}, {1'190, 6, 35}}), 120, 180), 110, 40);
    return sum;
}

Samples door_move() {
    Samples sum = scaled(noise_loop(5, 60, 240), 320);
    Samples rolling = noise_loop(6, 200, 900);
    add(sum, times(std::move(rolling), swell(kMove_ms, 9, 0, 2)), 0, 70);
    return sum;
}

Samples door_stop() {
    Samples sum = silence(580);
    const Samples hit = strike(500, 8, 1'200, 8);
    add(sum, struck(hit, {{83, 55, 160}, {176, 36, 110}, {312, 22, 60}, {590, 12, 30}}), 0);
    add(sum, latch(9), 30, 40);
    return sum;
}

Samples slab_start() {
    Samples sum = silence(690);
    add(sum, struck(strike(600, 14, 500, 11), {{54, 80, 60}, {96, 45, 50}, {210, 26, 45}}), 0);
    add(sum, high_passed(low_passed(shaped(noise(600, 12), 60, 120), 900), 150), 0, 170);
    return sum;
}

Samples slab_move() {
    Samples sum = scaled(noise_loop(14, 30, 110), 700);
    add(sum, times(noise_loop(15, 180, 700), swell(kMove_ms, 5, 20)), 0, 160);
    Chance chance(16);
    for (std::uint32_t i = 0; i < 70; ++i) {
        const Grain crunch{chance.between(0, kMove_ms - 1), chance.between(10, 45), 1'800};
        add_around(sum, high_passed(strike(40, 6, crunch.hz, 200 + i), 250), crunch.at_ms, crunch.percent);
    }
    return sum;
}

Samples slab_stop() {
    Samples sum = silence(790);
    add(sum, struck(strike(740, 16, 600, 18), {{47, 120, 22}, {79, 80, 40}, {151, 40, 60}, {330, 22, 60}}), 0);
    add(sum, high_passed(low_passed(shaped(noise(500, 19), 10, 70), 1'500), 200), 0, 150);
    return sum;
}

Samples clank(std::uint32_t seed, std::int32_t pitch_percent) {
    return struck(strike(420, 3, 7'000, seed),
                  {{344, 50, 50}, {731, 70, 60}, {1'287, 60, 50}, {2'120, 45, 40}, {3'390, 30, 25}}, pitch_percent);
}

Samples gate_start() {
    Samples sum = silence(790);
    add(sum, clank(21, 100), 0);
    add(sum, clank(22, 112), 130, 55);
    add(sum, clank(23, 94), 235, 70);
    return sum;
}

Samples gate_move() {
    Samples sum = scaled(noise_loop(25, 50, 200), 260);
    Chance chance(26);
    for (std::int32_t i = 0; i < 22; ++i) {
        const Grain link{i * 90 + chance.between(0, 40), chance.between(18, 42), 0};
        const Samples one = clank(300 + static_cast<std::uint32_t>(i), chance.between(88, 118));
        add_around(sum, one, link.at_ms, link.percent);
    }
    return sum;
}

Samples gate_stop() {
    Samples sum = silence(1'190);
    const Samples hit = strike(1'150, 5, 4'500, 28);
    add(sum,
        struck(hit,
               {{113, 120, 120}, {219, 170, 110}, {511, 190, 80}, {893, 150, 55}, {1'412, 110, 40}, {2'230, 70, 22}}),
        0);
    return sum;
}

// A motor that gains or loses speed.
Samples motor_glide(std::int32_t ms, std::int64_t from_hz, std::int64_t to_hz) {
    Samples sum = silence(ms);
    for (std::int32_t n = 1; n <= 5; ++n)
        add(sum, tone(ms, from_hz * n * 100, to_hz * n * 100), 0, 100 / (n + 1) + (n == 3 ? 12 : 0));
    return sum;
}

Samples lift_start() {
    Samples sum = silence(690);
    add(sum, struck(strike(120, 2, 6'000, 31), {{420, 14, 80}, {1'560, 8, 50}}), 0, 90);
    add(sum, times(motor_glide(640, 32, 86), swell(1'280, 1, 0)), 40, 80);
    return sum;
}

Samples lift_move() {
    Samples sum = hum_loop({{86, 0, 80}, {172, 0, 34}, {258, 0, 24}, {344, 0, 10}, {430, 0, 6}, {87, 0, 18}});
    add(sum, noise_loop(33, 300, 1'200), 0, 12);
    return sum;
}

Samples lift_stop() {
    Samples sum = silence(690);
    add(sum, shaped(motor_glide(560, 86, 24), 4, 150), 0, 80);
    add(sum, struck(strike(400, 8, 900, 35), {{72, 50, 70}, {143, 34, 70}, {390, 20, 60}}), 250, 90);
    return sum;
}

Samples train_start() {
    Samples sum = silence(990);
    add(sum, clank(41, 60), 0, 60);
    add(sum, times(motor_glide(920, 24, 69), swell(1'840, 1, 0)), 50, 100);
    return sum;
}

Samples train_move() {
    Samples sum = hum_loop({{46, 0, 45}, {92, 0, 60}, {138, 0, 50}, {230, 0, 18}, {47, 0, 20}});
    add(sum, noise_loop(43, 40, 300), 0, 220);
    for (const std::int32_t at_ms : {0, 140, 1'000, 1'140})
        add_around(sum,
                   struck(strike(200, 4, 2'500, 44 + static_cast<std::uint32_t>(at_ms)),
                          {{95, 30, 120}, {540, 18, 40}, {1'130, 12, 25}}),
                   at_ms, 45);
    return sum;
}

Samples train_stop() {
    Samples sum = silence(790);
    add(sum, shaped(motor_glide(700, 69, 20), 4, 200), 0, 80);
    add(sum, clank(47, 55), 300, 60);
    return sum;
}

Samples button() {
    Samples sum = silence(390);
    add(sum, struck(strike(150, 2, 5'000, 51), {{520, 14, 90}, {1'420, 10, 60}, {180, 20, 80}}), 0);
    add(sum, struck(strike(150, 2, 6'500, 52), {{690, 12, 80}, {1'880, 9, 60}}), 95, 60);
    return sum;
}

}  // namespace

std::vector<NamedSound> make_movers() {
    return {{"door_start", finished(door_start(), false, 75)},   {"door_move", finished(door_move(), true, 60)},
            {"door_stop", finished(door_stop(), false, 80)},     {"slab_start", finished(slab_start(), false, 80)},
            {"slab_move", finished(slab_move(), true, 65)},      {"slab_stop", finished(slab_stop(), false, 85)},
            {"gate_start", finished(gate_start(), false, 70)},   {"gate_move", finished(gate_move(), true, 60)},
            {"gate_stop", finished(gate_stop(), false, 80)},     {"lift_start", finished(lift_start(), false, 75)},
            {"lift_move", finished(lift_move(), true, 50)},      {"lift_stop", finished(lift_stop(), false, 80)},
            {"train_start", finished(train_start(), false, 75)}, {"train_move", finished(train_move(), true, 65)},
            {"train_stop", finished(train_stop(), false, 75)},   {"button", finished(button(), false, 75)}};
}

}  // namespace oblong::sound_source
