#include "engine/scene/face_surface.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/raster/kernels/kernels.h"
#include "tests/scene/scene_fixture.h"

namespace oblong::test {
namespace {

using Texels = std::vector<std::uint8_t>;

/// The tiny level's floor, and another one 1,000 units further along x in another style.
Level two_floors() {
    Level level = tiny_level();
    Face far = level.faces[FaceIndex(0)];
    far.styles[0] = 4;
    far.texel_min_u += 1008;
    level.faces.push_back(far);
    return level;
}

constexpr FaceIndex kNear{0}, kFar{1};

struct Surfaces {
    Level level;
    Colormap colormap = plain_colormap();
    FaceTable faces;
    FaceSurfaces surfaces;

    explicit Surfaces(Level made)
        : level(std::move(made)), faces(make_face_table(level)), surfaces(level, faces, ScreenMode{}) {
        surfaces.start_frame({}, 100, colormap, best_kernels());
    }

    Texels look(FaceIndex face, const SurfaceState& state, int mip = 0) {
        const FaceSurface surface = surfaces.get(face, mip, state);
        Texels texels;
        for (std::int32_t y = 0; y < surface.view.height; ++y)
            for (std::int32_t x = 0; x < surface.view.width; ++x)
                texels.push_back(surface.view.texels[(y << surface.view.stride_log2) + x]);
        return texels;
    }
    /// How many texels a call builds.
    std::int64_t built_by(auto call) {
        const std::int64_t before = surfaces.built_texels();
        call();
        return surfaces.built_texels() - before;
    }
};

constexpr std::int64_t kTexels = 48 * 16;  ///< of a floor

/// Quake's thresholds, a level each at 1, 2.5 and 5 texels a pixel: no depth has a finer level than a nearer one, and
/// neighbours of a span, whose depths are less than doubled, are of levels that differ by one at most.
TEST(FaceSurfaces, HardCaseX11_MipLevelsRiseWithDepthOneAtATime) {
    const Surfaces scene(two_floors());
    const ProjectionAxis axis = make_projection({}, Degrees::from_int(90)).x;  // 160 pixels at depth 1
    const auto level_at = [&](View z, int bias) { return scene.surfaces.mip_level(kNear, z, axis, bias); };
    for (int bias = -3; bias <= 3; ++bias) {
        int before = 0;
        std::set<int> levels;
        for (View z = View::from_int(1); z < View::from_int(8192); z = z + View::from_raw(z.raw / 64)) {
            const int level = level_at(z, bias);
            EXPECT_GE(level, before);
            EXPECT_LE(level_at(z * 2 - View::ulp(), bias), level + 1) << bias;
            const double texels_a_pixel = std::ldexp(static_cast<double>(z.raw), -View::kFractionBits + bias) / 160;
            const int expected = (texels_a_pixel > 1) + (texels_a_pixel > 2.5) + (texels_a_pixel > 5);
            const bool is_close = std::abs(texels_a_pixel - 1) < 0.02 || std::abs(texels_a_pixel - 2.5) < 0.05 ||
                                  std::abs(texels_a_pixel - 5) < 0.1;
            EXPECT_TRUE(is_close || level == expected) << texels_a_pixel << " at bias " << bias;
            levels.insert(before = level);
        }
        EXPECT_EQ(levels.size(), 4u) << bias;
    }
}

TEST(FaceSurfaces, AStyleRelightsOnlyTheFacesThatHaveIt) {
    Surfaces scene(two_floors());
    LightStyles styles = plain_light_styles();
    const auto look_at_both = [&] {
        scene.look(kNear, {styles});
        scene.look(kFar, {styles});
    };
    EXPECT_EQ(scene.built_by(look_at_both), 2 * kTexels);
    EXPECT_EQ(scene.built_by(look_at_both), 0);
    styles[4] = 0;
    EXPECT_EQ(scene.built_by(look_at_both), kTexels);
    styles[5] = 0;
    EXPECT_EQ(scene.built_by(look_at_both), 0) << "no face has it";
}

TEST(FaceSurfaces, ALiquidShowsItsFrame) {
    Level level = two_floors();
    const TextureIndex first = add_texture(level, "+0x", 50), second = add_texture(level, "+1x", 60);
    level.texinfos[TexInfoIndex(0)].texture = first;
    level.texinfos[TexInfoIndex(0)].material = Material::Liquid;
    Surfaces scene(level);
    const LightStyles styles = plain_light_styles();
    EXPECT_EQ(scene.look(kNear, {styles})[0], 50);
    EXPECT_EQ(scene.look(kNear, {styles, second})[0], 60);
    EXPECT_EQ(scene.built_by([&] { scene.look(kNear, {styles, second}); }), 0) << "the texture itself";
}

TEST(FaceSurfaces, OneWithoutLightHasAKernelForItsSize) {
    for (const std::int32_t width : {16, 48}) {
        Level level = two_floors();
        level.texinfos[TexInfoIndex(0)].texture = add_texture(level, "plain", 50, width);
        level.texinfos[TexInfoIndex(0)].material = Material::Unlit;
        Surfaces scene(level);
        const LightStyles styles = plain_light_styles();
        EXPECT_EQ(scene.surfaces.get(kNear, 0, {styles}).kernel,
                  width == 16 ? best_kernels().draw_blocks : draw_blocks_any_size);
    }
}

MovingLight light_at(int x) {
    return {point_at(x, -4, 20), World::from_int(60)};
}

TEST(FaceSurfaces, AMovingLightRelightsOnlyWhatItTouches) {
    Surfaces scene(two_floors());
    const LightStyles styles = plain_light_styles();
    const auto texels_built_with = [&](const std::vector<MovingLight>& lights) {
        return scene.built_by([&] {
            scene.surfaces.set_moving_lights(lights, {});
            scene.look(kNear, {styles});
            scene.look(kFar, {styles});
        });
    };
    EXPECT_EQ(texels_built_with({}), 2 * kTexels);
    EXPECT_EQ(texels_built_with({light_at(500)}), 0) << "between the two";
    EXPECT_EQ(texels_built_with({light_at(10)}), kTexels);
    EXPECT_EQ(texels_built_with({light_at(10)}), 0) << "it stands still";
    EXPECT_EQ(texels_built_with({light_at(10), light_at(1010)}), kTexels) << "another one at the other floor";
    EXPECT_EQ(texels_built_with({light_at(11), light_at(1010)}), kTexels);
    EXPECT_EQ(texels_built_with({light_at(1010)}), kTexels) << "the first is gone";
    EXPECT_EQ(texels_built_with({}), kTexels);
    EXPECT_EQ(texels_built_with({}), 0);
}

TEST(FaceSurfaces, ALevelWithoutLightStaysFullbright) {
    Level level = two_floors();
    level.lighting.clear();
    for (Face& face : level.faces) face.light_offset = -1;
    Surfaces scene(level);
    const LightStyles styles = plain_light_styles();
    const Texels before = scene.look(kNear, {styles});
    const MovingLight light = light_at(10);
    scene.surfaces.set_moving_lights(std::span(&light, 1), {});
    EXPECT_EQ(scene.look(kNear, {styles}), before);
    EXPECT_EQ(scene.surfaces.built_texels(), kTexels);
}

/// Lights, styles, frames and places at random, the states coming back again and again: what the cache gives is what a
/// fresh one builds.
TEST(FaceSurfaces, NothingIsEverStale) {
    std::mt19937 random(6);
    Level level = two_floors();
    add_texture(level, "+0x", 50);
    add_texture(level, "+1x", 60);
    Surfaces kept(level);
    const std::vector<MovingLight> places{light_at(-40), light_at(10), light_at(11), light_at(60), light_at(1010)};
    std::int64_t texels_of_fresh = 0;
    for (int round = 0; round < 3000; ++round) {
        LightStyles styles = plain_light_styles();
        styles[0] = random() % 4 == 0 ? 100 : 256;
        std::vector<MovingLight> lights;
        for (const MovingLight& light : places)
            if (random() % 3 == 0) lights.push_back(light);
        std::shuffle(lights.begin(), lights.end(), random);
        const SurfaceState state{styles, TextureIndex(static_cast<std::int32_t>(random() % 3)),
                                 point_at(static_cast<int>(random() % 2) * 30, 0, 0)};
        const FaceIndex face(static_cast<std::int32_t>(random() % 2));
        const int mip = static_cast<int>(random() % 2);
        Surfaces fresh(level);
        kept.surfaces.set_moving_lights(lights, {});
        fresh.surfaces.set_moving_lights(lights, {});
        ASSERT_EQ(kept.look(face, state, mip), fresh.look(face, state, mip)) << round;
        texels_of_fresh += fresh.surfaces.built_texels();
    }
    EXPECT_LT(kept.surfaces.built_texels(), texels_of_fresh);
}

}  // namespace
}  // namespace oblong::test
