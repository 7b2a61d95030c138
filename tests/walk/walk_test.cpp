#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "engine/io/files.h"
#include "game/simulation/demo.h"
#include "game/simulation/tick.h"
#include "tests/controls/virtual_pad.h"
#include "tests/support/folders.h"
#include "tests/walk/walked_level.h"

namespace oblong::test {
namespace {

/// Holds a virtual pad's sticks and buttons so that the game makes of them a given input of a tick: with the default
/// bindings and preferences, and turns that a stick can make (1040 of 65,536 sideways, 624 up or down).
class PadPilot {
  public:
    explicit PadPilot(VirtualPad& pad) : pad_(pad) {}

    void steer(const TickInput& input) {
        const Place walk = pushed({middle_of(input.right, 127), middle_of(input.forward, 127)});
        pad_.set(PadAxis::LeftX, axis(walk.x));
        pad_.set(PadAxis::LeftY, axis(-walk.y));
        const Place look = pushed(unsquared({middle_of(-input.yaw, 1040), middle_of(input.pitch, 624)}));
        pad_.set(PadAxis::RightX, axis(look.x));
        pad_.set(PadAxis::RightY, axis(look.y));
        hold(PadButton::A, (input.buttons & kJumpButton) != 0);
        hold(PadButton::Y, (input.buttons & kRespawnButton) != 0);
        hold(PadButton::X, std::exchange(view_, input.view) != input.view);
    }

  private:
    struct Place {
        double x, y;  // 1: the full way
    };

    // The middle of what is rounded to `value` of `full`.
    static double middle_of(int value, int full) {
        if (value == 0) return 0;
        return std::copysign(std::min((std::abs(value) + 0.5) / full, 1.0), value);
    }
    static Place unsquared(Place place) {
        const double length = std::hypot(place.x, place.y);
        return length > 0 ? Place{place.x / std::sqrt(length), place.y / std::sqrt(length)} : place;
    }
    // Past a dead zone of 15 %; the full length is at 97 %.
    static Place pushed(Place place) {
        const double length = std::hypot(place.x, place.y);
        if (length == 0 || length >= 1) return place;
        const double pushed = 0.15 + length * (0.97 - 0.15);
        return {place.x / length * pushed, place.y / length * pushed};
    }
    static std::int32_t axis(double place) { return static_cast<std::int32_t>(std::lround(place * kFullAxis)); }
    void hold(PadButton button, bool is_held) { is_held ? pad_.press(button) : pad_.release(button); }

    VirtualPad& pad_;
    ViewDials view_ = kUsualView;
};

/// What the player did. A route draws no pictures and names their work itself; a trigger_budget fires at another tick.
std::vector<TickInput> inputs_of(const Demo& demo) {
    std::vector<TickInput> inputs;
    for (const DemoTick& tick : demo.ticks) inputs.push_back(tick.input);
    for (TickInput& input : inputs) input.work = 0;
    return inputs;
}

/// In an upright window.
class UprightPlatform final : public ScriptedPlatform {
  public:
    using ScriptedPlatform::ScriptedPlatform;
    WindowSize window_size() const override { return {720, 1280}; }
    void present(Framebuffer picture, const Palette&, const PresentRect& rect) override {
        ++presented;
        EXPECT_EQ(picture.width_px, 200);
        EXPECT_EQ(picture.height_px, 320);
        EXPECT_EQ(rect.width_px, 720);
        EXPECT_EQ(rect.height_px, 1280);
    }
    int presented = 0;
};

using TitleToEnd = WalkedLevel;

TEST_F(TitleToEnd, ShowsUprightPicturesInAnUprightWindow) {
    UprightPlatform platform(40, [](std::int64_t poll) { return poll == 10 ? accept() : PlatformInput{}; });
    EXPECT_GT(record({}, platform).ticks.size(), 20u);
    EXPECT_GT(platform.presented, 30);
}

// Enter on the title's "Walk" starts the demo that is to be replayed; what the program records of it is that demo, to
// the end of the level.
TEST_F(TitleToEnd, TheRecordedWalkGoesThroughTheWholeProgram) {
    Options options;
    options.replay = test::build_folder() + "/assets/walk.demo";
    options.preferences.game_speed_100 = 800;
    const Demo walk = decode_demo(read_file(options.replay));
    constexpr std::int64_t kTitlePolls = 20, kEndPolls = 20;
    const auto polls = kTitlePolls + static_cast<std::int64_t>(walk.ticks.size()) / 8 + kEndPolls;
    ScriptedPlatform platform(polls,
                              [&](std::int64_t poll) { return poll == kTitlePolls ? accept() : PlatformInput{}; });

    Demo recorded = record(options, platform);
    // The last frame of the walk may hold some ticks more than the demo.
    ASSERT_GE(recorded.ticks.size(), walk.ticks.size());
    EXPECT_LT(recorded.ticks.size(), walk.ticks.size() + 8) << "the end's page does not stop the game";
    expect_all_found(replayed(recorded));
    recorded.ticks.resize(walk.ticks.size());
    EXPECT_EQ(recorded, walk);
}

// Keeps what is presented, as a number, and the brightest that black became.
class WatchedPlatform final : public ScriptedPlatform {
  public:
    explicit WatchedPlatform(std::int64_t polls)
        : ScriptedPlatform(polls, [](std::int64_t) { return PlatformInput{}; }) {}

