#include "engine/scene/moving_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/scene/scene_fixture.h"
#include "tests/support/point.h"

namespace oblong::test {
namespace {

double value_of(auto fixed) {
    return static_cast<double>(fixed.raw) / static_cast<double>(std::int64_t{1} << fixed.kFractionBits);
}

/// The tiny level's floor, turned and textured in other ways.
struct OneFace {
    Level level = tiny_level();
    FaceTable table;

    LevelPlane& plane() { return level.planes[PlaneIndex(0)]; }
    TexInfo& texinfo() { return level.texinfos[TexInfoIndex(0)]; }
    Face& face() { return level.faces[FaceIndex(0)]; }
    std::size_t samples() { return static_cast<std::size_t>(columns() * rows()); }
    int columns() { return face().texel_extent_u / 16 + 1; }
    int rows() { return face().texel_extent_v / 16 + 1; }
    void finish() { table = make_face_table(level); }

    /// Where a light sample is in the world: the point of the plane with those texture coordinates, by Cramer's rule.
    Point sample(int column, int row) {
        const Point n = to_point(plane().normal), s = to_point(texinfo().s), t = to_point(texinfo().t);
        const double u = face().texel_min_u + 16 * column - value_of(texinfo().s_offset);
        const double v = face().texel_min_v + 16 * row - value_of(texinfo().t_offset);
        const Point a = cross(t, n), b = cross(n, s), c = cross(s, t);
        const double volume = dot(s, a);
        return (a * u + b * v + c * value_of(plane().distance)) * (1 / volume);
    }
};

double expected_light(const Point& sample, const MovingLight& light, const Vec3<World>& offset) {
    const Point at = to_point(light.position), moved = to_point(offset);
    return std::max(value_of(light.radius) - length(sample + moved - at), 0.0) * light.brightness_256 / 256;
}

World random_world(std::mt19937& random, double reach) {
    std::uniform_real_distribution<double> part(-reach, reach);
    return World::from_raw(static_cast<std::int32_t>(std::lround(part(random) * 4096)));
}

/// A plane and axes of any direction, the axes not nearly parallel on the plane, 1/8 to 4 texels a unit.
OneFace random_face(std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> density(-3, 2), coordinate(-2000, 2000);
    OneFace scene;
    const auto direction = [&] { return normalised(Point{normal(random), normal(random), normal(random)}); };
    Point n, s, t;
    do {
        n = direction(), s = direction(), t = direction();
    } while (std::abs(dot(s, cross(t, n))) < 0.3);
    const auto unit = [](double part) {
        return Unit::from_raw(static_cast<std::int32_t>(std::lround(part * (1 << 30))));
    };
    scene.plane() = {{unit(n.x), unit(n.y), unit(n.z)},
                     {},
                     PlaneDistance::from_raw(std::llround(coordinate(random) * std::pow(2.0, 42)))};
    const auto axis = [&](const Point& v, double scale) {
        const auto part = [&](double p) {
            return TexelAxis::from_raw(static_cast<std::int32_t>(std::lround(p * scale * (1 << 23))));
        };
        return Vec3<TexelAxis>{part(v.x), part(v.y), part(v.z)};
    };
    scene.texinfo().s = axis(s, std::pow(2.0, density(random)));
    scene.texinfo().t = axis(t, std::pow(2.0, density(random)));
    scene.texinfo().s_offset = Texel::from_raw(std::llround(coordinate(random) * 65536));
    scene.face().is_back = random() % 2 == 0;
    scene.face().texel_min_u = static_cast<std::int32_t>(random() % 200) * 16 - 1600;
    scene.face().texel_min_v = static_cast<std::int32_t>(random() % 200) * 16 - 1600;
    scene.face().texel_extent_u = static_cast<std::int32_t>(random() % 12) * 16;
    scene.face().texel_extent_v = static_cast<std::int32_t>(random() % 12) * 16;
    scene.finish();
    return scene;
}

/// A light around the middle of the face.
MovingLight random_light(std::mt19937& random, OneFace& scene, const Vec3<World>& offset) {
    const Point middle = scene.sample(scene.columns() / 2, scene.rows() / 2), moved = to_point(offset);
    std::uniform_real_distribution<double> size(20, 400);
    const double radius = size(random), reach = radius * 0.7;
    std::uniform_real_distribution<double> part(-reach, reach);
    std::array<World, 3> at;
    for (std::size_t i = 0; i < 3; ++i)
        at[i] = World::from_raw(static_cast<std::int32_t>(std::lround((middle[i] + moved[i] + part(random)) * 4096)));
    MovingLight light{{at[0], at[1], at[2]}, World::from_raw(static_cast<std::int32_t>(radius * 4096))};
    light.brightness_256 = static_cast<std::int32_t>(random() % 256) + 1;
    return light;
}

bool is_in_front(OneFace& scene, const MovingLight& light, const Vec3<World>& offset) {
    const Point at = to_point(light.position - offset);
    const double distance = dot(at, to_point(scene.plane().normal)) - value_of(scene.plane().distance);
    return scene.face().is_back ? distance < -0.01 : distance > 0.01;
}

/// With the planes of all directions, any axes, moved models and both sides: each sample by a renderer in double
/// precision, and a light that gives a sample anything always touches the face.
TEST(MovingLights, EachSampleIsThatOfDoublePrecision) {
    std::mt19937 random(1);
    int lit = 0;
    for (int round = 0; round < 1500; ++round) {
        OneFace scene = random_face(random);
        const Vec3<World> offset{random_world(random, 300), random_world(random, 300), random_world(random, 300)};
        const MovingLight light = random_light(random, scene, offset);
        if (!is_in_front(scene, light, offset)) continue;
        MovingLights lights(scene.level, scene.table);
        lights.set(std::span(&light, 1), {});
        const LightTouch touch = lights.touch(FaceIndex(0), offset);
        std::vector<std::int32_t> samples(scene.samples(), 512);
        lights.add_light(FaceIndex(0), offset, touch.lights, samples);
        for (int row = 0; row < scene.rows(); ++row)
            for (int column = 0; column < scene.columns(); ++column) {
                const double expected = expected_light(scene.sample(column, row), light, offset);
                const auto index = static_cast<std::size_t>(row * scene.columns() + column);
                ASSERT_NEAR(samples[index] / 256.0 - 2, expected, 1.0 / 64) << round << ": " << column << ", " << row;
                lit += expected > 0;
            }
    }
    EXPECT_GT(lit, 10'000);
}

TEST(MovingLights, LightsAdd) {
    OneFace scene;
    scene.finish();
    const std::vector<MovingLight> both{{point_at(0, -8, 20), World::from_int(64)},
                                        {point_at(20, 0, 30), World::from_int(90), 77}};
    MovingLights lights(scene.level, scene.table);
    lights.set(both, {});
    std::vector<std::int32_t> sum(8), together(8);
    lights.add_light(FaceIndex(0), {}, lights.touch(FaceIndex(0), {}).lights, together);
    for (const MovingLight& light : both) {
        MovingLights alone(scene.level, scene.table);
        alone.set(std::span(&light, 1), {});
        alone.add_light(FaceIndex(0), {}, alone.touch(FaceIndex(0), {}).lights, sum);
    }
    EXPECT_EQ(together, sum);
}

TEST(MovingLights, OnlyWhatIsInFrontAndInReachIsTouched) {
    OneFace scene;  // x from -4 to 44 and y from -16 to 16 by its samples' rectangle
    scene.finish();
    const auto is_touched = [&](const MovingLight& light, const Vec3<World>& offset = {}) {
        MovingLights lights(scene.level, scene.table);
        lights.set(std::span(&light, 1), {});
        return lights.touch(FaceIndex(0), offset).lights != 0;
    };
    const World radius = World::from_int(50);
    EXPECT_TRUE(is_touched({point_at(10, 5, 20), radius}));
    EXPECT_FALSE(is_touched({point_at(10, 5, 7), radius})) << "behind";
    EXPECT_FALSE(is_touched({point_at(10, 5, 8), radius})) << "on the plane";
    EXPECT_FALSE(is_touched({point_at(10, 5, 58), radius})) << "too high";
    EXPECT_FALSE(is_touched({point_at(200, 5, 20), radius})) << "too far to the side";
    EXPECT_FALSE(is_touched({point_at(10, 200, 20), radius}));
    EXPECT_FALSE(is_touched({point_at(10, 5, 20), World{}})) << "without radius";
    EXPECT_FALSE(is_touched({point_at(10, 5, 20), radius, 0})) << "without brightness";
    EXPECT_FALSE(is_touched({point_at(10, 5, 20), -radius, -5}));
    EXPECT_TRUE(is_touched({point_at(210, 5, 20), radius}, point_at(200, 0, 0))) << "the model has moved there";
    EXPECT_FALSE(is_touched({point_at(10, 5, 20), radius}, point_at(200, 0, 0))) << "and has left here";
    scene.face().is_back = true;
    EXPECT_TRUE(is_touched({point_at(10, 5, 7), radius})) << "the front is below now";
}

TEST(MovingLights, ExtremePositionsAreNoFault) {
    OneFace scene;
    scene.finish();
    const Vec3<World> low{World::lowest(), World::lowest(), World::lowest()},
        high{World::highest(), World::highest(), World::highest()};
    MovingLights lights(scene.level, scene.table);
    for (const auto& eye : {low, high})
        for (const auto& position : {low, high, Vec3<World>{}})
            for (const auto& offset : {low, high, Vec3<World>{}}) {
                const MovingLight light{position, World::highest(), std::numeric_limits<std::int32_t>::max()};
                lights.set(std::vector<MovingLight>(40, light), eye);
                const LightTouch touch = lights.touch(FaceIndex(0), offset);
                std::vector<std::int32_t> samples(8);
                lights.add_light(FaceIndex(0), offset, touch.lights, samples);
                for (const std::int32_t sample : samples) {
                    EXPECT_GE(sample, 0);
                    EXPECT_LE(sample, 32 * 2048 * 16 * 256);
                }
            }
}

/// What the nearest 32 of a list add to the first sample, found by sorting.
std::vector<MovingLight> nearest_by_sorting(std::vector<MovingLight> lights, const Vec3<World>& eye) {
    const auto distance = [&eye](const MovingLight& light) {
        const Point way = to_point(light.position - eye);
        return std::floor(length(way) * 256) - std::floor(value_of(light.radius) * 256);
    };
    std::stable_sort(lights.begin(), lights.end(),
                     [&](const MovingLight& a, const MovingLight& b) { return distance(a) < distance(b); });
    lights.resize(32);
    return lights;
}

TEST(MovingLights, OfTenThousandTheNearestCount) {
    std::mt19937 random(2);
    OneFace scene;
    scene.finish();
    std::vector<MovingLight> many;
    for (int i = 0; i < 10'000; ++i)
        many.push_back({point_at(static_cast<int>(random() % 300), static_cast<int>(random() % 300),
                                 static_cast<int>(random() % 300)),
                        World::from_int(static_cast<int>(random() % 60) + 1)});
    const Vec3<World> eye = point_at(20, 0, 30);
    MovingLights all(scene.level, scene.table), nearest(scene.level, scene.table);
    all.set(many, eye);
    nearest.set(nearest_by_sorting(many, eye), eye);
    std::vector<std::int32_t> of_all(8), of_nearest(8);
    all.add_light(FaceIndex(0), {}, all.touch(FaceIndex(0), {}).lights, of_all);
    nearest.add_light(FaceIndex(0), {}, nearest.touch(FaceIndex(0), {}).lights, of_nearest);
    EXPECT_GT(of_all[0], 0);
    EXPECT_EQ(of_all, of_nearest);
}

TEST(MovingLights, OfEqualOnesTheFirstCount) {
    OneFace scene;
    scene.finish();
    std::vector<MovingLight> many(64, {point_at(12, 0, 20), World::from_int(64), 256});
    for (std::size_t i = 32; i < 64; ++i) many[i].brightness_256 = 1;
    MovingLights lights(scene.level, scene.table);
    lights.set(many, point_at(0, 0, 20));
    std::vector<std::int32_t> samples(8);
    lights.add_light(FaceIndex(0), {}, lights.touch(FaceIndex(0), {}).lights, samples);
    EXPECT_EQ(samples[5], 32 * (64 - 12) * 256);
}

/// The version of a touch stands for the lights that make it up: it is the same only while they are.
TEST(MovingLights, TheVersionChangesWithWhatTouches) {
    OneFace scene;
    scene.finish();
    MovingLights lights(scene.level, scene.table);
    const MovingLight near{point_at(10, 0, 20), World::from_int(50)}, far{point_at(9000, 0, 20), World::from_int(50)};
    MovingLight moved = near;
    moved.position.x += World::ulp();
    MovingLight far_moved = far;
    far_moved.radius += World::from_int(1);
    const auto version = [&](const std::vector<MovingLight>& of, const Vec3<World>& offset = {}) {
        lights.set(of, {});
        return lights.touch(FaceIndex(0), offset).version;
    };
    const std::uint32_t first = version({near, far});
    EXPECT_NE(first, 0u);
    EXPECT_EQ(version({near, far}), first);
    EXPECT_EQ(version({far, near}), first) << "in another order";
    EXPECT_EQ(version({near, far_moved}), first) << "only one that does not touch it has changed";
    EXPECT_EQ(version({near}), first);
    const std::uint32_t second = version({moved});
    EXPECT_NE(second, first);
    EXPECT_NE(version({near}), second);
    const std::uint32_t doubled = version({near, near});
    EXPECT_NE(doubled, version({near}));
    EXPECT_NE(version({near}), version({near}, point_at(1, 0, 0))) << "the model has moved";
    EXPECT_EQ(version({far}), 0u);
    EXPECT_EQ(version({}), 0u);
}

}  // namespace
}  // namespace oblong::test
