#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "engine/base/checksum.h"
#include "engine/base/table.h"
#include "engine/io/files.h"
#include "engine/platform/headless.h"
#include "game/options/options.h"
#include "game/program/played_game.h"
#include "game/program/program.h"
#include "game/program/program_files.h"
#include "game/program/screens.h"
#include "game/program/session.h"
#include "game/simulation/items.h"
#include "game/simulation/step.h"
#include "tests/support/programs.h"
#include "tests/support/refusal.h"
#include "tests/walk/walked_level.h"

// The example of a game without C++ (game/example), compiled and played as its page says.
namespace oblong {
namespace {

namespace fs = std::filesystem;

PlatformInput no_input(std::int64_t) {
    return {};
}

// Keeps what the window was called.
class NamedWindow final : public test::ScriptedPlatform {
  public:
    using ScriptedPlatform::ScriptedPlatform;
    void set_title(const char* title) override { titles.emplace_back(title); }
    void set_icon(std::span<const std::uint8_t> rgba, WindowSize size) override {
        icon.assign(rgba.begin(), rgba.end());
        icon_size = size;
    }

    std::vector<std::string> titles;
    std::vector<std::uint8_t> icon;
    WindowSize icon_size;
};

class ExampleGame : public testing::Test {
  protected:
    void SetUp() override {
        fs::copy(test::source_folder() + "/game/example", folder_, fs::copy_options::recursive);
        for (const std::string level : {"first", "second", "third"}) {
            ASSERT_EQ(compile(level), 0) << said_;
            EXPECT_EQ(said_, "") << "a warning";
        }
    }
    EndFigures end_figures(const LoadedLevel& level, const GameState& state) const {
        const Options own = options();
        return PlayedGame(own, level).end_figures(level, state);
    }
    // A program of the build, with its options; what it says on standard error goes to `said_`.
    int run(const std::string& command) {
        const auto [exit_code, error] =
            test::run_line(test::at_home_in(temporary_.path("home")) + test::build_folder() + "/bin/" + command);
        said_ = error;
        return exit_code;
    }
    // The game for a picture, or more, with other options.
    int run_game(const std::string& others = "", int pictures = 1) {
        return run("oblong --game " + folder_ + others + " --headless " + std::to_string(pictures) + " --out " +
                   temporary_.path("out"));
    }
    int compile(const std::string& level) {
        const std::string map = folder_ + "/maps/" + level;
        return run("oblong-map " + map + ".map -o " + map + ".bsp --wad " + assets_ + "/demo.wad --game " + folder_);
    }
    Options options() const {
        Options options;
        options.game = folder_;
        return options;
    }
    LoadedLevel loaded(const std::string& level) const {
        LevelFiles files = level_files_of(options(), assets_);
        files.level = level_file_of(*files.game, level);
        return LoadedLevel(files);
    }
    void replace_in_definition(const std::string& part, const std::string& by) const {
        std::string text = read_text(folder_ + "/game.json");
        ASSERT_NE(text.find(part), text.npos);
        text.replace(text.find(part), part.size(), by);
        write_file(folder_ + "/game.json", text);
    }

