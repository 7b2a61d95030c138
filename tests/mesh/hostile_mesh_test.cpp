// Meshes that no modeller made, and places where nothing stands: they end, and touch no pixel outside their part. Built
// with the sanitisers too (tools/presets/asan.cmake).
#include <gtest/gtest.h>

#include <limits>

#include "tests/mesh/mesh_picture.h"

namespace oblong::test {
namespace {

/// Draws with each kind of shading, close by and far away, blended and not.
void draw_all_ways(const Mesh& mesh, PlacedMesh placed, MeshPicture& picture) {
    placed.mesh = &mesh;
    const MovingLight point{world_point(5, 0, 0), World::from_int(100), 256};
    const MeshLight light{100, {unit_vector({1, 1, 1}), 100}, {&point, 1}, 800};
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong})
        for (const bool is_affine : {false, true}) {
            placed.shading = shading;
            placed.highlight = 200;
            picture.draw(placed, unshaded(), light, is_affine);
        }
}

World any_world(std::mt19937& random) {
    const World ends[] = {World::lowest(), World::highest(), World{}, World::ulp(), -World::ulp()};
    const auto kind = random() % 4;
    if (kind == 0) return ends[random() % 5];
    if (kind == 1) return World::from_raw(random_below(random, 200'000) - 100'000);
    if (kind == 2) return World::from_raw(random_below(random, 64) - 32);
    return World::from_raw(static_cast<std::int32_t>(random()));
}

Vec3<World> any_point(std::mt19937& random) {
    const World x = any_world(random), y = any_world(random), z = any_world(random);
    return {x, y, z};
}

Mesh random_mesh(std::mt19937& random) {
    MeshBuilder builder;
    const auto unit = [&] { return Unit::from_raw(static_cast<std::int32_t>(random())); };
    for (int i = 0; i < 12; ++i) {
        builder.add(any_point(random), 0, 0, {unit(), unit(), unit()});
        builder.mesh.texels.back() = {Texel::from_raw(static_cast<std::int64_t>(random()) << (random() % 30)),
                                      -Texel::from_raw(static_cast<std::int64_t>(random()) << (random() % 30))};
    }
    const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    for (int i = 0; i < 30; ++i) builder.mesh.triangles.push_back({{below(14), below(14), below(14)}, below(3)});
    builder.mesh.skins = {checkered_skin(16, 1, 2), {"short", 100, 100, {1, 2, 3}}};
    if (random() % 4 == 0) builder.mesh.texels.clear();
    return builder.done();
}

TEST(HostileMeshes, AnyNumbersEnd) {
    std::mt19937 random(1);
    MeshPicture picture(view_from(world_point(3, 2, 1)));
    for (int i = 0; i < 400; ++i) {
        const Mesh mesh = random_mesh(random);
        PlacedMesh placed;
        placed.position = i % 2 == 0 ? Vec3<World>{} : any_point(random);
        placed.yaw = random_angle(random);
        placed.pitch = random_angle(random);
        placed.skin = random() % 3 == 0 ? static_cast<std::uint32_t>(random()) : 0;
        const auto scale = [&] {
            return Entry::from_raw(static_cast<std::int64_t>(std::uint64_t{random()} << (random() % 31)));
        };
        if (i % 3 == 0) placed.scale = {scale(), scale(), scale()};
        draw_all_ways(mesh, placed, picture);
        world_box(placed_at(mesh, placed.position));
    }
    EXPECT_GT(picture.painted(), 1000);
}

TEST(HostileMeshes, MissingPartsAreLeftOut) {
    MeshPicture picture(view_from({}));
    draw_all_ways({}, {}, picture);
    EXPECT_EQ(picture.draw({}, unshaded()).pixels, 0) << "no mesh";
    MeshBuilder builder;
    builder.add(world_point(50, 10, 0));
    builder.triangle(0, 1, 2);
    builder.triangle(0, 0, 0);
    draw_all_ways(builder.done(), {}, picture);
    const Mesh ball = ball_mesh(20, 6, plain_skin(3));
    PlacedMesh placed = placed_at(ball, world_point(100, 0, 0));
    for (const Entry scale : {Entry{}, Entry::from_raw(-1), Entry::lowest()}) {
        placed.scale.y = scale;
        draw_all_ways(ball, placed, picture);
    }
    EXPECT_EQ(picture.painted(), 0);
    Mesh uneven = ball;
    uneven.frames.push_back(ball.frames[0]);
    uneven.frames[1].vertices.resize(40);
    placed = placed_at(uneven, world_point(100, 0, 0));
    placed.next_frame = 1;
    placed.blend_256 = 100;
    draw_all_ways(uneven, placed, picture);
    EXPECT_GT(picture.painted(), 0);
}

TEST(HostileMeshes, TheEyeMayBeInsideOrOnAVertex) {
    const Mesh ball = ball_mesh(20, 6, checkered_skin(64, 1, 2)), cube = cube_mesh(20, plain_skin(3));
    MeshPicture picture(view_from({}));
    for (const Vec3<World>& position : {world_point(0, 0, 0), world_point(0, 0, 20), world_point(20, 20, 20),
                                        world_point(-20, 0, 0), world_point(20.0003, 0, 0)}) {
        draw_all_ways(ball, placed_at(ball, position), picture);
        draw_all_ways(cube, placed_at(cube, position), picture);
    }
    MeshPicture inside(view_from({}));
    inside.draw(placed_at(cube), unshaded());
    EXPECT_EQ(inside.painted(), 0) << "its faces face away";
}

/// A square across the whole view, a hundredth of a unit from the eye: no near plane cuts it.
TEST(HostileMeshes, NothingIsTooNear) {
    MeshBuilder builder;
    builder.add(world_point(0.01, 1, 1)), builder.add(world_point(0.01, -1, 1));
    builder.add(world_point(0.01, -1, -1)), builder.add(world_point(0.01, 1, -1));
    builder.triangle(0, 1, 2), builder.triangle(0, 2, 3);
    MeshPicture picture(view_from({}));
    const MeshCounts counts = picture.draw(placed_at(builder.done()), unshaded());
    EXPECT_EQ(picture.painted(), 64'000);
    EXPECT_EQ(counts.pixels, 64'000);
}

TEST(HostileMeshes, AMillionTrianglesAreDrawn) {
    const Mesh ball = ball_mesh(100, 500, plain_skin(3));
    ASSERT_GT(ball.triangles.size(), 990'000u);
    MeshPicture picture(view_from({}));
    const MeshCounts counts = picture.draw(placed_at(ball, world_point(300, 0, 0)), unshaded());
    EXPECT_GT(counts.facing, 250'000);
    // Smaller than pixels as they are, they cover each once: a disc of radius 100 / sqrt(300^2 - 100^2).
    const double radius = 160 * 100 / std::sqrt(80'000.0), area = 3.14159265 * radius * radius / 1.2;
    EXPECT_NEAR(static_cast<double>(picture.painted()), area, area * 0.01);
    EXPECT_NEAR(static_cast<double>(counts.pixels), area, area * 0.01);
}

}  // namespace
}  // namespace oblong::test
