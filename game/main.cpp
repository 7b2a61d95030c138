#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "engine/platform/files.h"
#include "engine/platform/headless/headless.h"
#include "engine/platform/sdl/window.h"
#include "engine/platform/worker_threads.h"
#include "engine/screen/screen.h"
#include "game/gallery.h"
#include "game/options.h"
#include "game/session.h"
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

ViewOptions view_options_of(const Options& options) {
    ViewOptions view_options;
    view_options.preset = options.preset;
    view_options.brightness_100 = options.brightness_100;
    view_options.gamma_100 = options.gamma_100;
    view_options.flashes = options.flashes;
    view_options.accuracy = options.accuracy;
    view_options.has_crt_look = options.has_crt_look;
    view_options.scaling = options.scaling;
    view_options.corrects_projection = options.corrects_projection;
    view_options.shown_as = options.shown_as;
    view_options.log = options.log;
    view_options.map = options.map;
    view_options.wireframe = options.wireframe;
    view_options.line_method = options.line_method;
    return view_options;
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

void show_gallery(const Options& options, const GameData& data) {
    const auto platform = open_platform(options);
    Gallery(data, {options.mode, options.field_of_view, view_options_of(options)}, *platform).run();
}

void time_demo(const Options& options, const GameData& data, const GameLevel& level, Workers& workers) {
    const Demo demo = read_parsed(options.timedemo, decode_demo);
    GameRenderer renderer(data, level, options.mode, &workers);
    warn_of_torn_edges("oblong", data.level_file, renderer.torn_edges());
    const Settings settings = settings_of(view_options_of(options));
    const auto result = naming_file(
        options.timedemo, [&] { return run_timedemo(level, demo, renderer, settings, options.field_of_view); });
    std::cout << describe(result) << '\n';
}

// Before the game is played, not after it.
void check_writable(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    if (fs::is_directory(file)) throw FileError(file, "write", "is a folder, expected a file");
    if (!folder.empty() && !fs::is_directory(folder))
        throw FileError(file, "write", folder.string() + " is no folder, expected a folder for the file");
}

void play(const Options& options, const GameData& data, const GameLevel& level, Workers& workers) {
    std::optional<Demo> demo;
    if (!options.replay.empty()) demo = read_parsed(options.replay, decode_demo);
    const bool records = !options.record.empty();
    if (records) check_writable(options.record);
    naming_file(options.replay, [&] {
        TickInputSource input(start_of(level), demo, records);
        const auto platform = open_platform(options);
        Session(data, level, {options.mode, options.field_of_view, view_options_of(options), &workers}, input,
                *platform)
            .run();
        if (records) write_file(options.record, encode_demo(input.recorded()));
    });
}

void run_game(const Options& options, const std::string& assets) {
    const GameData data = load_game(options.level, options.palette, assets, options.models);
    if (options.shows_gallery) return show_gallery(options, data);
    const GameLevel level = naming_file(data.level_file, [&] { return make_game_level(data.level); });
    WorkerThreads workers(static_cast<int>(options.threads));
    if (!options.timedemo.empty())
        time_demo(options, data, level, workers);
    else
        play(options, data, level, workers);
}

}  // namespace
}  // namespace oblong

int main(int argc, char** argv) {
    return oblong::run_with_options(
        argc, argv, [&](const oblong::Options& options) { oblong::run_game(options, oblong::assets_folder(argv[0])); });
}
