#include "tools/demo_level/sounds/grains.h"
#include "tools/demo_level/sounds/sounds.h"

namespace oblong::sound_source {
namespace {

using namespace synth;

// What differs from one step to the next.
struct Step {
    std::uint32_t seed;
    std::int32_t pitch_percent;
};

// The heel, then softer and a little higher the toes.
template <class Contact>
Samples heel_and_toes(const Step& step, std::int32_t toes_ms, std::int32_t toes_percent, Contact contact) {
    Samples sum = silence(320);
    add(sum, contact(step), 0);
    add(sum, contact(Step{step.seed + 50, step.pitch_percent * 109 / 100}), toes_ms, toes_percent);
    return sum;
}

Samples stone_contact(const Step& step) {
    const Samples hit = strike(240, 4, 5'000, step.seed);
    Samples sum = struck(hit, {{118, 16, 45}, {870, 7, 50}, {1'950, 6, 60}, {3'300, 4, 45}}, step.pitch_percent);
    add(sum, high_passed(hit, 700), 0, 90);
    // The hall answers.
    add(sum, low_passed(shaped(noise(230, step.seed + 7), 8, 40), 1'800), 6, 5);
    return sum;
}

Samples wood_contact(const Step& step) {
    const Samples hit = strike(220, 5, 2'200, step.seed);
    Samples sum =
        struck(hit, {{132, 26, 130}, {271, 20, 90}, {498, 13, 55}, {905, 8, 35}, {1'720, 4, 15}}, step.pitch_percent);
    add(sum, hit, 0, 25);
    return sum;
}

Samples metal_contact(const Step& step) {
    const Samples hit = strike(310, 3, 7'000, step.seed);
    Samples sum =
        struck(hit, {{187, 40, 70}, {411, 60, 60}, {1'127, 75, 45}, {1'873, 55, 32}, {2'986, 40, 24}, {4'210, 26, 14}},
               step.pitch_percent);
    add(sum, high_passed(hit, 1'500), 0, 40);
    return sum;
}

Samples earth_contact(const Step& step) {
    Samples sum = struck(strike(200, 9, 500, step.seed), {{74, 24, 9}}, step.pitch_percent);
    Chance chance(step.seed);
    for (std::uint32_t i = 0; i < 14; ++i) {
        const Grain crumb{chance.between(0, 75), chance.between(25, 80), 2'600};
        add(sum, high_passed(strike(26, 5, crumb.hz, step.seed + 100 + i), 500), crumb.at_ms, crumb.percent);
    }
    return sum;
}

Samples carpet_contact(const Step& step) {
    Samples sum = struck(strike(200, 14, 260, step.seed), {{88, 20, 16}, {190, 12, 30}}, step.pitch_percent);
    add(sum, low_passed(shaped(noise(120, step.seed + 3), 12, 16), 900), 0, 75);
    return sum;
}

Samples water_step(const Step& step) {
    Samples sum = silence(480);
    add(sum, high_passed(low_passed(shaped(noise(420, step.seed), 18, 55), 2'400), 350), 0, 120);
    Chance chance(step.seed);
    for (int i = 0; i < 7; ++i) {
        const Grain drop{chance.between(30, 330), chance.between(10, 30), chance.between(420, 1'150),
                         chance.between(40, 90)};
        add(sum, bubble(drop.length_ms, drop.hz), drop.at_ms, drop.percent);
    }
    return sum;
}

void add_variants(std::vector<NamedSound>& sounds, const std::string& name, std::int32_t peak_percent,
                  Samples (*make)(const Step&)) {
    constexpr std::int32_t kPitches[] = {100, 93, 107};
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Step step{11 + i * 17, kPitches[i]};
        sounds.push_back({name + std::to_string(i + 1), finished(make(step), false, peak_percent)});
    }
}

Samples landing() {
    Samples sum = silence(380);
    add(sum, struck(strike(360, 16, 420, 5), {{62, 45, 22}, {101, 30, 26}}), 0);
    add(sum, stone_contact({77, 84}), 4, 130);
    add(sum, stone_contact({91, 90}), 38, 90);
    return sum;
}

}  // namespace

std::vector<NamedSound> make_steps() {
    std::vector<NamedSound> sounds;
    add_variants(sounds, "step_stone", 80, [](const Step& step) { return heel_and_toes(step, 74, 42, stone_contact); });
    add_variants(sounds, "step_wood", 80, [](const Step& step) { return heel_and_toes(step, 82, 50, wood_contact); });
    add_variants(sounds, "step_metal", 75, [](const Step& step) {
        Samples sum = silence(480);
        add(sum, metal_contact(step), 0);
        add(sum, metal_contact({step.seed + 50, step.pitch_percent * 104 / 100}), 70, 40);
        return sum;
    });
    add_variants(sounds, "step_earth", 70, [](const Step& step) { return heel_and_toes(step, 95, 60, earth_contact); });
    add_variants(sounds, "step_carpet", 60,
                 [](const Step& step) { return heel_and_toes(step, 88, 55, carpet_contact); });
    add_variants(sounds, "step_water", 75, water_step);
    sounds.push_back({"land", finished(landing(), false, 85)});
    return sounds;
}

}  // namespace oblong::sound_source
