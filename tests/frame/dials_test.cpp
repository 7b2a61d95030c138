// What each dial does to a frame.

#include <cmath>
#include <map>
#include <set>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/frame_record.h"
#include "tests/frame/holes.h"
#include "tests/support/views.h"

namespace oblong::test {
namespace {

/// In the demo level's courtyard and next to a leaning board, where every dial shows.
std::vector<Camera> cameras() {
    return {camera_at(point_at(300, 1110, 40), 58, -14),
            {point_at(0, -368, 70), Angle{16500}, Angle::from_bam(-777), {}}};
}

/// The pictures of all cameras, one after the other.
std::vector<std::uint8_t> draw_all(Stage& stage, const Accuracy& accuracy, ObservedWorkspace& work) {
    stage.settings.accuracy = accuracy;
    std::vector<std::uint8_t> all;
    for (const Camera& camera : cameras()) {
        stage.draw(camera, work);
        all.insert(all.end(), stage.pixels.begin(), stage.pixels.end());
    }
    return all;
}

Accuracy with(std::string_view name, std::int32_t value) {
    Accuracy accuracy;
    dial_named(name)->set(accuracy, value);
    if (name == "texel-bound") accuracy.texturing = Texturing::BoundedTexels;
    return accuracy;
}

TEST(Dials, ChangeThePictureAndNoneIsRememberedByTheWorkspace) {
    Stage stage = demo_stage();
    ObservedWorkspace used(stage.level, stage.mode);
    for (const Dial& dial : all_dials()) {
        SCOPED_TRACE(dial.name);
        std::set<std::vector<std::uint8_t>> pictures;
        for (const DialSetting& setting : dial.settings) {
            const Accuracy accuracy = with(dial.name, setting.value);
            ObservedWorkspace fresh(stage.level, stage.mode);
            pictures.insert(draw_all(stage, accuracy, used));
            EXPECT_TRUE(pictures.contains(draw_all(stage, accuracy, fresh))) << setting.name;
        }
        // The finest steps of some dials are too small for two frames to show. The demo level has neither T-junctions
        // nor coloured light.
        const std::size_t settings = dial.settings.size();
        const bool shows = dial.name != "t-junctions" && dial.name != "colours";
        EXPECT_GE(pictures.size(), !shows ? 1 : settings > 3 ? settings - 2 : settings);
    }
}

TEST(Dials, MipLevelsAreThoseThatAreAskedFor) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    work.keep_record();
    const auto greatest_mip = [&](const Accuracy& accuracy) {
        int greatest = -1;
        stage.settings.accuracy = accuracy;
        for (const Camera& camera : cameras()) {
            stage.draw(camera, work);
            for (const PixelRecord& pixel : work.record.pixels) greatest = std::max<int>(greatest, pixel.mip);
        }
        return greatest;
    };
    EXPECT_EQ(greatest_mip(with("mip", static_cast<std::int32_t>(MipSelection::None))), 0);
    EXPECT_LT(greatest_mip(with("mip-bias", -3)), greatest_mip({}));
    EXPECT_GT(greatest_mip(with("mip", static_cast<std::int32_t>(MipSelection::Span))), 0);
    EXPECT_EQ(greatest_mip(with("mip-bias", 3)), 3);
}

/// By span, pixels may only get smaller levels than the face's nearest corner asks for.
TEST(Dials, MipLevelsOfSpansAreNeverFinerThanThoseOfTheirFaces) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    const auto record_by = [&](MipSelection selection) {
        stage.settings.accuracy = with("mip", static_cast<std::int32_t>(selection));
        work.keep_record();
        stage.draw(cameras()[0], work);
        return work.record.pixels;
    };
    const auto by_face = record_by(MipSelection::Face), by_span = record_by(MipSelection::Span);
    int coarser = 0;
    for (std::size_t i = 0; i < by_face.size(); ++i) {
        ASSERT_EQ(by_face[i].face, by_span[i].face);
        ASSERT_GE(by_span[i].mip, by_face[i].mip) << i;
        coarser += by_span[i].mip > by_face[i].mip;
    }
    EXPECT_GT(coarser, 100);
}

