// Each stage of a mesh's way to the screen against the same in doubles.
#include "engine/mesh/mesh_stages.h"

#include <gtest/gtest.h>

#include "engine/methods/mesh_stages.h"
#include "tests/mesh/mesh_picture.h"

namespace oblong::test::mesh_stages_test {
namespace {

PlacedMesh random_place(const Mesh& mesh, std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(-2000, 2000);
    PlacedMesh placed = placed_at(mesh, world_point(anywhere(random), anywhere(random), anywhere(random)));
    turn_at_random(placed, random);
    const auto entry = [&] { return fixed_of<Entry>(random_between(random, 0.2, 3)); };
    placed.scale = {entry(), entry(), entry()};
    return placed;
}

TEST(MeshStages, PointsAndNormalsGoToTheWorldAndToTheView) {
    std::mt19937 random(1);
    const Mesh mesh = ball_mesh(30, 6, plain_skin(1));
    for (int i = 0; i < 50; ++i) {
        const PlacedMesh placed = random_place(mesh, random);
        const auto transform = make_mesh_transform(placed);
        ASSERT_TRUE(transform);
        std::vector<WorldVertex> world;
        transform_to_world(mesh.frames[0].vertices, *transform, world);
        const ViewContext view = view_from(random_world(random, 12), placed.roll, placed.yaw);
        std::vector<ViewVertex> seen;
        transform_to_view(mesh.frames[0].vertices, placed, *transform, view, seen);
        const MeshAxes axes(placed);
        const Point scale = to_point(placed.scale);
        for (std::size_t v = 0; v < world.size(); ++v) {
            const Point p = to_point(mesh.frames[0].vertices[v].position);
            const Point n = to_point(mesh.frames[0].vertices[v].normal);
            const Point point = to_point(placed.position) + axes.turned({p.x * scale.x, p.y * scale.y, p.z * scale.z});
            ASSERT_LE(farthest_apart(to_point(world[v].position), point), 1.3e-4);
            // In the view places are more exact: they are not rounded to a place in the world.
            const auto along = [&](const Vec3<Unit>& axis) { return dot(point - to_point(view.eye), to_point(axis)); };
            const Point in_view{along(view.axes.right), along(view.axes.up), along(view.axes.forward)};
            ASSERT_LE(farthest_apart(to_point(seen[v].position), in_view), 1.3e-5);
            // The inverse transpose of R S is R S^-1.
            const Point normal = normalised(axes.turned({n.x / scale.x, n.y / scale.y, n.z / scale.z}));
            ASSERT_LE(farthest_apart(to_point(world[v].normal), normal), 1e-7);
        }
    }
}

TEST(MeshStages, FacingIsTheSignOfTheExactProduct) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(-1, 1);
    double most = 100;
    const auto point = [&] { return world_point(most * share(random), most * share(random), most * share(random)); };
    int facing_count = 0;
    for (int i = 0; i < 2000; ++i) {
        MeshBuilder builder;
        most = std::ldexp(1.0, i % 17);
        builder.add(point()), builder.add(point()), builder.add(point());
        builder.triangle(0, 1, 2);
        const double edge = most;
        most = std::ldexp(1.0, i / 17 % 19);
        const Vec3<World> eye = point();
        std::vector<std::uint32_t> facing;
        find_facing(builder.mesh.triangles, builder.mesh.frames[0].vertices, eye, facing);
        const auto& vertices = builder.mesh.frames[0].vertices;
        const Point a = to_point(vertices[0].position), b = to_point(vertices[1].position),
                    c = to_point(vertices[2].position), e = to_point(eye);
        // Clockwise seen from the front in right-handed axes: this product points to the front. In doubles only its
        // sign near 0 may be wrong.
        const double side = dot(cross(c - a, b - a), e - a);
        if (std::abs(side) < 1e-12 * edge * edge * (edge + most)) continue;
        ASSERT_EQ(!facing.empty(), side > 0);
        facing_count += side > 0;
    }
    EXPECT_GT(facing_count, 800);
    EXPECT_LT(facing_count, 1200);
}

/// Against 128 bits, with eyes in the planes of triangles and one step beside them; by corners as well as by planes.
TEST(MeshStages, PlanesTellExactlyWhatFaces) {
    std::mt19937 random(3);
    int facing_count = 0, without = 0;
    for (int i = 0; i < 6000; ++i) {
        MeshBuilder builder;
        const int size = random_below(random, 20), far = random_below(random, 5);
        const Vec3<World> middle = random_world(random, far + 4);
        const auto near = [&] { return middle + random_world(random, 12 + size); };
        builder.add(near()), builder.add(near()), builder.add(near());
        builder.triangle(0, 1, 2);
        const Mesh& mesh = builder.done();
        const std::vector<FacingPlane> planes = facing_planes(mesh);
        const auto at = [&](std::size_t corner) { return mesh.frames[0].vertices[corner].position; };
        const auto exact_cross = cross(at(2) - at(0), at(1) - at(0));
        const auto is_long = [](auto part) { return part.raw != static_cast<std::int32_t>(part.raw); };
        ASSERT_EQ(planes.empty(), is_long(exact_cross.x) || is_long(exact_cross.y) || is_long(exact_cross.z));
        without += planes.empty();
        Vec3<World> eye = i % 2 == 0 ? at(0) + at(1) - at(2) : random_world(random, 3);
        if (i % 4 == 0) eye.z += World::from_raw(random_below(random, 3) - 1);
        if (!is_near_enough(eye)) continue;
        const auto exact = [](std::int64_t factor, World to, World from) {
            return static_cast<__int128>(factor) * (std::int64_t{to.raw} - from.raw);
        };
        const bool faces = exact(exact_cross.x.raw, eye.x, at(0).x) + exact(exact_cross.y.raw, eye.y, at(0).y) +
                               exact(exact_cross.z.raw, eye.z, at(0).z) >
                           0;
        std::vector<std::uint32_t> facing;
        if (size <= 16) {  // beyond, corners are clamped
            find_facing(mesh.triangles, mesh.frames[0].vertices, eye, facing);
            ASSERT_EQ(facing.size(), faces ? 1u : 0u) << i;
            facing.clear();
        }
        if (planes.empty()) continue;
        find_facing(planes, eye, facing);
        ASSERT_EQ(facing.size(), faces ? 1u : 0u) << i;
        facing_count += faces;
    }
    EXPECT_GT(facing_count, 1500);
    EXPECT_GT(without, 500);
}

TEST(MeshStages, OnlyAWholeMeshOfOneFrameHasPlanes) {
    Mesh mesh = ball_mesh(10, 4, plain_skin(1));
    EXPECT_EQ(facing_planes(mesh).size(), mesh.triangles.size());
    Mesh broken = mesh;
    broken.triangles[3].vertices[2] = 1000;
    EXPECT_TRUE(facing_planes(broken).empty());
    mesh.frames.push_back(mesh.frames[0]);
    EXPECT_TRUE(facing_planes(mesh).empty());
}

TEST(MeshStages, APoseIsBetweenTwoFrames) {
    Mesh mesh = ball_mesh(10, 4, plain_skin(1));
    mesh.frames.push_back(ball_mesh(30, 4, plain_skin(1)).frames[0]);
    PlacedMesh placed = placed_at(mesh);
    placed.next_frame = 1;
    std::vector<MeshVertex> scratch;
    for (const std::int32_t blend : {-5, 0, 64, 128, 256, 1000}) {
        placed.blend_256 = blend;
        const double radius = 10 + 20 * std::clamp(blend, 0, 256) / 256.0;
        for (const MeshVertex& vertex : pose_of(placed, scratch)) {
            const Point p = to_point(vertex.position), n = to_point(vertex.normal);
            ASSERT_NEAR(std::sqrt(dot(p, p)), radius, 1e-3);
            ASSERT_NEAR(dot(p, n), radius, 1e-3);
        }
    }
    placed.frame = 99, placed.blend_256 = 0;
    EXPECT_NEAR(to_point(pose_of(placed, scratch)[0].position).z, 30, 1e-3);
}

/// Values at corners that clipping made are those of the plane's points there.
TEST(MeshStages, ClippedCornersHaveTheValuesOfTheirPlace) {
    const ViewContext view = view_from({});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> ahead(-50, 300), side(-300, 300);
    ClipScratch scratch;
    std::vector<ScreenCorner> polygon;
    int clipped = 0;
    for (int i = 0; i < 3000; ++i) {
        // u = 1000 + 2 y + z, v = 2000 - x + z: linear in space, so also on any plane.
        std::vector<MeshVertex> world;
        std::array<CornerValues, 3> values;
        for (CornerValues& value : values) {
            const Vec3<World> p = world_point(ahead(random), side(random), side(random));
            world.push_back({p, {}});
            const auto texel = [](World number) { return convert<Texel>(number); };
            value.u = Texel::from_int(1000) + texel(p.y) + texel(p.y) + texel(p.z);
            value.v = Texel::from_int(2000) - texel(p.x) + texel(p.z);
        }
        std::vector<ViewVertex> seen;
        transform_to_view(world, {}, *make_mesh_transform({}), view, seen);
        clip_and_project({&seen[0], &seen[1], &seen[2]}, {&values[0], &values[1], &values[2]}, view, scratch, polygon);
        ASSERT_LE(polygon.size(), 7u);
        if ((seen[0].outcode | seen[1].outcode | seen[2].outcode) == 0) continue;
        for (const ScreenCorner& corner : polygon) {
            const double z = 1 / number_of(corner.inverse_z);
            if (z < 1) continue;
            const double px = std::ldexp(corner.screen.x.raw, -8) - 160, py = 100 - std::ldexp(corner.screen.y.raw, -8);
            const double x = z, y = -px / 160 * z, up = py / (160 / 1.2) * z;
            ASSERT_NEAR(number_of(corner.values.u), 1000 + 2 * y + up, 0.02 + z / 8000);
            ASSERT_NEAR(number_of(corner.values.v), 2000 - x + up, 0.02 + z / 8000);
            ++clipped;
        }
    }
    EXPECT_GT(clipped, 1000);
}

bool holds(const LevelBox& box, const Vec3<World>& place) {
    const Point p = to_point(place);
    for (const std::size_t axis : {0u, 1u, 2u})
        if (p[axis] < box.mins[axis] || p[axis] > box.maxs[axis]) return false;
    return true;
}

TEST(MeshStages, ThePartsBoxesHoldTheirTriangles) {
    std::mt19937 random(5);
    Mesh mesh = ball_mesh(30, 12, plain_skin(1));
    set_boxes(mesh.frames[0], mesh.triangles);
    const std::vector<MeshBox>& parts = mesh.frames[0].parts;
    ASSERT_EQ(parts.size(), (mesh.triangles.size() + kPartTriangles - 1) / kPartTriangles);
    for (int i = 0; i < 20; ++i) {
        const PlacedMesh placed = random_place(mesh, random);
        const MeshTransform transform = *make_mesh_transform(placed);
        std::vector<WorldVertex> world;
        transform_to_world(mesh.frames[0].vertices, transform, world);
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            const MeshBox& part = parts[triangle / kPartTriangles];
            const LevelBox box = world_box(transform.to_world, part, part);
            for (const std::uint32_t vertex : mesh.triangles[triangle].vertices)
                ASSERT_TRUE(holds(box, world[vertex].position));
        }
    }
}

