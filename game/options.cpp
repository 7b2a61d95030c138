#include "game/options.h"

#include "tools/common/arguments.h"
#include "tools/common/command_line.h"

namespace oblong {
namespace {

[[noreturn]] void refuse(const char* option, const std::string& value, const std::string& expected) {
    throw UsageError(std::string(option) + ": '" + value + "', expected " + expected);
}

Scaling scaling_of(const std::string& name) {
    for (int i = 0; i < kScalingCount; ++i)
        if (name == name_of(static_cast<Scaling>(i))) return static_cast<Scaling>(i);
    refuse("--scaling", name, "sharp, rows, even, nearest or stretch");
}

// The options of numbers and names, as they were written.
struct Words {
    std::string mode = "320x200", display = "4:3", field_of_view = "90", window, accuracy = "bounded",
                scaling = "sharp";
};

void declare(Command& line, Options& options, Words& words) {
    line.add("level", options.level, "Quake BSP file to play; without one, the demo level");
    line.add("--palette", options.palette, "768 bytes of red, green, blue; default: the level's, else the demo's");
    line.add("--mode", words.mode, "WxH, size of the picture in pixels");
    line.add("--display", words.display, "W:H, shape of the display that the picture is for");
    line.add("--fov", words.field_of_view, "degrees seen across the whole width");
    line.add("--accuracy", words.accuracy, "1991, 1994, 1996, bounded or exact");
    line.add("--scaling", words.scaling, "sharp, rows, even, nearest or stretch");
    line.add("--window", words.window, "WxH, size of the window; default: what the desktop has room for");
    auto record = line.add("--record", options.record, "write the game played to this demo file");
    auto replay = line.add("--replay", options.replay, "play this demo file instead of the keys");
    auto timedemo = line.add("--timedemo", options.timedemo, "replay this demo file as fast as it goes; no window");
    auto headless = line.add("--headless", options.headless_frames,
                             "no window: draw so many ticks of a short walk, or of --replay");
    auto out = line.add("--out", options.out, "folder for the pictures of --headless");
    headless.limit(1, 1'000'000).need(out);
    out.need(headless);
    timedemo.exclude(record).exclude(replay).exclude(headless);
    record.exclude(replay);
}

void interpret(const Words& words, Options& options) {
    parse_mode_size(words.mode, options.mode);
    options.mode.display = parse_display(words.display);
    if (!words.window.empty()) options.window = parse_window_size(words.window);
    options.field_of_view = parse_field_of_view(words.field_of_view);
    check_view(options.mode, options.field_of_view);
    options.preset = parse_preset(words.accuracy);
    options.scaling = scaling_of(words.scaling);
}

}  // namespace

int run_with_options(int argument_count, const char* const* arguments,
                     const std::function<void(const Options&)>& body) {
    Options options;
    Words words;
    CommandLine line("oblong", "A world of 320x200 pixels in the right shape. F1 in the game lists its keys.");
    declare(line, options, words);
    return line.run(argument_count, arguments, [&] {
        interpret(words, options);
        body(options);
    });
}

}  // namespace oblong
