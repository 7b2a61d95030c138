#include "game/options/options.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string_view>

#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "game/options/preference_table.h"

namespace oblong {
namespace {

constexpr std::array<std::string_view, kMapViewCount> kMapNames{"off", "player", "north"};
constexpr std::array<std::string_view, kWireframeCount> kWireframeNames{"off", "over", "alone"};
constexpr std::array<std::string_view, kLineMethodCount> kLineNames{"naive", "dda", "bresenham", "gupta-sproull"};

bool is_dial(const Preference& preference) {
    return preference.name.starts_with("dial-");
}

// The options that are parsed after the command line is read.
struct OptionTexts {
    std::map<std::string, std::string> preferences;  // by name; empty: not given
    std::vector<std::string> dials;
    std::string instructions, window, map = "off", wireframe = "off", lines = "gupta-sproull", log, config;
    bool is_portable = false;
};

void declare_preferences(CommandArguments& line, OptionTexts& texts) {
    for (const Preference& preference : all_preferences()) {
        if (is_dial(preference)) continue;  // --dial is for all of them
        const std::string help =
            preference.help + "; " + preference.values + "; default: " + preference.text(Preferences{});
        if (preference.is_switch)
            line.add_switch(preference.name, texts.preferences[preference.name], help);
        else
            line.add("--" + preference.name, texts.preferences[preference.name], help);
    }
    line.add("--dial", texts.dials, "NAME=VALUE, on top of --accuracy; may be given several times (README)");
}

void declare_runs(CommandArguments& line, Options& options) {
    auto record = line.add("--record", options.record, "write the game played to this demo file");
    auto replay = line.add("--replay", options.replay, "play this demo file instead of the keys");
    auto timedemo = line.add("--timedemo", options.timedemo, "replay this demo file as fast as it goes; no window");
    auto route = line.add("--route", options.route, "walk the waypoints of this CSV file into --record; no window");
    auto headless = line.add("--headless", options.headless_frames,
                             "no window: draw this many ticks of a short walk, or of --replay");
    auto out = line.add("--out", options.out, "folder for the pictures of --headless");
    headless.limit(1, 1'000'000).need(out);
    out.need(headless);
    timedemo.exclude(record).exclude(replay).exclude(headless);
    route.need(record).exclude(replay).exclude(headless);
}

void declare(CommandArguments& line, Options& options, OptionTexts& texts) {
    auto level = line.add("level", options.level, "Quake BSP file to play; without one, the title");
    auto map = line.add("--map", options.map,
                        "name of the level to play, such as e1m1: in this folder, in maps/ or in a pak file (README)");
    map.exclude(level);
    line.add("--watch", options.watch,
             "a level's source (.map): compiles a draft and shows it, again whenever it changes")
        .exclude(level)
        .exclude(map);
    line.add("--room", options.room,
             "begin in the museum's room of this name, with open doors: fog, any-plane and so on");
    line.add("--game", options.game,
             "folder with a game.json, or with maps/ and pak0.pak; default: this folder, and id1/ in it");
    line.add("--palette", options.palette, "768 bytes of red, green, blue; default: the level's, else the demo's");
    line.add("--models", options.models, "folder of Quake's models: shows a level's items (README)");
    line.add_flag("--title", options.shows_title, "begin with the title: the default without a level or another task");
    line.add_flag("--gallery", options.shows_gallery, "show the gallery of the engine's features instead of the game");
    line.add("--log", texts.log,
             "prints lines of these kinds on standard error, once a second: " + names_of(LogChannels::all()));
    line.add("--automap", texts.map, "off, player or north: shows the map, with that direction upwards");
    line.add("--wireframe", texts.wireframe,
             "off, over or alone: draws the edges of faces, over the picture or without it");
    line.add("--lines", texts.lines, "naive, dda, bresenham or gupta-sproull: method that draws the lines of both");
    line.add("--threads", options.threads,
             "number of threads that draw; default: 1. A second one saves time from about 640x480 on")
        .limit(1, 256);
    line.add("--instructions", texts.instructions, instructions_help());
    line.add("--window", texts.window, "WxH, size of the window; default: as large as the desktop allows");
    line.add_flag("--error-box", options.shows_error_box,
                  "show errors in a window too: for starts from the desktop's menu");
    declare_runs(line, options);
    line.add("--config", texts.config, "file of options to use instead of the one in the player's folder");
    line.add_flag("--portable", texts.is_portable, "keep options and saved games beside the program (README)");
    declare_preferences(line, texts);
}

// Applies the preferences of the command line.
void change_by_command_line(const OptionTexts& texts, Preferences& preferences) {
    for (const Preference& preference : all_preferences()) {
        const auto text = texts.preferences.find(preference.name);
        if (text != texts.preferences.end() && !text->second.empty()) preference.parse(preferences, text->second);
    }
    for (const std::string& dial : texts.dials) parse_dial(dial, preferences.accuracy);
    preferences.kernels = &parse_instructions(texts.instructions);
    check_view(preferences.mode, preferences.field_of_view);
}

void interpret(const OptionTexts& texts, Options& options) {
    Preferences checked;  // errors of the command line are reported before any file is read
    change_by_command_line(texts, checked);
    for (const char* name : {"brightness", "gamma", "tube-light"})
        if (const auto text = texts.preferences.find(name); text != texts.preferences.end() && !text->second.empty())
            options.light.insert(*text);
    if (!texts.window.empty()) options.window = parse_window_size(texts.window);
    if (!texts.log.empty()) options.log = parse_log_channels(texts.log);
    options.automap = static_cast<MapView>(parse_choice("--automap", texts.map, kMapNames));
    options.wireframe = static_cast<Wireframe>(parse_choice("--wireframe", texts.wireframe, kWireframeNames));
    options.line_method = static_cast<LineMethod>(parse_choice("--lines", texts.lines, kLineNames));
    const bool has_run = !(options.record + options.replay + options.timedemo).empty();
    if (options.shows_title && (!options.timedemo.empty() || options.shows_gallery))
        throw UsageError("--title: --timedemo and --gallery show none, expected it without them");
    if (!options.room.empty() &&
        (has_run || options.shows_title || options.shows_gallery || options.headless_frames > 0))
        throw UsageError("--room: a walk begins there, expected it without another run, --title and --gallery");
    options.shows_title |= (options.level + options.map + options.watch + options.room).empty() && !has_run &&
                           !options.shows_gallery && options.headless_frames == 0;
    if (options.shows_error_box && (options.headless_frames > 0 || !options.timedemo.empty()))
        throw UsageError("--error-box: no window to show it in, expected it without --headless and --timedemo");
    if (!options.log.is_empty() && !(options.timedemo + options.route).empty())
        throw UsageError("--log: --timedemo and --route write no lines, expected it without them");
    check_replaces_none("--record", options.record,
                        {options.level, options.replay, options.palette, options.watch, texts.config});
    check_replaces_only("--record", options.record, "demo", {"OBLGDEMO"});
    if (options.shows_gallery && has_run)
        throw UsageError("--gallery: there is no game to record or to replay, expected it without the other");
    if (options.shows_gallery && !(options.level + options.map + options.watch + options.game).empty())
        throw UsageError("--gallery: it is drawn in the museum, expected it without LEVEL, --map, --watch and --game");
}

namespace fs = std::filesystem;

// An absolute path from the environment, with `below` added; empty if there is none.
fs::path environment_folder(const char* variable, const char* below) {
    const char* const value = std::getenv(variable);
    if (value == nullptr || !fs::path(value).is_absolute()) return {};
    return fs::path(value) / below;
}

fs::path base_folder(const char* variable, const char* below_home) {
    const fs::path given = environment_folder(variable, "");
    return given.empty() ? environment_folder("HOME", below_home) : given;
}

// $XDG_CONFIG_HOME/oblong/oblong.cfg and $XDG_DATA_HOME/oblong, by the XDG Base Directory Specification; if these are
// unset or not absolute, below ~/.config and ~/.local/share.
PlayerFolders desktop_folders() {
    const fs::path config = base_folder("XDG_CONFIG_HOME", ".config");
    const fs::path data = base_folder("XDG_DATA_HOME", ".local/share");
    PlayerFolders folders;
    if (!config.empty()) folders.config_file = (config / "oblong" / "oblong.cfg").string();
    if (!data.empty()) folders.data = (data / "oblong").string();
    return folders;
}

// Both in the folder oblong-data below the program's folder.
PlayerFolders portable_folders(const std::string& program_folder) {
    const fs::path folder = fs::path(program_folder) / "oblong-data";
    return {(folder / "oblong.cfg").string(), folder.string()};
}

// Measured and replayed runs are the same for every player: they read no player's files, except a named --config.
PlayerFolders folders_of(const OptionTexts& texts, const Options& options, const char* program) {
    PlayerFolders folders;
    const bool is_played = options.headless_frames == 0 && (options.timedemo + options.replay + options.record).empty();
    if (is_played) folders = texts.is_portable ? portable_folders(program_folder(program)) : desktop_folders();
    if (!texts.config.empty()) folders.config_file = texts.config;
    const bool lacks_config = folders.config_file.empty(), lacks_data = folders.data.empty();
    if (is_played && (lacks_config || lacks_data))
        folders.fault = std::string(!lacks_data     ? "Options are not"
                                    : !lacks_config ? "Games are not"
                                                    : "Nothing is") +
                        " saved: HOME is no absolute path, expected the player's folder there, or --portable";
    return folders;
}

}  // namespace

int run_with_options(int argument_count, const char* const* arguments,
                     const std::function<void(const Options&, PreferencesStore&)>& body) {
    Options options;
    OptionTexts texts;
    CommandLine line("oblong", "A world of 320x200 pixels in the right shape. " +
                                   name_of(default_bindings().inputs_of(Action::ShowHelp).front()) +
                                   " in the game lists its keys.");
    declare(line, options, texts);
    return line.run(argument_count, arguments, [&] {
        interpret(texts, options);
        options.folders = folders_of(texts, options, arguments[0]);
        PreferencesStore store(options.folders.config_file);
        print_fault("oblong", options.folders.fault);
        for (const std::string& fault : store.faults()) print_fault("oblong", fault);
        options.preferences = store.kept();
        change_by_command_line(texts, options.preferences);
        store.begin_with(options.preferences);
        body(options, store);
    });
}

}  // namespace oblong
