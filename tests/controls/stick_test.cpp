#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/input/controls.h"
#include "game/input/tick_input_source.h"
#include "game/options/preferences.h"

namespace oblong {
namespace {

struct Vector {
    double x, y;
};

// The same by the definition, in parts of the full way.
Vector expected_without_dead_zone(double x, double y, double dead_zone) {
    const double length = std::hypot(x, y);
    if (length <= dead_zone) return {0, 0};
    const double longer = length >= 0.97 ? std::max(length, 1.0) : (length - dead_zone) / (0.97 - dead_zone);
    return {x / length * longer, y / length * longer};
}

template <class Body>
void for_each_place(const Body& body) {
    for (std::int32_t y = -kFullAxis; y <= kFullAxis; y += 1489)
        for (std::int32_t x = -kFullAxis; x <= kFullAxis; x += 1489) body(Stick{x, y});
}

TEST(Stick, DeadZoneIsThatOfDoubles) {
    constexpr double kTolerance = 3.0 / kFullAxis;  // lengths are rounded to whole steps
    for (const int dead_zone_100 : {0, 5, 15, 50, 90})
        for_each_place([&](Stick raw) {
            const Vector expected =
                expected_without_dead_zone(raw.x / double{kFullAxis}, raw.y / double{kFullAxis}, dead_zone_100 / 100.0);
            const Stick stick = without_dead_zone(raw, dead_zone_100);
            // Short pieces of way are stretched: by 14 with a dead zone of 90 %.
            const double tolerance = kTolerance * 0.97 / (0.97 - dead_zone_100 / 100.0);
            EXPECT_NEAR(stick.x / double{kFullAxis}, expected.x, tolerance) << raw.x << ' ' << raw.y;
            EXPECT_NEAR(stick.y / double{kFullAxis}, expected.y, tolerance) << raw.x << ' ' << raw.y;
        });
}

TEST(Stick, RestsInTheDeadZoneAndReachesTheFullLength) {
    EXPECT_EQ(without_dead_zone({4'900, 0}, 15), Stick{});
    EXPECT_EQ(without_dead_zone({-3'400, 3'400}, 15), Stick{});  // a circle: 4,808 from the middle
    EXPECT_NE(without_dead_zone({-3'600, 3'600}, 15), Stick{});
    EXPECT_EQ(without_dead_zone({0, 31'900}, 15).y, kFullAxis);
    EXPECT_EQ(without_dead_zone({kFullAxis, -kFullAxis}, 15), (Stick{kFullAxis, -kFullAxis}));
}

TEST(Stick, SquaredIsThatOfDoubles) {
    for_each_place([](Stick raw) {
        const double length = std::min(std::hypot(raw.x, raw.y) / kFullAxis, 1.0);
        EXPECT_NEAR(squared(raw).x, raw.x * length, 2) << raw.x << ' ' << raw.y;
        EXPECT_NEAR(squared(raw).y, raw.y * length, 2) << raw.x << ' ' << raw.y;
    });
}

TickInput tick_of(const Controls& controls, const Preferences& preferences = {}) {
    LiveInput live;
    live.use(preferences);
    live.gather(controls);
    return live.next();
}

TEST(LiveInput, AStickWalksByHowFarItIsPushed) {
    Controls controls;
    controls.walk_stick = {-kFullAxis, 0};
    EXPECT_EQ(tick_of(controls).right, -127);
    controls.walk_stick = {0, kFullAxis};
    EXPECT_EQ(tick_of(controls).forward, 127);
    controls.walk_stick = {0, kFullAxis / 2};  // (0.5 - 0.15) / (0.97 - 0.15) of 127
    EXPECT_EQ(tick_of(controls).forward, 54);
    controls.walk_stick = {0, kFullAxis / 10};
    EXPECT_EQ(tick_of(controls), TickInput{});
}

TEST(LiveInput, KeysAndStickTogetherAreNotFasterThanOne) {
    Controls controls;
    controls.moves.set(Action::Forward);
    controls.walk_stick = {0, kFullAxis};
    EXPECT_EQ(tick_of(controls).forward, 127);
    controls.moves.set(Action::Back);
    controls.moves.set(Action::Forward, false);
    EXPECT_EQ(tick_of(controls).forward, 0);
}

TEST(LiveInput, AlwaysRunsOrWalksUnlessTheKeyIsHeld) {
    Controls controls;
    controls.moves.set(Action::Forward);
    Preferences walks;
    walks.always_runs = false;
    EXPECT_EQ(tick_of(controls).forward, 127);
    EXPECT_EQ(tick_of(controls, walks).forward, 56);
    controls.moves.set(Action::WalkSlowly);
    EXPECT_EQ(tick_of(controls).forward, 56);
    EXPECT_EQ(tick_of(controls, walks).forward, 127);
}

TEST(LiveInput, AStickTurnsBySensitivityAndUpOrDownAsItIsInverted) {
    Controls controls;
    controls.look_stick = {kFullAxis, 0};
    EXPECT_EQ(tick_of(controls).yaw, -1040);  // 200 degrees a second: 1040 of 65,536, 35 times a second
    Preferences preferences;
    preferences.gamepad_sensitivity_100 = 250;
    EXPECT_EQ(tick_of(controls, preferences).yaw, -2600);
    controls.look_stick = {0, kFullAxis};
    EXPECT_EQ(tick_of(controls).pitch, -624);
    preferences = {};
    preferences.inverts_look = true;
    EXPECT_EQ(tick_of(controls, preferences).pitch, 624);
}

TEST(LiveInput, AStickTurnsSmoothlyBetweenTicks) {
    LiveInput live;
    Controls controls;
    controls.look_stick = {-kFullAxis, 0};
    live.gather(controls);
    EXPECT_EQ(live.next().yaw, 1040);
    EXPECT_EQ(live.look_offset(0).yaw, -1040);
    EXPECT_EQ(live.look_offset(32'768).yaw, -520);
}

TEST(LiveInput, SlowMouseMotionAddsUp) {
    Preferences preferences;
    preferences.mouse_sensitivity_100 = 10;
    LiveInput live;
    live.use(preferences);
    Controls controls;
    controls.mouse_x = -1;
    controls.mouse_y = 1;
    TickInput sum;
    for (int i = 0; i < 50; ++i) {
        live.gather(controls);
        const TickInput tick = live.next();
        sum.yaw = static_cast<std::int16_t>(sum.yaw + tick.yaw);
        sum.pitch = static_cast<std::int16_t>(sum.pitch + tick.pitch);
    }
    EXPECT_EQ(sum.yaw, 60);  // 50 counts of 1.2
    EXPECT_EQ(sum.pitch, 60);
}

TEST(LiveInput, InvertedLookTurnsTheMouseOver) {
    Preferences preferences;
    preferences.inverts_look = true;
    Controls controls;
    controls.mouse_y = 10;
    EXPECT_EQ(tick_of(controls).pitch, 120);
    EXPECT_EQ(tick_of(controls, preferences).pitch, -120);
}

TEST(LiveInput, AStepBetweenTwoTicksIsMade) {
    LiveInput live;
    Controls tap;
    tap.moves = {Action::Left, Action::TurnLeft};
    live.gather(tap);
    live.gather({});
    const TickInput input = live.next();
    EXPECT_EQ(input.right, -127);
    EXPECT_GT(input.yaw, 0);
    EXPECT_EQ(live.next(), TickInput{});
}

TEST(LiveInput, AKeyLetGoBeforeATickIsNotHeldInIt) {
    LiveInput live;
    Controls held;
    held.moves = {Action::TurnLeft, Action::Jump};
    live.gather(held);
    EXPECT_GT(live.next().yaw, 0);
    live.gather(held);
    live.gather({});
    EXPECT_EQ(live.next(), TickInput{});
}

TEST(LiveInput, RespawnIsAButtonOfOneTick) {
    LiveInput live;
    Controls controls;
    controls.commands = {Action::Respawn};
    live.gather(controls);
    live.gather({});
    EXPECT_EQ(live.next().buttons, kRespawnButton);
    EXPECT_EQ(live.next().buttons, 0);
}

}  // namespace
}  // namespace oblong