    void present(Framebuffer canvas, const Palette& palette, const PresentRect&) override {
        std::uint64_t hash = 0;
        for (std::int32_t y = 0; y < canvas.height_px; ++y)
            for (std::int32_t x = 0; x < canvas.width_px; ++x) hash = hash * 1'099'511'628'211u + canvas.row(y)[x];
        pictures.push_back(hash);
        brightest_black = std::max(brightest_black, palette.colours[0].red);
    }

    std::vector<std::uint64_t> pictures;
    std::uint8_t brightest_black = 0;
};

TEST_F(TitleToEnd, TheTitleShowsTheWalkUntilTheLastLensAndNoFlash) {
    Options options;
    options.shows_title = true;
    constexpr std::int64_t kTicksPerPoll = 4;
    options.preferences.game_speed_100 = 100 * kTicksPerPoll;
    const Demo walk = decode_demo(read_file(test::build_folder() + "/assets/walk.demo"));
    std::int64_t found_all_at = 0;
    GameState state = start_of(level_);
    for (const DemoTick& tick : walk.ticks) {
        step(level_, state, tick.input);
        const ItemCount lenses = count_items(level_, state, ItemClass::Lens);
        if (lenses.taken < lenses.all) found_all_at = state.tick;
    }
    ASSERT_LT(found_all_at, state.tick - 20 * kTicksPerSecond) << "the tower is the rest of the walk";

    WatchedPlatform platform(state.tick / kTicksPerPoll);
    PreferencesStore store;
    Program(options, load_program_files(options, assets_), store, platform, {}).run();
    ASSERT_EQ(platform.pictures.size(), static_cast<std::size_t>(state.tick / kTicksPerPoll));
    const auto again = std::find(platform.pictures.begin() + 100, platform.pictures.end(), platform.pictures[20]);
    ASSERT_NE(again, platform.pictures.end()) << "it does not begin again";
    EXPECT_NEAR(static_cast<double>(again - platform.pictures.begin() - 20) * kTicksPerPoll,
                static_cast<double>(found_all_at), 4 * kTicksPerPoll);
    EXPECT_LT(platform.brightest_black, 40) << "a flash";
}

using GamepadWalk = WalkedLevel;

bool accepts(const PlatformInput& input) {
    const InputEvent wanted{InputEvent::Kind::Press, pad_button(PadButton::A), 0, 0};
    return std::find(input.events.begin(), input.events.end(), wanted) != input.events.end();
}

// A accepts the title's "Walk"; then sticks and A lead along the recorded walk to the end of the level. Nothing but
// events of a pad reaches the program.
TEST_F(GamepadWalk, APadAloneWalksFromTheTitleToTheEnd) {
    const Demo walk = decode_demo(read_file(test::build_folder() + "/assets/walk.demo"));
    const UnseenWindow window;
    VirtualPad pad;
    PadPilot pilot(pad);
    constexpr std::int64_t kPress = 5, kRelease = 7, kEndPolls = 10;
    std::size_t played = 0;
    bool has_begun = false;
    const std::int64_t polls = kPress + static_cast<std::int64_t>(walk.ticks.size()) + kEndPolls;
    ScriptedPlatform platform(polls, [&](std::int64_t poll) {
        if (poll == kPress) pad.press(PadButton::A);
        if (poll == kRelease && !has_begun) pad.release(PadButton::A);
        if (has_begun) pilot.steer(played < walk.ticks.size() ? walk.ticks[played++].input : TickInput{});
        const PlatformInput input = window.input->poll();
        has_begun |= accepts(input);
        return input;
    });

    Demo recorded = record({}, platform);
    ASSERT_TRUE(has_begun);
    ASSERT_GE(recorded.ticks.size(), walk.ticks.size());
    expect_all_found(replayed(recorded));
    recorded.ticks.resize(walk.ticks.size());
    EXPECT_EQ(inputs_of(recorded), inputs_of(walk));
}

// In a window on an X server of its own, from the title by the keyboard to the page at the end, and out again: what was
// played there is the recorded walk, state by state.
TEST(WindowWalk, TheRecordedWalkIsPlayedFromTheTitleToTheEnd) {
    const std::string folder = test::build_folder() + "/window_walk", recorded = folder + "/recorded.demo";
    make_folder(folder);
    const std::string command = "HOME='" + folder + "' XDG_CONFIG_HOME='" + folder + "' XDG_DATA_HOME='" + folder +
                                "' python3 '" + test::source_folder() + "/tests/walk/window_walk.py' '" +
                                test::build_folder() + "' '" + recorded + "' '" + folder + "/end.png'";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    constexpr int kSkipped = 77;
    if (WEXITSTATUS(status) == kSkipped) GTEST_SKIP() << "see above for what is missing";
    ASSERT_EQ(WEXITSTATUS(status), 0);
    const Demo walk = read_parsed(test::build_folder() + "/assets/walk.demo", decode_demo);
    const Demo played = read_parsed(recorded, decode_demo);
    EXPECT_EQ(played.start_hash, walk.start_hash);
    ASSERT_GE(played.ticks.size(), walk.ticks.size()) << "nothing moves after the end, but ticks go on";
    EXPECT_TRUE(std::equal(walk.ticks.begin(), walk.ticks.end(), played.ticks.begin()));
}

}  // namespace
}  // namespace oblong::test
