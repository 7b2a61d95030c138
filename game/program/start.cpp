#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/io/files.h"
#include "engine/io/system.h"
#include "engine/platform/sdl/sdl.h"
#include "engine/platform/worker_threads.h"
#include "engine/programs/arguments.h"
#include "game/input/route.h"
#include "game/lab/error_meter.h"
#include "game/lab/timedemo.h"
#include "game/options/options.h"
#include "game/program/map_watch.h"
#include "game/program/program.h"

namespace oblong {
namespace {

std::unique_ptr<Platform> open_platform(const Options& options) {
    if (options.headless_frames > 0) return open_headless(options);
    auto window = open_window("Oblong", options.window);
    end_with_terminal();  // SDL's window takes SIGTERM, upon which the game saves
    return window;
}

void time_demo(const Options& options, const LoadedLevel& loaded, Workers& workers) {
    Demo demo = read_parsed(options.timedemo, decode_demo);
    GameRenderer renderer(loaded.data, loaded.level, options.preferences.mode, &workers);
    warn_of_torn_edges("oblong", loaded.data.level_file, renderer.torn_edges());
    const Settings settings = settings_of(options.preferences);
    const std::string result = naming_file(options.timedemo, [&] {
        return run_timedemo(loaded, std::move(demo), renderer, settings, options.preferences.field_of_view);
    });
    std::puts(result.c_str());
}

// Records the walk along a route, as fast as possible.
void record_route(const Options& options, const std::string& assets) {
    check_writable(options.record);
    const LoadedLevel loaded(level_files_of(options, assets));
    const std::vector<Waypoint> route = read_parsed(options.route, parse_route);
    Demo demo = naming_file(options.route, [&] { return walk_route(loaded.level, route); });
    demo.start_hash = start_hash_of(start_of(loaded.level), loaded.data.rules_hash);
    write_file(options.record, encode_demo(demo));
}

std::shared_ptr<MapWatch> watch_of(const Options& options, const char* called_as) {
    if (options.watch.empty()) return nullptr;
    auto watch = std::make_shared<MapWatch>(options.watch, program_folder(called_as) + "/oblong-map", options.game);
    const bool has_window = options.headless_frames == 0 && (options.timedemo + options.route).empty();
    watch->compile_first(has_window && !options.shows_error_box);
    return watch;
}

std::string gallery_program(const char* called_as) {
    return program_folder(called_as) + "/oblong-gallery";
}

[[noreturn]] void fail_to_start(const std::string& program) {
    throw FileError(program, "file",
                    std::string(std::strerror(errno)) + ", expected the gallery's program beside oblong");
}

// In a window of its own, one at a time.
std::function<void()> gallery_starter(const std::string& program, const PlayerFolders& folders) {
    std::vector<std::string> words{program, "--gallery", "--error-box"};
    if (!folders.config_file.empty()) words.insert(words.end(), {"--config", folders.config_file});
    return [program, words, started = std::optional<int>()]() mutable {
        if (started && state_of_program(*started) == ProgramState::Runs) return;
        started = start_program(words, "/dev/null");
        if (!started) fail_to_start(program);
    };
}

void become_gallery(int argument_count, const char* const* arguments) {
    const std::string program = gallery_program(arguments[0]);
    std::vector<std::string> words(arguments, arguments + argument_count);
    words[0] = program;
    replace_program(words);
    fail_to_start(program);
}

void run_game(Options options, PreferencesStore& store, const char* called_as, OpenGallery open_gallery) {
    const std::string assets = assets_folder(called_as);
    const std::shared_ptr<MapWatch> watch = watch_of(options, called_as);
    if (watch) options.level = watch->level_file();
    if (!options.route.empty()) return record_route(options, assets);
    WorkerThreads workers(static_cast<int>(options.threads));
    if (!options.timedemo.empty()) {
        time_demo(options, LoadedLevel(level_files_of(options, assets)), workers);
        return;
    }
    ProgramFiles files = load_program_files(options, assets);
    files.watch = watch;
    if (options.headless_frames > 0) options.preferences.machine.reset();  // a picture a tick
    const auto platform = open_platform(options);
    show_icon(*files.loaded->files.game, *platform);
    const OpenSound open_sound = options.headless_frames == 0 ? OpenSound(open_mixer) : OpenSound();
    ProgramParts parts{&workers, open_sound, open_reference_meter, open_gallery};
    if (!open_gallery) parts.start_gallery = gallery_starter(gallery_program(called_as), options.folders);
    Program(options, std::move(files), store, *platform, std::move(parts)).run();
}

}  // namespace

int start_game(int argument_count, const char* const* arguments, OpenGallery open_gallery) {
    std::string error_text;
    const int code = run_with_options(argument_count, arguments, [&](const Options& options, PreferencesStore& store) {
        try {
            if (options.shows_gallery && !open_gallery) become_gallery(argument_count, arguments);
            run_game(options, store, arguments[0], open_gallery);
        } catch (const std::exception& error) {
            if (options.shows_error_box) error_text = "oblong: " + message_of(error);
            throw;
        }
    });
    if (!error_text.empty()) show_error_window(error_text);
    return code;
}

int start_game(int argument_count, const char* const* arguments) {
    return start_game(argument_count, arguments, nullptr);
}

}  // namespace oblong
