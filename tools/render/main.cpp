#include <chrono>
#include <cstdio>
#include <optional>

#include "engine/base/text.h"
#include "engine/effects/palette_effects.h"
#include "engine/io/game_files.h"
#include "engine/level/bsp_read.h"
#include "engine/models/level_models.h"
#include "engine/pictures/picture.h"
#include "engine/platform/worker_threads.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "engine/programs/frame_log.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/scene/level_effects.h"
#include "engine/scene/placed_models.h"
#include "tools/render/camera_list.h"
#include "tools/render/renderer.h"

namespace {

using namespace oblong;

struct Options {
    std::string level, cameras, palette, models, out, json;
    std::string mode = "320x200", display = "4:3", field_of_view = "90", brightness = "1", preset = "bounded",
                effects = "auto", hidden_surfaces = "span-buffer", log, texel_error, view = "first-person",
                seconds = "0", step_seconds = "0", instructions;
    std::vector<std::string> dials;
    std::int64_t repeat = 1, threads = 1;
    bool prints_plan = false, times_whole_frames = false;
};

std::string effect_names() {
    std::string names;
    for (const std::string_view name : kEffectNames) names += (names.empty() ? "" : ",") + std::string(name);
    return names;
}

void declare(CommandArguments& line, Options& options) {
    line.add("LEVEL", options.level, "a Quake level: BSP 29, BSP2 or 2PSB").require();
    line.add("--cameras", options.cameras, "CSV: x,y,z,yaw,pitch[,roll]").require();
    line.add("--palette", options.palette, "768 bytes of red, green, blue (default: the demo level's)");
    line.add("--models", options.models, "folder of Quake's models (README): shows items; misc_model needs none");
    line.add("--out", options.out, "folder for one indexed PNG a camera: 00000.png on");
    line.add("--json", options.json, "file for times, checksums and counts; - for standard output")
        .accept_standard_output();
    line.add("--repeat", options.repeat, "timed renderings of each frame").limit(1, 100'000);
    line.add_flag("--whole-frames", options.times_whole_frames,
                  "time frames without their passes, whose clocks take a few per cent");
    line.add("--mode", options.mode, "pixels, WIDTHxHEIGHT");
    line.add("--display", options.display, "shape of the display, WIDTH:HEIGHT");
    line.add("--view", options.view, kViewSyntax);
    line.add("--fov", options.field_of_view, "degrees across");
    line.add("--brightness", options.brightness, "of the light on surfaces, 0.25 to 8");
    line.add("--accuracy", options.preset, std::string(kPresetNames));
    line.add("--dial", options.dials, "NAME=VALUE, on top of --accuracy; may be given several times (README)");
    line.add("--texel-error", options.texel_error, "largest texture error on screen, pixels (default 0.375)");
    line.add("--effects", options.effects, "auto, none, or names: " + effect_names());
    line.add("--hidden-surfaces", options.hidden_surfaces, "by " + listed(kHiddenSurfaceNames));
    line.add_flag(
        "--plan", options.prints_plan,
        "print the passes and effects of each frame, with their pixels and times (with --json - on standard error)");
    line.add("--log", options.log, "write lines of these kinds on standard error: " + names_of(LogChannels::all()));
    line.add("--instructions", options.instructions, instructions_help());
    line.add("--threads", options.threads,
             "number of threads that draw; default: 1. A second one saves time from about 640x480 on")
        .limit(1, 256);
    line.add("--time", options.seconds, "the scene's time, seconds");
    line.add("--time-step", options.step_seconds, "seconds from each timed rendering of a frame to the next, up to 60");
}

EffectSet parse_effects(const std::string& text) {
    if (text == "auto") return EffectSet::all();
    EffectSet effects;
    if (text == "none") return effects;
    for (const std::string& name : split(text, ",")) {
        const auto known = std::find(kEffectNames.begin(), kEffectNames.end(), name);
        if (known == kEffectNames.end())
            throw UsageError("--effects: '" + text + "', expected auto, none, or names of " + effect_names());
        effects = effects.with(static_cast<Effect>(known - kEffectNames.begin()));
    }
    return effects;
}

Settings make_settings(const Options& options, Preset preset) {
    Settings settings;
    settings.accuracy = parse_accuracy(preset, options.dials);
    settings.brightness_100 = parse_brightness(options.brightness);
    settings.allowed_effects = parse_effects(options.effects);
    settings.kernels = &parse_instructions(options.instructions);
    if (options.texel_error.empty()) return settings;
    if (settings.accuracy.texturing != Texturing::Bounded)
        throw UsageError("--texel-error: is the bound of --accuracy bounded, expected no --accuracy " + options.preset);
    const std::optional<std::int64_t> error_px_256 = parse_decimal(options.texel_error, 8);
    if (!error_px_256 || *error_px_256 < 1 || *error_px_256 > 4096)
        throw UsageError("--texel-error: '" + options.texel_error + "', expected 0.004 to 16 pixels");
    settings.accuracy.pixel_bound_256 = static_cast<std::int32_t>(*error_px_256);
    return settings;
}

std::int64_t parse_time_ms(const std::string& option, const std::string& seconds, std::int64_t most_s) {
    const std::optional<std::int64_t> time_20 = parse_decimal(seconds, 20);
    if (!time_20 || *time_20 < 0 || *time_20 > most_s << 20)
        throw UsageError(option + ": '" + seconds + "', expected 0 to " + std::to_string(most_s) + " seconds");
    return *time_20 * 1000 / (1 << 20);
}

std::string picture_path(const std::string& folder, std::size_t index) {
    char name[32];
    std::snprintf(name, sizeof name, "%05zu.png", index);
    return folder + "/" + name;
}

void report(const ReportHead& head, const std::vector<FrameReport>& frames, const Options& options) {
    const std::string& json_path = options.json;
    const std::string json = json_path.empty() ? "" : report_json(head, frames);
    if (options.prints_plan) std::fputs(plan_text(frames).c_str(), json_path == "-" ? stderr : stdout);
    if (json_path == "-") {
        std::fputs(json.c_str(), stdout);
        return;
    }
    const TimeSummary times = summarize_times(frames);
    std::printf("%zu frames, median %.1f us, 99th percentile %.1f us, level loaded in %.1f ms\n", frames.size(),
                times.median, times.p99, head.load_milliseconds);
    if (!json_path.empty()) write_file(json_path, json);
}

/// The view of each camera by the option.
std::vector<ViewSpec> views_of(std::span<const Camera> cameras, const std::string& option, const ScreenMode& mode,
                               SineMethod sine) {
    const ViewOfCamera view_of = parse_view(option);
    std::vector<ViewSpec> views;
    for (const Camera& camera : cameras)
        views.push_back(option == "first-person"
                            ? first_person_view(camera, sine)
                            : checked_view(view_of, camera, mode, "--view at camera " + std::to_string(views.size())));
    return views;
}

void check_hidden_surfaces(HiddenSurfaces method, std::span<const ViewSpec> views) {
    const auto is_parallel = [](const ViewSpec& view) { return view.is_parallel; };
    if (serves_parallel_views(method) || std::none_of(views.begin(), views.end(), is_parallel)) return;
    throw UsageError("--hidden-surfaces: " + std::string(item(kHiddenSurfaceNames, method)) +
                     " of a parallel view, expected span-buffer or painter");
}

/// The palette that shows a view's picture.
Palette shown_palette(const Palette& palette, const RenderJob& job, const LevelEffects& level_effects,
                      const ViewSpec& view) {
    PaletteEffects effects =
        palette_effects_at(job.scene.level, level_effects, palette, view.eye, job.settings.flashes);
    if (view.is_parallel || !job.settings.allowed_effects.has(Effect::Underwater)) effects.liquid = {};
    return apply_palette_effects(palette, effects, job.scene.time_ms);
}

void render(const Options& options) {
    check_replaces_none("--json", options.json, {options.level, options.cameras, options.palette});
    if (!options.json.empty() && options.json != "-") check_writable(options.json);
    ScreenMode mode;
    parse_mode_size(options.mode, mode);
    mode.display = parse_display(options.display);
    const Degrees field_of_view = parse_field_of_view(options.field_of_view);
    check_view(mode, field_of_view);
    const Preset preset = parse_preset(options.preset);
    const Settings settings = make_settings(options, preset);
    HiddenSurfaceMethod hidden_surfaces(
        static_cast<HiddenSurfaces>(parse_choice("--hidden-surfaces", options.hidden_surfaces, kHiddenSurfaceNames)));
    const LogChannels channels = options.log.empty() ? LogChannels{} : parse_log_channels(options.log);
    constexpr std::int64_t kMostTime_s = 1 << 24, kMostStep_s = 60;
    const std::int64_t time_ms = parse_time_ms("--time", options.seconds, kMostTime_s),
                       step_ms = parse_time_ms("--time-step", options.step_seconds, kMostStep_s);

    const Palette palette = read_parsed(options.palette, read_palette);
    const Colormap colormap = make_colormap(palette);
    const std::vector<Camera> cameras =
        read_parsed(options.cameras, [&](const auto& bytes) { return parse_cameras(bytes, field_of_view); });
    const std::vector<ViewSpec> views = views_of(cameras, options.view, mode, settings.accuracy.sine);
    check_hidden_surfaces(hidden_surfaces.method(), views);

    const auto start = std::chrono::steady_clock::now();
    Level level = read_parsed(options.level, read_bsp);
    print_warnings("oblong-render", options.level, read_lit_file_beside(options.level, level));
    const std::vector<PlacedModel> models = models_at_rest(level);
    const LevelModels level_models = read_level_models(level, palette, {options.level, options.models});
    WorkerThreads workers(static_cast<int>(options.threads));
    FrameWorkspace work(level, mode, &workers);
    work.claimer = &hidden_surfaces;
    const std::chrono::duration<double, std::milli> load = std::chrono::steady_clock::now() - start;

    if (!options.out.empty()) make_folder(options.out);
    const RenderJob job{
        {level, colormap, models, time_ms}, mode,    settings,      views,           static_cast<int>(options.repeat),
        !options.times_whole_frames,        step_ms, &level_models, &hidden_surfaces};
    print_warnings("oblong-render", options.level, texture_warnings(level));
    print_warnings("oblong-render", options.level, work.cache.effects.warnings);
    print_warnings("oblong-render", options.level, work.cache.things.warnings);
    print_warnings("oblong-render", options.level, level_models.warnings);
    warn_of_torn_edges("oblong-render", options.level, work.cache.faces.torn_edges);
    FrameLog log(channels, standard_error_lines());
    const auto frames = render_views(job, work, [&](std::size_t index, std::span<const std::uint8_t> pixels) {
        if (!channels.is_empty()) log.note({job.scene, views[index], mode, settings, work});
        if (options.out.empty()) return;
        const Palette shown = shown_palette(palette, job, work.cache.effects, views[index]);
        const auto png = encode_indexed_png(pixels, mode.width_px, mode.height_px, shown);
        write_file(picture_path(options.out, index), png);
    });
    report(
        {options.level, preset, mode, field_of_view, settings, hidden_surfaces.method(), workers.count(), load.count()},
        frames, options);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CommandLine line("oblong-render", "Renders the frames of a list of cameras, without a window.");
    declare(line, options);
    return line.run(argc, argv, [&] {
        if (options.palette.empty()) options.palette = assets_folder(argv[0]) + "/palette.lmp";
        render(options);
    });
}
