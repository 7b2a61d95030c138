#include "engine/view/clip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/methods/polygons.h"
#include "engine/raster/scan.h"
#include "tests/hard_cases/hard_case.h"
#include "tests/support/reference_polygons.h"

namespace oblong::test {
namespace {

using reference::Vec;

constexpr ClipPlane kAtDepth4{{0, 0, 1}, 4 * 65536};

Vec3<View> view_point(double x, double y, double z) {
    const auto raw = [](double value) { return View::from_raw(std::llround(value * 65536)); };
    return {raw(x), raw(y), raw(z)};
}

std::vector<ClipVertex> random_polygon(std::mt19937& random, int corners) {
    // On an ellipse in a random plane: convex.
    const auto direction = [&] {
        return Vec{random_between(random, -900, 900), random_between(random, -900, 900),
                   random_between(random, -900, 900)};
    };
    const Vec centre = direction(), across = direction(), along = direction();
    std::vector<ClipVertex> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i / corners;
        const Vec p = centre + across * std::cos(angle) + along * std::sin(angle);
        polygon.push_back({view_point(p.x, p.y, p.z), 0});
    }
    return polygon;
}

std::vector<ClipVertex> clipped(const std::vector<ClipVertex>& polygon, const ClipPlane& plane) {
    std::vector<ClipVertex> out;
    clip_to_plane(plane, 1, polygon, out);
    return out;
}

/// Twice the area of the polygon's shadow along z, (1/65536 unit)^2: exact.
std::int64_t doubled_shadow(const std::vector<ClipVertex>& polygon) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3<View>&a = polygon[i].position, &b = polygon[(i + 1) % polygon.size()].position;
        sum += a.x.raw * b.y.raw - b.x.raw * a.y.raw;
    }
    return sum;
}

/// A corner on the plane stays a corner of all its faces; where an edge leaves the view there, the crossing beside it
/// is another corner, which lies on the screen's border exactly. A polygon that only touches the plane is one point.
void expect_no_corner_twice(const std::vector<ClipVertex>& polygon, int seed) {
    if (std::ranges::all_of(polygon, [&](const ClipVertex& vertex) { return vertex.position == polygon[0].position; }))
        return;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipVertex &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        EXPECT_TRUE(here.position != next.position || here.borders != next.borders) << seed << ", " << i;
    }
}

TEST(HardCaseC1, CornersOnThePlaneAreInsideAndNeverDoubled) {
    const std::vector<ClipVertex> touching{
        {view_point(0, 0, 4), 0}, {view_point(9, 0, 4), 0}, {view_point(5, 7, 9), 0}};
    const std::vector<ClipVertex> whole = clipped(touching, kAtDepth4);
    ASSERT_EQ(whole.size(), 3u);
    EXPECT_EQ(doubled_shadow(whole), doubled_shadow(touching));

    const std::vector<ClipVertex> crossing{
        {view_point(0, 0, 4), 0}, {view_point(9, 0, 1), 0}, {view_point(5, 7, 9), 0}};
    const std::vector<ClipVertex> rest = clipped(crossing, kAtDepth4);
    expect_no_corner_twice(rest, 0);
    // What is left: (0, 0), (7.5, 2.625), (5, 7).
    EXPECT_EQ(doubled_shadow(rest), std::llround(0x1p32 * (7.5 * 7 - 5 * 2.625)));
}

TEST(HardCaseC1, NoPolygonGetsACornerTwiceOrLosesOneInside) {
    std::mt19937 random(1);
    for (int i = 0; i < 5000; ++i) {
        auto polygon = random_polygon(random, 3 + i % 7);
        for (ClipVertex& vertex : polygon)
            if (random() % 3 == 0) vertex.position.z = View::from_int(4);
        const auto rest = clipped(polygon, kAtDepth4);
        expect_no_corner_twice(rest, i);
        for (const ClipVertex& vertex : polygon) {
            const bool is_kept = std::ranges::count(rest, vertex.position, &ClipVertex::position) != 0;
            ASSERT_EQ(is_kept, vertex.position.z >= View::from_int(4)) << i;
        }
    }
}