    const test::TemporaryFolder temporary_;
    const std::string folder_ = temporary_.path("three"), assets_ = test::build_folder() + "/assets";
    std::string said_;
};

// Ahead, always jumping, with Enter once a second: from the title through the three rooms.
TEST_F(ExampleGame, IsPlayedFromTheTitleToTheEnd) {
    Options played = options();
    played.shows_title = true;
    played.folders.data = temporary_.path("data");
    played.preferences.game_speed_100 = 400;
    NamedWindow platform(1200, [](std::int64_t poll) {
        Controls controls;
        if (poll % kTicksPerSecond == 20) controls.menu = {MenuAction::Accept};
        controls.moves.set(Action::Forward);
        controls.moves.set(Action::Jump);
        return test::scripted_input(controls);
    });
    PreferencesStore store;
    Program(played, load_program_files(played, assets_), store, platform, {}).run();
    show_icon(read_game_definition(folder_), platform);
    EXPECT_EQ(platform.icon_size, (WindowSize{32, 32}));
    ASSERT_EQ(platform.icon.size(), 32u * 32 * 4);
    EXPECT_EQ(platform.icon[3], 0) << "the corner is transparent";
    const std::size_t middle = (16 * 32 + 15) * 4;
    EXPECT_EQ((std::vector<std::uint8_t>(platform.icon.begin() + middle, platform.icon.begin() + middle + 4)),
              (std::vector<std::uint8_t>{0xff, 0xe8, 0x90, 0xff}));
    ASSERT_GE(platform.titles.size(), 5u);
    platform.titles.resize(5);
    EXPECT_EQ(platform.titles,
              (std::vector<std::string>{"Three Rooms - first", "Three Rooms - first", "Three Rooms - second",
                                        "Three Rooms - third", "Three Rooms - third"}))
        << "the last one begins again";
    EXPECT_FALSE(fs::is_empty(played.folders.data + "/three")) << "nothing was saved";
    for (const auto& entry : fs::directory_iterator(played.folders.data))
        EXPECT_TRUE(entry.is_directory()) << entry.path() << " is among the museum's";
}

TEST_F(ExampleGame, OwnClassesAreThoseTheyStandForWithTheirValues) {
    const LoadedLevel second = loaded("second");
    ASSERT_EQ(second.level.movers.size(), 1u);
    EXPECT_EQ(second.level.movers[0].kind, MoverKind::Door);
    EXPECT_NEAR(second.level.movers[0].speed_per_tick.raw * double(kTicksPerSecond) / 4096, 30, 0.01);
    EXPECT_EQ(second.level.movers[0].wait_ticks, 6 * kTicksPerSecond);
    ASSERT_EQ(second.level.items.size(), 1u);
    EXPECT_EQ(second.level.items[0].item_class, ItemClass::Lens);
    ASSERT_EQ(second.data.models.meshes.size(), 1u);
    // Two sides of twelve corners and twelve squares between them.
    EXPECT_EQ(second.data.models.meshes[0]->triangles.size(), 2u * 10 + 12 * 2);
}

TEST_F(ExampleGame, AnEntitysOwnValueWins) {
    std::string map = read_text(folder_ + "/maps/second.map");
    const std::string part = "\"angle\" \"-1\"";
    map.replace(map.find(part), part.size(), part + "\n\"speed\" \"70\"");
    write_file(folder_ + "/maps/second.map", map);
    ASSERT_EQ(compile("second"), 0);
    EXPECT_NEAR(loaded("second").level.movers[0].speed_per_tick.raw * double(kTicksPerSecond) / 4096, 70, 0.01);
}

// The room of the demo has no entity of the class whose rule changes: its start is the same state.
TEST_F(ExampleGame, DemosAndSavesBelongToTheirRules) {
    const std::string demo = temporary_.path("walk.demo");
    ASSERT_EQ(run_game(" --record " + demo, 40), 0) << said_;
    EXPECT_EQ(run_game(" --replay " + demo, 40), 0) << said_;
    EXPECT_EQ(run("oblong " + folder_ + "/maps/first.bsp --headless 40 --out " + temporary_.path("out") + " --replay " +
                  demo),
              1);
    const std::uint64_t level_hash = loaded("first").data.level_hash;
    replace_in_definition("\"30\"", "\"31\"");
    EXPECT_EQ(run_game(" --replay " + demo, 40), 1);
    EXPECT_EQ(said_, "oblong: " + demo + ": start: recorded on another level or by other rules, expected this one's\n");
    EXPECT_NE(loaded("first").data.level_hash, level_hash) << "what saves are held to";
    std::set<std::uint64_t> hashes{level_hash, loaded("first").data.level_hash};
    for (const auto& [part, other] : {std::pair{"func_slow_door", "func_slow_gate"},
                                      {"\"is\": \"func_door\"", "\"is\": \"func_door_rotating\""},
                                      {"\"wait\"", "\"dmg\""}}) {
        replace_in_definition(part, other);
        EXPECT_TRUE(hashes.insert(loaded("first").data.level_hash).second) << other;
    }
}

TEST_F(ExampleGame, LevelsFollowInTheirOrder) {
    const GameDefinition game = read_game_definition(folder_);
    EXPECT_EQ(level_after(game, folder_ + "/maps/first.bsp"), "second");
    EXPECT_EQ(level_after(game, folder_ + "/maps/second.bsp"), "third");
    EXPECT_EQ(level_after(game, folder_ + "/maps/third.bsp"), "");
    EXPECT_EQ(level_after(game, assets_ + "/demo.bsp"), "");
}

// While a game is being made.
TEST_F(ExampleGame, ALevelThatIsNotThereStopsOnlyItself) {
    fs::remove(folder_ + "/maps/second.bsp");
    EXPECT_EQ(run_game(), 0) << said_;
    EXPECT_EQ(run_game(" --map third"), 0) << said_;
    EXPECT_EQ(run_game(" --map second"), 1);
    const GameDefinition game = read_game_definition(folder_);
    EXPECT_EQ(level_after(game, folder_ + "/maps/first.bsp"), "second");
    const LoadedLevel first = loaded("first");
    const Options own = options();
    const PlayedGame played(own, first);
    const EndFigures figures = played.end_figures(first, start_of(first.level));
    EXPECT_EQ(figures.next_level, "");
    EXPECT_NE(figures.fault.find("second.bsp"), std::string::npos) << figures.fault;
    EXPECT_EQ(played.levels(first).at(1).file, folder_ + "/maps/second.bsp")
        << "what its row in the menu says is missing";
    fs::remove(folder_ + "/maps/first.bsp");
    EXPECT_EQ(run_game(), 1);
    EXPECT_TRUE(said_.starts_with("oblong: " + folder_ + "/maps/first.bsp: ")) << said_;
}

TEST_F(ExampleGame, ADemoThatIsNotThereIsAWarningOfTheTitle) {
    replace_in_definition("\"levels\"", "\"demo\": \"none.demo\", \"levels\"");
    EXPECT_EQ(run_game(" --title"), 0);
    EXPECT_EQ(said_, "oblong: " + folder_ + "/game.json: warning: /demo: there is no file " + folder_ +
                         "/none.demo, expected one that --record wrote\n");
    EXPECT_EQ(run_game(" --record " + folder_ + "/none.demo"), 0);
    EXPECT_EQ(said_, "") << "of one that is being recorded";
}

TEST_F(ExampleGame, ADemoFromBeforeAChangeIsAWarningOfTheTitle) {
    const std::string demo = folder_ + "/a.demo";
    EXPECT_EQ(run_game(" --record " + demo), 0);
    replace_in_definition("\"levels\"", "\"demo\": \"a.demo\", \"levels\"");
    EXPECT_EQ(run_game(" --title"), 0);
    EXPECT_EQ(said_, "");
    replace_in_definition("\"30\"", "\"31\"");
    EXPECT_EQ(run_game(" --title"), 0);
    EXPECT_EQ(said_, "oblong: " + folder_ + "/game.json: warning: /demo: " + demo +
                         " is not shown: recorded on another level or by other rules, expected the first level's\n");
    EXPECT_EQ(run_game(" --title --map second"), 0);
    EXPECT_EQ(said_, "") << "of a level that it was not recorded for";
}

TEST_F(ExampleGame, AFolderThatHoldsNoGameIsNoMuseum) {
    for (const std::string other : {"/none", "/game.json", "/maps"}) {
        EXPECT_EQ(run_game(other), 1);
        EXPECT_TRUE(said_.starts_with("oblong: " + folder_ + other + ": --game: is no folder")) << said_;
    }
}

TEST_F(ExampleGame, SaysCoinsForLenses) {
    const LoadedLevel first = loaded("first");
    GameState state = start_of(first.level);
    EXPECT_EQ(goal_of(first.level, state).title, "Coins");
    EXPECT_EQ(goal_of(first.level, state).list, "a coin: missing\na coin: missing");
    const GameState before = state;
    state.items[0] = ItemState::Taken;
    EXPECT_EQ(found_text(first.level, before, state), "Coins: 1 of 2. Missing: a coin (east)");
}

TEST_F(ExampleGame, EntitiesHaveSoundsOfTheirOwn) {
    const LoadedLevel first = loaded("first");
    const LevelSounds& own = first.data.sounds;
    ASSERT_EQ(own.sounds.size(), 2u);
    for (const Item& coin : first.level.items)
        EXPECT_EQ(item(own.sounds, item(own.by_entity, coin.entity)).name, "sounds/coin.wav") << "by its class";
    ASSERT_EQ(first.level.movers.size(), 1u);
    const LevelSound& creak = item(own.sounds, item(own.by_entity, first.level.movers[0].entity));
    EXPECT_EQ(creak.name, "sounds/creak.wav");
    EXPECT_EQ(creak.samples.rate_hz, 11'025);
    EXPECT_NEAR(double(creak.samples.samples.size()), 0.9 * 11'025, 1);
}

TEST_F(ExampleGame, ASoundThatIsMissingIsAWarningAndABrokenOneAnError) {
    fs::remove(folder_ + "/sounds/creak.wav");
    replace_in_definition(",\n    \"sounds/creak.wav\": \"a gate creaks\"", "");
    EXPECT_EQ(run_game(), 0);
    EXPECT_NE(said_.find("(func_door_rotating): there is no file sounds/creak.wav for its noise, expected one in " +
                         folder_ + "\n"),
              std::string::npos)
        << said_;
    write_file(folder_ + "/sounds/creak.wav", "RIFF1234AVI ");
    EXPECT_EQ(run_game(), 1);
    EXPECT_EQ(said_, "oblong: " + folder_ + "/sounds/creak.wav: offset 8: no sound, expected WAVE\n");
}

TEST_F(ExampleGame, AnIconThatIsTooLargeIsRefused) {
    fs::copy_file(test::source_folder() + "/assets/readme.png", folder_ + "/large.png");
    replace_in_definition("icon.png", "large.png");
    NamedWindow platform(1, no_input);
    const std::string said = test::refusal<FileError>([&] { show_icon(read_game_definition(folder_), platform); });
    EXPECT_TRUE(said.starts_with(folder_ + "/large.png: size: ")) << said;
    EXPECT_TRUE(said.ends_with("expected up to 256x256 of an icon")) << said;
}

TEST_F(ExampleGame, WhatIsNotKeptIsSaidInTheWindow) {
    const auto shown = [&](const std::string& fault) {
        Options wanted = options();
        wanted.folders.fault = fault;
        std::uint64_t hash = 0;
        HeadlessPlatform platform(2, kTicksPerSecond, no_input, [&](Framebuffer picture, const Palette&) {
            hash = fnv1a_of({picture.pixels, as_size(picture.width_px) * as_size(picture.height_px)});
        });
        PreferencesStore store;
        Program(wanted, load_program_files(wanted, assets_), store, platform, {}).run();
        return hash;
    };
    EXPECT_NE(shown("Nothing is saved"), shown(""));
}

TEST(PlayersFolders, WithoutAHomeItIsSaidWhatIsNotSaved) {
    const std::map<std::string, std::string> before = [] {
        std::map<std::string, std::string> values;
        for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"})
            if (const char* value = std::getenv(name)) values[name] = value;
        return values;
    }();
    struct Case {
        std::vector<const char*> words;
        const char *home, *config, *data, *said;
    };
    for (const Case& each :
         {Case{{"oblong"}, "/a", "", "", ""}, Case{{"oblong"}, "", "/a", "/b", ""},
          Case{{"oblong"}, "", "", "", "Nothing is saved: HOME is no absolute path"},
          Case{{"oblong"}, "here", "", "", "Nothing is saved: HOME"},
          Case{{"oblong"}, "", "/a", "", "Games are not saved: HOME"},
          Case{{"oblong"}, "", "", "/b", "Options are not saved: HOME"}, Case{{"oblong", "--portable"}, "", "", "", ""},
          Case{{"oblong", "--headless", "1", "--out", "x"}, "", "", "", ""}}) {
        for (const auto& [name, value] : {std::pair{"HOME", each.home}, std::pair{"XDG_CONFIG_HOME", each.config},
                                          std::pair{"XDG_DATA_HOME", each.data}})
            *value != '\0' ? setenv(name, value, 1) : unsetenv(name);
        std::string said = "not run";
        run_with_options(static_cast<int>(each.words.size()), each.words.data(),
                         [&](const Options& options, PreferencesStore&) { said = options.folders.fault; });
        EXPECT_EQ(said.substr(0, std::string(each.said).size()), each.said);
        EXPECT_EQ(said.empty(), *each.said == '\0') << said;
    }
    for (const auto& [name, value] : before) setenv(name.c_str(), value.c_str(), 1);
}

TEST_F(ExampleGame, ACaptionOfNoSoundIsNamed) {
    replace_in_definition("\"lenses\"", "\"lense\\n\"");
    EXPECT_EQ(run_game(), 1);
    EXPECT_TRUE(said_.starts_with("oblong: " + folder_ + "/game.json: /captions/lense?: is no sound")) << said_;
}

TEST_F(ExampleGame, HasALabOnlyIfItAsksForOne) {
    for (const bool has_lab : {false, true}) {
        if (has_lab) replace_in_definition("[\"counts\"]", "[\"lab\"]");
        LevelFiles files = level_files_of(options(), assets_);
        files.level = level_file_of(*files.game, "first");
        const auto first = std::make_shared<const LoadedLevel>(files);
        test::ScriptedPlatform platform(1, no_input);
        ViewOptions shown;
        Session session(first, {}, shown, TickInputSource(start_of(first->level), std::nullopt, false), platform);
        Controls controls;
        controls.commands = {Action::LabPanel};
        session.advance(controls, platform.now_us());
        EXPECT_EQ(shown.lab.shows_panel, has_lab);
        const std::vector<KeyHelp> help = session.key_help({shown.preferences.bindings, platform, false});
        const auto is_lab = [](const KeyHelp& line) { return line.actions.front() == Action::LabPanel; };
        EXPECT_EQ(std::ranges::any_of(help, is_lab), has_lab);
        EXPECT_FALSE(first->files.game->has_gallery);
    }
    replace_in_definition("[\"lab\"]", "[\"labs\"]");
    EXPECT_EQ(run_game(), 1);
    EXPECT_NE(said_.find("/shows/0: \"labs\", expected counts, gallery or lab"), std::string::npos) << said_;
}

TEST_F(ExampleGame, HasItsOwnWordsForLockedDoorsAndForItsEnd) {
    replace_in_definition(
        "\"lenses\": \"coins\"",
        "\"You need the gold key\": \"The gate wants brass\", \"You have reached the end.\": \"Home.\"");
    replace_in_definition("\"speed\"", "\"spawnflags\": \"8\", \"speed\"");
    const LoadedLevel second = loaded("second");
    const std::vector<std::string>& messages = second.level.messages;
    EXPECT_EQ(std::count(messages.begin(), messages.end(), "The gate wants brass"), 1);
    EXPECT_EQ(std::count(messages.begin(), messages.end(), "You need the gold key"), 0);
    EXPECT_EQ(end_figures(second, start_of(second.level)).message, "Home.");
}

TEST_F(ExampleGame, ABookIsReadPageByPageWhileTheWalkWaits) {
    Options played = options();
    played.map = "third";
    PreferencesStore store;
    test::ScriptedPlatform platform(200, no_input);
    Screens screens(played, load_program_files(played, assets_), store, platform, {});
    for (int tick = 0; tick < 60 && !screens.menu().is_open(); ++tick) {
        Controls controls;
        controls.moves.set(tick < 11 ? Action::TurnLeft : Action::Forward);  // 44 degrees, to the book
        platform.poll();
        screens.up().advance(controls, platform.now_us());
        screens.up().open_due_page(screens.pages());
    }
    std::vector<std::string> texts;
    Controls accept;
    accept.menu = {MenuAction::Accept};
    for (; screens.menu().is_open(); screens.menu().handle(accept, {320, 200}, 1, {0, 0, 320, 200})) {
        EXPECT_EQ(screens.menu().page().title, "The keeper's book");
        texts.push_back(screens.menu().page().text);
    }
    ASSERT_EQ(texts.size(), 2u);
    EXPECT_TRUE(texts[0].ends_with("sorry.\n\nSparks burn. A red cross heals who is hurt.")) << texts[0];
    EXPECT_TRUE(texts[1].starts_with("My red key")) << texts[1];
    EXPECT_EQ(screens.messages().front(), "The keeper's book\n" + texts[0] + "\n" + texts[1]) << "to read again";
}

TEST_F(ExampleGame, TheThirdRoomCanBeLost) {
    const LoadedLevel third = loaded("third");
    GameState state = start_of(third.level);
    EXPECT_EQ(status_text(third.level, state, true), "Health 100  Coins 0 of 4");
    for (int second = 0; second < 4; ++second) {
        state.player.position = world_vector(224, 160, 24);  // the sparks: 20 a second
        EXPECT_FALSE(state.has_ended);
        for (int tick = 0; tick < (second == 0 ? 1 : 35); ++tick) step(third.level, state, {});
    }
    EXPECT_EQ(status_text(third.level, state, false), "Health 20");
    for (int tick = 0; tick < 35; ++tick) step(third.level, state, {});
    EXPECT_TRUE(state.is_lost());
    const EndFigures figures = end_figures(third, state);
    EXPECT_TRUE(figures.is_lost);
    EXPECT_EQ(figures.message, "That was too much.");
    EXPECT_EQ(figures.lenses, "Coins found: 0 of 4");
}

TEST_F(ExampleGame, WhoHasLostIsOfferedNoNextLevel) {
    const LoadedLevel first = loaded("first");
    GameState state = start_of(first.level);
    EXPECT_EQ(end_figures(first, state).next_level, "second");
    state.has_ended = true;
    EXPECT_EQ(end_figures(first, state).next_level, "");
}

TEST_F(ExampleGame, TheGateOfTheFirstRoomWantsACoin) {
    const LoadedLevel first = loaded("first");
    EXPECT_EQ(first.level.movers[0].touch.lenses, 1);
    const std::vector<std::string>& said = first.level.messages;
    EXPECT_EQ(std::count(said.begin(), said.end(), "You need a coin"), 1);
}

TEST(GameName, IsOfPlainLettersAndDiffersWhereFoldersDo) {
    EXPECT_EQ(game_name(""), kQuake);
    EXPECT_EQ(game_name("/games/three-rooms.2/"), "three-rooms.2");
    EXPECT_EQ(game_name("/games/my_game 2"), "my_game_2");
    EXPECT_EQ(game_name("/games/museum"), "_museum");
    EXPECT_EQ(game_name("/games/lock"), "_lock") << "which the museum's saves have a file for";
    const std::string one = game_name("/games/дом"), other = game_name("/games/сад");
    EXPECT_NE(one, other);
    EXPECT_EQ(one.find_first_not_of("_-0123456789abcdef"), std::string::npos) << one;
}

// Each would take minutes if all members were looked through for each.
TEST(GameDefinition, LongListsAreRead) {
    const test::TemporaryFolder folder;
    std::string levels, captions, classes;
    for (int i = 0; i < 100'000; ++i) {
        const std::string name = (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\"";
        levels += name;
        captions += name + ":\"\"";
        classes += name + ":{\"is\":\"func_wall\"}";
    }
    folder.write("game.json", "{\"title\":\"x\",\"levels\":[" + levels + "],\"captions\":{" + captions +
                                  "},\"classes\":{" + classes + "}}");
    const GameDefinition game = read_game_definition(folder.path());
    for (const std::size_t size : {game.levels.size(), game.captions.size(), game.classes.size()})
        EXPECT_EQ(size, 100'000u);
}

// A definition, or a class and a key of a class that stands for it; and what is said.
constexpr const char* kFaults = R"({"classes": {"x": {}, "x": {}}} => member "x": is there twice
{"title": 1e999} => JSON:
[] => /: is array, expected members
{"levels": ["a"]} => /: has no "title"
{"title": "x"} => /: has no "levels"
{"title": 3} => /title: is number, expected a text
{"titel": "x"} => /titel: is unknown, expected one of title,
{"\u001b[2J": "x"} => /?[2J: is unknown
{"levels": ["a", "b", "a"]} => /levels/2: "a" is there twice
{"levels": ["../a"]} => /levels/0: "../a", expected the name of a level
{"levels": ["a\u001b"]} => /levels/0: "a?", expected the name of a level
{"levels": "a"} => /levels: is string, expected a list
{"palette": "/etc/passwd"} => /palette: "/etc/passwd", expected a path
{"music": "a/../../b.mod"} => /music: "a/../../b.mod", expected a path
{"music": "none.mod"} => /music: there is no file
{"classes": {"x": {}}} => /classes/x: has no "is"
{"classes": {"func_door": {"is": "func_wall"}}} => /classes/func_door: is a class of the engine
{"classes": {"x": {"is": "func_dor"}}} => /classes/x/is: "func_dor", expected a class
{"classes": {"x": {"is": "y"}, "y": {"is": "x"}}} => /classes/x/is: "y", expected a class
{"classes": {"x": {"is": "light"}}} => /classes/x: stands for light, which the map compiler
{"classes": {"x": {"as": "func_door"}}} => /classes/x/as: is unknown
func_door: "spead": "3" => /spead: is unknown, expected a key of func_door
{"classes": {"x": {"keys": {"speed": "fast"}, "is": "func_door"}}} => /classes/x/keys/speed: "fast", expected a number
func_door: "speed": "" => /speed: "", expected a number
func_door: "spawnflags": "4.5" => /spawnflags: "4.5", expected a whole number
misc_model: "up": "x" => /up: "x", expected y or z
misc_sprite: "texture": "lamp" => /texture: "lamp", expected a texture that begins with '{'
misc_rain: "size": "64" => /size: "64", expected 3 numbers
func_door: "speed": 3 => /speed: is number, expected a text
)";

TEST(GameDefinition, FaultsAreNamedWithTheirPlace) {
    const test::TemporaryFolder folder;
    const auto expect_fault = [&](const std::string& text, const std::string& said) {
        folder.write("game.json", text);
        const std::string found = test::refusal<FileError>([&] { read_game_definition(folder.path()); });
        EXPECT_TRUE(found.starts_with(folder.path("game.json") + ": " + said)) << text << ": " << found;
    };
    expect_fault("", "line 1, column 1: no JSON: syntax error");
    expect_fault("{\"title\":\n \"x\",", "line 2, column 6: no JSON: syntax error");
    std::istringstream rows(kFaults);
    for (std::string row; std::getline(rows, row);) {
        const std::string text = row.substr(0, row.find(" => ")), said = row.substr(text.size() + 4);
        const std::size_t colon = text.find(": ");
        if (text.find_first_of("{[") == 0)
            expect_fault(text, said);
        else
            expect_fault(R"({"classes": {"x": {"is": ")" + text.substr(0, colon) + R"(", "keys": {)" +
                             text.substr(colon + 2) + "}}}}",
                         "/classes/x/keys" + said);
    }
}

}  // namespace
}  // namespace oblong
