// The probe says what frames draw: its texels are those of a frame's face.

#include <gtest/gtest.h>

#include <sstream>
#include <tuple>

#include "engine/frame/frame_record.h"
#include "tests/accuracy/scenes_fixture.h"
#include "tests/support/random.h"
#include "tests/support/reference_polygons.h"
#include "tools/accuracy/scene_map.h"
#include "tools/map/compile.h"
#include "tools/probe/probe.h"

namespace oblong::test {
namespace {

using map::Point;

/// In viewspace.
using Triangle = std::array<reference::TexturedCorner, 3>;

/// The texels that the probe answers for columns `first` to `end` - 1 of a row of a triangle's plane.
std::vector<reference::ScreenPoint> ask_for_texels(const std::string& mode, const Accuracy& accuracy,
                                                   const Triangle& triangle, int row, int first, int end) {
    std::ostringstream query;
    query.precision(15);
    query << "texspanq " << mode << " 320 200 4 3 90";
    for (const reference::TexturedCorner& corner : triangle)
        query << ' ' << corner.position.x << ' ' << corner.position.y << ' ' << corner.position.z << ' ' << corner.u
              << ' ' << corner.v;
    query << ' ' << row << ' ' << first << ' ' << end;
    std::istringstream answer(Probe(accuracy).answer(query.str()));
    std::vector<reference::ScreenPoint> texels;
    for (double u, v; answer >> u >> v;) texels.push_back({u, v});
    EXPECT_EQ(texels.size(), static_cast<std::size_t>(end - first)) << query.str();
    return texels;
}

/// The rounding of a texture coordinate alone (engine/fixed/README.md): closer no texel can be to its place.
constexpr double kRounding_texels = 1.0 / 4096;

/// Where the triangle's plane shows a texel, pixels.
reference::ScreenPoint place_of(const Triangle& triangle, const reference::ScreenPoint& texel) {
    const auto& [a, b, c] = triangle;
    const double ub = b.u - a.u, uc = c.u - a.u, vb = b.v - a.v, vc = c.v - a.v, u = texel.x - a.u, v = texel.y - a.v;
    const double area = ub * vc - uc * vb, to_b = (u * vc - uc * v) / area, to_c = (ub * v - u * vb) / area;
    return project(a.position + (b.position - a.position) * to_b + (c.position - a.position) * to_c,
                   reference::Projection{});
}

/// A room with a wedge that shows the eye one triangle, whose texels are `scale` units wide.
struct Wedge {
    std::array<Point, 3> corners;  ///< clockwise as the eye sees them
    double scale = 1;

    explicit Wedge(std::mt19937& random) : scale(std::exp2(std::floor(random_between(random, -1, 4)))) {
        // Before the eye at (0, 0, 128), which looks along x: no whole numbers of 16 texels, where surfaces begin.
        const double far = std::round(random_between(random, 8, 90));
        const auto corner = [&](double across, double up) {
            const double x = far + std::round(random_between(random, 0, far / 2));
            return Point{x, std::round(across * x * random_between(random, 0.3, 0.9)),
                         128 + std::round(up * x / 2) + 1};
        };
        corners = {corner(1, -0.8), corner(0.1, 0.9), corner(-1, -0.6)};
    }

    MeasuredLevel level(const Palette& palette) const {
        SceneMap room({{-256, -256, 0}, {512, 256, 256}});
        room.add_start({-200, 0, 32});
        const auto& [a, b, c] = corners;
        const Point back{a.x + b.x + c.x, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
        const Point inside{(a.x + b.x + c.x) * 0.4, back.y, back.z};
        std::vector<map::MapEntity> entities = room.entities();
        entities.push_back(
            {{{"classname", "func_detail"}},
             {make_solid({{a, b, c}, {a, back, b}, {b, back, c}, {c, back, a}}, inside, "stone", scale)}});
        const std::string bytes =
            map::to_bytes(map::compile_map(entities, {map::Wad(make_scene_wad(palette))}, {true}));
        Camera camera;
        camera.eye = {World::from_int(0), World::from_int(0), World::from_int(128)};
        return make_measured_level("wedge", "", std::vector<std::uint8_t>(bytes.begin(), bytes.end()), {camera});
    }
};

/// A frame of a wedge.
struct WedgeFrame {
    const Wedge& wedge;
    const MeasuredLevel& level;
    const FrameRecord& record;

