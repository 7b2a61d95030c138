#include "game/program/program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>

#include "engine/effects/palette_effects.h"
#include "engine/io/files.h"
#include "engine/platform/headless.h"
#include "tests/support/folders.h"
#include "tests/support/named_action.h"
#include "tests/support/script.h"
#include "tests/support/scripted_input.h"
#include "tests/walk/walked_level.h"
#include "tools/gallery/program/gallery_screen.h"

namespace oblong {
namespace {

// What is done at polls: "10 menu; 12 up*3 accept; 20 unfocused". A command by its name, or actions in a menu.
using ByPoll = std::map<std::int64_t, Controls>;

ByPoll by_poll(const std::string& text) {
    const std::map<std::string, MenuAction> in_menus{
        {"up", MenuAction::Up}, {"down", MenuAction::Down}, {"accept", MenuAction::Accept}, {"back", MenuAction::Back}};
    ByPoll script;
    for (const test::ScriptLine& line : test::script_lines(text))
        for (const test::Words& words : line.actions) {
            Controls& controls = script[std::stoi(words.at(0))];
            for (std::size_t i = 1; i < words.size(); ++i) {
                const std::string word = words[i].substr(0, words[i].find('*'));
                const std::size_t times = word == words[i] ? 1 : std::stoul(words[i].substr(word.size() + 1));
                if (const auto found = in_menus.find(word); found != in_menus.end())
                    controls.menu.insert(controls.menu.end(), times, found->second);
                else if (word == "unfocused")
                    controls.has_focus = false;
                else
                    controls.commands.push_back(test::action_named(word));
            }
        }
    return script;
}

// A whole program, played by a script in a folder of its own; in all polls the player walks ahead.
class ProgramOfTheDemo : public testing::Test {
  protected:
    struct Shown {
        std::vector<std::uint8_t> pixels;
        Palette palette;
    };
    void play_on(Platform& platform, const Options& options) {
        PreferencesStore store(options.folders.config_file);
        store.begin_with(options.preferences);
        Program(options, load_program_files(options, assets_), store, platform, {.open_gallery = open_gallery}).run();
    }
    // The last picture; `shown_` is the number of all.
    Shown play(
        std::int64_t frames, const Options& options, const std::string& script,
        const std::function<void(std::int64_t)>& at_poll = [](std::int64_t) {}) {
        Shown last;
        shown_ = 0;
        HeadlessPlatform platform(
            frames, 35,
            [&, all = by_poll(script)](std::int64_t poll) {
                at_poll(poll);
                polls_ = static_cast<std::size_t>(poll) + 1;
                const auto found = all.find(poll);
                Controls controls = found == all.end() ? Controls{} : found->second;
                controls.moves.set(Action::Forward);
                return test::scripted_input(controls);
            },
            [&](Framebuffer picture, const Palette& palette) {
                ++shown_;
                const std::size_t size = pixel_count(picture.width_px, picture.height_px);
                last = {{picture.pixels, picture.pixels + size}, palette};
            });
        play_on(platform, options);
        return last;
    }
    Options recording() const {
        Options options;
        options.record = path("walk.demo");
        return options;
    }
    Options keeping() const {
        Options options;
        options.folders = {path("oblong.cfg"), path("data")};
        return options;
    }
    Preferences kept() const { return PreferencesStore(path("oblong.cfg")).kept(); }
    // Of the first walk that was saved.
    std::int64_t saved_tick() const { return SaveSlots(path("data")).load({SaveKind::Walk, 1}).game->state.tick; }
    std::size_t recorded_ticks() const { return read_parsed(path("walk.demo"), decode_demo).ticks.size(); }
    std::string path(const char* name) const { return folder_.path(name); }

