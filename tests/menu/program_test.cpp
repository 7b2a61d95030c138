#include "game/program/program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "engine/effects/palette_effects.h"
#include "engine/io/files.h"
#include "engine/platform/headless.h"
#include "tests/support/folders.h"
#include "tests/support/scripted_input.h"
#include "tests/walk/walked_level.h"
#include "tools/gallery/program/gallery_screen.h"

namespace oblong {
namespace {

using ByPoll = std::map<std::int64_t, Controls>;  // by poll; in all others the player walks ahead

Controls pressing(Action command) {
    Controls controls;
    controls.commands = {command};
    return controls;
}

Controls acting(std::vector<MenuAction> actions) {
    Controls controls;
    controls.menu = std::move(actions);
    return controls;
}

// A whole program, played by a script in a folder of its own.
class ProgramOfTheDemo : public testing::Test {
  protected:
    static Controls at_poll(const ByPoll& script, std::int64_t poll) {
        const auto found = script.find(poll);
        Controls controls = found == script.end() ? Controls{} : found->second;
        controls.moves.set(Action::Forward);
        return controls;
    }
    void play_on(Platform& platform, const Options& options) {
        PreferencesStore store(options.folders.config_file);
        store.begin_with(options.preferences);
        Program(options, load_program_files(options, assets_), store, platform, {.open_gallery = open_gallery}).run();
    }
    // The number of pictures shown.
    std::int64_t play(std::int64_t frames, const Options& options, const ByPoll& script) {
        std::int64_t shown = 0;
        HeadlessPlatform platform(
            frames, 35,
            [&](std::int64_t poll) {
                polls_ = static_cast<std::size_t>(poll) + 1;
                return test::scripted_input(at_poll(script, poll));
            },
            [&](Framebuffer, const Palette&) { ++shown; });
        play_on(platform, options);
        return shown;
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
    // Of the first walk that was saved.
    std::int64_t saved_tick(SaveKind kind = SaveKind::Walk) const {
        return SaveSlots(path("data")).load({kind, 1}).game->state.tick;
    }
    std::size_t recorded_ticks() const { return read_parsed(path("walk.demo"), decode_demo).ticks.size(); }
    std::string path(const char* name) const { return folder_.path(name); }

    std::size_t polls_ = 0;  // of the last play(): a paused game is not drawn at each
    const std::string assets_ = test::build_folder() + "/assets";
    const test::TemporaryFolder folder_;
};

TEST_F(ProgramOfTheDemo, NothingIsSimulatedWhileTheMenuIsOpen) {
    play(60, recording(), {});
    ASSERT_EQ(recorded_ticks(), polls_);
    const Controls menu = pressing(Action::Menu),
                   gallery = acting({MenuAction::Up, MenuAction::Up, MenuAction::Up, MenuAction::Accept});
    Controls unfocused;
    unfocused.has_focus = false;
    for (const auto& [name, script] : std::map<std::string, ByPoll>{
             {"by its key", {{10, menu}, {29, menu}}},
             {"by lost focus, until the player goes on", {{10, unfocused}, {29, acting({MenuAction::Accept})}}},
             {"through the gallery", {{10, menu}, {11, gallery}, {20, menu}, {29, menu}}}}) {
        play(60, recording(), script);
        EXPECT_EQ(recorded_ticks(), polls_ - 20) << name;
    }
}

TEST_F(ProgramOfTheDemo, RestartingKeepsTheSettings) {
    play(60, keeping(),
         {{5, pressing(Action::Brighter)}, {6, pressing(Action::Brighter)}, {20, pressing(Action::Restart)}});
    EXPECT_EQ(PreferencesStore(path("oblong.cfg")).kept().light().brightness_100, 200);
    EXPECT_FALSE(SaveSlots(path("data")).last_walk()) << "two seconds are no walk";
}

// The sixth row from the end of the menu is Keys, and the fifth from the end of that makes it brighter.
TEST_F(ProgramOfTheDemo, TheMenuDoesWhatAKeyDoes) {
    const auto up = [](std::size_t rows) {
        std::vector<MenuAction> actions(rows, MenuAction::Up);
        actions.push_back(MenuAction::Accept);
        return acting(actions);
    };
    play(60, keeping(), {{5, pressing(Action::Menu)}, {6, up(6)}, {7, up(5)}});
    EXPECT_EQ(PreferencesStore(path("oblong.cfg")).kept().light().brightness_100, 140);
}

// A Quake level looks as on a tube until the player says otherwise, and what the player says of it is not the museum's.
TEST_F(ProgramOfTheDemo, LightIsKeptAGame) {
    OBLONG_NEEDS_SHARED_LEVELS();
    const auto play_dm4 = [&](Options options, std::int64_t brighter_at) {
        options.level = (test::find_shared_folder() / "levels" / "dm4.bsp").string();
        options.palette = (test::find_shared_folder() / "levels" / "gfx" / "palette.lmp").string();
        Palette shown;
        HeadlessPlatform platform(
            20, 35,
            [=](std::int64_t poll) {
                return test::scripted_input(poll == brighter_at ? pressing(Action::Brighter) : Controls{});
            },
            [&](Framebuffer, const Palette& palette) { shown = palette; });
        play_on(platform, options);
        return shown;
    };
    const Palette quakes =
        read_parsed((test::find_shared_folder() / "levels" / "gfx" / "palette.lmp").string(), read_palette);
    const Palette tube = apply_palette_effects(quakes, {{}, {}, {}, make_tube_table()}, 0);
    EXPECT_EQ(play_dm4(keeping(), 5).colours, tube.colours);
    const Preferences kept = PreferencesStore(path("oblong.cfg")).kept();
    EXPECT_EQ(kept.light_of(kQuake), (Light{140, 100, true}));
    EXPECT_EQ(kept.light_of(kMuseum), Light{});
    Options plain = keeping();
    plain.light = {{"tube-light", "off"}};
    EXPECT_EQ(play_dm4(plain, -1).colours, quakes.colours) << "as the command line says";
    EXPECT_TRUE(PreferencesStore(path("oblong.cfg")).kept().light_of(kQuake).is_of_tube) << "and not the file";
}

TEST_F(ProgramOfTheDemo, TheGalleryIsDrawnInTheMuseumFromAnyLevel) {
    const auto gallery_from = [&](const std::string& level) {
        Options options;
        options.level = level;
        const ByPoll script{{10, pressing(Action::Menu)},
                            {11, acting({MenuAction::Up, MenuAction::Up, MenuAction::Up, MenuAction::Accept})}};
        Palette palette;
        std::vector<std::uint8_t> pixels;
        HeadlessPlatform platform(
            20, 35, [&](std::int64_t poll) { return test::scripted_input(at_poll(script, poll)); },
            [&](Framebuffer picture, const Palette& its) {
                pixels.assign(picture.pixels, picture.pixels + pixel_count(picture.width_px, picture.height_px));
                palette = its;
            });
        play_on(platform, options);
        return std::pair(pixels, palette.colours);
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
    const Controls leave = acting({MenuAction::Up, MenuAction::Accept});
    ByPoll script{{90, pressing(Action::Menu)}, {91, leave}};
    EXPECT_EQ(play(200, options, script), 200) << "it waits for an answer";
    script[95] = acting({MenuAction::Down, MenuAction::Accept});
    EXPECT_LT(play(200, options, script), 100);
}

// Its folder is away for a while.
TEST_F(ProgramOfTheDemo, ADemoThatCantBeWrittenIsLeftOnlyAfterAQuestion) {
    Options options = keeping();
    options.record = path("away/walk.demo");
    const std::string folder = path("away");
    std::filesystem::create_directory(folder);
    const ByPoll script{{90, pressing(Action::Menu)},
                        {91, acting({MenuAction::Up, MenuAction::Accept})},
                        {100, acting({MenuAction::Accept})},  // "No": back to "Quit"
                        {110, acting({MenuAction::Accept})}};
    HeadlessPlatform platform(
        200, 35,
        [&](std::int64_t poll) {
            if (poll == 50) std::filesystem::remove(folder);
            if (poll == 105) std::filesystem::create_directory(folder);
            polls_ = static_cast<std::size_t>(poll);
            return test::scripted_input(at_poll(script, poll));
        },
        [](Framebuffer, const Palette&) {});
    play_on(platform, options);
    EXPECT_EQ(polls_, 110u);
    EXPECT_EQ(read_parsed(options.record, decode_demo).ticks.size(), 90u);
}

TEST_F(ProgramOfTheDemo, OptionsThatCantBeSavedAreToldOnceInTheMenu) {
    Options options = recording();
    options.folders.config_file = path("no_folder/oblong.cfg");
    std::ofstream(path("no_folder")) << "a file";
    ByPoll script{{5, pressing(Action::Brighter)}, {10, pressing(Action::Menu)}, {15, acting({MenuAction::Back})}};
    play(100, options, script);
    EXPECT_EQ(recorded_ticks(), 10u) << "it waits for an answer";
    script[50] = acting({MenuAction::Accept});
    script[60] = pressing(Action::Menu);
    script[65] = acting({MenuAction::Back});
    script[70] = pressing(Action::Darker);  // it tries again after a second, and at the end
    testing::internal::CaptureStderr();
    play(200, options, script);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_GT(recorded_ticks(), 60u);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_NE(said.find("no_folder"), std::string::npos) << said;
}

TEST_F(ProgramOfTheDemo, RestartAsksOnceThereIsSomethingToLose) {
    play(120, keeping(), {{100, pressing(Action::Restart)}, {101, acting({MenuAction::Accept})}});  // "No"
    EXPECT_GT(saved_tick(), 110) << "saved on leaving, as it was";
}

TEST_F(ProgramOfTheDemo, AWalkThatIsBegunAgainIsKept) {
    play(300, keeping(), {{100, pressing(Action::Restart)}, {101, acting({MenuAction::Down, MenuAction::Accept})}});
    EXPECT_NEAR(static_cast<double>(saved_tick()), 100, 2);
    EXPECT_GT(SaveSlots(path("data")).load({SaveKind::Walk, 2}).game->state.tick, 190);
}

TEST_F(ProgramOfTheDemo, AWalkSavedToASlotIsSavedOnLeavingAllTheSame) {
    const ByPoll script{{100, pressing(Action::Menu)},
                        {101, acting({MenuAction::Down, MenuAction::Accept})},  // "Save"
                        {102, acting({MenuAction::Accept})},                    // "Slot 1"
                        {110, pressing(Action::Menu)},
                        {111, acting({MenuAction::Up, MenuAction::Accept})}};  // "Quit"
    EXPECT_LT(play(200, keeping(), script), 115);
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
    play(100, options,
         {{20, pressing(Action::Menu)},
          {21, acting({MenuAction::Up, MenuAction::Up, MenuAction::Accept})},  // "Title"
          {22, acting({MenuAction::Accept})}});                                // "OK"
    EXPECT_EQ(recorded_ticks(), polls_ - 3) << "of the menu";
}

TEST_F(ProgramOfTheDemo, ATitleOverALevelLeadsToThatLevel) {
    std::filesystem::copy_file(assets_ + "/demo.bsp", path("other.bsp"));
    Options options = keeping();
    options.shows_title = true;
    options.level = path("other.bsp");
    play(150, options, {{5, acting({MenuAction::Accept})}});  // "Walk"
    ASSERT_TRUE(SaveSlots(path("data")).last_walk());
    EXPECT_EQ(SaveSlots(path("data")).last_walk()->game->level.name, path("other.bsp"));
}

TEST_F(ProgramOfTheDemo, TheTitleLeadsToAWalkAndTheMenuBackToIt) {
    Options options = keeping();
    options.shows_title = true;
    ByPoll script{{5, acting({MenuAction::Accept})},  // no walk yet: "Walk"
                  {90, pressing(Action::Menu)},
                  {91, acting({MenuAction::Up, MenuAction::Up, MenuAction::Accept})},  // "Title"
                  {100, acting({MenuAction::Accept})},                                 // "Continue"
                  {120, pressing(Action::Menu)},
                  {121, acting({MenuAction::Up, MenuAction::Accept})}};  // "Quit"
    EXPECT_LT(play(200, options, script), 125) << "the program is left before the script ends";
    EXPECT_NEAR(static_cast<double>(saved_tick()), 84 + 19, 3);
}

// A window that notes what is shown; nothing happens but the script.
class CountingPlatform final : public test::ScriptedPlatform {
  public:
    explicit CountingPlatform(const ByPoll& script)
        : ScriptedPlatform(100, [this, script](std::int64_t poll) {
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
    ByPoll script{{20, pressing(Action::Menu)}, {40, acting({MenuAction::Down})}, {80, pressing(Action::Menu)}};
    CountingPlatform platform(script);
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
        CountingPlatform platform({});
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
    CountingPlatform platform({});
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
    Controls unfocused;
    unfocused.has_focus = false;
    CountingPlatform platform({{20, unfocused}});
    play_on(platform, Options{});
    ASSERT_FALSE(platform.shown.empty());
    EXPECT_EQ(platform.shown.back(), 21) << "paused, and nothing after it";
}

// The keys scroll it; it is nowhere under what the window says at its foot.
TEST(ErrorWindow, ALongErrorIsReadToItsEnd) {
    std::string text;
    for (int i = 0; i < 40; ++i) text += "line " + std::to_string(i) + "\n";
    for (const Controls& closing : {acting({MenuAction::Accept}), pressing(Action::Menu)}) {
        constexpr std::int64_t kClosing = 50;
        std::int64_t polls = 0;
        std::vector<std::vector<std::uint8_t>> shown;
        HeadlessPlatform platform(
            2 * kClosing, 35,
            [&](std::int64_t poll) {
                polls = poll;
                return test::scripted_input(poll == kClosing ? closing : acting({MenuAction::Down}));
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
