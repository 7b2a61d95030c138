#include "engine/geometry/clip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/visible/outline.h"
#include "tests/hard_cases/hard_case.h"
#include "tools/reference/polygon.h"

namespace oblong {
namespace {

using namespace test;
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
    clip_to_plane(plane, 0, polygon, out);
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

TEST(HardCaseC1, CornersOnThePlaneAreInsideAndNeverDoubled) {
    const std::vector<ClipVertex> touching{
        {view_point(0, 0, 4), 0}, {view_point(9, 0, 4), 0}, {view_point(5, 7, 9), 0}};
    const std::vector<ClipVertex> whole = clipped(touching, kAtDepth4);
    ASSERT_EQ(whole.size(), 3u);
    EXPECT_EQ(doubled_shadow(whole), doubled_shadow(touching));

    const std::vector<ClipVertex> crossing{
        {view_point(0, 0, 4), 0}, {view_point(9, 0, 1), 0}, {view_point(5, 7, 9), 0}};
    const std::vector<ClipVertex> rest = clipped(crossing, kAtDepth4);
    ASSERT_EQ(rest.size(), 3u);
    for (std::size_t i = 0; i < rest.size(); ++i)
        EXPECT_NE(rest[i].position, rest[(i + 1) % rest.size()].position) << i;
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
        const auto has_cut = [&](const std::vector<ClipVertex>& polygon) {
            return std::any_of(polygon.begin(), polygon.end(), [&](const ClipVertex& v) { return v.position == cut; });
        };
        ASSERT_TRUE(has_cut(forth) && has_cut(back)) << i;
    }
}

TEST(HardCaseC3, WhatIsInsideAndWhatIsOutsideAddUpToAll) {
    std::mt19937 random(3);
    const ClipPlane other_side{{0, 0, -1}, -4 * 65536};
    for (int i = 0; i < 2000; ++i) {
        const auto polygon = random_polygon(random, 3 + i % 7);
        std::int64_t sum = 0;
        for (const ClipPlane& side : {kAtDepth4, other_side}) {
            const auto part = clipped(polygon, side);
            if (part.size() >= 3) sum += doubled_shadow(part);
        }
        // Two crossings, each rounded by up to a step on a polygon 4 * 900 units wide.
        ASSERT_NEAR(static_cast<double>(sum), static_cast<double>(doubled_shadow(polygon)), 4.0 * 3600 * 65536) << i;
    }
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
    for (int i = 0; i < 2000; ++i) {
        // Three corners of a plane through the eye, each a sum of two random directions.
        const auto integer = [&] { return random_integer(random, -60, 60); };
        const int a[] = {integer(), integer(), integer()}, b[] = {integer(), integer(), integer()};
        std::string line = "clip 320 200 4 3 90 4 8192 3";
        for (int corner = 0; corner < 3; ++corner) {
            const int p = integer(), q = integer();
            for (int axis = 0; axis < 3; ++axis) line += " " + std::to_string(p * a[axis] + q * b[axis]);
        }
        ASSERT_LE(ask_numbers(line).at(0), 1) << line;
    }
}

TEST(HardCaseC6, SixPlanesAddAtMostSixCorners) {
    std::mt19937 random(6);
    const Projection lens = make_projection({}, Degrees::from_int(90));
    const Frustum frustum = make_frustum(view_basis({}, {}, {}), lens);
    std::size_t most_added = 0;
    for (int i = 0; i < 20000; ++i) {
        ClipScratch scratch{random_polygon(random, 3 + i % 7), {}};
        const std::size_t before = scratch.polygon.size();
        scratch.polygon = clipped(scratch.polygon, {{0, 0, -1}, -500 * 65536});
        if (scratch.polygon.size() < 3) continue;
        clip_polygon(frustum, 31, scratch);
        if (!scratch.polygon.empty())
            most_added = std::max(most_added, scratch.polygon.size() - std::min(before, scratch.polygon.size()));
        ASSERT_LE(scratch.polygon.size(), before + 6);
    }
    EXPECT_GE(most_added, 3u) << "the polygons are too tame to try the bound";
}

/// The frame's own way from a polygon in the world to its outline on the screen.
struct FrameOutline {
    ViewContext view;
    Outline outline;

    FrameOutline() {
        view.axes = y_up_basis({}, {}, {});
        view.lens = make_projection({}, Degrees::from_int(90));
        view.frustum = make_frustum(view.axes, view.lens);
        view.grid = SubpixelGrid::of_bits(8);
    }
    bool make(const std::vector<Vec>& corners) {
        std::vector<Vec3<World>> world;
        const auto raw = [](double value) {
            return World::from_raw(static_cast<std::int32_t>(std::llround(value * 4096)));
        };
        for (const Vec& corner : corners) world.push_back({raw(corner.x), raw(corner.y), raw(corner.z)});
        return make_polygon_outline(world, view, outline);
    }
};

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
        for (const ScreenVertex& vertex : frame.outline.screen) {
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
        RowColumns rows(kHeight);
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

TEST(HardCaseC8, NearPolygonsAreCutAndNotPushed) {
    std::mt19937 random(88);
    FrameOutline frame;
    const auto lens = reference::make_lens(320, 200, 4.0 / 3, 90);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::vector<Vec> corners = random_triangle(random, 300);
        std::vector<reference::ScreenPoint> expected;
        for (const Vec& corner : reference::clip_to_view(corners, 1.0 / 16384, 1e9, lens))
            expected.push_back(reference::project(corner, lens));
        std::vector<reference::ScreenPoint> found;
        if (frame.make(corners))
            for (const ScreenVertex& v : frame.outline.screen) found.push_back({v.x.raw / 256.0, v.y.raw / 256.0});
        // A silhouette moved by 1/16 pixel everywhere changes the area by that times its length, at most 1,040 pixels.
        worst = std::max(worst, std::abs(reference::area(expected) - reference::area(found)));
    }
    EXPECT_LE(worst, 1040.0 / 16);
    RecordProperty("worst_area_difference_px2", std::to_string(worst));
    std::printf("largest difference of area: %.3f square pixels\n", worst);
}

}  // namespace
}  // namespace oblong