    std::size_t polls_ = 0;  // of the last play(): a paused game is not drawn at each
    std::int64_t shown_ = 0;
    const std::string assets_ = test::build_folder() + "/assets";
    const test::TemporaryFolder folder_;
};

TEST_F(ProgramOfTheDemo, NothingIsSimulatedWhileTheMenuIsOpen) {
    play(60, recording(), "");
    ASSERT_EQ(recorded_ticks(), polls_);
    for (const char* script : {"10 menu; 29 menu", "10 unfocused; 29 accept",   // until the player goes on
                               "10 menu; 11 up*3 accept; 20 menu; 29 menu"}) {  // through the gallery
        play(60, recording(), script);
        EXPECT_EQ(recorded_ticks(), polls_ - 20) << script;
    }
}

TEST_F(ProgramOfTheDemo, RestartingKeepsTheSettings) {
    play(60, keeping(), "5 brighter; 6 brighter; 20 restart");
    EXPECT_EQ(kept().light().brightness_100, 200);
    EXPECT_FALSE(SaveSlots(path("data")).last_walk()) << "two seconds are no walk";
}

// The sixth row from the end of the menu is Keys, and the fifth from the end of that makes it brighter.
TEST_F(ProgramOfTheDemo, TheMenuDoesWhatAKeyDoes) {
    play(60, keeping(), "5 menu; 6 up*6 accept; 7 up*5 accept");
    EXPECT_EQ(kept().light().brightness_100, 140);
}

// A Quake level looks as on a tube until the player says otherwise, and what the player says of it is not the museum's.
TEST_F(ProgramOfTheDemo, LightIsKeptAGame) {
    OBLONG_NEEDS_SHARED_LEVELS();
    const std::filesystem::path levels = test::find_shared_folder() / "levels";
    const auto play_dm4 = [&](Options options, const std::string& script) {
        options.level = (levels / "dm4.bsp").string();
        options.palette = (levels / "gfx" / "palette.lmp").string();
        return play(20, options, script).palette.colours;
    };
    const Palette quakes = read_parsed((levels / "gfx" / "palette.lmp").string(), read_palette);
    const Palette tube = apply_palette_effects(quakes, {{}, {}, {}, make_tube_table()}, 0);
    EXPECT_EQ(play_dm4(keeping(), "5 brighter"), tube.colours);
    EXPECT_EQ(kept().light_of(kQuake), (Light{140, 100, true}));
    EXPECT_EQ(kept().light_of(kMuseum), Light{});
    Options plain = keeping();
    plain.light = {{"tube-light", "off"}};
    EXPECT_EQ(play_dm4(plain, ""), quakes.colours) << "as the command line says";
    EXPECT_TRUE(kept().light_of(kQuake).is_of_tube) << "and not the file";
}

TEST_F(ProgramOfTheDemo, TheGalleryIsDrawnInTheMuseumFromAnyLevel) {
    const auto gallery_from = [&](const std::string& level) {
        Options options;
        options.level = level;
        const Shown last = play(20, options, "10 menu; 11 up*3 accept");
        return std::pair(last.pixels, last.palette.colours);
    };
    std::filesystem::copy_file(assets_ + "/demo.bsp", path("other.bsp"));
    folder_.write("palette.lmp", std::vector<std::uint8_t>(768, 99));
    EXPECT_EQ(gallery_from(path("other.bsp")), gallery_from(""));
}

// The folder of saves is a file here.
TEST_F(ProgramOfTheDemo, AWalkThatCantBeSavedIsLeftOnlyAfterAQuestion) {
    Options options = recording();
    options.folders = {path("oblong.cfg"), path("no_folder/data")};
    std::ofstream(path("no_folder")) << "a file";
    play(200, options, "90 menu; 91 up accept");
    EXPECT_EQ(shown_, 200) << "it waits for an answer";
    play(200, options, "90 menu; 91 up accept; 95 down accept");
    EXPECT_LT(shown_, 100);
}

// Its folder is away for a while.
TEST_F(ProgramOfTheDemo, ADemoThatCantBeWrittenIsLeftOnlyAfterAQuestion) {
    Options options = keeping();
    options.record = path("away/walk.demo");
    const std::string folder = path("away");
    std::filesystem::create_directory(folder);
    // "No" leads back to "Quit".
    play(200, options, "90 menu; 91 up accept; 100 accept; 110 accept", [&](std::int64_t poll) {
        if (poll == 50) std::filesystem::remove(folder);
        if (poll == 105) std::filesystem::create_directory(folder);
    });
    EXPECT_EQ(polls_, 111u);
    EXPECT_EQ(read_parsed(options.record, decode_demo).ticks.size(), 90u);
}

TEST_F(ProgramOfTheDemo, OptionsThatCantBeSavedAreToldOnceInTheMenu) {
    Options options = recording();
    options.folders.config_file = path("no_folder/oblong.cfg");
    std::ofstream(path("no_folder")) << "a file";
    const std::string script = "5 brighter; 10 menu; 15 back";
    play(100, options, script);
    EXPECT_EQ(recorded_ticks(), 10u) << "it waits for an answer";
    testing::internal::CaptureStderr();
    play(200, options,
         script + "; 50 accept; 60 menu; 65 back; 70 darker");  // tries again after a second, and at the end
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_GT(recorded_ticks(), 60u);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_NE(said.find("no_folder"), std::string::npos) << said;
}

TEST_F(ProgramOfTheDemo, RestartAsksOnceThereIsSomethingToLose) {
    play(120, keeping(), "100 restart; 101 accept");  // "No"
    EXPECT_GT(saved_tick(), 110) << "saved on leaving, as it was";
}

TEST_F(ProgramOfTheDemo, AWalkThatIsBegunAgainIsKept) {
    play(300, keeping(), "100 restart; 101 down accept");
    EXPECT_NEAR(static_cast<double>(saved_tick()), 100, 2);
    EXPECT_GT(SaveSlots(path("data")).load({SaveKind::Walk, 2}).game->state.tick, 190);
}

TEST_F(ProgramOfTheDemo, AWalkSavedToASlotIsSavedOnLeavingAllTheSame) {
    play(200, keeping(), "100 menu; 101 down accept; 102 accept; 110 menu; 111 up accept");  // "Save", "Slot 1"; "Quit"
    EXPECT_LT(shown_, 115);
    ASSERT_TRUE(SaveSlots(path("data")).load({SaveKind::Numbered, 1}).game);
    ASSERT_TRUE(SaveSlots(path("data")).last_walk()) << "\"Continue\" resumes it";
    EXPECT_GT(saved_tick(), 103);
}

// The title's demo is read when the player goes there.
TEST_F(ProgramOfTheDemo, AWalkGoesOnIfTheTitleCannotBeShown) {
    Options options = recording();
    options.game = path("game");
    std::filesystem::create_directories(path("game/maps"));
    std::filesystem::copy_file(assets_ + "/demo.bsp", path("game/maps/hall.bsp"));
    folder_.write("game/game.json", R"({"title": "Hall", "levels": ["hall"], "demo": "damaged.demo"})");
    folder_.write("game/damaged.demo", "damaged");
    play(100, options, "20 menu; 21 up up accept; 22 accept");  // "Title"; "OK"
    EXPECT_EQ(recorded_ticks(), polls_ - 3) << "of the menu";
}

TEST_F(ProgramOfTheDemo, ATitleOverALevelLeadsToThatLevel) {
    std::filesystem::copy_file(assets_ + "/demo.bsp", path("other.bsp"));
    Options options = keeping();
    options.shows_title = true;
    options.level = path("other.bsp");
    play(150, options, "5 accept");  // "Walk"
    ASSERT_TRUE(SaveSlots(path("data")).last_walk());
    EXPECT_EQ(SaveSlots(path("data")).last_walk()->game->level.name, path("other.bsp"));
}

TEST_F(ProgramOfTheDemo, TheTitleLeadsToAWalkAndTheMenuBackToIt) {
    Options options = keeping();
    options.shows_title = true;
    // No walk yet: "Walk"; "Title", "Continue"; "Quit".
    play(200, options, "5 accept; 90 menu; 91 up up accept; 100 accept; 120 menu; 121 up accept");
    EXPECT_LT(shown_, 125) << "the program is left before the script ends";
    EXPECT_NEAR(static_cast<double>(saved_tick()), 84 + 19, 3);
}

// A window that notes what is shown; nothing happens but the script.
class CountingPlatform final : public test::ScriptedPlatform {
  public:
    explicit CountingPlatform(const std::string& text)
        : ScriptedPlatform(100, [this, script = by_poll(text)](std::int64_t poll) {
              polls_ = poll + 1;
              const auto found = script.find(poll);
              return test::scripted_input(found == script.end() ? Controls{} : found->second);
          }) {}
    std::uint64_t now_us() override { return ScriptedPlatform::now_us() + waited_us_; }
    void capture_mouse(bool is_captured) override { captured.push_back(is_captured); }
    bool wait_for_input(std::int32_t timeout_ms) override {
        waited_us_ += static_cast<std::uint64_t>(timeout_ms) * 1000;
        return false;
    }
    void present(Framebuffer, const Palette& palette, const PresentRect&) override {
        shown.push_back(polls_);
        shown_us.push_back(now_us());
        colours.push_back(palette.colours);
    }

