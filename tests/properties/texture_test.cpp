// Textures repeat: what is shifted by whole textures has the same bytes. Spans far from the texture's origin:
// HardCaseX5; below zero: HardCaseX6.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/frame/frame_fixture.h"

namespace oblong::test {
namespace {

/// The level with each texture moved along its faces by its own number of whole textures.
Level shifted_by_whole_textures(Level level) {
    Table<std::array<std::int32_t, 2>, TexInfo> shifts;
    for (TexInfo& texinfo : level.texinfos) {
        const MipTexture& texture = level.textures[texinfo.texture];
        const std::int32_t by_u = *rc::gen::inRange(-20, 21) * texture.width,
                           by_v = *rc::gen::inRange(-20, 21) * texture.height;
        texinfo.s_offset += Texel::from_int(by_u);
        texinfo.t_offset += Texel::from_int(by_v);
        shifts.push_back({by_u, by_v});
    }
    for (Face& face : level.faces) {
        const auto& [by_u, by_v] = shifts[face.texinfo];
        face.texel_min_u += by_u;
        face.texel_min_v += by_v;
    }
    return level;
}

std::vector<std::uint8_t> picture_of(Stage& stage, const Camera& camera) {
    FrameWorkspace work(stage.level, stage.mode);
    stage.draw(camera, work);
    return stage.pixels;
}

TEST(PropertyTexture, FramesOfTheDemoLevelAreTheSameWithTexturesShiftedByWholeTextures) {
    Stage stage = demo_stage();
    Stage shifted = demo_stage();
    const std::vector<Vec3<World>> places = entity_origins(stage.level);
    ASSERT_FALSE(places.empty());
    EXPECT_TRUE(rc::check([&] {
        shifted.level = shifted_by_whole_textures(stage.level);
        Camera camera;
        camera.eye = *rc::gen::elementOf(places);
        camera.yaw = Angle::from_bam(*rc::gen::arbitrary<std::uint16_t>());
        camera.pitch = Angle::from_bam(*rc::gen::inRange(-8'000, 8'000));
        RC_ASSERT(picture_of(shifted, camera) == picture_of(stage, camera));
    }));
}

}  // namespace
}  // namespace oblong::test
