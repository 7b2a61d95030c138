#include "engine/reference/frame.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/reference/made_level.h"
#include "tests/support/reference_polygons.h"

namespace oblong::reference::frame_test {
namespace {

using namespace test;

/// Left, top, right and bottom of the pixels that show a face, which must fill that rectangle.
std::array<int, 4> rectangle_of(const Frame& frame, int face) {
    std::array<int, 4> box{frame.width_px, frame.height_px, 0, 0};
    int count = 0;
    for (int row = 0; row < frame.height_px; ++row)
        for (int column = 0; column < frame.width_px; ++column) {
            if (frame.at(column, row).face != face) continue;
            ++count;
            box = {std::min(box[0], column), std::min(box[1], row), std::max(box[2], column + 1),
                   std::max(box[3], row + 1)};
        }
    EXPECT_EQ(count, std::max(box[2] - box[0], 0) * std::max(box[3] - box[1], 0));
    return box;
}

using Box = std::array<int, 4>;

Frame drawn(const Level& level, std::span<const PlacedModel> models = {}) {
    return draw(level, models, make_plain_view());
}

void expect_near(const Vec& found, const Vec& expected) {
    const Vec difference = found - expected;
    EXPECT_LT(dot(difference, difference), 1e-20) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(ReferenceView, AxesAreQuakes) {
    const auto axes = [](double yaw, double pitch, double roll) {
        return make_camera({.eye = {}, .yaw = yaw, .pitch = pitch, .roll = roll}).axes;
    };
    expect_near(axes(0, 0, 0).forward, {1, 0, 0});
    expect_near(axes(0, 0, 0).right, {0, -1, 0});
    expect_near(axes(0, 0, 0).up, {0, 0, 1});
    expect_near(axes(16384, 0, 0).forward, {0, 1, 0});   // to the left, north
    expect_near(axes(0, 16384, 0).forward, {0, 0, -1});  // down
    expect_near(axes(0, 16384, 0).up, {1, 0, 0});
    expect_near(axes(0, 0, 16384).right, {0, 0, -1});  // the head leans right: its right side is down
    expect_near(axes(16384, 16384, 16384).right, {0, -1, 0});
    expect_near(axes(16384, 16384, 16384).forward, {0, 0, -1});
}

TEST(ReferenceView, PixelsAreAsHighAsTheDisplayMakesThem) {
    View view;
    EXPECT_NEAR(make_camera(view).projection.multiplier_x, 160, 1e-9);
    EXPECT_NEAR(make_camera(view).projection.multiplier_y, 160 / 1.2, 1e-9);
    view.correct_aspect = false;
    EXPECT_NEAR(make_camera(view).projection.multiplier_y, 160, 1e-9);
}

TEST(ReferenceFrame, AShiftMovesTheRays) {
    Level level = make_level();
    add_rectangle(level, 10.25, 20.25, 30.25, 40.25);
    EXPECT_EQ(rectangle_of(draw(level, {}, make_plain_view(), {-kRayUnit / 2, 0}), 0), (Box{11, 20, 31, 40}));
    EXPECT_EQ(rectangle_of(draw(level, {}, make_plain_view(), {0, -kRayUnit / 2}), 0), (Box{10, 21, 30, 41}));
}

TEST(ReferenceFrame, FacesThatFaceAwayAreNotDrawn) {
    Level level = make_level();
    add_face(level, {shown_at(20, 40, 160), shown_at(40, 40, 160), shown_at(40, 20, 160), shown_at(20, 20, 160)});
    EXPECT_EQ(rectangle_of(drawn(level), 0), (Box{320, 200, 0, 0}));
}

TEST(ReferenceFrame, DepthStaysWithinTheCorners) {
    // A plane through the corners on the left that misses those on the right by far.
    Level level = make_level();
    Face& face = add_face(
        level, {shown_at(100, 50, 100), shown_at(200, 50, 120), shown_at(200, 150, 120), shown_at(100, 150, 100)});
    face.plane.normal = {-0.5, -0.8, 0};
    face.plane.offset = dot(face.plane.normal, shown_at(100, 50, 100));
    const Frame frame = drawn(level);
    EXPECT_NEAR(frame.at(100, 100).z, 100, 0.5);
    EXPECT_NEAR(frame.at(199, 100).z, 120, 1e-9);
    EXPECT_LT(PlaneView(level, face, {}, make_camera(make_plain_view())).inverse_z({199.5, 100.5}), 1 / 200.0);
}

TEST(ReferenceFrame, ModelsAreDrawnWhereTheyMovedTo) {
    Level level = make_level();
    add_rectangle(level, 0, 0, 320, 200, 320);
    level.models.push_back({{}, {}, 1, 0});
    add_rectangle(level, 20, 20, 40, 40, 160);
    EXPECT_EQ(rectangle_of(drawn(level), 1), (Box{320, 200, 0, 0}));
    const PlacedModel moved{1, {0, -5, -3}};
    const Frame frame = drawn(level, {&moved, 1});
    EXPECT_EQ(rectangle_of(frame, 1), (Box{25, 23, 45, 43}));
    EXPECT_EQ(frame.at(30, 30).model, 1);
    EXPECT_EQ(frame.at(0, 0).model, 0);
    // The texture moves along: the corner that was at column 20 is at u = -140.
    EXPECT_NEAR(frame.at(25, 23).u, -139.5, 1e-9);
    EXPECT_NEAR(frame.at(25, 23).v, -79.5, 1e-9);
}

/// A room of 2 x 2 x 2 units times `half`, seen from inside.
void add_room(Level& level, double half) {
    const auto side = [&](const Vec& normal, const Vec& across) {
        const Vec up = cross(normal, across);  // clockwise seen against the normal
        add_face(level, {(up - across - normal) * half, (up + across - normal) * half, (across - up - normal) * half,
                         (up + across + normal) * -half});
    };
    for (const double sign : {1.0, -1.0}) {
        side({sign, 0, 0}, {0, 1, 0});
        side({0, sign, 0}, {0, 0, 1});
        side({0, 0, sign}, {1, 0, 0});
    }
}

struct CloseCall {
    int column, row;
    bool is_one;
};
void expect_close_calls(const Frame& frame, const std::vector<CloseCall>& calls) {
    for (const auto& [column, row, is_one] : calls)
        EXPECT_EQ(frame.at(column, row).is_close_call, is_one) << column << ", " << row;
}

TEST(ReferenceFrame, CloseCallsAreEdgesVeryNearToACentre) {
    Level level = make_level();
    add_rectangle(level, 10.5 + 1.0 / 1024, 20, 30.5 + 1.0 / 128, 40.5 - 1.0 / 1024, 160);
    const Frame frame = draw_with_close_calls(level, {}, make_plain_view());
    // Those of the first two are just not covered, that of the third clearly enough.
    expect_close_calls(frame, {{10, 30, true}, {20, 40, true}, {30, 30, false}, {11, 30, false}, {20, 20, false}});
    EXPECT_EQ(frame.at(30, 30).face, 0);
    const Frame wider = draw_with_close_calls(level, {}, make_plain_view(), kRayUnit / 64);
    EXPECT_TRUE(wider.at(30, 30).is_close_call);
}

TEST(ReferenceFrame, CloseCallsAreFacesAtTheSameDepth) {
    Level level = make_level();
    for (const auto& [left_top, right_bottom, depth] : {std::array{10.0, 30.0, 160.0},
                                                        {20, 40, 160},
                                                        {50, 70, 160},
                                                        {50, 70, 160.01},
                                                        {80, 99, 160.00001},
                                                        {80, 99, 160}})
        add_rectangle(level, left_top, left_top, right_bottom, right_bottom, depth);
    const Frame frame = drawn(level);
    expect_close_calls(frame, {{90, 90, true}, {25, 25, true}, {15, 15, false}, {35, 35, false}, {60, 60, false}});
    EXPECT_EQ(frame.at(90, 90).face, 5);  // the nearer one all the same
}

TEST(ReferenceFrame, EachPixelNamesThePlaneThatItShows) {
    Level level = make_level();
    add_room(level, 100);
    const View view{{3, 5, 7}, 5000, 3000, 1000};
    const Frame frame = draw(level, {}, view);
    for (const int row : {0, 50, 150})
        for (const int column : {0, 100, 300}) {
            const Pixel& pixel = frame.at(column, row);
            const Texel texel =
                frame.planes.at(static_cast<std::size_t>(pixel.plane)).texel_at({column + 0.5, row + 0.5});
            EXPECT_DOUBLE_EQ(texel.u, pixel.u);
            EXPECT_DOUBLE_EQ(texel.v, pixel.v);
            EXPECT_DOUBLE_EQ(1 / texel.inverse_z, pixel.z);
        }
}

std::int64_t random_integer(std::mt19937& random, std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
}

bool is_inside(const std::optional<RayTriangle>& triangle, const RayGrid& grid, int column, int row) {
    if (!triangle) return false;
    const Interval inside = triangle->inside(grid, row);
    return column >= inside.first && column < inside.end;
}

TEST(Rays, InFrontOfTheEyeTrianglesCoverWhatExactEdgeFunctionsSay) {
    std::mt19937 random(1);
    const RayGrid grid{24, 16, {}};
    int covered = 0;
    for (int i = 0; i < 3000; ++i) {
        std::array<GridPoint, 3> points;
        std::array<RayCorner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            // Often on pixel centres and their rows and columns, so that rays meet edges and corners.
            const std::int64_t step = i % 2 == 0 ? 128 : 1, depth = random_integer(random, 1, 1 << 20);
            points[k] = {random_integer(random, -4 * 256 / step, 28 * 256 / step) * step,
                         random_integer(random, -4 * 256 / step, 20 * 256 / step) * step};
            corners[k] = {(points[k].x - 12 * 256) * depth, (points[k].y - 8 * 256) * depth, 256 * depth};
        }
        const auto triangle = RayTriangle::make(corners[0], corners[1], corners[2]);
        for (int row = 0; row < grid.height_px; ++row)
            for (int column = 0; column < grid.width_px; ++column) {
                const bool expected = covers(points, column, row);
                covered += expected;
                ASSERT_EQ(is_inside(triangle, grid, column, row), expected) << i << ' ' << column << ' ' << row;
            }
    }
    EXPECT_GT(covered, 100000);
}

TEST(Rays, AClosedMeshAroundTheEyeCoversEveryRayOnce) {
    // A cube's corners, each anywhere in its octant: on small whole numbers many rays meet edges and corners.
    constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    std::mt19937 random(2);
    const RayGrid grid{8, 8, {}};
    for (int i = 0; i < 500; ++i) {
        std::array<RayCorner, 8> corners;
        for (std::size_t k = 0; k < 8; ++k) {
            const auto part = [&](unsigned bit) { return random_integer(random, 1, 7) * ((k & bit) != 0 ? 1 : -1); };
            corners[k] = {part(1), part(2), part(4)};
        }
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                int winding = 0;
                for (const auto& side : kSides) {
                    const std::array polygon{corners[side[0]], corners[side[1]], corners[side[2]], corners[side[3]]};
                    for (const RayTriangle& triangle : make_ray_fan(polygon))
                        winding += is_inside(triangle, grid, column, row) ? triangle.winding() : 0;
                }
                ASSERT_EQ(winding, 1) << i << ' ' << column << ' ' << row;
            }
    }
}

TEST(Rays, ATriangleInAPlaneThroughTheEyeCoversNothing) {
    EXPECT_FALSE(RayTriangle::make({1, 2, 3}, {4, 5, 6}, {5, 7, 9}));
}

TEST(Rays, OrientationIsExactForTheLargestCorners) {
    // Products of 165 bits that cancel: det(a, b, c) = det(a, b - a, c - a) = n det((1 1 1), (0 -1 0), (0 0 -1)) = n.
    constexpr std::int64_t n = (std::int64_t{1} << 55) - 1;
    const RayCorner a{n, n, n}, b{n, n - 1, n}, c{n, n, n - 1};
    ASSERT_TRUE(RayTriangle::make(a, b, c));
    EXPECT_EQ(RayTriangle::make(a, b, c)->winding(), 1);
    EXPECT_EQ(RayTriangle::make(b, a, c)->winding(), -1);
    EXPECT_FALSE(RayTriangle::make(a, b, {n, n - 2, n}));
}

TEST(Rays, CornersTooFarForExactDeterminantsAreRefused) {
    EXPECT_THROW(make_ray_corner({1e12, 0, 0}, make_camera({})), std::range_error);
}

/// A floor whose height at x = 100 is this, at -100 it is -64; u is x, v is 7 - y.
Level floor_rising_to(double height) {
    Level level = make_level();
    level.texinfos[0] = {{1, 0, 0}, {0, -1, 0}, 0, 7, 0, false};
    add_face(level, {{-100, 100, -64}, {100, 100, height}, {100, -100, height}, {-100, -100, -64}});
    return level;
}

// Where the plane shows a texel, by its closed forms: tests/measure/texel_error_test.cpp.
TEST(PlaneView, TexelsBehindTheEyeHaveNoPlace) {
    const Level level = floor_rising_to(-64);
    const PlaneView view(level, level.faces[0], {}, make_camera(make_plain_view()));
    EXPECT_FALSE(view.place_of(-50, 7));
    ASSERT_TRUE(view.place_of(64, 7));
    EXPECT_NEAR(view.place_of(64, 7)->x, 160, 1e-9);
    EXPECT_NEAR(view.place_of(64, 7)->y, 260, 1e-9);  // 45 degrees down
}

TEST(PlaneView, AxesAcrossThePlaneHaveNoPlaces) {
    Level level = floor_rising_to(-30);
    level.texinfos[0].s = level.faces[0].plane.normal * 0.7;
    const PlaneView view(level, level.faces[0], {}, make_camera(make_plain_view()));
    for (const double u : {-9, 0, 5}) EXPECT_FALSE(view.place_of(u, 7)) << u;
}

}  // namespace
}  // namespace oblong::reference::frame_test
