#include "game/program.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "engine/platform/files.h"
#include "game/level_search.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

// Before the game is played, not after it.
void check_writable(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    if (fs::is_directory(file)) throw FileError(file, "write", "is a folder, expected a file");
    if (!folder.empty() && !fs::is_directory(folder))
        throw FileError(file, "write", folder.string() + " is no folder, expected a folder for the file");
}

}  // namespace

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
    view_options.map = options.automap;
    view_options.wireframe = options.wireframe;
    view_options.line_method = options.line_method;
    return view_options;
}

LevelFiles level_files_of(const Options& options, const std::string& assets_folder) {
    LevelFiles files{options.level, options.palette, assets_folder, options.models, game_folders_of(options.game)};
    if (!options.map.empty()) files.level = find_named_level(options.map, {"", files.game_folders});
    return files;
}

ProgramFiles load_program_files(const Options& options, const std::string& assets_folder) {
    auto loaded = std::make_shared<const LoadedLevel>(level_files_of(options, assets_folder));
    std::optional<Demo> demo;
    if (!options.replay.empty()) demo = read_parsed(options.replay, decode_demo);
    if (!options.record.empty()) check_writable(options.record);
    const GameState start = start_of(loaded->level);
    return naming_file(options.replay, [&] {
        return ProgramFiles{loaded, TickInputSource(start, std::move(demo), !options.record.empty())};
    });
}

Program::Program(const Options& options, ProgramFiles files, Platform& platform, Workers* workers)
    : options_(options),
      view_options_(view_options_of(options)),
      platform_(platform),
      settings_{options.mode, options.field_of_view, workers} {
    if (options_.shows_gallery)
        gallery_ = std::make_unique<Gallery>(std::move(files.loaded), settings_, view_options_, platform_);
    else
        session_ = std::make_unique<Session>(std::move(files.loaded), settings_, view_options_, std::move(files.input),
                                             platform_);
}

void Program::run() {
    naming_file(options_.replay, [&] {
        while (platform_.is_open()) show_frame();
    });
    if (!options_.record.empty()) write_file(options_.record, encode_demo(session_->input().recorded()));
}

void Program::show_frame() {
    const Controls controls = platform_.poll();
    GameScreen& screen = gallery_ ? static_cast<GameScreen&>(*gallery_) : *session_;
    screen.advance(controls, platform_.now_us());
    const ShownPicture picture = screen.draw();
    platform_.present(picture.canvas, picture.palette, picture.rect);
}

}  // namespace oblong
