// Light on meshes against dot products in doubles.
// Directions blended from one frame of a mesh to the next: the only rotations that anything here blends.

#include "engine/mesh/mesh_light.h"

#include <gtest/gtest.h>

#include "engine/mesh/mesh_stages.h"
#include "tests/mesh/mesh_picture.h"

namespace oblong::test {

namespace {

Vec3<Unit> random_direction(std::mt19937& random) {
    std::normal_distribution<double> part;
    return unit_vector({part(random), part(random), part(random)});
}

TEST(MeshLight, OfADirectionIsTheDotProduct) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3<Unit> normal = random_direction(random), toward = random_direction(random);
        const double expected = 200 * std::max(0.0, dot(to_point(normal), to_point(toward)));
        EXPECT_NEAR(diffuse_light(normal, DirectionalLight{toward, 200}) / 256.0, expected, 1 / 256.0);
    }
    EXPECT_EQ(diffuse_light(unit_vector({0, 0, 1}), DirectionalLight{unit_vector({0, 0, 1}), 128}), 128 * 256);
    EXPECT_EQ(diffuse_light(unit_vector({0, 0, 1}), DirectionalLight{unit_vector({0, 0, -1}), 128}), 0);
}

TEST(MeshLight, OfAPlaceIsTheDotProductTimesWhatIsLeftOfItsRadius) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-200, 200);
    int lit = 0;
    for (int i = 0; i < 2000; ++i) {
        const Point p{anywhere(random), anywhere(random), anywhere(random)};
        const Vec3<Unit> normal = random_direction(random);
        const MovingLight light{to_world({10, 20, 30}), World::from_int(300), 128};
        const Point way = Point{10, 20, 30} - to_point(to_world(p));
        const double distance = length(way), cosine = dot(to_point(normal), normalised(way));
        const double expected = distance >= 300 ? 0 : std::max(0.0, (300 - distance) / 2 * cosine);
        EXPECT_NEAR(diffuse_light(to_world(p), normal, light) / 256.0, expected, 0.01);
        lit += expected > 0;
    }
    EXPECT_GT(lit, 500);
}

TEST(MeshLight, AddsUpAndBecomesAShade) {
    const MovingLight point{world_point(0, 0, 100), World::from_int(150), 256};
    MeshLight light{40, {unit_vector({0, 0, 1}), 30}, {&point, 1}, 100};
    EXPECT_EQ(light_at({}, unit_vector({0, 0, 1}), light), (40 + 30 + 50) * 256);
    EXPECT_EQ(shade_of(brightened(kFullLight * 256, 100)), 32 << 16);
    EXPECT_EQ(shade_of(brightened(0, 100)), 63 << 16);
    EXPECT_EQ(shade_of(brightened(kFullLight * 256 * 10, 100)), 0);
    EXPECT_EQ(shade_of(brightened(kFullLight * 128, 200)), 32 << 16);
}

TEST(MeshLight, AHighlightIsAPowerOfTheCosine) {
    const HighlightTable table = make_highlight_table(100);
    for (int cosine = 0; cosine <= 256; ++cosine)
        EXPECT_NEAR(table[static_cast<std::size_t>(cosine)] / 256.0, 100 * std::pow(cosine / 256.0, kShininess), 0.01);
}

/// A square across the view, seen head-on, whose corners have these normals.
PlacedMesh square(MeshBuilder& builder, const std::array<Vec3<Unit>, 4>& normals, Shading shading) {
    builder.add(world_point(100, 40, 40), 0, 0, normals[0]);
    builder.add(world_point(100, -40, 40), 0, 0, normals[1]);
    builder.add(world_point(100, -40, -40), 0, 0, normals[2]);
    builder.add(world_point(100, 40, -40), 0, 0, normals[3]);
    builder.triangle(0, 1, 2);
    builder.triangle(0, 2, 3);
    PlacedMesh placed = placed_at(builder.done());
    placed.shading = shading;
    return placed;
}

/// Where a pixel's centre is on the square: 0 to 1 across from y = 40, and down from z = 40.
Point place_on_square(std::int32_t x, std::int32_t y) {
    return {0, ((x + 0.5) - 96) / 128, ((y + 0.5) - (100 - 160 / 3.0)) / (320 / 3.0)};
}

const DirectionalLight kFromEye{unit_vector({-1, 0, 0}), 100};

TEST(Shading, FlatIsTheLightOfTheTrianglesOwnNormal) {
    MeshBuilder builder;
    const Vec3<Unit> wrong = unit_vector({0, 0, 1});
    const PlacedMesh placed = square(builder, {wrong, wrong, wrong, wrong}, Shading::Flat);
    MeshPicture picture(view_from({}));
    picture.draw(placed, numbered_shades(), {20, kFromEye, {}, 100});
    EXPECT_EQ(picture.at(160, 100), std::lround(shade_in_doubles(120)));
    EXPECT_EQ(picture.at(100, 60), std::lround(shade_in_doubles(120)));
}

