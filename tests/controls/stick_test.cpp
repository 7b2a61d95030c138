#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

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

TickInput tick_of(const Controls& controls, const Preferences& preferences) {
    LiveInput live;
    live.use(preferences);
    live.gather(controls);
    return live.next();
}

Preferences preferring(const std::function<void(Preferences&)>& change) {
    Preferences preferences;
    change(preferences);
    return preferences;
}

TEST(LiveInput, MakesATickOfWhatIsHeld) {
    const Preferences usual, walks = preferring([](Preferences&p) { p.always_runs = false; }),
                             fast = preferring([](Preferences&p) { p.gamepad_sensitivity_100 = 250; }),
                             inverted = preferring([](Preferences&p) { p.inverts_look = true; });
    constexpr Moves kAhead{Action::Forward}, kSlowly{Action::Forward, Action::WalkSlowly};
    struct Case {
        const char* name;
        const Preferences& preferences;
        Controls held;
        TickInput expected;
    };
    const auto moves = [](Moves held, Stick walk = {}) {
        Controls controls;
        controls.moves = held;
        controls.walk_stick = walk;
        return controls;
    };
    const auto looks = [](Stick look, std::int32_t mouse_y = 0) {
        Controls controls;
        controls.look_stick = look;
        controls.mouse_y = mouse_y;
        return controls;
    };
    const std::vector<Case> cases{
        {"a stick to the left", usual, moves({}, {-kFullAxis, 0}), {0, -127, 0, 0, 0}},
        {"a stick ahead", usual, moves({}, {0, kFullAxis}), {127, 0, 0, 0, 0}},
        {"half ahead: (0.5 - 0.15) / (0.97 - 0.15) of 127", usual, moves({}, {0, kFullAxis / 2}), {54, 0, 0, 0, 0}},
        {"in the dead zone", usual, moves({}, {0, kFullAxis / 10}), {}},
        {"key and stick together are not faster", usual, moves(kAhead, {0, kFullAxis}), {127, 0, 0, 0, 0}},
        {"key against stick", usual, moves({Action::Back}, {0, kFullAxis}), {}},
        {"a key", usual, moves(kAhead), {127, 0, 0, 0, 0}},
        {"a key of who walks", walks, moves(kAhead), {56, 0, 0, 0, 0}},
        {"walking slowly", usual, moves(kSlowly), {56, 0, 0, 0, 0}},
        {"walking slowly of who walks", walks, moves(kSlowly), {127, 0, 0, 0, 0}},
        {"turning: 200 degrees a second", usual, looks({kFullAxis, 0}), {0, 0, -1040, 0, 0}},
        {"turning faster", fast, looks({kFullAxis, 0}), {0, 0, -2600, 0, 0}},
        {"looking up", usual, looks({0, kFullAxis}), {0, 0, 0, -624, 0}},
        {"looking down", inverted, looks({0, kFullAxis}), {0, 0, 0, 624, 0}},
        {"the mouse down", usual, looks({}, 10), {0, 0, 0, 120, 0}},
        {"the mouse up", inverted, looks({}, 10), {0, 0, 0, -120, 0}},
    };
    for (const Case& each : cases) EXPECT_EQ(tick_of(each.held, each.preferences), each.expected) << each.name;
}

TEST(LiveInput, SticksAndKeysTurnSmoothlyBetweenTicks) {
    Controls stick, keys;
    stick.look_stick = {-kFullAxis, 0};
    keys.moves.set(Action::TurnLeft);
    EXPECT_EQ(tick_of(stick, {}).yaw, 1040);
    for (const Controls& controls : {stick, keys}) {
        LiveInput live;
        live.gather(controls);
        const std::int32_t whole = live.next().yaw;
        EXPECT_EQ(live.look_offset(0).yaw, -whole);
        EXPECT_EQ(live.look_offset(32'768).yaw, -whole / 2);
        EXPECT_LE(std::abs(live.look_offset(65'535).yaw), 1);
    }
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

TEST(LiveInput, AStepBetweenTwoTicksIsMade) {
    LiveInput live;
    Controls tap;
    tap.moves = {Action::Left, Action::TurnLeft, Action::Jump};
    live.gather(tap);
    live.gather({});
    const TickInput input = live.next();
    EXPECT_EQ(input.right, -127);
    EXPECT_EQ(input.buttons, kJumpButton);
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
