// Sliding along walls of any direction, against projections in doubles.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "game/simulation/collision.h"
#include "tests/game/logic_level.h"
#include "tests/support/point.h"

namespace oblong::test::sliding_test {
namespace {

/// Nothing but walls, each `kGap` from a player in the middle, whose box has been added to them.
constexpr double kGap = 1;
ToyLevel between(const std::vector<Point>& normals) {
    ToyLevel toy;
    toy.add_model({{5000, 5000, 5000, 5001, 5001, 5001}});
    for (const Point& normal : normals) {
        LevelPlane plane;
        plane.normal = {fixed_of<Unit>(normal.x), fixed_of<Unit>(normal.y), fixed_of<Unit>(normal.z)};
        plane.distance = PlaneDistance::from_int(-kGap);
        toy.level.planes.push_back(plane);
        ClipNode node;
        node.plane = PlaneIndex(toy.level.planes.count() - 1);
        node.children = {toy.level.models[kWorldModel].clip_roots[0], ClipChild(contents::kSolid)};
        toy.level.clip_nodes.push_back(node);
        toy.level.models[kWorldModel].clip_roots[0] = ClipChild(ClipNodeIndex(toy.level.clip_nodes.count() - 1));
    }
    return toy;
}

/// The motion of a tick from the middle.
Motion after(const std::vector<Point>& normals, const Point& velocity) {
    const ToyLevel toy = between(normals);
    const GameLevel level = make_game_level(toy.level);
    return slide_move(level, start_of(level), {{}, to_world(velocity)});
}

class Directions {
  public:
    Point next() {
        const Point any{part_(random_), part_(random_), part_(random_)};
        return dot(any, any) > 0.1 ? normalised(any) : next();
    }
    /// One that goes into a wall.
    Point into(const Point& normal) {
        const Point any = next();
        return dot(any, normal) < -0.2 ? any : into(normal);
    }

  private:
    std::mt19937 random_{1};
    std::uniform_real_distribution<double> part_{-1, 1};
};

constexpr double kSpeed = 700;

TEST(Sliding, AlongAWallLosesWhatGoesIntoIt) {
    Directions directions;
    for (int i = 0; i < 2'000; ++i) {
        const Point normal = directions.next(), v = directions.into(normal) * kSpeed;
        const Motion motion = after({normal}, v);
        const Point along = v - normal * dot(v, normal);
        ASSERT_LT(length(to_point(motion.velocity) - along), 0.01) << i;
        // As far along the wall, beside it by no more than the trace's 1/32.
        const Point place = to_point(motion.position);
        ASSERT_LT(length(place - normal * dot(place, normal) - along * (1.0 / 35)), 0.1) << i;
        ASSERT_NEAR(dot(place, normal), -kGap, 0.05) << i;
    }
}

TEST(Sliding, BetweenTwoWallsFollowsTheSecondOrTheCreaseOfAnAcuteAngle) {
    Directions directions;
    int acute = 0, wide = 0;
    while (acute < 1'000 || wide < 1'000) {
        const Point first = directions.next(), second = directions.next(), heading = directions.into(first);
        const double turn = dot(first, second);  // below 0: less than a right angle is between the walls
        const Point along_first = heading - first * dot(heading, first);
        if (std::abs(turn) < 0.1 || std::abs(turn) > 0.9) continue;
        if (dot(heading, second) < dot(heading, first) + 0.05 || dot(along_first, second) > -0.2) continue;
        const Point crease = normalised(cross(first, second));
        const Point goes = turn < 0 ? crease * dot(heading, crease) : along_first - second * dot(along_first, second);
        const Motion motion = after({first, second}, heading * kSpeed);
        ASSERT_LT(length(to_point(motion.velocity) - goes * kSpeed), 0.05) << acute << ' ' << wide;
        const Point place = to_point(motion.position);
        ASSERT_GE(std::min(dot(place, first), dot(place, second)), -kGap) << acute << ' ' << wide;
        ++(turn < 0 ? acute : wide);
    }
}

// Quake's limit: a normal with a z of 0.7, 45.57 degrees.
TEST(Ground, IsNotSteeperThanItsLimit) {
    for (const double degrees : {0.0, 30.0, 45.0, 46.0, 60.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const ToyLevel toy = between({{-std::sin(angle), 0, std::cos(angle)}});
        const GameLevel level = make_game_level(toy.level);
        const auto is_over_ground = [&](std::int32_t z, std::int32_t reach) {
            return find_ground(level, start_of(level), world_vector(0, 0, z), World::from_int(reach)).has_hit;
        };
        EXPECT_EQ(is_over_ground(0, 3), std::cos(angle) >= 0.7) << degrees;
        EXPECT_FALSE(is_over_ground(3, 3)) << degrees << ": too far below";
        EXPECT_FALSE(is_over_ground(-3, 3)) << degrees << ": in solid";
    }
}

}  // namespace
}  // namespace oblong::test::sliding_test
