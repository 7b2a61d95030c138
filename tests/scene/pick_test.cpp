#include "engine/scene/pick.h"

#include <gtest/gtest.h>

#include "tests/support/levels.h"
#include "tests/support/random.h"

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
        const Point inward = cross(b - a, normal);  // clockwise: the inside is on the right
        if (length(inward) > 0) least = std::min(least, dot(p - a, inward) / length(inward));
    }
    return least;
}

void look_at_face(const Level& level, FaceIndex index, Point eye, Point direction, Met& best) {
    const Face& face = level.faces[index];
    const LevelPlane& plane = level.planes[face.plane];
    const double sign = face.is_back ? -1 : 1;
    const Point normal = to_point(plane.normal) * sign;
    const double above = dot(eye, normal) - sign * number_of(plane.distance), approach = -dot(direction, normal);
    if (above <= 0 || approach <= 0 || above / approach >= best.distance) return;
    const double t = above / approach, depth = depth_in(level, face, normal, eye + direction * t);
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

class PickInRealLevels : public OfLevel {};

/// Rays in all directions from the open of a level. Where the engine and the look at all faces differ, the ray goes
/// along an edge, where rounding decides.
TEST_P(PickInRealLevels, FindsWhatALookAtAllFacesFinds) {
    constexpr int kCount = 500;
    const Level level = read_level(GetParam());
    const std::vector<PlacedModel> models = models_at_rest(level);
    std::mt19937 random(7);
    int at_edges = 0, on_models = 0;
    for (int i = 0; i < kCount; ++i) {
        const Vec3<World> eye = random_open_point(level, random);
        const Vec3<Unit> direction = any_direction(random);
        const std::optional<PickedFace> found = pick_face(level, models, eye, direction);
        const Met expected = look_at_all(level, models, eye, direction);
        if (expected.from_edge < 0.01) {
            ++at_edges;
            continue;
        }
        ASSERT_TRUE(found) << i;
        ASSERT_NEAR(number_of(found->distance), expected.distance, 0.01) << i;
        on_models += !found->model.is_none();
        // Faces may lie in one plane, one over the other.
        if (found->face == expected.face) continue;
        ASSERT_EQ(level.faces[found->face].plane, level.faces[expected.face].plane) << i;
    }
    EXPECT_LT(at_edges, kCount / 50);
    EXPECT_TRUE(on_models > 0 || models.size() < 4);
}

OBLONG_FOR_REAL_LEVELS(PickInRealLevels);

const Vec3<Unit> kDown{{}, {}, -Unit::from_int(1)};

TEST(Pick, OfTheTinyLevelIsItsFloorAtTheRightPlace) {
    const Level level = tiny_level();
    const Vec3<World> eye = to_world({10, 5, 40});
    const auto found = pick_face(level, {}, eye, kDown);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->face, FaceIndex(0));
    EXPECT_EQ(found->distance, RayDistance::from_int(32));
    EXPECT_EQ(found->world_point, to_world({10, 5, 8}));
    EXPECT_EQ(level.texture_of(level.faces[found->face]).name, "floor");
    EXPECT_FALSE(pick_face(level, {}, eye, -kDown)) << "away from the floor";
    EXPECT_FALSE(pick_face(level, {}, to_world({40, 5, 40}), kDown)) << "beside it";
    EXPECT_FALSE(pick_face(level, {}, to_world({10, 5, 4}), -kDown)) << "from behind";
    EXPECT_FALSE(pick_face(level, {}, eye, {Unit::from_int(1), {}, {}})) << "along it";
    EXPECT_FALSE(pick_face(level, {}, to_world({10, 5, 8}), kDown)) << "from a point on it";
}

TEST(Pick, FindsAModelAtItsPlaceBeforeTheWorldBehindIt) {
    Level level = tiny_level();
    level.models.push_back(level.models.front());
    const std::array placed{PlacedModel{ModelIndex(1), to_world({0, 0, 10})}};
    const auto found = pick_face(level, placed, to_world({10, 5, 40}), kDown);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->model, PlacedIndex(0));
    EXPECT_EQ(found->world_point, to_world({10, 5, 18}));
    const auto below = pick_face(level, placed, to_world({10, 5, 17}), kDown);
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
