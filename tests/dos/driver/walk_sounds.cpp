// How loud the recorded walk is, by the mixer that the game has elsewhere: of each tenth of a second of its first
// ticks, the root of the mean square of its samples, both sides together.    walk_sounds ASSETS TICKS
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "engine/sound/mixer.h"
#include "game/level/load.h"
#include "game/simulation/demo.h"
#include "game/simulation/step.h"
#include "game/sound/game_sound.h"
#include "game/sound/sound_scene.h"

namespace {

using namespace oblong;

constexpr std::size_t kWindow = 2 * Mixer::kRate_hz / 10;

std::vector<std::int16_t> samples_of(const std::string& assets, std::size_t ticks) {
    LevelFiles files;
    files.level = assets + "/demo.bsp";
    files.assets = assets;
    const LoadedLevel loaded(files);
    const Demo demo = read_parsed(assets + "/walk.demo", decode_demo);
    Mixer mixer;
    SoundPlayer player(mixer, {assets + "/sounds"});
    player.take_own(loaded.data.sounds);
    SoundScene scene(loaded.level, &loaded.data.sounds);
    GameState state = start_of(loaded.level);
    std::vector<std::int16_t> samples;
    for (std::size_t tick = 0; tick < ticks && tick < demo.ticks.size(); ++tick) {
        const GameState before = state;
        const TickReport report = step(loaded.level, state, demo.ticks[tick].input);
        scene.note_tick(before, state, report);
        constexpr std::int32_t kLoudness_256 = 204;  // 80 %, as the options have it
        player.play(scene.audible().sounds, kLoudness_256);
        const std::size_t from = samples.size(), end = 2 * (tick + 1) * Mixer::kRate_hz / kTicksPerSecond / 2 * 2;
        samples.resize(end);
        mixer.mix(std::span(samples).subspan(from));
    }
    return samples;
}

void print_loudness(const std::vector<std::int16_t>& samples) {
    for (std::size_t at = 0; at + kWindow <= samples.size(); at += kWindow) {
        double sum = 0;
        for (std::size_t i = 0; i < kWindow; i += 2) {
            const double both = (samples[at + i] + samples[at + i + 1]) / 2.0;
            sum += both * both;
        }
        std::printf("%.1f\n", std::sqrt(sum / (kWindow / 2)));
    }
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("walk_sounds", [&] {
        if (argc != 3) throw UsageError("expected ASSETS TICKS");
        print_loudness(samples_of(argv[1], static_cast<std::size_t>(std::stoi(argv[2]))));
    });
}