/// One colour for each floor and ceiling (normals by doubles); all else is as with textures.
TEST(Dials, FlatFloorsAreOfOneColourAndChangeNothingElse) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    work.keep_record();
    int level_faces = 0, steep_pixels = 0;
    for (const Camera& camera : cameras()) {
        stage.settings.accuracy = {};
        stage.settings.allowed_effects = {};
        stage.draw(camera, work);
        const std::vector<std::uint8_t> textured = stage.pixels;
        const std::vector<PixelRecord> before = work.record.pixels;
        stage.settings.accuracy = with("floors", 0);
        stage.draw(camera, work);
        std::map<FaceIndex, std::set<std::uint8_t>> colours;
        for (std::size_t i = 0; i < textured.size(); ++i) {
            const PixelRecord& pixel = work.record.pixels[i];
            ASSERT_EQ(pixel.face, before[i].face);
            const Face& face = stage.level.faces[pixel.face];
            const double up = std::abs(number_of(stage.level.planes[face.plane].normal.z));
            const bool is_flat = before[i].mip >= 0 && up > std::sqrt(0.5);
            ASSERT_EQ(pixel.mip, is_flat ? -1 : before[i].mip) << i;
            if (is_flat) colours[pixel.face].insert(stage.pixels[i]);
            ASSERT_TRUE(is_flat || stage.pixels[i] == textured[i]) << i;
            steep_pixels += !is_flat;
        }
        for (const auto& [face, shown] : colours) EXPECT_EQ(shown.size(), 1u) << face.position();
        level_faces += static_cast<int>(colours.size());
    }
    EXPECT_GT(level_faces, 10);
    EXPECT_GT(steep_pixels, 10'000);
}

/// Neighbours step along the edge that they share in the same way, whatever its error.
TEST(Dials, AccumulatedEdgesLeaveNoHole) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    work.count();
    stage.settings.accuracy = with("edges", static_cast<std::int32_t>(EdgeStepping::Accumulated));
    for (const Camera& camera : cameras()) expect_each_pixel_once(stage, camera, work);
}

/// A crack shows what is behind: another face, or the back of one.
TEST(Dials, WithoutCornersAtTJunctionsCracksOpen) {
    OBLONG_NEEDS_SHARED_LEVELS();
    Stage stage = real_stage("e1m7");
    ObservedWorkspace work(stage.level, stage.mode);
    work.keep_record();
    const auto faces_shown = [&](const Camera& camera, bool mends) {
        stage.settings.accuracy = accuracy_of(Preset::Year1991);
        stage.settings.accuracy.mends_t_junctions = mends;
        stage.draw(camera, work);
        std::vector<FaceIndex> faces;
        for (const PixelRecord& pixel : work.record.pixels) faces.push_back(pixel.face);
        return faces;
    };
    int through_cracks = 0;
    for (const Leaf& leaf : stage.level.leaves) {
        const auto middle = [&](std::size_t axis) {
            return World::from_int((leaf.box.mins[axis] + leaf.box.maxs[axis]) / 2);
        };
        Camera camera;
        camera.eye = {middle(0), middle(1), middle(2)};
        if (!is_open(stage.level, camera.eye)) continue;
        const auto mended = faces_shown(camera, true), open = faces_shown(camera, false);
        for (std::size_t i = 1; i + 1 < mended.size(); ++i) {
            const bool is_beside = open[i] == mended[i - 1] || open[i] == mended[i + 1];
            through_cracks += open[i] != mended[i] && !is_beside;
        }
    }
    EXPECT_GT(through_cracks, 0);
}

TEST(Dials, CountsAddUp) {
    Stage stage = demo_stage();
    ObservedWorkspace work(stage.level, stage.mode);
    work.count();
    for (const Texturing texturing : {Texturing::Affine, Texturing::Every16, Texturing::Exact}) {
        stage.settings.accuracy = with("perspective", static_cast<std::int32_t>(texturing));
        stage.draw(cameras()[0], work);
        const StageCounts& stages = work.counts.stages;
        EXPECT_EQ(stages.textured_pixels + stages.flat_pixels + stages.sky_pixels, 64000);
        EXPECT_GE(stages.blocks, (work.counts.divisions - stages.exact_divisions) / 2);
        EXPECT_LE(stages.last_blocks, stages.blocks);
        EXPECT_LE(stages.projected, stages.vertices);
        EXPECT_GT(stages.projected, 0);
        EXPECT_GT(stages.surfaces, 0);
        EXPECT_GE(stages.edges, 3 * stages.surfaces);
        if (texturing == Texturing::Exact) {
            EXPECT_EQ(stages.blocks, stages.textured_pixels - stages.divided_pixels);
            EXPECT_LT(stages.exact_divisions, stages.divided_pixels);
        }
        if (texturing == Texturing::Affine) {
            EXPECT_LE(stages.blocks, work.counts.spans);
        }
    }
}

}  // namespace
}  // namespace oblong::test