TEST(Shading, GouraudsShadeGoesEvenlyOverTheScreen) {
    MeshBuilder builder;
    const std::array normals{unit_vector({-1, 0, 0}), unit_vector({-1, -1, 0}), unit_vector({-1, 0, -3}),
                             unit_vector({-1, 2, 0})};
    const PlacedMesh placed = square(builder, normals, Shading::Gouraud);
    MeshPicture picture(view_from({}));
    picture.draw(placed, numbered_shades(), {20, kFromEye, {}, 100});
    std::array<double, 4> shades;
    for (std::size_t i = 0; i < 4; ++i) shades[i] = shade_in_doubles(20 + 100 * -to_point(normals[i]).x);
    for (std::int32_t y = 50; y < 150; ++y)
        for (std::int32_t x = 98; x < 222; ++x) {
            const Point at = place_on_square(x, y);
            if (std::abs(at.y - at.z) < 0.01) continue;
            const double shade = at.y > at.z
                                     ? shades[0] + at.y * (shades[1] - shades[0]) + at.z * (shades[2] - shades[1])
                                     : shades[0] + at.y * (shades[2] - shades[3]) + at.z * (shades[3] - shades[0]);
            ASSERT_NEAR(picture.at(x, y), shade, 0.51) << x << ", " << y;
        }
}

TEST(Shading, PhongsNormalGoesEvenlyAndItsHighlightWithIt) {
    MeshBuilder builder;
    const std::array normals{unit_vector({-1, 1, 1}), unit_vector({-1, -1, 1}), unit_vector({-1, -1, -1}),
                             unit_vector({-1, 1, -1})};
    PlacedMesh placed = square(builder, normals, Shading::Phong);
    placed.highlight = 60;
    MeshPicture picture(view_from({}));
    picture.draw(placed, numbered_shades(), {20, kFromEye, {}, 100});
    // The directions to the light and to the eye (from the mesh's origin) differ: the mesh is placed at the eye, and
    // that has no direction, so that H is L.
    double brightest = 99;
    for (std::int32_t y = 50; y < 150; ++y)
        for (std::int32_t x = 98; x < 222; ++x) {
            const Point at = place_on_square(x, y);
            const double third = 1 / std::sqrt(3.0);
            const Point normal{-third, third - 2 * third * at.y, third - 2 * third * at.z};
            const double cosine = -normal.x / length(normal);
            const double light = 20 + 100 * cosine + 60 * std::pow(cosine, kShininess);
            // The cosine has steps of 1/256.
            ASSERT_NEAR(picture.at(x, y), shade_in_doubles(light), 1.6) << x << ", " << y;
            brightest = std::min<double>(brightest, picture.at(x, y));
        }
    EXPECT_NEAR(brightest, shade_in_doubles(180), 1.1);
}

/// A mesh of one vertex, whose normal goes from one direction to another.
Mesh mesh_between(const Vec3<Unit>& from, const Vec3<Unit>& to) {
    Mesh mesh;
    mesh.frames.resize(2);
    mesh.frames[0].vertices = {{{}, from}};
    mesh.frames[1].vertices = {{{}, to}};
    return mesh;
}

Vec3<Unit> blended(const Mesh& mesh, std::int32_t blend_256) {
    PlacedMesh placed;
    placed.mesh = &mesh;
    placed.next_frame = 1;
    placed.blend_256 = blend_256;
    std::vector<MeshVertex> scratch;
    return pose_of(placed, scratch)[0].normal;
}

TEST(HardCaseT5, ABlendIsOfLengthOneEndsExactlyAndStaysOnTheShorterArc) {
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vec3<Unit> from = random_direction(random);
        Vec3<Unit> to = random_direction(random);
        // Every third pair next to each other, or to the opposite.
        const auto half = [](Unit value) { return floor_shift(value, 1); };
        const Vec3<Unit> near{half(from.x), half(from.y), half(from.z) + Unit::from_raw(i + 1)};
        if (i % 3 == 1) to = normalised(near);
        if (i % 3 == 2) to = normalised(Vec3<Unit>{-near.x, -near.y, -near.z + Unit::from_raw(i << 10)});
        const Mesh mesh = mesh_between(from, to);
        EXPECT_EQ(blended(mesh, 0), from);
        EXPECT_EQ(blended(mesh, 256), to);
        double nearness = 1.1;
        for (int blend = 0; blend <= 256; blend += 8) {
            const Vec3<Unit> between = blended(mesh, blend);
            ASSERT_NEAR(length(to_point(between)), 1, 0x1p-24) << i << ' ' << blend;
            // From `from` on, ever farther away: never back, never round the other side.
            ASSERT_LE(dot(to_point(between), to_point(from)), nearness + 0x1p-24) << i << ' ' << blend;
            nearness = dot(to_point(between), to_point(from));
            ASSERT_GE(nearness, dot(to_point(from), to_point(to)) - 0x1p-24) << i << ' ' << blend;
        }
    }
}

TEST(HardCaseT5, OppositesHaveNoDirectionHalfWayAndOneElsewhere) {
    const Unit one = Unit::from_int(1);
    const Mesh mesh = mesh_between({{}, {}, one}, {{}, {}, -one});
    EXPECT_EQ(blended(mesh, 128), (Vec3<Unit>{}));
    for (const int blend : {0, 1, 127}) EXPECT_EQ(blended(mesh, blend), (Vec3<Unit>{{}, {}, one})) << blend;
    for (const int blend : {129, 255, 256}) EXPECT_EQ(blended(mesh, blend), (Vec3<Unit>{{}, {}, -one})) << blend;
}

}  // namespace

}  // namespace oblong::test
