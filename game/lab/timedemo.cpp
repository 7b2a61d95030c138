#include "game/lab/timedemo.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <utility>
#include <vector>

#include "game/input/tick_input_source.h"

namespace oblong {

TimedemoResult run_timedemo(const LoadedLevel& loaded, Demo demo, GameRenderer& renderer, const Settings& settings,
                            Degrees field_of_view) {
    GameState state = start_of(loaded.level);
    std::vector<std::int64_t> times_ns;
    times_ns.reserve(demo.ticks.size());
    TickInputSource input(state, std::move(demo), false, loaded.data.rules_hash);
    while (input.is_replaying()) {
        input.play_tick(loaded.level, state);
        const InterpolatedState frame{state, state, 0};
        const std::int64_t began_ns = steady_clock_ns();
        renderer.draw({frame, camera_at(frame, {}, field_of_view)}, settings);
        times_ns.push_back(steady_clock_ns() - began_ns);
    }
    TimedemoResult result;
    result.frames = static_cast<std::int64_t>(times_ns.size());
    if (times_ns.empty()) return result;
    for (const std::int64_t time_ns : times_ns) result.total_us += time_ns;
    result.total_us /= 1000;
    std::sort(times_ns.begin(), times_ns.end());
    result.median_us = times_ns[times_ns.size() / 2] / 1000;
    return result;
}

std::string describe(const TimedemoResult& result) {
    const double seconds = static_cast<double>(result.total_us) / 1e6;
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(),
                  "%" PRId64 " frames, %.3f seconds, %.1f frames a second, median %" PRId64 " microseconds",
                  result.frames, seconds, seconds > 0 ? static_cast<double>(result.frames) / seconds : 0.0,
                  result.median_us);
    return text.data();
}

}  // namespace oblong