    std::vector<std::int64_t> shown;      // the poll before each picture
    std::vector<std::uint64_t> shown_us;  // when
    std::vector<decltype(Palette::colours)> colours;
    std::vector<bool> captured;

  private:
    std::int64_t polls_ = 0;
    std::uint64_t waited_us_ = 0;
};

TEST_F(ProgramOfTheDemo, NothingIsDrawnWhileNothingChanges) {
    CountingPlatform platform("20 menu; 40 down; 80 menu");
    play_on(platform, Options{});
    std::int64_t paused = 0;
    for (const std::int64_t poll : platform.shown) paused += poll > 21 && poll <= 80;
    EXPECT_EQ(paused, 1) << "the row that was chosen";
    EXPECT_EQ(platform.captured, (std::vector<bool>{true, false, true}));
}

// In each of the first pictures the player stands at the start: all take the same time, that of a timed frame's events.
TEST_F(ProgramOfTheDemo, APictureStaysForTheTimeOfItsMachine) {
    const GameData data = load_game({"", "", assets_, ""});
    const GameLevel level = make_game_level(data.level);
    GameState state = start_of(level);
    while (state.player.ground == Player::kNoGround) step(level, state, {});
    const InterpolatedState shown{state, state};
    GameRenderer renderer(data, level, ScreenMode{});
    const Settings settings;
    const GameView view{shown, camera_at(shown, {}, Degrees::from_int(90))};
    renderer.draw(view, settings);
    const Events events = events_of(renderer.draw_and_count(view, settings), settings.accuracy);
    for (const Processor machine : kProcessors) {
        CountingPlatform platform("");
        Options options;
        options.preferences.machine = machine;
        options.preferences.flashes = Flashes::Off;  // or the palette turns between two pictures
        play_on(platform, options);
        ASSERT_GT(platform.shown_us.size(), 4u);
        const std::int64_t wanted_us = cycles_on(machine, events) / megahertz_of(machine);
        const auto first = static_cast<std::int64_t>(platform.shown_us[1]),
                   last = static_cast<std::int64_t>(platform.shown_us.back()),
                   found_us = (last - first) / (std::ssize(platform.shown_us) - 2);
        EXPECT_GE(found_us, wanted_us * 97 / 100) << "lamps flicker";
        EXPECT_LE(found_us, wanted_us * 103 / 100 + 2 * 28'572) << "two polls more, at most";
    }
}

// The museum's palette takes four steps a second, between a 386's pictures too.
TEST_F(ProgramOfTheDemo, ThePaletteTurnsWhileAPictureStays) {
    CountingPlatform platform("");
    Options options;
    options.preferences.machine = Processor::I386;
    play_on(platform, options);
    std::vector<std::uint64_t> turned_us;
    for (std::size_t i = 1; i < platform.colours.size(); ++i)
        if (platform.colours[i] != platform.colours[i - 1]) turned_us.push_back(platform.shown_us[i]);
    ASSERT_GT(turned_us.size(), 3u);
    for (std::size_t i = 1; i < turned_us.size(); ++i)
        EXPECT_NEAR(static_cast<double>(turned_us[i] - turned_us[0]), 250'000.0 * static_cast<double>(i), 2 * 28'572)
            << "two polls";
}

TEST_F(ProgramOfTheDemo, APageThatOpensByItselfIsDrawn) {
    CountingPlatform platform("20 unfocused");
    play_on(platform, Options{});
    ASSERT_FALSE(platform.shown.empty());
    EXPECT_EQ(platform.shown.back(), 21) << "paused, and nothing after it";
}

// The keys scroll it; it is nowhere under what the window says at its foot.
TEST(ErrorWindow, ALongErrorIsReadToItsEnd) {
    std::string text;
    for (int i = 0; i < 40; ++i) text += "line " + std::to_string(i) + "\n";
    for (const char* closing : {"50 accept", "50 menu"}) {
        constexpr std::int64_t kClosing = 50;
        std::int64_t polls = 0;
        std::vector<std::vector<std::uint8_t>> shown;
        HeadlessPlatform platform(
            2 * kClosing, 35,
            [&](std::int64_t poll) {
                polls = poll;
                return test::scripted_input(by_poll(poll == kClosing ? closing : std::to_string(poll) + " down")[poll]);
            },
            [&](Framebuffer picture, const Palette&) { shown.emplace_back(picture.pixels, picture.row(200)); });
        show_error(text, platform);
        EXPECT_EQ(polls, kClosing);
        ASSERT_EQ(shown.size(), static_cast<std::size_t>(kClosing));
        for (int i = 1; i < 20; ++i) EXPECT_NE(shown[i], shown[i - 1]) << i;
        EXPECT_EQ(shown.back(), shown[shown.size() - 2]) << "its end";
    }
}

}  // namespace
}  // namespace oblong
