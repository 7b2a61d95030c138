#include "game/lab/timedemo.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <numeric>
#include <utility>
#include <vector>

#include "game/input/tick_input_source.h"

namespace oblong {

std::string run_timedemo(const LoadedLevel& loaded, Demo demo, GameRenderer& renderer, const Settings& settings,
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
    std::sort(times_ns.begin(), times_ns.end());
    const std::int64_t total_us = std::accumulate(times_ns.begin(), times_ns.end(), std::int64_t{0}) / 1000;
    const std::int64_t median_us = times_ns.empty() ? 0 : times_ns[times_ns.size() / 2] / 1000;
    const double seconds = static_cast<double>(total_us) / 1e6, frames = static_cast<double>(times_ns.size());
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(),
                  "%.0f frames, %.3f seconds, %.1f frames a second, median %" PRId64 " microseconds", frames, seconds,
                  seconds > 0 ? frames / seconds : 0.0, median_us);
    return text.data();
}

}  // namespace oblong
