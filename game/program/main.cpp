#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

#include "engine/files/arguments.h"
#include "engine/files/assets_folder.h"
#include "engine/files/files.h"
#include "engine/files/picture.h"
#include "engine/platform/headless/headless.h"
#include "engine/platform/sdl/sdl.h"
#include "engine/platform/worker_threads.h"
#include "engine/view/screen.h"
#include "game/input/actions.h"
#include "game/input/route.h"
#include "game/lab/timedemo.h"
#include "game/options/options.h"
#include "game/program/error_window.h"
#include "game/program/program.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

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

void hold(Action action, bool is_held, PlatformInput& input) {
    input.events.push_back({is_held ? InputEvent::Kind::Press : InputEvent::Kind::Release, scripted(action), 0, 0});
}

// The input of --headless without a demo, in ticks: 2.5 s ahead, a quarter turn to the right, 4 s ahead with a jump, a
// turn to the left.
PlatformInput short_walk(std::int64_t tick) {
    constexpr std::int64_t kTurn = 87, kAhead = 110, kJump = 130, kLook = 250, kRound = 280;
    const std::int64_t at = tick % kRound;
    PlatformInput input;
    hold(Action::Forward, at < kTurn || (at >= kAhead && at < kLook), input);
    hold(Action::TurnRight, at >= kTurn && at < kAhead, input);
    hold(Action::TurnLeft, at >= kLook, input);
    hold(Action::Jump, at == kJump, input);
    return input;
}

// The input of --headless --gallery: a row a picture.
PlatformInput page_through(std::int64_t poll) {
    PlatformInput input;
    if (poll > 0)
        for (const bool is_held : {true, false}) hold(Action::PageDown, is_held, input);
    return input;
}

std::unique_ptr<Platform> open_platform(const Options& options) {
    if (options.headless_frames == 0) return open_window("Oblong", options.window);
    const auto script = [&options](std::int64_t poll) {
        if (options.shows_gallery) return page_through(poll);
        return options.replay.empty() ? short_walk(poll) : PlatformInput{};
    };
    return std::make_unique<HeadlessPlatform>(options.headless_frames, kTicksPerSecond, script, png_sink(options.out));
}

void time_demo(const Options& options, const LoadedLevel& loaded, Workers& workers) {
    const Demo demo = read_parsed(options.timedemo, decode_demo);
    GameRenderer renderer(loaded.data, loaded.level, options.preferences.mode, &workers);
    warn_of_torn_edges("oblong", loaded.data.level_file, renderer.torn_edges());
    const Settings settings = settings_of(options.preferences);
    const auto result = naming_file(options.timedemo, [&] {
        return run_timedemo(loaded, demo, renderer, settings, options.preferences.field_of_view);
    });
    std::cout << describe(result) << '\n';
}

// Records who walks a route, as fast as it goes.
void record_route(const Options& options, const std::string& assets) {
    const LoadedLevel loaded(level_files_of(options, assets));
    const std::vector<Waypoint> route = read_parsed(options.route, parse_route);
    Demo demo = naming_file(options.route, [&] { return walk_route(loaded.level, route); });
    demo.start_hash ^= loaded.data.rules_hash;
    write_file(options.record, encode_demo(demo));
}

void run_game(const Options& options, PreferencesStore& store, const std::string& assets) {
    if (!options.route.empty()) return record_route(options, assets);
    WorkerThreads workers(static_cast<int>(options.threads));
    if (!options.timedemo.empty()) {
        time_demo(options, LoadedLevel(level_files_of(options, assets)), workers);
        return;
    }
    ProgramFiles files = load_program_files(options, assets);
    const auto platform = open_platform(options);
    const OpenSound open_sound = options.headless_frames == 0 ? OpenSound(open_mixer) : OpenSound();
    Program(options, std::move(files), store, *platform, &workers, open_sound).run();
}

// Runs the game as the command line says; the exit code. Whoever started it from a menu reads no standard error: with
// --error-box an error is shown in a window too, after it was printed.
int run(int argument_count, const char* const* arguments) {
    std::string error_text;
    const int code = run_with_options(argument_count, arguments, [&](const Options& options, PreferencesStore& store) {
        try {
            run_game(options, store, assets_folder(arguments[0]));
        } catch (const std::exception& error) {
            if (options.shows_error_box) error_text = "oblong: " + message_of(error);
            throw;
        }
    });
    if (!error_text.empty()) show_error_window(error_text);
    return code;
}

}  // namespace
}  // namespace oblong

int main(int argc, char** argv) {
    return oblong::run(argc, argv);
}
