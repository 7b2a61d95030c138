// The edges over a frame of the demo level, held against doubles.

#include "engine/frame/wireframe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

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

TEST(WireframeOfTheDemo, IsTheEdgesOfFacesThatOwnPixels) {
    Stage stage = demo_stage();
    for (PlacedModel& placed : stage.models) placed.offset = point_at(5, -3, 11);
    EffectSet& effects = stage.settings.allowed_effects;  // but those whose faces own no pixels of the record
    effects = effects.without(Effect::Fence).without(Effect::Translucency);
    ObservedWorkspace work(stage.level, stage.mode);
    int of_models = 0;
    struct View {
        Vec3<World> eye;
        int degrees;
    };
    const Vec3<World> start = point_at(0, -368, 70);
    for (const auto& [eye, degrees] : {View{start, 0}, View{start, 77}, View{start, 200}, View{start, 301},
                                       View{point_at(950, 144, 60), 0}, View{point_at(480, 1250, 90), 115}}) {
        const Camera camera = camera_at(eye, degrees, degrees / 23.0);
        const TrueCamera truth(camera);
        work.keep_record();
        stage.draw(camera, work);
        const FrameRecord& record = work.record;
        std::fill(stage.pixels.begin(), stage.pixels.end(), std::uint8_t{0});
        draw_wireframe(stage.level, first_person_view(camera), stage.mode, stage.settings, work,
                       {LineMethod::Bresenham, kLine},
                       {stage.pixels.data(), stage.mode.width_px, stage.mode.height_px, stage.mode.width_px});

        std::set<FaceIndex> faces;
        for (const PixelRecord& pixel : record.pixels)
            if (!pixel.face.is_none()) faces.insert(pixel.face);
        const auto is_line = [&](std::int32_t x, std::int32_t y) {
            return x >= 0 && y >= 0 && x < 320 && y < 200 &&
                   stage.pixels.at(static_cast<std::size_t>(y * 320 + x)) != 0;
        };
        std::vector<bool> is_near_edge(stage.pixels.size());
        std::int64_t missing = 0, samples = 0;
        constexpr int kSteps = 3'000;
        for (const FaceIndex face : faces) {
            const Point offset = offset_of(face, stage);
            of_models += offset.z != 0;
            for (const SurfEdge& step : stage.level.edges_of(stage.level.faces[face])) {
                const Edge& edge = stage.level.edges[step.edge()];
                const Point from = to_point(stage.level.vertices[edge.from]) + offset,
                            to = to_point(stage.level.vertices[edge.to]) + offset;
                for (int i = 0; i <= kSteps; ++i) {
                    const Point seen = truth.shown(along(from, to, i / double{kSteps}));
                    // What lies on the border of the screen, or beyond it by rounding, is near its last pixels.
                    if (seen.z < 0.0625 || seen.x < -1 || seen.y < -1 || seen.x >= 321 || seen.y >= 201) continue;
                    const int x = static_cast<int>(std::floor(seen.x)), y = static_cast<int>(std::floor(seen.y));
                    const bool is_on_screen = x >= 0 && y >= 0 && x < 320 && y < 200;
                    bool is_drawn = false;
                    for (int row = y - 1; row <= y + 1; ++row)
                        for (int column = x - 1; column <= x + 1; ++column) {
                            is_drawn |= is_line(column, row);
                            if (row >= 0 && column >= 0 && row < 200 && column < 320)
                                is_near_edge.at(static_cast<std::size_t>(row * 320 + column)) = true;
                        }
                    missing += is_on_screen && !is_drawn;
                    samples += is_on_screen;
                }
            }
        }
        EXPECT_GT(samples, 10'000) << degrees;
        EXPECT_EQ(missing, 0) << degrees;
        std::int64_t beside = 0;
        for (std::size_t i = 0; i < stage.pixels.size(); ++i) beside += stage.pixels[i] != 0 && !is_near_edge[i];
        EXPECT_EQ(beside, 0) << degrees;
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