    const PixelRecord& pixel(int column, int row) const {
        return record.pixels[static_cast<std::size_t>(row * 320 + column)];
    }
    bool is_of_wedge(int column, int row) const {
        if (pixel(column, row).face.is_none()) return false;
        const reference::Plane& plane = level.exact.face(pixel(column, row).face.number()).plane;
        return std::all_of(wedge.corners.begin(), wedge.corners.end(), [&](const Point& p) {
            return std::abs(dot(plane.normal, {p.x, p.y, p.z}) - plane.offset) < 0.01;
        });
    }
    std::pair<int, int> columns_of_wedge(int row) const {
        int first = 0;
        while (first < 320 && !is_of_wedge(first, row)) ++first;
        int end = first;
        while (end < 320 && is_of_wedge(end, row)) ++end;
        return {first, end};
    }
    /// The face of a pixel in viewspace.
    Triangle triangle_at(int column, int row) const {
        const reference::Camera camera = reference::make_camera(reference_view(level.cameras[0], kMeasuredMode));
        const reference::PlaneView plane(level.exact, level.exact.face(pixel(column, row).face.number()), {}, camera);
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& p = wedge.corners[k];
            const reference::Vec position{-p.y, p.z - 128, p.x};
            const reference::Texel texel = plane.texel_at(project(position, {}), 1 / position.z);
            triangle[k] = {position, texel.u, texel.v};
        }
        return triangle;
    }
};

/// How far apart, in pixels, a row of the wedge shows texels in the frame and by the probe, and of how many pixels.
std::pair<double, int> compare_row(const WedgeFrame& frame, int row, const std::string& mode,
                                   const Accuracy& accuracy) {
    const auto [first, end] = frame.columns_of_wedge(row);
    if (end - first < 2) return {};
    const Triangle triangle = frame.triangle_at(first, row);
    double most_apart = 0;
    int column = first;
    for (const reference::ScreenPoint& probed : ask_for_texels(mode, accuracy, triangle, row, first, end)) {
        const PixelRecord& pixel = frame.pixel(column++, row);
        const reference::ScreenPoint drawn{number_of(pixel.u), number_of(pixel.v)};
        if (std::hypot(probed.x - drawn.x, probed.y - drawn.y) <= kRounding_texels) continue;
        const auto in_frame = place_of(triangle, drawn), in_probe = place_of(triangle, probed);
        most_apart = std::max(most_apart, std::hypot(in_frame.x - in_probe.x, in_frame.y - in_probe.y));
    }
    return {most_apart, end - first};
}

TEST(ProbeFrames, TheProbesTexelsAreThoseThatFramesDraw) {
    std::mt19937 random(19);
    const Scenes scenes(0);
    int compared = 0;
    for (int i = 0; i < 40; ++i) {
        const Wedge wedge(random);
        const MeasuredLevel level = wedge.level(scenes.palette);
        LevelFrames frames(level, scenes.colormap);
        for (const auto& [mode, texturing, rounding_px] : {std::tuple{"affine", Texturing::Affine, 0.1},
                                                           {"every16", Texturing::Every16, 0.02},
                                                           {"bounded", Texturing::Bounded, 0.0}}) {
            Accuracy accuracy = textured_by(texturing);
            accuracy.mip = MipSelection::None;
            accuracy.pixel_bound_256 = 24 << random() % 4;
            const FrameRecord& record = frames.record(level.cameras[0], accuracy);
            for (int row = 0; row < 200; row += 7) {
                const auto [apart, pixels] = compare_row({wedge, level, record}, row, mode, accuracy);
                // Bounded blocks of the same lengths may differ by the part of the bound that is left for rounding.
                const bool is_bounded = texturing == Texturing::Bounded;
                ASSERT_LE(apart, is_bounded ? accuracy.pixel_bound_256 / 256.0 / 16 : rounding_px)
                    << mode << ", " << i << " row " << row;
                compared += pixels;
            }
        }
    }
    EXPECT_GT(compared, 120000);
}

}  // namespace
}  // namespace oblong::test
