// What seed 3 (the course notes) says of the cube, of matrices, clip planes and clipping, with the values as corrected.
// Its lines and look-at: vectors_test.cpp; its triangles on the screen: notes_raster_test.cpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>

#include "engine/math/matrix.h"
#include "engine/math/vec.h"
#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "engine/view/clip.h"
#include "engine/view/frustum.h"
#include "engine/view/project.h"
#include "tests/seeds/seed_values.h"

namespace oblong::test {
namespace {

/// Corners are numbered from 1, as in the notes.
using Face = std::array<int, 3>;

Vec3<Whole> cube_corner(int number) {
    const std::array corners{whole(-1, -1, -1), whole(-1, 1, -1), whole(1, 1, -1), whole(1, -1, -1),
                             whole(1, 1, 1),    whole(1, -1, 1),  whole(-1, 1, 1), whole(-1, -1, 1)};
    return corners.at(static_cast<std::size_t>(number - 1));
}

/// The cube's sides, clockwise seen from outside in left-handed axes, each cut in two.
std::vector<Face> cube_faces() {
    std::vector<Face> faces;
    for (const auto& [a, b, c, d] :
         {std::array{1, 2, 3, 4}, {4, 3, 5, 6}, {6, 5, 7, 8}, {8, 7, 2, 1}, {2, 7, 5, 3}, {6, 8, 1, 4}}) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
    }
    return faces;
}

Vec3<Whole> normal_of(const Face& face) {
    const Vec3<Whole> a = cube_corner(face[0]);
    const auto normal = cross(cube_corner(face[1]) - a, cube_corner(face[2]) - a);
    const auto narrow = [](auto value) { return static_cast<std::int32_t>(value.raw); };
    return whole(narrow(normal.x), narrow(normal.y), narrow(normal.z));
}

/// Six times the volume between the faces and the origin.
std::int64_t sextuple_volume(const std::vector<Face>& faces) {
    std::int64_t sum = 0;
    for (const Face& face : faces) sum += dot(cube_corner(face[0]), normal_of(face)).raw;
    return sum;
}

/// Edges of which the face on the other side does not use the opposite direction, once.
std::vector<std::pair<int, int>> unmatched_edges(const std::vector<Face>& faces) {
    std::map<std::pair<int, int>, int> uses;
    for (const Face& face : faces)
        for (std::size_t i = 0; i < 3; ++i) ++uses[{face[i], face[(i + 1) % 3]}];
    std::vector<std::pair<int, int>> unmatched;
    for (const auto& [edge, count] : uses) {
        const auto back = uses.find({edge.second, edge.first});
        if (count != 1 || back == uses.end() || back->second != 1) unmatched.push_back(edge);
    }
    return unmatched;
}

TEST(SeedN1, CubeWithFace821IsClosedAndFacesOutward) {
    const std::vector<Face> faces = cube_faces();
    EXPECT_EQ(faces[7], (Face{8, 2, 1}));
    EXPECT_EQ(faces.size(), 12u);
    EXPECT_EQ(unmatched_edges(faces).size(), 0u) << "each of the 18 edges is used once each way";
    EXPECT_EQ(sextuple_volume(faces), 6 * 8);
    for (const Face& face : faces) EXPECT_GT(dot(normal_of(face), cube_corner(face[0])).raw, 0);
}

TEST(SeedN1, ListedFace851BreaksTheCube) {
    std::vector<Face> faces = cube_faces();
    faces[7] = {8, 5, 1};
    EXPECT_EQ(normal_of(faces[7]), whole(-4, 4, 0));
    EXPECT_EQ(dot(normal_of(faces[7]), cube_corner(8)).raw, 0) << "it passes through the middle";
    EXPECT_EQ(sextuple_volume(faces), 6 * 22 / 3);
    EXPECT_EQ(unmatched_edges(faces), (std::vector<std::pair<int, int>>{{1, 2}, {2, 8}, {5, 1}, {8, 5}}));
}

TEST(SeedN2, AspectInTheMatrixIsHeightOverWidth) {
    // A picture of 4:3, 90 degrees high: f = 1, and the right edge of the view is x = 4/3 z.
    const auto edge_by = [](Entry a) {
        Matrix4 matrix = perspective(entry(1));
        matrix.rows[0][0] = a;
        return number_of(point_of(matrix * point(entry(4), Entry{}, entry(3)))->x);
    };
    EXPECT_NEAR(edge_by(entry(3, 4)), 1, 1e-8);
    EXPECT_NEAR(edge_by(entry(4, 3)), 1.777778, 1e-6) << "as listed";
}

/// The notes' depth of z between the planes zn and zf, by `lambda` and `offset`.
double depth(Entry lambda, Entry offset, Entry z) {
    Matrix4 matrix = perspective(entry(1));
    matrix.rows[2] = {Entry{}, Entry{}, lambda, offset};
    return number_of(point_of(matrix * point(Entry{}, Entry{}, z))->z);
}

TEST(SeedN3, DepthRunsFrom0AtTheNearPlaneTo1AtTheFarPlane) {
    const Entry near = entry(1, 10), far = entry(100);
    const Entry lambda = divide<Entry>(far, far - near), offset = -multiply(lambda, near);
    EXPECT_NEAR(number_of(lambda), 1.001001001, 1e-9);
    EXPECT_NEAR(number_of(offset), -0.100100100, 1e-9);
    EXPECT_NEAR(depth(lambda, offset, near), 0, 1e-8);
    EXPECT_NEAR(depth(lambda, offset, far), 1, 1e-8);
}

TEST(SeedN3, ListedLambdaMissesTheFarPlaneAndIsZeroForANearPlaneAt1) {
    const auto listed = [](Entry near, Entry far) {
        return divide<Entry>(far, far - near) - divide<Entry>(multiply(far, near), far - near);
    };
    const Entry near = entry(1, 10), far = entry(100), lambda = listed(near, far);
    EXPECT_NEAR(number_of(lambda), 0.900900901, 1e-8);
    EXPECT_NEAR(depth(lambda, -multiply(lambda, near), far), 0.9, 1e-8);
    EXPECT_EQ(listed(entry(1), far).raw, 0);
}

constexpr std::size_t kRight = 1, kTop = 3;

TEST(SeedN6, RightPlaneOf90DegreesHoldsWhatLiesLeftOfXEqualsZ) {
    const Frustum frustum = make_frustum(y_up_basis({}, {}, {}), make_projection(ScreenMode{}, Degrees::from_int(90)));
    const ClipPlane& right = frustum.clip_planes[kRight];
    const auto distance = [&right](int x) {
        const double length = std::hypot(right.normal.x.raw, right.normal.z.raw);
        return std::ldexp(static_cast<double>(right.distance(view_point(x, 0, 1)).raw), -16) / length;
    };
    EXPECT_NEAR(distance(0), 0.7071, 1e-4);
    EXPECT_EQ(distance(1), 0);
    EXPECT_LT(distance(2), 0);
    EXPECT_EQ(outcode_of(frustum, view_point(1, 0, 1)), 0) << "on the plane is inside";
    EXPECT_EQ(outcode_of(frustum, view_point(2, 0, 1)), kOutRight);
}

TEST(SeedN6, SidePlanesTakeTheFieldAcrossAndTopAndBottomTheFieldDown) {
    const Frustum frustum = make_frustum(y_up_basis({}, {}, {}), make_projection(ScreenMode{}, Degrees::from_int(90)));
    const auto field = [](ClipNormal across, ClipNormal along) {
        return 2 * std::atan2(static_cast<double>(along.raw), static_cast<double>(-across.raw)) * 180 /
               std::numbers::pi;
    };
    const auto &right = frustum.clip_planes[kRight].normal, &top = frustum.clip_planes[kTop].normal;
    EXPECT_NEAR(field(right.x, right.z), 90, 1e-5);
    EXPECT_NEAR(field(top.y, top.z), 73.7398, 1e-4);
}

/// Twice the area of a polygon that lies in a plane z, square units.
std::int64_t doubled_area(const std::vector<ClipVertex>& polygon) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3<View>&a = polygon[i].position, &b = polygon[(i + 1) % polygon.size()].position;
        sum += (a.x.raw >> 16) * (b.y.raw >> 16) - (b.x.raw >> 16) * (a.y.raw >> 16);
    }
    return sum;
}

