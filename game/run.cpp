#include "game/run.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "engine/platform/files.h"
#include "engine/platform/headless/headless.h"
#include "engine/platform/sdl/window.h"
#include "game/session.h"
#include "game/short_walk.h"
#include "game/timedemo.h"
#include "tools/common/png.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

Choices choices_of(const Options& options) {
    Choices choices;
    choices.preset = options.preset;
    choices.scaling = options.scaling;
    return choices;
}

// Writes 00000.png, 00001.png and so on into a folder.
HeadlessPlatform::FrameSink png_sink(const std::string& folder) {
    make_folder(folder);
    return [folder, frame = 0](Framebuffer picture, const Palette& palette) mutable {
        char name[16];
        std::snprintf(name, sizeof name, "%05d.png", frame++);
        const std::size_t size =
            static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(picture.height_px);
        write_file((fs::path(folder) / name).string(),
                   encode_indexed_png({picture.pixels, size}, picture.width_px, picture.height_px, palette));
    };
}

std::unique_ptr<Platform> open_platform(const Options& options) {
    if (options.headless_frames == 0) return open_window("Oblong", options.window);
    const bool replays = !options.replay.empty();
    return std::make_unique<HeadlessPlatform>(
        options.headless_frames, kTicksPerSecond,
        [replays](std::int64_t poll) { return replays ? Controls{} : short_walk(poll); }, png_sink(options.out));
}

void time_demo(const Options& options, const GameData& data, const Stage& stage) {
    const Demo demo = read_parsed(options.timedemo, decode_demo);
    Painter painter(data, stage, options.mode);
    const Settings settings = settings_of(choices_of(options));
    const auto result = naming_file(
        options.timedemo, [&] { return run_timedemo(stage, demo, painter, settings, options.field_of_view); });
    std::cout << describe(result) << '\n';
}

// Before the game is played, not after it.
void expect_place_for(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    if (fs::is_directory(file)) throw FileError(file, "write", "is a folder, expected a file");
    if (!folder.empty() && !fs::is_directory(folder))
        throw FileError(file, "write", folder.string() + " is no folder, expected a place for a file");
}

void play(const Options& options, const GameData& data, const Stage& stage) {
    std::optional<Demo> demo;
    if (!options.replay.empty()) demo = read_parsed(options.replay, decode_demo);
    const bool records = !options.record.empty();
    if (records) expect_place_for(options.record);
    naming_file(options.replay, [&] {
        Hands hands(start_of(stage), demo, records);
        const auto platform = open_platform(options);
        Session(data, stage, {options.mode, options.field_of_view, choices_of(options)}, hands, *platform).run();
        if (records) write_file(options.record, encode_demo(hands.recorded()));
    });
}

}  // namespace

void run_game(const Options& options, const std::string& assets_folder) {
    const GameData data = load_game(options.level, options.palette, assets_folder);
    const Stage stage = make_stage(data.level);
    if (!options.timedemo.empty())
        time_demo(options, data, stage);
    else
        play(options, data, stage);
}

}  // namespace oblong
