#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/platform/sdl/input.h"
#include "game/route.h"
#include "game/tick_input_source.h"
#include "tests/controls/virtual_pad.h"
#include "tests/walk/walked_level.h"

namespace oblong::test {
namespace {

/// Walks a route by a gamepad: reads the state of a game of its own, which the same controls move, and pushes sticks.
class PadPilot {
  public:
    PadPilot(const GameLevel& level, std::vector<Waypoint> route)
        : level_(level), route_(std::move(route)), walker_(route_), state_(start_of(level)) {
        input_.use(Preferences{});
    }

    /// Pushes the sticks to where they should be in the next tick.
    void steer(VirtualPad& pad) {
        const bool walks = !walker_.is_over() && !state_.has_ended && !walker_.is_stuck();
        const TickInput wanted = walks ? walker_.next(state_) : TickInput{};
        pad.set(PadAxis::LeftY, -pushed(wanted.forward / 127.0));
        pad.set(PadAxis::RightX, -pushed(std::copysign(std::sqrt(std::abs(wanted.yaw) / kFullTurn), wanted.yaw)));
        if ((wanted.buttons & kJumpButton) != 0)
            pad.press(PadButton::A);
        else
            pad.release(PadButton::A);
    }

    /// What the game makes of the controls, in the tick that they are for.
    void follow(Controls controls) {
        walk_by_panel_keys(controls);
        input_.gather(controls);
        step(level_, state_, input_.next());
        hashes_.push_back(hash_of(state_));
    }

    const GameState& state() const { return state_; }
    const std::vector<std::uint64_t>& hashes() const { return hashes_; }
    std::size_t stuck_on_line() const { return walker_.is_over() ? 0 : walker_.waypoint().line; }

  private:
    static constexpr double kFullTurn = 1040;  // a tick, by the stick pushed as far as it goes

    // A part of a stick's way, -1 to 1, as the place of the axis that gives it in spite of the dead zone.
    static std::int32_t pushed(double part) {
        if (part == 0) return 0;
        const double dead = Preferences{}.gamepad_dead_zone_100 / 100.0;
        const double way = dead + std::min(std::abs(part), 1.0) * (1 - dead);
        return static_cast<std::int32_t>(std::lround(std::copysign(way * 32'767, part)));
    }

    const GameLevel& level_;
    const std::vector<Waypoint> route_;
    RouteWalker walker_;
    GameState state_;
    LiveInput input_;
    std::vector<std::uint64_t> hashes_;
};

class GamepadWalk : public WalkedLevel {
  protected:
    // Without a window that has the focus, gamepads are heard all the same.
    void SetUp() override {
        SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        ASSERT_EQ(SDL_Init(SDL_INIT_VIDEO), 0) << SDL_GetError();
        window_ = SDL_CreateWindow("test", 0, 0, 640, 400, 0);
        ASSERT_NE(window_, nullptr) << SDL_GetError();
        events_ = std::make_unique<SdlInput>(window_);
    }
    void TearDown() override {
        events_.reset();
        SDL_DestroyWindow(window_);
        SDL_Quit();
    }

    // The recorded walk's way, without its stops to look around.
    static std::vector<Waypoint> brisk_route() {
        std::vector<Waypoint> route = parse_route(read_file(OBLONG_SOURCE_DIR "/assets/walk.csv"));
        for (Waypoint& waypoint : route) waypoint.wait_ticks = std::min(waypoint.wait_ticks, 1);
        return route;
    }

    SDL_Window* window_ = nullptr;
    std::unique_ptr<SdlInput> events_;
};

// From "Walk" on the title, which the pad's A accepts, to the end of the level: nothing but events of a pad.
TEST_F(GamepadWalk, APadAloneWalksFromTheTitleToTheEnd) {
    VirtualPad pad;
    PadPilot pilot(level_, brisk_route());
    constexpr std::int64_t kPress = 5, kRelease = 7, kMostPolls = 6000;
    bool has_begun = false;
    std::int64_t polls_after_end = 0;
    ScriptedPlatform platform(kMostPolls, [&](std::int64_t poll) {
        if (poll == kPress) pad.press(PadButton::A);
        if (poll == kRelease) pad.release(PadButton::A);
        if (poll > kRelease) pilot.steer(pad);
        Controls controls = events_->poll();
        controls.has_focus = true;
        if (has_begun && !pilot.state().has_ended) pilot.follow(controls);
        has_begun |= !controls.menu.empty();
        polls_after_end += pilot.state().has_ended;
        if (polls_after_end == 10) platform.close();
        return controls;
    });
    const Demo recorded = record({}, platform);
    ASSERT_TRUE(pilot.state().has_ended) << "stuck on the way to line " << pilot.stuck_on_line() << " of walk.csv";
    ASSERT_GE(recorded.ticks.size(), pilot.hashes().size());
    for (std::size_t tick = 0; tick < pilot.hashes().size(); ++tick)
        ASSERT_EQ(recorded.ticks[tick].state_hash, pilot.hashes()[tick]) << "tick " << tick;
    expect_all_found(replayed(recorded));
}

}  // namespace
}  // namespace oblong::test
