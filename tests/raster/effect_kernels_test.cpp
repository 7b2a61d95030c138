// Kernels of surfaces that warp, have holes, or show what is behind them, against the definition of one pixel.
#include "engine/raster/kernels/effect_kernels.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/raster/random_blocks.h"

namespace oblong::test {

namespace {

/// Everything that a kernel may need, at random. A third of the texels are holes.
struct RandomTexels {
    std::vector<std::uint8_t> texels;
    WarpTable warp;
    ColourRow shades{};
    BlendTable blend;
    EffectTexels all;

    RandomTexels(std::mt19937& random, std::int32_t width, std::int32_t height, std::int32_t stride_log2)
        : texels(static_cast<std::size_t>(width * height)) {
        for (std::uint8_t& texel : texels) texel = random() % 3 == 0 ? kHoleTexel : random_byte(random);
        for (std::uint32_t& shift_16 : warp.shift_16)
            shift_16 = static_cast<std::uint32_t>(random() % (16 * 65536 + 1));
        fill_at_random(shades, random);
        for (auto& row : blend.rows) fill_at_random(row, random);
        const auto u_mask = static_cast<std::uint32_t>(width - 1), v_mask = static_cast<std::uint32_t>(height - 1);
        all = {{texels.data(), width, height, stride_log2, u_mask, v_mask}, &warp, &shades, &blend};
    }
};

/// One pixel, by the definition, in 64 bits and by division.
std::uint8_t defined(const EffectTexels& texels, TexelTraits traits, std::int64_t u_16, std::int64_t v_16,
                     std::uint8_t below) {
    const std::int64_t du = traits.warps ? texels.warp->shift_16[static_cast<std::size_t>(v_16 / 65536 % 128)] : 0;
    const std::int64_t dv = traits.warps ? texels.warp->shift_16[static_cast<std::size_t>(u_16 / 65536 % 128)] : 0;
    const std::int64_t u = (u_16 + du) / 65536 % texels.surface.width, v = (v_16 + dv) / 65536 % texels.surface.height;
    const std::uint8_t texel = texels.surface.texels[v * texels.surface.width + u];
    if (traits.has_holes && texel == kHoleTexel) return below;
    const std::uint8_t shade = traits.has_holes || traits.blends ? (*texels.colours)[texel] : texel;
    return traits.blends ? texels.blend->rows[shade][below] : shade;
}

void expect_the_definition(std::mt19937& random, const RandomTexels& texels, TexelTraits traits) {
    std::uint32_t pixel_count = 0;
    const std::vector<TexelBlock> blocks = random_blocks(random, pixel_count);
    std::vector<std::uint8_t> behind(pixel_count + 16);
    fill_at_random(behind, random);
    std::vector<std::uint8_t> expected = behind;
    for (const TexelBlock& block : blocks)
        for (std::int64_t i = 0; i < block.count; ++i) {
            std::uint8_t& pixel = expected[block.pixel + static_cast<std::size_t>(i)];
            pixel =
                defined(texels.all, traits, block.u_16 + i * block.u_step_16, block.v_16 + i * block.v_step_16, pixel);
        }
    EffectTexels needed = texels.all;  // what the traits do not call for must not be read
    if (!traits.warps) needed.warp = nullptr;
    if (!traits.blends) needed.blend = nullptr;
    if (!traits.blends && !traits.has_holes) needed.colours = nullptr;
    for (const Kernels& kernels : all_kernels()) {
        const EffectKernel draw = effect_kernel(traits, kernels);
        std::vector<std::uint8_t> drawn = behind;
        draw(blocks, needed, drawn.data());
        ASSERT_EQ(drawn, expected) << traits.warps << traits.has_holes << traits.blends << traits.is_wrapped_by_masks;
    }
}

template <class Visit>
void for_all_effects(bool is_wrapped_by_masks, Visit visit) {
    for (const bool warps : {false, true})
        for (const bool has_holes : {false, true})
            for (const bool blends : {false, true}) visit(TexelTraits{warps, has_holes, blends, is_wrapped_by_masks});
}

}  // namespace

TEST(EffectKernels, SurfacesThatMasksWrap) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 30; ++trial) {
        const int width_log2 = static_cast<int>(random() % 9), height_log2 = static_cast<int>(random() % 9);
        const RandomTexels texels(random, 1 << width_log2, 1 << height_log2, width_log2);
        for_all_effects(true, [&](TexelTraits traits) { expect_the_definition(random, texels, traits); });
    }
}

TEST(EffectKernels, SurfacesOfAnySize) {
    std::mt19937 random(2);
    for (const auto& [width, height] : {std::pair{300, 7}, {48, 80}, {1, 1}, {513, 3}}) {
        const RandomTexels texels(random, width, height, 0);
        for_all_effects(false, [&](TexelTraits traits) { expect_the_definition(random, texels, traits); });
    }
}

}  // namespace oblong::test
