#include "game/options.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "tools/common/arguments.h"
#include "tools/common/command_line.h"

namespace oblong {
namespace {

Scaling scaling_of(const std::string& name) {
    for (int i = 0; i < kScalingCount; ++i)
        if (name == name_of(static_cast<Scaling>(i))) return static_cast<Scaling>(i);
    throw UsageError("--scaling: '" + name + "', expected sharp, rows, even, nearest or stretch");
}

bool corrects_projection_of(const std::string& name) {
    if (name == "display" || name == "square") return name == "display";
    throw UsageError("--aspect-projection: '" + name + "', expected display or square");
}

// The value of an option that is one of some names, from 0.
template <class Enum, std::size_t Count>
Enum named_value(const std::string& option, const std::string& name, const std::array<std::string_view, Count>& names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<Enum>(found - names.begin());
    std::string expected;
    for (std::size_t i = 0; i < Count; ++i)
        expected += (i == 0 ? "" : i + 1 == Count ? " or " : ", ") + std::string(names[i]);
    throw UsageError(option + ": '" + name + "', expected " + expected);
}
constexpr std::array<std::string_view, kMapViewCount> kMapNames{"off", "player", "north"};
constexpr std::array<std::string_view, kWireframeCount> kWireframeNames{"off", "over", "alone"};
constexpr std::array<std::string_view, kLineMethodCount> kLineNames{"naive", "dda", "bresenham", "gupta-sproull"};

ShownAs shown_as_of(const std::string& name) {
    constexpr std::array<std::string_view, kShownAsCount> names{"display", "square", "fill"};
    for (int i = 0; i < kShownAsCount; ++i)
        if (name == names[static_cast<std::size_t>(i)]) return static_cast<ShownAs>(i);
    throw UsageError("--aspect-display: '" + name + "', expected display, square or fill");
}

std::int32_t gamma_of(const std::string& text) {
    constexpr std::int64_t kOne_16 = 1 << 16;
    const std::int64_t gamma_16 = parse_number("--gamma", text, 16);
    if (gamma_16 < kOne_16 / 2 || gamma_16 > kOne_16 * 2)
        throw UsageError("--gamma: '" + text + "', expected 0.5 to 2");
    return static_cast<std::int32_t>((gamma_16 * 100 + kOne_16 / 2) / kOne_16);
}

Flashes flashes_of(const std::string& name) {
    constexpr std::array<std::string_view, 3> kNames{"full", "reduced", "off"};
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) throw UsageError("--flashes: '" + name + "', expected full, reduced or off");
    return static_cast<Flashes>(found - kNames.begin());
}

// The options that are parsed after the command line is read.
struct OptionTexts {
    std::string mode = "320x200", display = "4:3", field_of_view = "90", brightness = "1", gamma = "1",
                flashes = "full", window, accuracy = "bounded", scaling = "sharp", aspect_projection = "display",
                aspect_display = "display", automap = "off", wireframe = "off", lines = "gupta-sproull", log;
    std::vector<std::string> dials;
};

void declare(Command& line, Options& options, OptionTexts& texts) {
    auto level = line.add("level", options.level, "Quake BSP file to play; without one, the demo level");
    line.add("--map", options.map, "level to play by its name, as e1m1: beside, in maps/ or in a pak file (README)")
        .exclude(level);
    line.add("--game", options.game, "folder with maps/ and pak0.pak; default: the current one, and id1 in it");
    line.add("--palette", options.palette, "768 bytes of red, green, blue; default: the level's, else the demo's");
    line.add("--models", options.models, "folder of Quake's models: shows a level's items (README)");
    line.add("--mode", texts.mode, "WxH, size of the picture in pixels");
    line.add("--display", texts.display, "W:H, shape of the display that the picture is for");
    line.add("--fov", texts.field_of_view, "degrees seen across the whole width");
    line.add("--brightness", texts.brightness, "of the light on surfaces, 0.25 to 8; real levels are dark at 1");
    line.add("--gamma", texts.gamma, "of the display, 0.5 to 2: above 1, dark colours are brighter");
    line.add("--flashes", texts.flashes, "full, reduced or off: lights that flicker, colours that change, flashes");
    line.add("--accuracy", texts.accuracy, "1991, 1994, 1996, bounded or exact");
    line.add("--dial", texts.dials, "NAME=VALUE, on top of --accuracy; may be given several times (README)");
    line.add("--scaling", texts.scaling, "sharp, rows, even, nearest or stretch");
    line.add_flag("--crt", options.has_crt_look, "scanlines, mask and glow of a tube, drawn by the window");
    line.add("--aspect-projection", texts.aspect_projection, "display or square: which pixels F2 starts with");
    line.add("--aspect-display", texts.aspect_display, "display, square or fill: which shape F3 starts with");
    line.add_flag("--gallery", options.shows_gallery, "all that the engine can do, one thing after the other; no game");
    line.add("--log", texts.log,
             "once a second, lines of these kinds on standard error: " + names_of(LogChannels::all()));
    line.add("--automap", texts.automap, "off, player or north: the map that Tab shows, and what is up on it");
    line.add("--wireframe", texts.wireframe, "off, over or alone: the edges that E shows");
    line.add("--lines", texts.lines, "naive, dda, bresenham or gupta-sproull: how lines of both are drawn");
    line.add("--threads", options.threads, "that draw; default: 1. A second one pays from about 640x480 on")
        .limit(1, 256);
    line.add("--window", texts.window, "WxH, size of the window; default: what the desktop has room for");
    line.add_flag("--error-box", options.shows_error_box,
                  "show an error in a window too; the desktop's menu asks for it");
    auto record = line.add("--record", options.record, "write the game played to this demo file");
    auto replay = line.add("--replay", options.replay, "play this demo file instead of the keys");
    auto timedemo = line.add("--timedemo", options.timedemo, "replay this demo file as fast as it goes; no window");
    auto route = line.add("--route", options.route, "walk the waypoints of this CSV file into --record; no window");
    auto headless = line.add("--headless", options.headless_frames,
                             "no window: draw so many ticks of a short walk, or of --replay");
    auto out = line.add("--out", options.out, "folder for the pictures of --headless");
    headless.limit(1, 1'000'000).need(out);
    out.need(headless);
    timedemo.exclude(record).exclude(replay).exclude(headless);
    record.exclude(replay);
    route.need(record).exclude(headless);
}

void interpret(const OptionTexts& texts, Options& options) {
    parse_mode_size(texts.mode, options.mode);
    options.mode.display = parse_display(texts.display);
    if (!texts.window.empty()) options.window = parse_window_size(texts.window);
    options.field_of_view = parse_field_of_view(texts.field_of_view);
    check_view(options.mode, options.field_of_view);
    options.brightness_100 = parse_brightness(texts.brightness);
    options.gamma_100 = gamma_of(texts.gamma);
    options.flashes = flashes_of(texts.flashes);
    options.preset = parse_preset(texts.accuracy);
    options.accuracy = parse_accuracy(options.preset, texts.dials);
    options.scaling = scaling_of(texts.scaling);
    options.corrects_projection = corrects_projection_of(texts.aspect_projection);
    options.shown_as = shown_as_of(texts.aspect_display);
    if (!texts.log.empty()) options.log = parse_log_channels(texts.log);
    options.automap = named_value<MapView>("--automap", texts.automap, kMapNames);
    options.wireframe = named_value<Wireframe>("--wireframe", texts.wireframe, kWireframeNames);
    options.line_method = named_value<LineMethod>("--lines", texts.lines, kLineNames);
    if (options.shows_error_box && (options.headless_frames > 0 || !options.timedemo.empty()))
        throw UsageError("--error-box: nobody is there to close it, expected it without --headless or --timedemo");
    if (options.shows_gallery && !(options.record + options.replay + options.timedemo).empty())
        throw UsageError("--gallery: there is no game to record or to replay, expected it without the other");
}

}  // namespace

int run_with_options(int argument_count, const char* const* arguments,
                     const std::function<void(const Options&)>& body) {
    Options options;
    OptionTexts texts;
    CommandLine line("oblong", "A world of 320x200 pixels in the right shape. F1 in the game lists its keys.");
    declare(line, options, texts);
    return line.run(argument_count, arguments, [&] {
        interpret(texts, options);
        body(options);
    });
}

}  // namespace oblong
