// What faces leave open to things, against the owner and depth of each pixel of demo frames.

#include "engine/frame/face_cover.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/frame/claim_faces.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"
#include "tests/frame/frame_fixture.h"
#include "tools/render/camera_list.h"

namespace oblong::test::face_cover_test {
namespace {

/// 1/z of each pixel's face; none: nothing owns it.
using Depths = std::vector<std::optional<InverseDepth>>;

Depths depths_of(const FrameContext& frame, const Claims& claims) {
    Depths depths(320 * 200);
    const auto set = [&](std::span<const Span> spans, auto depth_at) {
        for (const Span& span : spans)
            for (std::int32_t x = span.first; x < span.end; ++x)
                depths[as_size(span.y * 320 + x)] = depth_at(x, span.y);
    };
    const auto infinitely_far = [](std::int32_t, std::int32_t) { return InverseDepth{0}; };
    for (const FaceList list : {FaceList::Walls, FaceList::Flat, FaceList::Liquid, FaceList::Mirror})
        for (const VisibleFace& face : claims.list(list))
            set(claims.spans_of(face), [plane = inverse_z_of(face, frame)](std::int32_t x, std::int32_t y) {
                return to_inverse_depth(plane.at(x, y));
            });
    for (const VisibleFace& face : claims.list(FaceList::Sky)) set(claims.spans_of(face), infinitely_far);
    set({claims.void_spans.begin(), claims.void_spans.end()}, infinitely_far);
    return depths;
}

bool is_open(const Depths& depths, const ScreenOutline& outline, InverseDepth nearest) {
    for (std::int32_t y = outline.pixels.first_row; y < outline.pixels.end_row; ++y)
        for (std::int32_t x = outline.pixels.first_column; x < outline.pixels.end_column; ++x) {
            const std::optional<InverseDepth>& depth = depths[as_size(y * 320 + x)];
            const bool is_inside = x + y >= outline.sums.first && x + y < outline.sums.end &&
                                   x - y >= outline.differences.first && x - y < outline.differences.end;
            if (is_inside && depth && *depth <= nearest) return true;
        }
    return false;
}

/// Claims faces as usual, then asks what they leave open.
class Asking : public FaceClaimer {
  public:
    int questions = 0, open = 0;

    void claim(const FrameContext& frame, ViewScratch& scratch) override {
        claim_faces(frame, scratch);
        const Depths depths = depths_of(frame, scratch.claims);
        FaceCover cover(frame, scratch.claims, open_);
        for (int i = 0; i < 30; ++i) ask(depths, cover);
    }

  private:
    std::int32_t below(std::int32_t end) { return static_cast<std::int32_t>(random_() % static_cast<unsigned>(end)); }
    ScreenRectangle rectangle_in(const ScreenRectangle& all, std::int32_t most) {
        const std::int32_t first_column = all.first_column + below(all.end_column - all.first_column),
                           first_row = all.first_row + below(all.end_row - all.first_row);
        return intersection({first_column, first_column + 1 + below(most), first_row, first_row + 1 + below(most)},
                            all);
    }
    /// A depth like those of the picture.
    InverseDepth depth_from(const Depths& depths) {
        const InverseDepth depth = depths[random_() % depths.size()].value_or(0);
        return depth - std::min(depth, static_cast<InverseDepth>(random_() % 3));
    }
    ScreenOutline outline_in(const ScreenRectangle& all) {
        ScreenOutline outline{rectangle_in(all, 80)};
        const ScreenRectangle& pixels = outline.pixels;
        const std::int32_t sum = pixels.first_column + pixels.first_row, way = pixels.first_column - pixels.end_row;
        outline.sums = {sum + below(40), sum + 40 + below(40)};
        outline.differences = {way + below(40), way + 40 + below(40)};
        return outline;
    }

    void ask(const Depths& depths, FaceCover& cover) {
        const ScreenRectangle pixels = rectangle_in({0, 320, 0, 200}, 160);
        const InverseDepth nearest = depth_from(depths);
        // Only sky is infinitely far.
        ASSERT_EQ(cover.begin(pixels, nearest, Hidden::ExceptOverSky), is_open(depths, {pixels}, 0));
        ASSERT_EQ(cover.begin(pixels, nearest, Hidden::Perhaps), is_open(depths, {pixels}, nearest));
        for (int part = 0; part < 5; ++part) expect_part(depths, cover, pixels, nearest);
        const ScreenOutline narrowed = outline_in(pixels);
        ASSERT_EQ(cover.narrow(narrowed, nearest), is_open(depths, narrowed, nearest));
        for (int part = 0; part < 5; ++part) {
            ScreenOutline outline = narrowed;
            outline.pixels = rectangle_in(narrowed.pixels, 20);
            ASSERT_EQ(cover.shows(outline, nearest), is_open(depths, outline, nearest));
        }
    }
    void expect_part(const Depths& depths, const FaceCover& cover, const ScreenRectangle& pixels,
                     InverseDepth nearest) {
        const ScreenOutline outline = outline_in(pixels);
        const InverseDepth farther = std::min(nearest, depth_from(depths));
        const bool shows = is_open(depths, outline, farther);
        ASSERT_EQ(cover.shows(outline, farther), shows);
        ++questions;
        open += shows;
    }

    std::mt19937 random_{3};
    std::vector<OpenFace> open_;
};

TEST(FaceCover, LeavesOpenWhatNoFaceIsNearerThan) {
    Stage stage = demo_stage();
    FrameWorkspace work(stage.level, stage.mode);
    Asking asking;
    work.claimer = &asking;
    for (const Camera& camera : parse_cameras(
             read_file_bytes(source_folder() + std::string("/assets/demo_cameras.csv")), Degrees::from_int(90)))
        stage.draw(camera, work);
    EXPECT_GT(asking.questions, 5'000);
    EXPECT_GT(asking.open, 500);
    EXPECT_LT(asking.open, asking.questions - 500);
}

// Faces far from every lantern are not asked whether its light touches them.
TEST(Lanterns, TouchOnlyFacesThatAreMarked) {
    const Stage stage = demo_stage();
    LevelCache cache(stage.level, stage.mode);
    ASSERT_FALSE(cache.things.lanterns.empty());
    int touched = 0, unmarked = 0;
    for (std::int64_t time_ms = 0; time_ms < 20'000; time_ms += 270) {
        std::vector<MovingLight> lights;
        for (const PlacedLantern& placed : cache.things.lanterns)
            lights.push_back({lantern_at(placed.lantern, time_ms).position, placed.lantern.light_radius});
        cache.surfaces.set_moving_lights(lights, {});
        for (const FaceIndex face : stage.level.faces.indices()) {
            const bool is_touched = cache.surfaces.is_touched(face, {});
            ASSERT_TRUE(!is_touched || cache.faces[face].is_near_lantern) << time_ms;
            touched += is_touched;
            unmarked += !cache.faces[face].is_near_lantern;
        }
    }
    EXPECT_GT(touched, 1'000);
    EXPECT_GT(unmarked, 30 * touched);
}

}  // namespace
}  // namespace oblong::test::face_cover_test
