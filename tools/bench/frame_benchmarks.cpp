#include "engine/accuracy/accuracy.h"
#include "tools/bench/benchmarks.h"

namespace oblong {

namespace {

/// One iteration draws all cameras' frames.
void time_frames(benchmark::State& state, const BenchLevel* level, ScreenMode mode, Preset preset) {
    FrameWorkspace work(level->level, mode);
    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px));
    const Framebuffer out{pixels.data(), mode.width_px, mode.height_px, mode.width_px};
    Settings settings;
    settings.accuracy = accuracy_of(preset);
    const auto draw_all = [&] {
        for (const Camera& camera : level->cameras) draw_frame(level->scene(), camera, mode, settings, work, out);
    };
    draw_all();  // builds the surfaces
    for (auto _ : state) draw_all();
    show_time_per("frame", std::ssize(level->cameras), state);
    show_time_per("pixel", std::ssize(level->cameras) * std::ssize(pixels), state);
}

}  // namespace

void register_frame_benchmarks(const BenchLevel& level, const ScreenMode& mode) {
    for (const Preset preset : {Preset::Year1996, Preset::Bounded, Preset::Exact})
        benchmark::RegisterBenchmark(("frames/" + std::string(name_of(preset))).c_str(), time_frames, &level, mode,
                                     preset)
            ->Unit(benchmark::kMicrosecond);
}

}  // namespace oblong