// What a part covers is asked of this outline alone.
TEST(MeshStages, OutlinesOfPartsHoldTheirVerticesOnTheScreen) {
    std::mt19937 random(6);
    Mesh mesh = ball_mesh(30, 12, plain_skin(1));
    set_boxes(mesh.frames[0], mesh.triangles);
    const ViewContext view = view_from({});
    int held = 0, outside_of_corners = 0;
    for (int i = 0; i < 200; ++i) {
        PlacedMesh placed = random_place(mesh, random);
        placed.position = point_at(50 + static_cast<int>(random() % 200), static_cast<int>(random() % 100) - 50, 0);
        const MeshTransform transform = *make_mesh_transform(placed);
        const MeshToView to_view = make_mesh_to_view(placed.position, transform, view);
        if (!to_view.is_usable) continue;
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            const MeshBox& part = mesh.frames[0].parts[triangle / kPartTriangles];
            const ViewBox box = view_box_of(part, part, to_view);
            const ScreenOutline outline = outline_of(box, view.projection);
            const ScreenRectangle& pixels = outline.pixels;
            for (const std::uint32_t number : mesh.triangles[triangle].vertices) {
                ViewVertex vertex;
                view_vertex(mesh.frames[0].vertices[number].position, transform, to_view, view, vertex);
                ASSERT_GE(vertex.position.z, box.nearest_z());
                if (vertex.outcode != 0) continue;
                const std::int32_t column = std::min(vertex.screen.x.raw / 256, 319),
                                   row = std::min(vertex.screen.y.raw / 256, 199);
                const PixelRange inside = outline.columns_in(row, column, column + 1);
                ASSERT_LT(inside.first, inside.end) << i << " " << triangle;
                ASSERT_TRUE(row >= pixels.first_row && row < pixels.end_row);
                ++held;
            }
            const PixelRange corner =
                outline.columns_in(pixels.first_row, pixels.first_column, pixels.first_column + 1);
            outside_of_corners += corner.first >= corner.end;
        }
    }
    EXPECT_GT(held, 10'000);
    EXPECT_GT(outside_of_corners, 10'000) << "an outline is little more than a rectangle";
}

TEST(MeshStages, ABoxHoldsAllVertices) {
    std::mt19937 random(4);
    const Mesh mesh = cube_mesh(20, plain_skin(1));
    for (int i = 0; i < 100; ++i) {
        const PlacedMesh placed = random_place(mesh, random);
        const LevelBox box = world_box(placed), turning = turning_box(turning_shape(placed));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            ASSERT_LE(turning.mins[axis], box.mins[axis]);
            ASSERT_GE(turning.maxs[axis], box.maxs[axis]);
        }
        std::vector<WorldVertex> world;
        transform_to_world(mesh.frames[0].vertices, *make_mesh_transform(placed), world);
        for (const WorldVertex& vertex : world) ASSERT_TRUE(holds(box, vertex.position));
    }
}

// Three products of 1.5: a coefficient is below 32.
TEST(MeshToView, IsUsedOnlyWhereItsCoefficientsFit) {
    for (const int entry : {1, 7, 8, 15}) {
        MeshTransform transform;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                transform.to_world.rows[row][column] = Entry::from_int(entry);
        transform.has_small_entries = true;
        ViewContext sheared{};
        const Unit part = Unit::from_raw(3 << 29);
        sheared.axes = {{part, part, part}, {part, part, part}, {part, part, part}};
        const MeshToView to_view = make_mesh_to_view({}, transform, sheared);
        EXPECT_EQ(to_view.is_usable, entry < 8) << entry;
        if (to_view.is_usable) {
            EXPECT_EQ(number_of(to_view.rows[1].z), 4.5 * entry);
        }
    }
}

}  // namespace
}  // namespace oblong::test::mesh_stages_test
