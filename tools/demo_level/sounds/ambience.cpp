#include "tools/demo_level/sounds/grains.h"
#include "tools/demo_level/sounds/sounds.h"

namespace oblong::sound_source {
namespace {

using namespace synth;

constexpr std::int32_t kOverlap_ms = 700;

// Noise between two frequencies, as a loop.
Samples band(std::int32_t ms, std::uint32_t seed, std::int32_t above_hz, std::int32_t below_hz) {
    const Samples all = noise(ms + kOverlap_ms, seed);
    return looped(high_passed(low_passed(low_passed(all, below_hz), below_hz), above_hz), kOverlap_ms);
}

// A band that whistles at a frequency.
Samples whistle(std::int32_t ms, std::uint32_t seed, std::int32_t hz, std::int32_t half_life_ms) {
    return looped(ringing(scaled(noise(ms + kOverlap_ms, seed), 10), hz, half_life_ms), kOverlap_ms);
}

Samples wind() {
    constexpr std::int32_t kLength_ms = 8'000;
    Samples sum = times(band(kLength_ms, 3, 60, 420), swell(kLength_ms, 1, 10));
    add(sum, band(kLength_ms, 4, 60, 260), 0, 90);
    add(sum, times(whistle(kLength_ms, 5, 390, 9), swell(kLength_ms, 2, 40, 2)), 0, 55);
    add(sum, times(whistle(kLength_ms, 6, 610, 9), swell(kLength_ms, 3, 75, 2)), 0, 32);
    return sum;
}

void scatter_bubbles(Samples& to, std::int32_t length_ms, int count, const Mode& lowest, const Mode& highest,
                     std::uint32_t seed) {
    Chance chance(seed);
    for (int i = 0; i < count; ++i) {
        const Grain grain{chance.between(0, length_ms - 1), chance.between(lowest.percent, highest.percent),
                          chance.between(lowest.hz, highest.hz),
                          chance.between(lowest.half_life_ms, highest.half_life_ms)};
        add_around(to, bubble(grain.length_ms, grain.hz), grain.at_ms, grain.percent);
    }
}

Samples rain() {
    constexpr std::int32_t kLength_ms = 5'000;
    Samples sum = scaled(band(kLength_ms, 8, 900, 5'500), 34);
    Chance chance(9);
    for (std::uint32_t i = 0; i < 420; ++i) {
        const Grain drop{chance.between(0, kLength_ms - 1), chance.between(6, 38), chance.between(2'500, 8'000)};
        add_around(sum, high_passed(strike(24, 2, drop.hz, 900 + i), 800), drop.at_ms, drop.percent);
    }
    scatter_bubbles(sum, kLength_ms, 60, {900, 20, 4}, {2'200, 45, 12}, 10);
    return sum;
}

Samples water() {
    constexpr std::int32_t kLength_ms = 6'000;
    Samples sum = times(band(kLength_ms, 12, 250, 900), swell(kLength_ms, 4, 0));
    add(sum, band(kLength_ms, 13, 120, 500), 0, 40);
    scatter_bubbles(sum, kLength_ms, 44, {320, 40, 3}, {920, 110, 13}, 14);
    return sum;
}

Samples slime() {
    constexpr std::int32_t kLength_ms = 5'000;
    Samples sum = scaled(band(kLength_ms, 16, 60, 200), 90);
    scatter_bubbles(sum, kLength_ms, 22, {110, 90, 15}, {270, 190, 50}, 17);
    return sum;
}

Samples lava() {
    constexpr std::int32_t kLength_ms = 6'000;
    Samples sum = scaled(band(kLength_ms, 19, 30, 110), 520);
    scatter_bubbles(sum, kLength_ms, 20, {62, 160, 30}, {140, 320, 85}, 20);
    Chance chance(21);
    for (std::uint32_t i = 0; i < 40; ++i) {
        const Grain crack{chance.between(0, kLength_ms - 1), chance.between(5, 26), 3'000};
        add_around(sum, high_passed(strike(30, 3, crack.hz, 1'400 + i), 400), crack.at_ms, crack.percent);
    }
    return sum;
}

Samples fire() {
    constexpr std::int32_t kLength_ms = 4'000;
    Samples sum = times(band(kLength_ms, 23, 80, 340), swell(kLength_ms, 13, 0));
    add(sum, band(kLength_ms, 24, 120, 600), 0, 60);
    Chance chance(25);
    for (std::uint32_t i = 0; i < 46; ++i) {
        const Grain crack{chance.between(0, kLength_ms - 1), chance.between(5, 34), chance.between(2'000, 6'000)};
        add_around(sum, high_passed(strike(22, 2, crack.hz, 1'700 + i), 900), crack.at_ms, crack.percent);
    }
    return sum;
}

// Mains at 50 Hz: twice that, and its multiples.
Samples hum() {
    constexpr std::int32_t kLength_ms = 2'000;
    Samples sum = silence(kLength_ms);
    for (const Mode& partial : {Mode{100, 0, 100}, {200, 0, 46}, {300, 0, 30}, {400, 0, 14}, {600, 0, 12}, {900, 0, 5}})
        add(sum, tone(kLength_ms, partial.hz * 100, partial.hz * 100), 0, partial.percent);
    return sum;
}

Samples sparks() {
    constexpr std::int32_t kLength_ms = 4'000;
    Samples sum = silence(kLength_ms);
    Chance chance(31);
    for (std::int32_t burst = 0; burst < 9; ++burst) {
        const std::int32_t at_ms = chance.between(0, kLength_ms - 1);
        for (std::uint32_t i = 0; i < 14; ++i) {
            const Grain spark{at_ms + chance.between(0, 210), chance.between(10, 80), 9'000};
            add_around(sum, high_passed(strike(16, 1, spark.hz, 2'000 + i), 1'800), spark.at_ms, spark.percent);
        }
    }
    return sum;
}

Samples bubbles() {
    constexpr std::int32_t kLength_ms = 4'000;
    Samples sum = silence(kLength_ms);
    scatter_bubbles(sum, kLength_ms, 40, {300, 45, 12}, {900, 110, 50}, 34);
    return sum;
}

// Drones that beat against each other, in whole cycles.
Samples teleporter() {
    constexpr std::int32_t kLength_ms = 4'000;
    Samples sum = silence(kLength_ms);
    for (const std::int64_t chz : {11'000, 11'050, 16'500, 16'575, 22'000, 33'050})
        add(sum, tone(kLength_ms, chz, chz), 0, static_cast<std::int32_t>(600'000 / chz));
    add(sum, times(whistle(kLength_ms, 37, 1'320, 20), swell(kLength_ms, 3, 0)), 0, 30);
    return sum;
}

Samples under_water() {
    constexpr std::int32_t kLength_ms = 6'000;
    Samples sum = scaled(band(kLength_ms, 39, 40, 170), 130);
    add(sum, times(band(kLength_ms, 40, 80, 330), swell(kLength_ms, 2, 30)), 0, 60);
    scatter_bubbles(sum, kLength_ms, 16, {180, 70, 4}, {420, 150, 14}, 41);
    return sum;
}

}  // namespace

std::vector<NamedSound> make_ambience() {
    return {{"wind", finished(wind(), true, 75)},
            {"rain", finished(rain(), true, 65)},
            {"water", finished(water(), true, 70)},
            {"slime", finished(slime(), true, 70)},
            {"lava", finished(lava(), true, 80)},
            {"fire", finished(fire(), true, 65)},
            {"hum", finished(hum(), true, 40)},
            {"sparks", finished(sparks(), true, 65)},
            {"bubbles", finished(bubbles(), true, 65)},
            {"teleporter", finished(teleporter(), true, 55)},
            {"under_water", finished(under_water(), true, 70)}};
}

std::vector<NamedSound> make_all_sounds() {
    std::vector<NamedSound> all;
    for (const auto make : {make_steps, make_movers, make_water, make_signals, make_ambience})
        for (NamedSound& sound : make()) all.push_back(std::move(sound));
    return all;
}

}  // namespace oblong::sound_source
