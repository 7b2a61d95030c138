// Sliding along walls of any direction, against projections in doubles.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "game/simulation/collision.h"
#include "tests/game/logic_level.h"

namespace oblong::test::sliding_test {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector sum(const Vector& a, double factor, const Vector& b) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
Vector unit(const Vector& v) {
    return sum({}, 1 / std::sqrt(dot(v, v)), v);
}
Vector vector_of(const Vec3<World>& v) {
    return {v.x.raw / 4096.0, v.y.raw / 4096.0, v.z.raw / 4096.0};
}
Vec3<World> world(const Vector& v) {
    const auto part = [](double units) {
        return World::from_raw(static_cast<std::int32_t>(std::lround(units * 4096)));
    };
    return {part(v[0]), part(v[1]), part(v[2])};
}
double distance(const Vector& a, const Vector& b) {
    const Vector way = sum(a, -1, b);
    return std::sqrt(dot(way, way));
}

/// Nothing but walls, each `kGap` from a player in the middle, whose box has been added to them.
constexpr double kGap = 1;
ToyLevel between(const std::vector<Vector>& normals) {
    ToyLevel toy;
    toy.add_model({{5000, 5000, 5000, 5001, 5001, 5001}});
    for (const Vector& normal : normals) {
        const auto part = [](double value) {
            return Unit::from_raw(static_cast<std::int32_t>(std::lround(value * (1 << 30))));
        };
        LevelPlane plane;
        plane.normal = {part(normal[0]), part(normal[1]), part(normal[2])};
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
Motion after(const std::vector<Vector>& normals, const Vector& velocity) {
    const ToyLevel toy = between(normals);
    const GameLevel level = make_game_level(toy.level);
    return slide_move(level, start_of(level), {{}, world(velocity)});
}

class Directions {
  public:
    Vector next() {
        const Vector any{part_(random_), part_(random_), part_(random_)};
        return dot(any, any) > 0.1 ? unit(any) : next();
    }
    /// One that goes into a wall.
    Vector into(const Vector& normal) {
        const Vector any = next();
        return dot(any, normal) < -0.2 ? any : into(normal);
    }

  private:
    std::mt19937 random_{1};
    std::uniform_real_distribution<double> part_{-1, 1};
};

constexpr double kSpeed = 700, kWay = kSpeed / 35;

TEST(Sliding, AlongAWallLosesWhatGoesIntoIt) {
    Directions directions;
    for (int i = 0; i < 2'000; ++i) {
        const Vector normal = directions.next(), v = sum({}, kSpeed, directions.into(normal));
        const Motion motion = after({normal}, v);
        const Vector along = sum(v, -dot(v, normal), normal);
        ASSERT_LT(distance(vector_of(motion.velocity), along), 0.01) << i;
        // As far along the wall, beside it by no more than the trace's 1/32.
        const Vector place = vector_of(motion.position);
        ASSERT_LT(distance(sum(place, -dot(place, normal), normal), sum({}, 1.0 / 35, along)), 0.1) << i;
        ASSERT_NEAR(dot(place, normal), -kGap, 0.05) << i;
    }
}

TEST(Sliding, BetweenTwoWallsFollowsTheSecondOrTheCreaseOfAnAcuteAngle) {
    Directions directions;
    int acute = 0, wide = 0;
    while (acute < 1'000 || wide < 1'000) {
        const Vector first = directions.next(), second = directions.next(), heading = directions.into(first);
        const double turn = dot(first, second);  // below 0: less than a right angle is between the walls
        const Vector along_first = sum(heading, -dot(heading, first), first);
        if (std::abs(turn) < 0.1 || std::abs(turn) > 0.9) continue;
        if (dot(heading, second) < dot(heading, first) + 0.05 || dot(along_first, second) > -0.2) continue;
        const Vector crease = unit(cross(first, second));
        const Vector goes =
            turn < 0 ? sum({}, dot(heading, crease), crease) : sum(along_first, -dot(along_first, second), second);
        const Motion motion = after({first, second}, sum({}, kSpeed, heading));
        ASSERT_LT(distance(vector_of(motion.velocity), sum({}, kSpeed, goes)), 0.05) << acute << ' ' << wide;
        const Vector place = vector_of(motion.position);
        ASSERT_GE(std::min(dot(place, first), dot(place, second)), -kGap) << acute << ' ' << wide;
        ++(turn < 0 ? acute : wide);
    }
}

}  // namespace
}  // namespace oblong::test::sliding_test