TEST(SeedN8, OutsideListHasBothCrossingsAndTheTwoAreasAddUp) {
    const auto corner = [](int x, int y) { return ClipVertex{view_point(x, y, 9), 0}; };
    // Q_2 to Q_4 are inside x >= 0; the edges cross it at I_1 and I_2.
    const ClipVertex q_1 = corner(-4, 0), q_5 = corner(-4, 4), i_1 = corner(0, -2), i_2 = corner(0, 6);
    const std::vector<ClipVertex> pentagon{q_1, corner(4, -4), corner(8, 2), corner(4, 8), q_5};
    std::vector<ClipVertex> inside, outside;
    clip_to_plane({{1, 0, 0}, 0}, 32, pentagon, inside);
    clip_to_plane({{-1, 0, 0}, 0}, 32, pentagon, outside);

    const std::array expected{q_1, i_1, i_2, q_5};
    const auto is_same = [](const auto& a, const auto& b) { return a.position == b.position; };
    const auto start = std::find_if(outside.begin(), outside.end(), [&](const auto& v) { return is_same(v, q_1); });
    std::rotate(outside.begin(), start, outside.end());
    EXPECT_TRUE(std::equal(outside.begin(), outside.end(), expected.begin(), expected.end(), is_same)) << "in order";
    EXPECT_EQ(doubled_area(inside) + doubled_area(outside), doubled_area(pentagon));
    EXPECT_NE(doubled_area(inside) + doubled_area({q_1, i_2, i_2, q_5}), doubled_area(pentagon)) << "as listed";
}

}  // namespace
}  // namespace oblong::test