TEST(HardCaseC2, BothSidesOfAnEdgeCutItAtTheSameBits) {
    std::mt19937 random(2);
    for (int i = 0; i < 20000; ++i) {
        const double size = i % 2 ? 32767 : 64;
        const auto coordinate = [&] { return random_between(random, -size, size); };
        const auto a = view_point(coordinate(), coordinate(), random_between(random, 4.001, size));
        const auto b = view_point(coordinate(), coordinate(), random_between(random, -size, 3.999));
        const ClipVertex one{view_point(coordinate(), coordinate(), 100), 0};
        const ClipVertex other{view_point(coordinate(), coordinate(), -100), 0};
        const auto forth = clipped({{a, 0}, {b, 0}, other}, kAtDepth4),
                   back = clipped({{b, 0}, {a, 0}, one}, kAtDepth4);
        const auto cut = cross_plane(a, kAtDepth4.distance(a), b, kAtDepth4.distance(b));
        for (const auto& polygon : {forth, back})
            ASSERT_NE(std::ranges::count(polygon, cut, &ClipVertex::position), 0) << i;
    }
}

__extension__ using Int128 = __int128;

/// Whether `cut` lies within half a step of where a line from a to b truly crosses a plane: in integers.
bool is_nearest(const Vec3<View>& cut, const Vec3<View>& a, const Vec3<View>& b, const ClipPlane& plane) {
    const Int128 part = plane.distance(a).raw, whole = part - plane.distance(b).raw, size = whole < 0 ? -whole : whole;
    const auto is_near = [&](View found, View from, View to) {
        const Int128 off = (Int128{found.raw} - from.raw) * whole - (Int128{to.raw} - from.raw) * part;
        return 2 * (off < 0 ? -off : off) <= size;
    };
    return is_near(cut.x, a.x, b.x) && is_near(cut.y, a.y, b.y) && is_near(cut.z, a.z, b.z);
}

/// The crossings of a polygon with a plane, as the side that `plane` keeps cuts them, between its other corners.
std::vector<ClipVertex> with_crossings(const std::vector<ClipVertex>& polygon, const ClipPlane& plane) {
    std::vector<ClipVertex> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3<View>&a = polygon[i].position, &b = polygon[(i + 1) % polygon.size()].position;
        constexpr ClipDistance kOn{};
        const ClipDistance distance_a = plane.distance(a), distance_b = plane.distance(b);
        result.push_back(polygon[i]);
        if (distance_a > kOn && distance_b < kOn) result.push_back({cross_plane(a, distance_a, b, distance_b), 0});
        if (distance_a < kOn && distance_b > kOn) result.push_back({cross_plane(b, distance_b, a, distance_a), 0});
    }
    return result;
}

TEST(HardCaseC3, WhatIsInsideAndWhatIsOutsideAddUpToAll) {
    std::mt19937 random(3);
    const ClipPlane other_side{{0, 0, -1}, -4 * 65536};
    int compared = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto polygon = random_polygon(random, 3 + i % 7);
        const auto crossed = with_crossings(polygon, kAtDepth4);
        for (std::size_t k = 0; k < crossed.size(); ++k) {
            const auto &before = crossed[(k + crossed.size() - 1) % crossed.size()].position,
                       &after = crossed[(k + 1) % crossed.size()].position;
            if (kAtDepth4.distance(crossed[k].position) == ClipDistance{}) {
                ASSERT_TRUE(is_nearest(crossed[k].position, before, after, kAtDepth4)) << i;
            }
        }
        // A crossing that lies just between two steps is rounded up from either side: to other steps.
        if (doubled_shadow(crossed) != doubled_shadow(with_crossings(polygon, other_side))) continue;
        ++compared;
        std::int64_t sum = 0;
        for (const ClipPlane& side : {kAtDepth4, other_side}) sum += doubled_shadow(clipped(polygon, side));
        ASSERT_EQ(sum, doubled_shadow(crossed)) << i;
    }
    EXPECT_GT(compared, 4900);
}

