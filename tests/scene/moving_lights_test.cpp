#include "engine/scene/moving_lights.h"

#include <gtest/gtest.h>

#include "tests/scene/scene_fixture.h"
#include "tests/support/random.h"

namespace oblong::test {
namespace {

/// The tiny level's floor, and turned and textured in other ways.
struct OneFace {
    Level level = tiny_level();
    FaceTable table = make_face_table(level);

    LevelPlane& plane() { return level.planes[PlaneIndex(0)]; }
    TexInfo& texinfo() { return level.texinfos[TexInfoIndex(0)]; }
    Face& face() { return level.faces[FaceIndex(0)]; }
    std::size_t samples() { return static_cast<std::size_t>(columns() * rows()); }
    int columns() { return face().texel_extent_u / 16 + 1; }
    int rows() { return face().texel_extent_v / 16 + 1; }

    LightTouch touch(std::span<const MovingLight> of, const Vec3<World>& offset = {}, const Vec3<World>& eye = {}) {
        MovingLights lights(level, table);
        lights.set(of, eye);
        return lights.touch(FaceIndex(0), offset);
    }
    /// What lights that touch the face give its samples, in addition.
    std::vector<std::int32_t> lit(std::span<const MovingLight> by, const Vec3<World>& offset = {},
                                  const Vec3<World>& eye = {}, std::int32_t before = 0) {
        MovingLights lights(level, table);
        lights.set(by, eye);
        std::vector<std::int32_t> light(samples(), before);
        lights.add_light(FaceIndex(0), offset, lights.touch(FaceIndex(0), offset).lights, light);
        return light;
    }

