#include "engine/scene/pick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/level/bsp_read.h"
#include "engine/level/side.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/folders.h"
#include "tests/support/point.h"

namespace oblong::test {
namespace {

/// What a ray meets, by a look at all faces in double precision.
struct Met {
    FaceIndex face = FaceIndex::none();
    double distance = 1e9;
    double from_edge = 0;  ///< how far within the face the ray goes through it, units
};

/// How far inside of a face's edges a point of its plane is; below 0 outside.
double depth_in(const Level& level, const Face& face, Point normal, Point p) {
    double least = 1e9;
    for (const SurfEdge step : level.edges_of(face)) {
        const Edge& edge = level.edges[step.edge()];
        const Point a = to_point(level.vertices[step.is_reversed() ? edge.to : edge.from]);
        const Point b = to_point(level.vertices[step.is_reversed() ? edge.from : edge.to]);
        const Point along = b - a, inward = cross(along, normal);  // clockwise: the inside is on the right
        const double size = std::sqrt(dot(inward, inward));
        if (size > 0) least = std::min(least, dot(p - a, inward) / size);
    }
    return least;
}

void look_at_face(const Level& level, FaceIndex index, Point eye, Point direction, Met& best) {
    const Face& face = level.faces[index];
    const LevelPlane& plane = level.planes[face.plane];
    const double sign = face.is_back ? -1 : 1;
    const Point n = to_point(plane.normal), normal{n.x * sign, n.y * sign, n.z * sign};
    const double above = dot(eye, normal) - sign * std::ldexp(static_cast<double>(plane.distance.raw), -42);
    const double approach = -dot(direction, normal);
    if (above <= 0 || approach <= 0 || above / approach >= best.distance) return;
    const double t = above / approach;
    const Point p{eye.x + direction.x * t, eye.y + direction.y * t, eye.z + direction.z * t};
    const double depth = depth_in(level, face, normal, p);
    if (depth >= 0) best = {index, t, depth};
}

Met look_at_all(const Level& level, std::span<const PlacedModel> models, const Vec3<World>& eye,
                const Vec3<Unit>& direction) {
    Met best;
    for (const FaceIndex face : level.world().faces)
        look_at_face(level, face, to_point(eye), to_point(direction), best);
    for (const PlacedModel& placed : models)
        for (const FaceIndex face : level.models[placed.model].faces)
            look_at_face(level, face, to_point(eye) - to_point(placed.offset), to_point(direction), best);
    return best;
}

Vec3<Unit> any_direction(std::mt19937& random) {
    const auto any = [&random] { return Unit::from_raw(static_cast<std::int32_t>(random()) / 4); };
    return normalised(Vec3<Unit>{any(), any(), any()});
}

Vec3<World> any_point(const LevelBox& box, std::mt19937& random) {
    const auto any = [&](std::size_t axis) {
        return World::from_raw(
            std::uniform_int_distribution<std::int32_t>(box.mins[axis] * 4096, box.maxs[axis] * 4096)(random));
    };
    const World x = any(0), y = any(1);
    return {x, y, any(2)};
}

/// Rays in all directions from the open of a level. Where the engine and the look at all faces differ, the ray goes
/// along an edge, where rounding decides.
void expect_same_as_all_faces(const Level& level, int count) {
    const std::vector<PlacedModel> models = models_at_rest(level);
    std::mt19937 random(7);
    int at_edges = 0, on_models = 0;
    for (int i = 0; i < count;) {
        const Vec3<World> eye = any_point(level.world().box, random);
        const std::int32_t contents = level.leaves[find_leaf(level, level.world(), eye)].contents;
        if (contents == contents::kSolid || contents == contents::kSky) continue;
        ++i;
        const Vec3<Unit> direction = any_direction(random);
        const std::optional<PickedFace> found = pick_face(level, models, eye, direction);
        const Met expected = look_at_all(level, models, eye, direction);
        if (expected.from_edge < 0.01) {
            ++at_edges;
            continue;
        }
        ASSERT_TRUE(found) << i;
        ASSERT_NEAR(std::ldexp(static_cast<double>(found->distance.raw), -24), expected.distance, 0.01) << i;
        on_models += !found->model.is_none();
        // Faces may lie in one plane, one over the other.
        if (found->face == expected.face) continue;
        ASSERT_EQ(level.faces[found->face].plane, level.faces[expected.face].plane) << i;
    }
    EXPECT_LT(at_edges, count / 50);
    EXPECT_TRUE(on_models > 0 || models.size() < 4);
}

class PickInRealLevels : public testing::TestWithParam<const char*> {};

TEST_P(PickInRealLevels, FindsWhatALookAtAllFacesFinds) {
    OBLONG_NEEDS_SHARED_LEVELS();
    expect_same_as_all_faces(read_bsp(read_shared_file(std::string(GetParam()) + ".bsp")), 500);
}

INSTANTIATE_TEST_SUITE_P(All, PickInRealLevels, testing::ValuesIn(kRealLevels));

TEST(Pick, OfTheTinyLevelIsItsFloorAtTheRightPlace) {
    const Level level = read_bsp(join_lumps(29, make_tiny_lumps()));
    const Vec3<World> eye = to_world({10, 5, 40});
    const Vec3<Unit> down{{}, {}, -Unit::from_int(1)};
    const auto found = pick_face(level, {}, eye, down);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->face, FaceIndex(0));
    EXPECT_EQ(found->distance, RayDistance::from_int(32));
    EXPECT_EQ(found->world_point, to_world({10, 5, 8}));
    EXPECT_EQ(level.texture_of(level.faces[found->face]).name, "floor");
    EXPECT_FALSE(pick_face(level, {}, eye, -down)) << "away from the floor";
    EXPECT_FALSE(pick_face(level, {}, to_world({40, 5, 40}), down)) << "beside it";
    EXPECT_FALSE(pick_face(level, {}, to_world({10, 5, 4}), -down)) << "from behind";
    EXPECT_FALSE(pick_face(level, {}, eye, {Unit::from_int(1), {}, {}})) << "along it";
    EXPECT_FALSE(pick_face(level, {}, to_world({10, 5, 8}), down)) << "from a point on it";
}

TEST(Pick, FindsAModelAtItsPlaceBeforeTheWorldBehindIt) {
    Level level = read_bsp(join_lumps(29, make_tiny_lumps()));
    level.models.push_back(level.models.front());
    const std::array placed{PlacedModel{ModelIndex(1), to_world({0, 0, 10})}};
    const Vec3<Unit> down{{}, {}, -Unit::from_int(1)};
    const auto found = pick_face(level, placed, to_world({10, 5, 40}), down);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->model, PlacedIndex(0));
    EXPECT_EQ(found->world_point, to_world({10, 5, 18}));
    const auto below = pick_face(level, placed, to_world({10, 5, 17}), down);
    ASSERT_TRUE(below);
    EXPECT_TRUE(below->model.is_none());
}

TEST(Pick, EntityOfAModelIsTheOneThatNamesIt) {
    Level level;
    level.entities = {{{{"classname", "worldspawn"}}}, {{{"classname", "func_door"}, {"model", "*1"}}}};
    ASSERT_NE(entity_of(level, ModelIndex(1)), nullptr);
    EXPECT_EQ(entity_of(level, ModelIndex(1))->value("classname"), "func_door");
    EXPECT_EQ(entity_of(level, ModelIndex(2)), nullptr);
}

}  // namespace
}  // namespace oblong::test
