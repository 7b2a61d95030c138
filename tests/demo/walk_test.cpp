#include <gtest/gtest.h>

#include <cmath>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "game/simulation/step.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

/// A point to walk to, and how high the player's middle must be before the visit goes on (a lift takes its time).
struct Waypoint {
    double x, y;
    double least_z = -1000;
};

double units(World value) {
    return static_cast<double>(value.raw) / (1 << World::kFractionBits);
}

/// A visitor who turns towards the next waypoint at once and walks.
class Visitor {
  public:
    explicit Visitor(const Level& level) : level_(make_game_level(level)), state_(start_of(level_)) {}

    const GameState& state() const { return state_; }

    /// False if the waypoint is not reached in half a minute of game time.
    bool walk_to(const Waypoint& waypoint) {
        for (std::int64_t tick = 0; tick < 30 * kTicksPerSecond && !state_.has_ended; ++tick) {
            const double dx = waypoint.x - units(state_.player.position.x),
                         dy = waypoint.y - units(state_.player.position.y);
            const bool is_there = std::hypot(dx, dy) < 14;
            if (is_there && units(state_.player.position.z) >= waypoint.least_z) return true;
            step(level_, state_, is_there ? TickInput{} : step_towards(dx, dy));
        }
        return state_.has_ended;
    }

    /// One tick towards a place. False from half a minute of them on.
    bool step_to(double x, double y) {
        step(level_, state_, step_towards(x - units(state_.player.position.x), y - units(state_.player.position.y)));
        return ++lone_steps_ < 30 * kTicksPerSecond;
    }

  private:
    TickInput step_towards(double dx, double dy) const {
        TickInput input;
        input.forward = 100;
        const auto wanted = static_cast<std::uint16_t>(std::lround(std::atan2(dy, dx) * 32768 / 3.14159265358979));
        input.yaw = static_cast<std::int16_t>(wanted - static_cast<std::uint16_t>(state_.player.yaw.bam));
        return input;
    }

    GameLevel level_;
    GameState state_;
    std::int64_t lone_steps_ = 0;
};

class DemoWalk : public testing::Test {
  protected:
    void walk(const std::vector<Waypoint>& route) {
        for (const Waypoint& waypoint : route) {
            const Position& position = visitor_.state().player.position;
            ASSERT_TRUE(visitor_.walk_to(waypoint))
                << "stuck at " << units(position.x) << ' ' << units(position.y) << ' ' << units(position.z)
                << " on the way to " << waypoint.x << ' ' << waypoint.y;
        }
    }

    const Level level_ = read_bsp(read_file(test::build_folder() + "/assets/demo.bsp"));
    Visitor visitor_{level_};
};

const std::vector<Waypoint> kEntranceToGallery{{0, -16}, {0, 200}, {200, 416}, {400, 416}};
const std::vector<Waypoint> kCourtyardToTower{{512, 1420},  {-60, 1600},  {-200, 1600}, {-290, 1590}, {-500, 1584},
                                              {-720, 1584}, {-792, 1620}, {-792, 2128}, {-792, 2320}, {-80, 2320},
                                              {512, 2320},  {512, 2200},  {512, 1900}};

TEST_F(DemoWalk, ThroughTheDoorUpTheLiftAndDownTheStairsToTheTower) {
    walk(kEntranceToGallery);
    walk({{1290, 416}, {1400, 416}, {1488, 560}, {1488, 700}, {1400, 760}, {1400, 888}, {1320, 888}});
    constexpr double kStandingOnTheBalcony = 160 + 24;
    walk({{1248, 888, kStandingOnTheBalcony - 1}, {1100, 888}, {1112, 1030}, {1112, 1300}, {1060, 1400}, {700, 1390}});
    walk(kCourtyardToTower);
}

TEST_F(DemoWalk, TheTowerIsShutAtBothGatesWhileLensesAreMissing) {
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}, {512, 1540}});
    EXPECT_FALSE(visitor_.walk_to({512, 1640})) << "from the courtyard";
    walk({{512, 1420}});
    walk(kCourtyardToTower);
    EXPECT_FALSE(visitor_.walk_to({512, 1800})) << "from the corridor";
}

TEST_F(DemoWalk, ThroughTheRainAndTheFogAndByTheTeleporterToTheTower) {
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}});
    walk({{740, 1430}, {1000, 1616}, {1230, 1616}, {1230, 1776}, {1392, 1776}, {1392, 1870}, {1392, 2240}});
    constexpr double kInTheGarden = -208 + 24;
    EXPECT_NEAR(units(visitor_.state().player.position.z), kInTheGarden, 1.5);
    while (units(visitor_.state().player.position.y) > 1800) ASSERT_TRUE(visitor_.step_to(1392, 2600));
    EXPECT_NEAR(units(visitor_.state().player.position.x), 40, 20) << "before the room of forced perspective";
    walk({kCourtyardToTower.begin() + 2, kCourtyardToTower.end()});
}

TEST_F(DemoWalk, WhoFallsIntoTheLavaCanClimbOutAtBothEndsOfBothPits) {
    constexpr double kStandingOnTheFloor = 48 + 24, kInLava = 48;
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}});
    walk({kCourtyardToTower.begin(), kCourtyardToTower.begin() + 9});
    for (const double y : {2432.0, 2236.0}) {
        for (const double x : {-780.0, -160.0}) {
            walk({{-472, 2320, kStandingOnTheFloor - 1}, {-472, y}});
            ASSERT_NE(visitor_.state().player.depth, Depth::Dry) << y;
            ASSERT_LT(units(visitor_.state().player.position.z), kInLava) << y;
            walk({{x, y, kStandingOnTheFloor - 1}, {x, 2320}});
            EXPECT_EQ(visitor_.state().player.depth, Depth::Dry) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace oblong