TEST(HardCaseC3, CornersOutsideOfDifferentSidesMayStillShowThePolygon) {
    FrameOutline frame;
    const auto area_of = [&](const std::vector<Vec>& corners) {
        std::string line = "clip 320 200 4 3 90 4 8192 " + std::to_string(corners.size());
        for (const Vec& corner : corners) line += " " + join(corner.x, corner.y, corner.z);
        const double found = reference::area(frame.points_of(corners));
        EXPECT_EQ(ask_numbers(line).at(0), found) << line;
        return found;
    };
    // At z = 5 the view is 10 wide and 7.5 high. Above, left and below, right and below: all of it, of either winding.
    EXPECT_EQ(area_of({{0, 100, 5}, {90, -60, 5}, {-90, -60, 5}}), 64000);
    EXPECT_EQ(area_of({{0, 100, 5}, {-90, -60, 5}, {90, -60, 5}}), 64000);
    // Left, above, and both: past the corner of the view.
    EXPECT_EQ(area_of({{-20, 1, 5}, {-1, 20, 5}, {-20, 20, 5}}), 0);
    // All above; all behind.
    EXPECT_EQ(area_of({{-90, 10, 5}, {90, 10, 5}, {0, 9, 5}}), 0);
    EXPECT_EQ(area_of({{-90, -60, -5}, {90, -60, -5}, {0, 100, -5}}), 0);
}

double clip_area(double height, double far) {
    const auto answer = ask_numbers(join("clip 320 200 4 3 90 4", far, "4 -32767", -height, "-32767 32767", -height,
                                         "-32767 32767", -height, "32767 -32767", -height, 32767));
    return answer.at(0);
}

TEST(HardCaseC4, AHugeFloorKeepsItsArea) {
    EXPECT_NEAR(clip_area(1, 8192), 10661.458, 0.01 * 100);
    // From the row of the far depth to the bottom: (100 - 400/3 * 48 / far) * 320.
    EXPECT_NEAR(clip_area(48, 3000), 31317.333, 1);
    EXPECT_NEAR(clip_area(48, 8192), 31750, 1);
}

TEST(HardCaseC5, PolygonsSeenEdgeOnHaveNoArea) {
    EXPECT_EQ(ask("clip 320 200 4 3 90 4 8192 4 -900 0 -900 900 0 -900 900 0 900 -900 0 900"), "0");
    std::mt19937 random(5);
    FrameOutline frame;
    double worst = 0;
    int far_count = 0;
    for (int i = 0; i < 5000; ++i) {
        // Three corners of a plane through the eye, each a sum of two random directions.
        const auto integer = [&] { return random_integer(random, -60, 60); };
        const int a[] = {integer(), integer(), integer()}, b[] = {integer(), integer(), integer()};
        std::string line = "clip 320 200 4 3 90 4 8192 3";
        std::vector<Vec> corners;
        for (int corner = 0; corner < 3; ++corner) {
            const int p = integer(), q = integer();
            corners.push_back({1.0 * p * a[0] + q * b[0], 1.0 * p * a[1] + q * b[1], 1.0 * p * a[2] + q * b[2]});
            line += " " + join(corners[corner].x, corners[corner].y, corners[corner].z);
        }
        ASSERT_EQ(ask(line), "0") << line;
        // A frame does not ask: it clips whatever does not come near the eye, from whose surroundings the eye is moved.
        if (std::ranges::any_of(corners, [](const Vec& v) { return v.z < 4; })) continue;
        ++far_count;
        worst = std::max(worst, reference::area(frame.points_of(corners)));
    }
    std::printf("largest area: %.3f square pixels\n", worst);
    EXPECT_LE(worst, 1);
    EXPECT_GT(far_count, 500);
}

TEST(HardCaseC6, SixPlanesAddAtMostSixCorners) {
    std::mt19937 random(6);
    const Projection projection = make_projection({}, Degrees::from_int(90));
    const Frustum frustum = make_frustum(view_basis({}, {}, {}), projection);
    std::size_t most_added = 0;
    for (int i = 0; i < 20000; ++i) {
        ClipScratch scratch{random_polygon(random, 3 + i % 7), {}};
        const std::size_t before = scratch.polygon.size();
        for (const ClipPlane& depth : {kAtDepth4, ClipPlane{{0, 0, -1}, -500 * 65536}})
            if (scratch.polygon.size() >= 3) scratch.polygon = clipped(scratch.polygon, depth);
        if (scratch.polygon.size() < 3) continue;
        clip_polygon(frustum, 15, scratch);
        if (!scratch.polygon.empty())
            most_added = std::max(most_added, scratch.polygon.size() - std::min(before, scratch.polygon.size()));
        ASSERT_LE(scratch.polygon.size(), before + 6);
    }
    EXPECT_GE(most_added, 3u) << "the polygons are too tame to try the bound";
}

