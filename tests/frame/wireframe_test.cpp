// The edges over a frame of the demo level, held against doubles.

#include "engine/frame/wireframe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "engine/frame/frame_record.h"
#include "engine/view/views.h"
#include "tests/frame/frame_fixture.h"
#include "tests/support/views.h"

namespace oblong::test {
namespace {

constexpr std::uint8_t kLine = 77;

/// Where the brush model of a face is.
Point offset_of(FaceIndex face, const Stage& stage) {
    for (const PlacedModel& placed : stage.models) {
        const IndexRange<Face>& faces = stage.level.models[placed.model].faces;
        if (face >= faces.first && face.number() < faces.first.number() + faces.count) return to_point(placed.offset);
    }
    return {};
}

/// Holds a picture of lines, 320x200 on black, against edges in doubles.
class EdgesOnScreen {
  public:
    EdgesOnScreen(const std::vector<std::uint8_t>& lines, const Camera& camera)
        : lines_(lines), camera_(camera), is_near_edge_(lines.size()) {}

    void follow(const Point& from, const Point& to) {
        constexpr int kSteps = 3'000;
        for (int i = 0; i <= kSteps; ++i) pass(camera_.shown(along(from, to, i / double{kSteps})));
    }
    /// Pixels of lines beside all edges.
    std::int64_t beside() const {
        std::int64_t count = 0;
        for (std::size_t i = 0; i < lines_.size(); ++i) count += lines_[i] != 0 && !is_near_edge_[i];
        return count;
    }

    std::int64_t samples = 0, missing = 0;  ///< places of edges; those of them without a line near by

  private:
    static bool is_on_screen(int x, int y) { return x >= 0 && y >= 0 && x < 320 && y < 200; }

    void pass(const Point& seen) {
        // What lies on the border of the screen, or beyond it by rounding, is near its last pixels.
        if (seen.z < 0.0625 || seen.x < -1 || seen.y < -1 || seen.x >= 321 || seen.y >= 201) return;
        const int x = static_cast<int>(std::floor(seen.x)), y = static_cast<int>(std::floor(seen.y));
        bool is_drawn = false;
        for (int row = y - 1; row <= y + 1; ++row)
            for (int column = x - 1; column <= x + 1; ++column) {
                if (!is_on_screen(column, row)) continue;
                const auto pixel = static_cast<std::size_t>(row * 320 + column);
                is_drawn |= lines_[pixel] != 0;
                is_near_edge_[pixel] = true;
            }
        missing += is_on_screen(x, y) && !is_drawn;
        samples += is_on_screen(x, y);
    }

    const std::vector<std::uint8_t>& lines_;
    TrueCamera camera_;
    std::vector<bool> is_near_edge_;
};

std::set<FaceIndex> faces_of(const FrameRecord& record) {
    std::set<FaceIndex> faces;
    for (const PixelRecord& pixel : record.pixels)
        if (!pixel.face.is_none()) faces.insert(pixel.face);
    return faces;
}

TEST(WireframeOfTheDemo, IsTheEdgesOfFacesThatOwnPixels) {
    Stage stage = demo_stage();
    for (PlacedModel& placed : stage.models) placed.offset = point_at(5, -3, 11);
    EffectSet& effects = stage.settings.allowed_effects;  // but those whose faces own no pixels of the record
    effects = effects.without(Effect::Fence).without(Effect::Translucency);
    ObservedWorkspace work(stage.level, stage.mode);
    int of_models = 0;
    const Vec3<World> start = point_at(0, -368, 70);
    for (const auto& [eye, degrees] : {std::pair{start, 0},
                                       {start, 77},
                                       {start, 200},
                                       {start, 301},
                                       {point_at(950, 144, 60), 0},
                                       {point_at(480, 1250, 90), 115}}) {
        const Camera camera = camera_at(eye, degrees, degrees / 23.0);
        work.keep_record();
        stage.draw(camera, work);
        std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0});
        draw_wireframe(stage.level, first_person_view(camera), stage.mode, stage.settings, work,
                       {LineMethod::Bresenham, kLine},
                       {stage.pixels.data(), stage.mode.width_px, stage.mode.height_px, stage.mode.width_px});
        EdgesOnScreen edges(stage.pixels, camera);
        for (const FaceIndex face : faces_of(work.record)) {
            const Point offset = offset_of(face, stage);
            of_models += offset.z != 0;
            for (const SurfEdge& step : stage.level.edges_of(stage.level.faces[face])) {
                const Edge& edge = stage.level.edges[step.edge()];
                edges.follow(to_point(stage.level.vertices[edge.from]) + offset,
                             to_point(stage.level.vertices[edge.to]) + offset);
            }
        }
        EXPECT_GT(edges.samples, 10'000) << degrees;
        EXPECT_EQ(edges.missing, 0) << degrees;
        EXPECT_EQ(edges.beside(), 0) << degrees;
    }
    EXPECT_GT(of_models, 20);
}

// The eye of a player who stands where a leak's path begins looks along it: 4 units aside, 32 ahead, are 4 / 32 of half
// the width of a view of 90 degrees.
TEST(Path, IsSeenByAnEyeThatLooksAlongIt) {
    const ScreenMode mode{};
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(mode.width_px * mode.height_px));
    const std::vector<Vec3<World>> path{point_at(32, 0, 0), point_at(2048, 0, 0)};
    draw_path(path, first_person_view(camera_at(point_at(0, 0, 0), 0, 0)), mode, {}, {LineMethod::Bresenham, kLine},
              {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    std::int32_t first = mode.width_px, last = -1;
    for (std::int32_t y = 0; y < mode.height_px; ++y)
        for (std::int32_t x = 0; x < mode.width_px; ++x)
            if (pixels.at(static_cast<std::size_t>(y * mode.width_px + x)) == kLine)
                first = std::min(first, x), last = std::max(last, x);
    EXPECT_NEAR(first, 160 - 20, 1);
    EXPECT_NEAR(last, 160 + 20, 1);
}

}  // namespace
}  // namespace oblong::test
