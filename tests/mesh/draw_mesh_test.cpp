// What draw_mesh() leaves out and works out in another way changes no pixel: held against the stages one after the
// other, for all vertices, and each short cut against its plain form.
#include "engine/mesh/draw_mesh.h"

#include <gtest/gtest.h>

#include "engine/fixed/wide.h"
#include "engine/methods/mesh_stages.h"
#include "engine/methods/transforms.h"
#include "tests/mesh/mesh_picture.h"

namespace oblong::test::draw_mesh_test {
namespace {

/// Draws a mesh by its stages, each of them whole. Not Shading::Flat.
void draw_by_stages(const PlacedMesh& placed, const Colormap& colormap, const MeshLight& light, MeshPicture& picture) {
    const Mesh& mesh = *placed.mesh;
    const MeshTransform transform = *make_mesh_transform(placed);
    MeshScratch& scratch = picture.scratch;
    const auto object = pose_of(placed, scratch.object_vertices);
    find_facing(mesh.triangles, object, to_object(picture.view.eye, transform), scratch.facing);
    transform_to_world(object, transform, scratch.world_vertices);
    transform_to_view(object, placed, transform, picture.view, scratch.view_vertices);
    find_corner_values(placed, scratch.world_vertices, light, scratch.values);
    const HighlightTable highlight = make_highlight_table(placed.highlight);
    const Vec3<Unit> toward_eye = normalised(widening_difference(picture.view.eye, placed.position));
    const MeshPaint paint{mesh.skins[0],  colormap, light,
                          placed.shading, false,    halfway(light.directional.toward, toward_eye),
                          &highlight,     nullptr};
    const ScreenRectangle all{0, picture.width, 0, picture.height};
    TriangleScratch& work = scratch.triangle;
    for (const std::uint32_t number : scratch.facing) {
        std::array<const ViewVertex*, 3> vertices{};
        std::array<const CornerValues*, 3> values{};
        for (std::size_t i = 0; i < 3; ++i) {
            vertices[i] = &scratch.view_vertices[mesh.triangles[number].vertices[i]];
            values[i] = &scratch.values[mesh.triangles[number].vertices[i]];
        }
        clip_and_project(vertices, values, picture.view, work.clip, work.polygon);
        for (std::size_t i = 2; i < work.polygon.size(); ++i) {
            const std::array<const ScreenCorner*, 3> fan{&work.polygon[0], &work.polygon[i - 1], &work.polygon[i]};
            scan_convex(std::array{fan[0]->screen, fan[1]->screen, fan[2]->screen}, work.rows);
            work.spans.clear();
            append_spans(work.rows, all, work.spans);
            Barycentric weights;
            if (work.spans.empty() || !make_barycentric({fan[0], fan[1], fan[2]}, work.spans, weights)) continue;
            const MeshGradients gradients =
                make_mesh_gradients(weights, {&fan[0]->values, &fan[1]->values, &fan[2]->values},
                                    inverse_z_over(weights), {placed.shading == Shading::Phong, false});
            draw_mesh_spans(
                work.spans, gradients, paint,
                {picture.depth, {picture.pixels.data(), picture.width, picture.height, picture.width}, all});
        }
    }
}

Skin checked_skin() {
    Skin skin{"", 16, 16, {}};
    for (int i = 0; i < 256; ++i) skin.texels.push_back(static_cast<std::uint8_t>(i));
    return skin;
}

TEST(DrawMesh, LeavesOutNothingThatShows) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> far(-1, 1);
    Mesh ball = ball_mesh(30, 12, checked_skin());
    ball.planes = facing_planes(ball);
    ball.places = shared_places(ball);
    ASSERT_EQ(ball.places[25 + 24], 25u) << "the seam of the first ring";
    ASSERT_FALSE(ball.planes.empty());
    std::vector<std::uint32_t> all_parts((ball.triangles.size() + kPartTriangles - 1) / kPartTriangles);
    std::iota(all_parts.begin(), all_parts.end(), 0u);
    ASSERT_GT(all_parts.size(), 2u);
    MeshLight light;
    light.directional = {unit_vector({0, 0, 1}), 100};
    int painted = 0, hidden = 0;
    for (int i = 0; i < 60; ++i) {
        const ViewContext view = view_from({});
        MeshPicture lazy(view), plain(view);
        // Several that hide parts of each other; from some pixels wide to clipped by the view on all sides.
        for (int ball_count = 0; ball_count < 3; ++ball_count) {
            const double ahead = std::exp2(4 + (i % 12) * 0.6 + far(random));
            PlacedMesh placed = placed_at(ball, world_point(ahead, far(random) * ahead, far(random) * ahead * 0.6));
            placed.yaw = random_angle(random);
            placed.roll = random_angle(random);
            placed.shading = i % 2 == 0 ? Shading::Gouraud : Shading::Phong;
            placed.highlight = 100;
            if (i % 3 == 0) placed.scale.z = Entry::from_raw(Entry::from_int(1).raw / 2);
            const bool shows =
                is_seen(placed, all_parts, *make_mesh_transform(placed), view, lazy.target(), lazy.scratch);
            const MeshCounts counts = lazy.draw(placed, numbered_shades(), light, false, all_parts);
            ASSERT_EQ(shows, counts.pixels > 0) << "picture " << i;
            hidden += !shows;
            draw_by_stages(placed, numbered_shades(), light, plain);
        }
        ASSERT_EQ(lazy.pixels, plain.pixels) << "picture " << i;
        for (std::int32_t y = 0; y < lazy.height; ++y)
            ASSERT_TRUE(std::equal(lazy.depth.row(y), lazy.depth.row(y) + lazy.width, plain.depth.row(y))) << y;
        painted += lazy.painted() > 0;
    }
    EXPECT_GT(painted, 40);
    EXPECT_GT(hidden, 5);
}

bool is_same(const Span& a, const Span& b) {
    return a.y == b.y && a.first == b.first && a.end == b.end;
}

TEST(DrawMesh, SpansOfSmallTrianglesAreThoseOfTheScan) {
    std::mt19937 random(8);
    const ScreenRectangle part{2, 9, 1, 8};
    ScanlineExtents rows(12);
    std::vector<Span> found, scanned;
    int with_pixels = 0;
    for (int i = 0; i < 200'000; ++i) {
        // Within 2 to 10 pixels; on a coarse grid now and then, so that edges meet centres.
        const int reach = 512 << (i % 3), grid = i % 2 == 0 ? 1 : 64;
        const auto place = [&] { return Screen::from_raw(random_below(random, reach) / grid * grid); };
        std::array<ScreenVertex, 3> corners;
        for (ScreenVertex& corner : corners) corner = {place(), place()};
        find_triangle_spans(corners, part, rows, found);
        scanned.clear();
        if (doubled_area(corners) > ScreenArea{}) {
            scan_convex(corners, rows);
            append_spans(rows, part, scanned);
        }
        ASSERT_TRUE(std::equal(found.begin(), found.end(), scanned.begin(), scanned.end(), is_same)) << i;
        with_pixels += !found.empty();
    }
    EXPECT_GT(with_pixels, 30'000);
}

TEST(DrawMesh, PointsOfSmallAndOfHugeMeshesAreRoundedAlike) {
    std::mt19937 random(9);
    Mesh mesh;
    for (int i = 0; i < 20'000; ++i) {
        PlacedMesh placed = placed_at(mesh, world_point(static_cast<double>(random() % 4000), i, -100));
        placed.yaw = random_angle(random);
        placed.pitch = random_angle(random);
        // Scales to either side of 2^5, points of all sizes.
        const auto scale = [&] { return Entry::from_raw(1 + (static_cast<std::int64_t>(random()) << (i % 7))); };
        placed.scale = {scale(), scale(), scale()};
        const auto transform = make_mesh_transform(placed);
        if (!transform) continue;
        const auto part = [&] { return World::from_raw(static_cast<std::int32_t>(random()) >> (random() % 31)); };
        const Vec3<World> point{part(), part(), part()};
        ASSERT_EQ(world_position(point, *transform), transformed_point(transform->to_world, point)) << i;
    }
}

TEST(DrawMesh, NormalsOfMeshesThatAreScaledAlikeAreWithinThreeStepsOfTheRotation) {
    std::mt19937 random(10);
    Mesh mesh;
    double most = 0;
    for (int i = 0; i < 20'000; ++i) {
        PlacedMesh placed = placed_at(mesh);
        turn_at_random(placed, random);
        const auto scale = Entry::from_raw((std::int64_t{1} << 32) + (static_cast<std::int64_t>(random()) << (i % 6)));
        const bool is_alike = i % 4 != 0;
        placed.scale = {scale, scale, is_alike ? scale : scale + scale};
        const auto transform = make_mesh_transform(placed);
        ASSERT_TRUE(transform);
        ASSERT_EQ(transform->turn.has_value(), is_alike);
        const auto part = [&] { return static_cast<std::int64_t>(random()) - (std::int64_t{1} << 31); };
        const auto unit = normalised_raw(std::array{part(), part(), part()});
        const Vec3<Unit> normal{unit[0], unit[1], unit[2]};
        const Vec3<Unit> found = world_normal(normal, *transform);
        if (!is_alike) {
            ASSERT_EQ(found, normalised(transform->normals * convert<Entry>(normal)));
            continue;
        }
        most = std::max(most, farthest_apart(to_point(found), MeshAxes(placed).turned(to_point(normal))));
    }
    EXPECT_LE(std::ldexp(most, 30), 3);
}

TEST(DrawMesh, WeightsAreTheNearestQuotients) {
    std::mt19937 random(11);
    int counted = 0;
    for (int i = 0; i < 50'000; ++i) {
        const unsigned reach = 64u << (i % 16);  // up to 8,192 pixels: beyond what two short divisions hold
        std::array<ScreenCorner, 3> corners{};
        for (ScreenCorner& corner : corners)
            corner.screen = {Screen::from_raw(static_cast<std::int32_t>(random() % reach)),
                             Screen::from_raw(static_cast<std::int32_t>(random() % reach))};
        Barycentric weights;
        if (!make_barycentric({&corners[0], &corners[1], &corners[2]}, std::array{Span{0, 0, 2}}, weights)) continue;
        if (weights.corners[2] != &corners[2]) continue;  // thin ones go along a side
        const auto way = [&](std::size_t to) {
            return std::array<std::int64_t, 2>{corners[to].screen.x.raw - corners[0].screen.x.raw,
                                               corners[to].screen.y.raw - corners[0].screen.y.raw};
        };
        const auto ab = way(1), ac = way(2);
        const std::int64_t area = ab[0] * ac[1] - ac[0] * ab[1];
        const auto quotient = [&](std::int64_t size) { return mul_div(size, std::int64_t{1} << 56, area); };
        ASSERT_EQ(WeightStep(weights.b_per_column).raw, quotient(ac[1]));
        ASSERT_EQ(WeightStep(weights.b_per_row).raw, quotient(-ac[0]));
        ASSERT_EQ(WeightStep(weights.c_per_column).raw, quotient(-ab[1]));
        ASSERT_EQ(WeightStep(weights.c_per_row).raw, quotient(ab[0]));
        ++counted;
    }
    EXPECT_GT(counted, 15'000);
}

TEST(DrawMesh, TheOnlyPixelOfATriangleHasTheValueAtItsCentre) {
    std::mt19937 random(12);
    ScanlineExtents rows(12);
    std::vector<Span> spans;
    int counted = 0;
    for (int i = 0; i < 50'000; ++i) {
        std::array<ScreenPlace, 3> corners{};
        for (ScreenPlace& corner : corners) {
            const auto along = [&] { return Screen::from_raw(static_cast<std::int32_t>(random() % 1024)); };
            // Differences of 32 bits and of more.
            corner = {{along(), along()}, InverseZ::from_raw(static_cast<std::int64_t>(random()) << (i % 16))};
        }
        const auto& [a, b, c] = corners;
        find_triangle_spans({a.screen, b.screen, c.screen}, {0, 4, 0, 4}, rows, spans);
        if (spans.size() != 1 || spans[0].end - spans[0].first != 1) continue;
        Barycentric weights;
        ASSERT_TRUE(make_barycentric({&a, &b, &c}, spans, weights));
        const auto area = [](double x, double y, const ScreenPlace& from, const ScreenPlace& to) {
            const double left = from.screen.x.raw, top = from.screen.y.raw;
            return (to.screen.x.raw - left) * (y - top) - (to.screen.y.raw - top) * (x - left);
        };
        const double x = spans[0].first * 256 + 128, y = spans[0].y * 256 + 128;
        const double of_a = area(x, y, b, c), of_b = area(x, y, c, a), of_c = area(x, y, a, b);
        const auto part = [&](double weight, const ScreenPlace& corner) {
            return weight / (of_a + of_b + of_c) * static_cast<double>(corner.inverse_z.raw);
        };
        const double exact = part(of_a, a) + part(of_b, b) + part(of_c, c);
        ASSERT_NEAR(static_cast<double>(inverse_z_over(weights).origin.raw), exact, 1 + std::ldexp(2, i % 16 + 2));
        ++counted;
    }
    EXPECT_GT(counted, 5'000);
}

}  // namespace
}  // namespace oblong::test::draw_mesh_test
