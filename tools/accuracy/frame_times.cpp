#include "tools/accuracy/frame_times.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

namespace oblong {
namespace {

constexpr int kMostUnlitRounds = 7;

/// The times of one frame with one setting, one for each round.
using Rounds = std::vector<double>;

double nanoseconds_of(LevelFrames& frames, const Camera& camera, const Accuracy& accuracy,
                      EffectSet effects = kStillEffects) {
    const std::int64_t start_ns = steady_clock_ns();
    frames.draw(camera, accuracy, effects);
    return static_cast<double>(steady_clock_ns() - start_ns);
}

double warm_nanoseconds(LevelFrames& frames, const Camera& camera, const Accuracy& accuracy,
                        EffectSet effects = kStillEffects) {
    frames.draw(camera, accuracy, effects);
    return nanoseconds_of(frames, camera, accuracy, effects);
}

TimeSpread mean_of(std::span<const Rounds> frames) {
    TimeSpread mean;
    const auto count = static_cast<double>(frames.size());
    for (const Rounds& times : frames) {
        const TimeSpread spread = spread_of(times);
        mean.median += spread.median / count;
        mean.low += spread.low / count;
        mean.high += spread.high / count;
    }
    return mean;
}

/// Times of every setting: for each a list of frames, by level.
using TimesTable = std::vector<std::vector<Rounds>>;

std::size_t frame_count(std::span<const LevelFrames> levels) {
    std::size_t count = 0;
    for (const LevelFrames& level : levels) count += level.level().cameras.size();
    return count;
}

/// Calls visit(level's frames, camera, index of the frame) for all frames.
template <class Visit>
void for_each_frame(std::span<LevelFrames> levels, Visit visit) {
    std::size_t frame = 0;
    for (LevelFrames& level : levels)
        for (const Camera& camera : level.level().cameras) visit(level, camera, frame++);
}

std::vector<std::size_t> timed_settings(const Configurations& configurations) {
    std::vector<std::size_t> timed;
    for (std::size_t i = 0; i < configurations.accuracies.size(); ++i)
        if (configurations.has_cost[i]) timed.push_back(i);
    return timed;
}

/// Settings with other surfaces than the default, and the default.
std::vector<std::size_t> settings_with_own_surfaces(const Configurations& configurations) {
    std::vector<std::size_t> settings;
    const Accuracy& plain = configurations.accuracies[configurations.default_index];
    for (const std::size_t i : timed_settings(configurations)) {
        const Accuracy& accuracy = configurations.accuracies[i];
        if (i == configurations.default_index || !has_same_surfaces(accuracy, plain) || accuracy.mip != plain.mip ||
            accuracy.mip_bias != plain.mip_bias)
            settings.push_back(i);
    }
    return settings;
}

void time_round(const Configurations& configurations, std::span<const std::size_t> settings,
                std::span<LevelFrames> levels, std::size_t round, TimesTable& times) {
    for_each_frame(levels, [&](LevelFrames& level, const Camera& camera, std::size_t frame) {
        for (std::size_t k = 0; k < settings.size(); ++k) {
            const std::size_t i = settings[(k + round) % settings.size()];  // rotates which one is first
            times[i][frame].push_back(warm_nanoseconds(level, camera, configurations.accuracies[i]));
        }
    });
}

void time_unlit_round(const Configurations& configurations, std::span<const std::size_t> settings,
                      std::span<LevelFrames> levels, TimesTable& times) {
    for_each_frame(levels, [&](LevelFrames& level, const Camera& camera, std::size_t frame) {
        for (const std::size_t i : settings) {
            level.forget_surfaces(configurations.accuracies[i]);
            times[i][frame].push_back(nanoseconds_of(level, camera, configurations.accuracies[i]));
        }
    });
}

SkyTimes time_sky(const Accuracy& accuracy, std::span<LevelFrames> levels, int rounds) {
    const EffectSet no_sky = EffectSet{}.with(Effect::Liquid).with(Effect::BrushModels);
    SkyTimes sky;
    for_each_frame(levels, [&](LevelFrames& level, const Camera& camera, std::size_t) {
        if (level.count(camera, accuracy).stages.sky_pixels == 0) return;
        Rounds with, without;
        for (int round = 0; round < rounds; ++round) {
            with.push_back(warm_nanoseconds(level, camera, accuracy));
            without.push_back(warm_nanoseconds(level, camera, accuracy, no_sky));
        }
        ++sky.frames;
        sky.with_sky += spread_of(with).median;
        sky.without += spread_of(without).median;
    });
    if (sky.frames == 0) return sky;
    sky.with_sky /= static_cast<double>(sky.frames);
    sky.without /= static_cast<double>(sky.frames);
    return sky;
}

}  // namespace

std::string machine_name() {
    std::ifstream cpus("/proc/cpuinfo");
    for (std::string line; std::getline(cpus, line);) {
        const std::size_t colon = line.find(':');
        if (!line.starts_with("model name") || colon == std::string::npos) continue;
        return line.substr(std::min(colon + 2, line.size())) + ", " +
               std::to_string(std::thread::hardware_concurrency()) + " threads";
    }
    return "unknown";
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "gcc " __VERSION__;
#else
    return "unknown";
#endif
}

FrameTimes time_frames(const Configurations& configurations, std::span<LevelFrames> levels, int rounds,
                       const map::WorkSharing& work) {
    const std::size_t settings = configurations.accuracies.size();
    const std::vector<std::size_t> timed = timed_settings(configurations);
    const std::vector<std::size_t> own_surfaces = settings_with_own_surfaces(configurations);
    FrameTimes result{
        std::vector<std::optional<SettingTimes>>(settings), {}, rounds, std::min(rounds, kMostUnlitRounds)};

    TimesTable times(settings, std::vector<Rounds>(frame_count(levels))), unlit_times = times;
    const std::int64_t began_ns = steady_clock_ns();
    const std::clock_t used = std::clock();
    for (int round = 0; round < result.unlit_rounds; ++round)
        time_unlit_round(configurations, own_surfaces, levels, unlit_times);
    work.for_each(as_size(rounds), [&](std::size_t round) { time_round(configurations, timed, levels, round, times); });

    for (const std::size_t i : timed) result.settings[i] = SettingTimes{mean_of(times[i]), {}};
    for (const std::size_t i : own_surfaces) result.settings[i]->unlit = mean_of(unlit_times[i]);
    result.sky = time_sky(configurations.accuracies[configurations.default_index], levels, rounds);
    const double used_ns = static_cast<double>(std::clock() - used) * (1e9 / CLOCKS_PER_SEC);
    result.share_of_processor = std::min(1.0, used_ns / static_cast<double>(steady_clock_ns() - began_ns));
    return result;
}

}  // namespace oblong