    /// Where a light sample is in the world: the point of the plane with those texture coordinates, by Cramer's rule.
    Point sample(int column, int row) {
        const Point n = to_point(plane().normal), s = to_point(texinfo().s), t = to_point(texinfo().t);
        const double u = face().texel_min_u + 16 * column - number_of(texinfo().s_offset);
        const double v = face().texel_min_v + 16 * row - number_of(texinfo().t_offset);
        const Point a = cross(t, n), b = cross(n, s), c = cross(s, t);
        const double volume = dot(s, a);
        return (a * u + b * v + c * number_of(plane().distance)) * (1 / volume);
    }
};

double expected_light(const Point& sample, const MovingLight& light, const Vec3<World>& offset) {
    const Point at = to_point(light.position), moved = to_point(offset);
    return std::max(number_of(light.radius) - length(sample + moved - at), 0.0) * light.brightness_256 / 256;
}

Point random_point(std::mt19937& random, double reach) {
    const double x = random_between(random, -reach, reach), y = random_between(random, -reach, reach);
    return {x, y, random_between(random, -reach, reach)};
}

template <class Part>
Vec3<Part> vector_of(const Point& p) {
    return {fixed_of<Part>(p.x), fixed_of<Part>(p.y), fixed_of<Part>(p.z)};
}

/// A plane and axes of any direction, the axes not nearly parallel on the plane, 1/8 to 4 texels a unit.
OneFace random_face(std::mt19937& random) {
    std::normal_distribution<double> normal;
    OneFace scene;
    const auto direction = [&] { return normalised(Point{normal(random), normal(random), normal(random)}); };
    Point n, s, t;
    do {
        n = direction(), s = direction(), t = direction();
    } while (std::abs(dot(s, cross(t, n))) < 0.3);
    const auto coordinate = [&] { return random_between(random, -2000, 2000); };
    scene.plane() = {vector_of<Unit>(n), {}, fixed_of<PlaneDistance>(coordinate())};
    scene.texinfo().s = vector_of<TexelAxis>(s * std::exp2(random_between(random, -3, 2)));
    scene.texinfo().t = vector_of<TexelAxis>(t * std::exp2(random_between(random, -3, 2)));
    scene.texinfo().s_offset = fixed_of<Texel>(coordinate());
    Face& face = scene.face();
    face.is_back = random() % 2 == 0;
    for (std::int32_t* const least : {&face.texel_min_u, &face.texel_min_v})
        *least = random_below(random, 200) * 16 - 1600;
    for (std::int32_t* const extent : {&face.texel_extent_u, &face.texel_extent_v})
        *extent = random_below(random, 12) * 16;
    scene.table = make_face_table(scene.level);
    return scene;
}

/// A light around the middle of the face.
MovingLight random_light(std::mt19937& random, OneFace& scene, const Vec3<World>& offset) {
    const Point middle = scene.sample(scene.columns() / 2, scene.rows() / 2) + to_point(offset);
    const double radius = random_between(random, 20, 400);
    const Point at = middle + random_point(random, radius * 0.7);
    return {to_world(at), fixed_of<World>(radius), random_below(random, 256) + 1};
}

bool is_in_front(OneFace& scene, const MovingLight& light, const Vec3<World>& offset) {
    const Point at = to_point(light.position - offset);
    const double distance = dot(at, to_point(scene.plane().normal)) - number_of(scene.plane().distance);
    return scene.face().is_back ? distance < -0.01 : distance > 0.01;
}

/// With the planes of all directions, any axes, moved models and both sides: each sample by a renderer in double
/// precision, and a light that gives a sample anything always touches the face.
TEST(MovingLights, EachSampleIsThatOfDoublePrecision) {
    std::mt19937 random(1);
    int lit = 0;
    for (int round = 0; round < 1500; ++round) {
        OneFace scene = random_face(random);
        const Vec3<World> offset = to_world(random_point(random, 300));
        const MovingLight light = random_light(random, scene, offset);
        if (!is_in_front(scene, light, offset)) continue;
        const std::vector<std::int32_t> samples = scene.lit({&light, 1}, offset, {}, 512);
        for (int row = 0; row < scene.rows(); ++row)
            for (int column = 0; column < scene.columns(); ++column) {
                const double expected = expected_light(scene.sample(column, row), light, offset);
                ASSERT_NEAR(item(samples, row * scene.columns() + column) / 256.0 - 2, expected, 1.0 / 64)
                    << round << ": " << column << ", " << row;
                lit += expected > 0;
            }
    }
    EXPECT_GT(lit, 10'000);
}

TEST(MovingLights, LightsAdd) {
    OneFace scene;
    const std::vector<MovingLight> both{{point_at(0, -8, 20), World::from_int(64)},
                                        {point_at(20, 0, 30), World::from_int(90), 77}};
    const std::vector<std::int32_t> first = scene.lit({&both[0], 1}), second = scene.lit({&both[1], 1});
    std::vector<std::int32_t> sum(8);
    std::transform(first.begin(), first.end(), second.begin(), sum.begin(), std::plus<>());
    EXPECT_EQ(scene.lit(both), sum);
}

TEST(MovingLights, OnlyWhatIsInFrontAndInReachIsTouched) {
    OneFace scene;  // x from -4 to 44 and y from -16 to 16 by its samples' rectangle
    const auto is_touched = [&](const MovingLight& light, const Vec3<World>& offset = {}) {
        return scene.touch({&light, 1}, offset).lights != 0;
    };
    const World radius = World::from_int(50);
    EXPECT_TRUE(is_touched({point_at(10, 5, 20), radius}));
    for (const auto& [where, light] : {std::pair{"behind", MovingLight{point_at(10, 5, 7), radius}},
                                       {"on the plane", {point_at(10, 5, 8), radius}},
                                       {"too high", {point_at(10, 5, 58), radius}},
                                       {"too far along x", {point_at(200, 5, 20), radius}},
                                       {"too far along y", {point_at(10, 200, 20), radius}},
                                       {"without radius", {point_at(10, 5, 20), World{}}},
                                       {"without brightness", {point_at(10, 5, 20), radius, 0}},
                                       {"of negative ones", {point_at(10, 5, 20), -radius, -5}}})
        EXPECT_FALSE(is_touched(light)) << where;
    EXPECT_TRUE(is_touched({point_at(210, 5, 20), radius}, point_at(200, 0, 0))) << "the model has moved there";
    EXPECT_FALSE(is_touched({point_at(10, 5, 20), radius}, point_at(200, 0, 0))) << "and has left here";
    scene.face().is_back = true;
    EXPECT_TRUE(is_touched({point_at(10, 5, 7), radius})) << "the front is below now";
}

TEST(MovingLights, ExtremePositionsAreNoFault) {
    OneFace scene;
    const Vec3<World> low{World::lowest(), World::lowest(), World::lowest()},
        high{World::highest(), World::highest(), World::highest()};
    for (const auto& eye : {low, high})
        for (const auto& position : {low, high, Vec3<World>{}})
            for (const auto& offset : {low, high, Vec3<World>{}}) {
                const MovingLight light{position, World::highest(), std::numeric_limits<std::int32_t>::max()};
                for (const std::int32_t sample : scene.lit(std::vector<MovingLight>(40, light), offset, eye)) {
                    EXPECT_GE(sample, 0);
                    EXPECT_LE(sample, 32 * 2048 * 16 * 256);
                }
            }
}

/// What the nearest 32 of a list add to the first sample, found by sorting.
std::vector<MovingLight> nearest_by_sorting(std::vector<MovingLight> lights, const Vec3<World>& eye) {
    const auto distance = [&eye](const MovingLight& light) {
        const Point way = to_point(light.position - eye);
        return std::floor(length(way) * 256) - std::floor(number_of(light.radius) * 256);
    };
    std::stable_sort(lights.begin(), lights.end(),
                     [&](const MovingLight& a, const MovingLight& b) { return distance(a) < distance(b); });
    lights.resize(32);
    return lights;
}

TEST(MovingLights, OfTenThousandTheNearestCount) {
    std::mt19937 random(2);
    OneFace scene;
    std::vector<MovingLight> many(10'000);
    for (MovingLight& light : many) {
        for (World* const part : {&light.position.x, &light.position.y, &light.position.z})
            *part = World::from_int(random_below(random, 300));
        light.radius = World::from_int(random_below(random, 60) + 1);
    }
    const Vec3<World> eye = point_at(20, 0, 30);
    const std::vector<std::int32_t> of_all = scene.lit(many, {}, eye);
    EXPECT_GT(of_all[0], 0);
    EXPECT_EQ(of_all, scene.lit(nearest_by_sorting(many, eye), {}, eye));
}

TEST(MovingLights, OfEqualOnesTheFirstCount) {
    OneFace scene;
    std::vector<MovingLight> many(64, {point_at(12, 0, 20), World::from_int(64), 256});
    for (std::size_t i = 32; i < 64; ++i) many[i].brightness_256 = 1;
    EXPECT_EQ(scene.lit(many, {}, point_at(0, 0, 20))[5], 32 * (64 - 12) * 256);
}

/// The version of a touch stands for the lights that make it up: it is the same only while they are.
TEST(MovingLights, TheVersionChangesWithWhatTouches) {
    OneFace scene;
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
