#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/view/shown_view.h"

namespace oblong {
namespace {

constexpr double kUnit = 4096;  // of World

GameState moving(double x, double y, std::int64_t tick = 0) {
    GameState state;
    state.tick = tick;
    state.player.velocity = {World::from_raw(static_cast<std::int32_t>(x * kUnit)),
                             World::from_raw(static_cast<std::int32_t>(y * kUnit)), World::from_int(-300)};
    return state;
}

Camera swayed(const GameState& state, std::int32_t bob_100, std::int32_t roll_100, std::int32_t fraction_16 = 0) {
    Preferences preferences;
    preferences.view_bob_100 = bob_100;
    preferences.view_roll_100 = roll_100;
    Camera camera;
    sway({state, state, fraction_16}, preferences, camera);
    return camera;
}

double up(const Camera& camera) {
    return camera.eye.z.raw / kUnit;
}
double roll_degrees(const Camera& camera) {
    return static_cast<std::int16_t>(camera.roll.bam) * 360.0 / 65'536;
}

TEST(ViewSway, IsNoneWhereOneStandsOrWhereItIsOff) {
    for (std::int64_t tick = 0; tick < 42; ++tick) {
        EXPECT_EQ(up(swayed(moving(0, 0, tick), 200, 200)), 0);
        EXPECT_EQ(up(swayed(moving(320, 0, tick), 0, 100)), 0);
        EXPECT_EQ(swayed(moving(0, 320, tick), 100, 0).roll, Angle{});
    }
}

// 0.02 s times the speed, three tenths of it still and seven in a wave of 0.6 s, from -7 to 4 units.
TEST(ViewSway, BobsAsTheFormulaInRealNumbers) {
    for (const double speed : {40.0, 130.0, 320.0, 900.0})
        for (std::int64_t tick = 0; tick < 60; ++tick)
            for (const std::int32_t fraction_16 : {0, 20'000, 65'535}) {
                const double time_s = (static_cast<double>(tick) + fraction_16 / 65'536.0) / 35;
                const double wave = std::sin(2 * std::numbers::pi * time_s / 0.6);
                const double expected = std::clamp(speed * 0.02 * (0.3 + 0.7 * wave), -7.0, 4.0);
                EXPECT_NEAR(up(swayed(moving(speed * 0.6, speed * 0.8, tick), 100, 0, fraction_16)), expected, 0.01);
                EXPECT_NEAR(up(swayed(moving(-speed, 0, tick), 50, 0, fraction_16)), expected / 2, 0.01);
            }
}

TEST(ViewSway, LeansTowardsWhereOneWalksByTwoDegreesAtMost) {
    EXPECT_NEAR(roll_degrees(swayed(moving(0, -100), 0, 100)), 1, 0.01) << "right is -y where one looks along x";
    EXPECT_NEAR(roll_degrees(swayed(moving(0, 100), 0, 100)), -1, 0.01);
    EXPECT_NEAR(roll_degrees(swayed(moving(0, -320), 0, 100)), 2, 0.01);
    EXPECT_NEAR(roll_degrees(swayed(moving(0, -320), 0, 200)), 4, 0.01);
    EXPECT_NEAR(roll_degrees(swayed(moving(320, 0), 0, 100)), 0, 0.01);
}

}  // namespace
}  // namespace oblong
