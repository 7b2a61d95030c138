#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

#include "engine/platform/files.h"
#include "engine/platform/headless/headless.h"
#include "engine/platform/sdl/window.h"
#include "engine/platform/worker_threads.h"
#include "engine/screen/screen.h"
#include "game/options.h"
#include "game/program.h"
#include "game/timedemo.h"
#include "tools/common/arguments.h"
#include "tools/common/png.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

// build/assets is beside build/bin, wherever the build folder was moved to.
std::string assets_folder(const char* called_as) {
    std::error_code error;
    fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) program = fs::absolute(called_as);
    return (program.parent_path().parent_path() / "assets").string();
}

// Writes 00000.png, 00001.png and so on into a folder.
HeadlessPlatform::FrameSink png_sink(const std::string& folder) {
    make_folder(folder);
    return [folder, frame = 0](Framebuffer picture, const Palette& palette) mutable {
        char name[16];
        std::snprintf(name, sizeof name, "%05d.png", frame++);
        const std::size_t size = pixel_count(picture.width_px, picture.height_px);
        write_file((fs::path(folder) / name).string(),
                   encode_indexed_png({picture.pixels, size}, picture.width_px, picture.height_px, palette));
    };
}

// The input of --headless without a demo, in ticks: 2.5 s ahead, a quarter turn to the right, 4 s ahead with a jump, a
// turn to the left.
Controls short_walk(std::int64_t tick) {
    constexpr std::int64_t kTurn = 87, kAhead = 110, kJump = 130, kLook = 250, kRound = 280;
    const std::int64_t at = tick % kRound;
    Controls controls;
    controls.forward = at < kTurn || (at >= kAhead && at < kLook);
    controls.turn_right = at >= kTurn && at < kAhead;
    controls.turn_left = at >= kLook;
    controls.jump = at == kJump;
    return controls;
}

// The input of --headless --gallery: a row a picture.
Controls page_through(std::int64_t poll) {
    Controls controls;
    if (poll > 0) controls.commands.push_back(Command::PageDown);
    return controls;
}

std::unique_ptr<Platform> open_platform(const Options& options) {
    if (options.headless_frames == 0) return open_window("Oblong", options.window);
    const auto script = [&options](std::int64_t poll) {
        if (options.shows_gallery) return page_through(poll);
        return options.replay.empty() ? short_walk(poll) : Controls{};
    };
    return std::make_unique<HeadlessPlatform>(options.headless_frames, kTicksPerSecond, script, png_sink(options.out));
}

void time_demo(const Options& options, const LoadedLevel& loaded, Workers& workers) {
    const Demo demo = read_parsed(options.timedemo, decode_demo);
    GameRenderer renderer(loaded.data, loaded.level, options.mode, &workers);
    warn_of_torn_edges("oblong", loaded.data.level_file, renderer.torn_edges());
    const Settings settings = settings_of(view_options_of(options));
    const auto result = naming_file(
        options.timedemo, [&] { return run_timedemo(loaded.level, demo, renderer, settings, options.field_of_view); });
    std::cout << describe(result) << '\n';
}

void run_game(const Options& options, const std::string& assets) {
    WorkerThreads workers(static_cast<int>(options.threads));
    if (!options.timedemo.empty()) {
        time_demo(options, LoadedLevel({options.level, options.palette, assets, options.models}), workers);
        return;
    }
    ProgramFiles files = load_program_files(options, assets);
    const auto platform = open_platform(options);
    Program(options, std::move(files), *platform, &workers).run();
}

}  // namespace
}  // namespace oblong

int main(int argc, char** argv) {
    return oblong::run_with_options(
        argc, argv, [&](const oblong::Options& options) { oblong::run_game(options, oblong::assets_folder(argv[0])); });
}
