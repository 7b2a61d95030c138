// Textures repeat: what is shifted by whole textures has the same bytes, in lit surfaces, in tiles and in whole frames.
// Spans far from the texture's origin: HardCaseX5; below zero: HardCaseX6.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/level/entities.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/surface/lit_surface.h"
#include "tests/frame/frame_fixture.h"

namespace oblong::test {
namespace {

std::vector<std::uint8_t> any_bytes(std::int32_t count) {
    return *rc::gen::container<std::vector<std::uint8_t>>(static_cast<std::size_t>(count),
                                                          rc::gen::arbitrary<std::uint8_t>());
}

/// Some shades beside each other; which colours they are makes no difference.
Colormap any_colormap() {
    Colormap map;
    for (std::size_t shade = 0; shade < Colormap::kShades; ++shade)
        for (std::size_t colour = 0; colour < 256; ++colour)
            map.shades[shade][colour] = static_cast<std::uint8_t>(colour * 7 + shade * 3);
    return map;
}

RC_GTEST_PROP(PropertyTexture, LitSurfacesRepeatByWholeTextures, ()) {
    const int mip = *rc::gen::inRange(0, 4);
    // Sizes and places at mip level 0 are any multiples of 16.
    const auto any_size = [mip] { return *rc::gen::inRange(1, 6) * (16 >> mip); };
    const auto any_place = [mip] { return *rc::gen::inRange(-40, 40) * (16 >> mip); };
    TextureView texture{nullptr, any_size(), any_size(), any_place(), any_place()};
    const std::vector<std::uint8_t> texels = any_bytes(texture.width * texture.height);
    texture.texels = texels.data();
    LightmapView light;
    light.columns = *rc::gen::inRange(2, 6);
    light.rows = *rc::gen::inRange(2, 6);
    const std::vector<std::uint8_t> samples = any_bytes(light.columns * light.rows);
    light.samples = samples.data();
    light.style_count = 1;
    light.style_scale_256[0] = 256;

    const auto built = [&](const TextureView& view) {
        const std::int32_t stride = lit_size(light.columns, mip);
        std::vector<std::uint8_t> out(static_cast<std::size_t>(stride * lit_size(light.rows, mip)));
        std::vector<std::int32_t> corner_shades(samples.size());
        build_lit_surface(view, light, any_colormap(), {}, mip, stride, corner_shades.data(), out.data());
        return out;
    };
    TextureView shifted = texture;
    shifted.min_u += *rc::gen::inRange(-1'000, 1'000) * texture.width;
    shifted.min_v += *rc::gen::inRange(-1'000, 1'000) * texture.height;
    RC_ASSERT(built(shifted) == built(texture));
}

/// A block whose coordinates run from one place below `highest_16` to another.
TexelBlock any_block(std::int32_t count, std::int64_t highest_16) {
    const auto texel = [highest_16] { return *rc::gen::inRange<std::int64_t>(0, highest_16); };
    const std::int64_t u = texel(), v = texel(), u_end = texel(), v_end = texel();
    return {0,
            count,
            static_cast<std::uint32_t>(u),
            static_cast<std::uint32_t>(v),
            static_cast<std::int32_t>((u_end - u) / count),
            static_cast<std::int32_t>((v_end - v) / count)};
}

RC_GTEST_PROP(PropertyTexture, TilesRepeatByWholeTexturesInEveryKernel, ()) {
    constexpr std::int64_t kHighest_16 = std::int64_t{30'000} << 16;
    const int width_log2 = *rc::gen::inRange(0, 10), height_log2 = *rc::gen::inRange(0, 10);
    SurfaceView tile;
    tile.width = 1 << width_log2;
    tile.height = 1 << height_log2;
    tile.stride_log2 = width_log2;
    tile.u_mask = static_cast<std::uint32_t>(tile.width) - 1;
    tile.v_mask = static_cast<std::uint32_t>(tile.height) - 1;
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(tile.width * tile.height));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 2'654'435'761u >> 13);
    tile.texels = texels.data();

    const TexelBlock block = any_block(*rc::gen::inRange(1, 320), kHighest_16);
    TexelBlock shifted = block;
    shifted.u_16 += static_cast<std::uint32_t>(*rc::gen::inRange(0, 35'000 >> width_log2) << width_log2) << 16;
    shifted.v_16 += static_cast<std::uint32_t>(*rc::gen::inRange(0, 35'000 >> height_log2) << height_log2) << 16;
    for (const BlockKernel kernel :
         {draw_blocks_plain, draw_blocks_packed, draw_blocks_any_size, best_block_kernel()}) {
        std::vector<std::uint8_t> here(320), there(320);
        kernel({&block, 1}, tile, here.data());
        kernel({&shifted, 1}, tile, there.data());
        RC_ASSERT(here == there);
    }
}

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

std::vector<Vec3<World>> places_of(const Level& level) {
    std::vector<Vec3<World>> places;
    for (const Entity& entity : level.entities)
        if (const auto origin = parse_world_vector(entity.value("origin"))) places.push_back(*origin);
    return places;
}

TEST(PropertyTexture, FramesOfTheDemoLevelAreTheSameWithTexturesShiftedByWholeTextures) {
    Stage stage = demo_stage();
    Stage shifted = demo_stage();
    const std::vector<Vec3<World>> places = places_of(stage.level);
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