std::vector<Vec> random_triangle(std::mt19937& random, double size) {
    std::vector<Vec> corners(3);
    for (Vec& corner : corners)
        corner = {snapped(random_between(random, -size, size)), snapped(random_between(random, -size, size)),
                  snapped(random_between(random, -size, size))};
    return corners;
}

TEST(HardCaseC7, OutlinesStayOnTheScreen) {
    std::mt19937 random(7);
    FrameOutline frame;
    int seen = 0;
    for (int i = 0; i < 20000; ++i) {
        if (!frame.make(random_triangle(random, i % 2 ? 32767 : 20))) continue;
        ++seen;
        for (const ScreenVertex& vertex : frame.polygon.vertices) {
            ASSERT_TRUE(vertex.x.raw >= 0 && vertex.x.raw <= 320 * 256) << i;
            ASSERT_TRUE(vertex.y.raw >= 0 && vertex.y.raw <= 200 * 256) << i;
        }
    }
    EXPECT_GT(seen, 3000);
}

TEST(HardCaseC7, TheScanStaysOnItsRowsWhateverItIsGiven) {
    std::mt19937 random(77);
    constexpr std::int32_t kHeight = 50, kCanary = 123456789;
    for (int i = 0; i < 50000; ++i) {
        std::vector<ScreenVertex> vertices(3 + i % 5);
        for (ScreenVertex& vertex : vertices) {
            const auto any = [&] { return Screen::from_raw(static_cast<std::int32_t>(random()) >> (random() % 32)); };
            vertex = {any(), any()};
        }
        ScanlineExtents rows(kHeight);
        rows.left.assign(kHeight, kCanary);
        rows.right.assign(kHeight, kCanary);
        scan_convex(vertices, rows);
        if (rows.first >= rows.end) continue;
        ASSERT_TRUE(rows.first >= 0 && rows.end <= kHeight) << i;
        for (std::int32_t row = 0; row < kHeight; ++row) {
            if (row < rows.first || row >= rows.end) {
                ASSERT_EQ(rows.left[static_cast<std::size_t>(row)], kCanary) << i;
            }
        }
    }
}

double distance_to_segment(const reference::ScreenPoint& p, const reference::ScreenPoint& a,
                           const reference::ScreenPoint& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const double along = squared == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0);
    return std::hypot(a.x + along * dx - p.x, a.y + along * dy - p.y);
}

/// How far the corners of one outline lie at most from the other.
double largest_distance(const std::vector<reference::ScreenPoint>& corners,
                        const std::vector<reference::ScreenPoint>& outline) {
    double largest = 0;
    for (const auto& corner : corners) {
        double nearest = 1e9;
        for (std::size_t i = 0; i < outline.size(); ++i)
            nearest = std::min(nearest, distance_to_segment(corner, outline[i], outline[(i + 1) % outline.size()]));
        largest = std::max(largest, nearest);
    }
    return largest;
}

TEST(HardCaseC8, NearPolygonsAreCutAndNotPushed) {
    std::mt19937 random(88);
    FrameOutline frame;
    double worst = 0;
    int seen = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::vector<Vec> corners = random_triangle(random, i % 2 ? 300 : 20);
        std::vector<reference::ScreenPoint> expected;
        for (const Vec& corner : reference::clip_to_view(corners, 1.0 / 16384, 1e9, kProjection))
            expected.push_back(reference::project(corner, kProjection));
        const auto found = frame.points_of(corners);
        if (expected.size() < 3 || found.empty()) {
            ASSERT_LE(reference::area(expected) + reference::area(found), 0.01) << i;
            continue;
        }
        ++seen;
        worst = std::max({worst, largest_distance(expected, found), largest_distance(found, expected)});
    }
    EXPECT_GT(seen, 2000);
    EXPECT_LE(worst, 1.0 / 16);
    std::printf("outlines differ by at most %.5f pixels\n", worst);
}

}  // namespace
}  // namespace oblong::test
