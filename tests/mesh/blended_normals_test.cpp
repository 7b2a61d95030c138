// Directions blended from one frame of a mesh to the next: the only rotations that anything here blends.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/mesh/mesh_stages.h"

namespace oblong::test {
namespace {

double number_of(Unit value) {
    return std::ldexp(static_cast<double>(value.raw), -30);
}

double dot_of(const Vec3<Unit>& a, const Vec3<Unit>& b) {
    return number_of(a.x) * number_of(b.x) + number_of(a.y) * number_of(b.y) + number_of(a.z) * number_of(b.z);
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

Vec3<Unit> any_direction(std::mt19937& random) {
    const auto any = [&] { return World::from_raw(static_cast<std::int32_t>(random() % 2000001) - 1000000); };
    return normalised(Vec3<World>{any(), any(), any()});
}

TEST(HardCaseT5, ABlendIsOfLengthOneEndsExactlyAndStaysOnTheShorterArc) {
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vec3<Unit> from = any_direction(random);
        Vec3<Unit> to = any_direction(random);
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
            const double length = std::sqrt(dot_of(between, between));
            ASSERT_NEAR(length, 1, 0x1p-24) << i << ' ' << blend;
            // From `from` on, ever farther away: never back, never round the other side.
            ASSERT_LE(dot_of(between, from), nearness + 0x1p-24) << i << ' ' << blend;
            nearness = dot_of(between, from);
            ASSERT_GE(nearness, dot_of(from, to) - 0x1p-24) << i << ' ' << blend;
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
