#include "engine/raster/kernels/effect_kernels.h"

#include <cstddef>
#include <type_traits>
#include <utility>

#include "engine/base/table.h"

namespace oblong {

namespace {

constexpr std::size_t index_of(TexelTraits traits) {
    return as_size(traits.warps) | as_size(traits.has_holes) << 1 | as_size(traits.blends) << 2 |
           as_size(traits.is_wrapped_by_masks) << 3;
}
constexpr TexelTraits traits_of(std::size_t index) {
    return {(index & 1) != 0, (index & 2) != 0, (index & 4) != 0, (index & 8) != 0};
}

/// The texel at u and v, warped and wrapped. Wrapping without masks needs sums that do not overflow: 64 bits.
template <TexelTraits Traits>
[[gnu::always_inline]] inline std::uint8_t texel_at(const EffectTexels& texels, std::uint32_t u_16,
                                                    std::uint32_t v_16) {
    const SurfaceView& surface = texels.surface;
    using Coordinate = std::conditional_t<Traits.is_wrapped_by_masks, std::uint32_t, std::uint64_t>;
    Coordinate u = u_16, v = v_16;
    if constexpr (Traits.warps) {
        u += shift_at(*texels.warp, v_16);
        v += shift_at(*texels.warp, u_16);
    }
    if constexpr (Traits.is_wrapped_by_masks)
        return surface.texels[(((v >> 16) & surface.v_mask) << surface.stride_log2) + ((u >> 16) & surface.u_mask)];
    const auto width = static_cast<std::uint32_t>(surface.width), height = static_cast<std::uint32_t>(surface.height);
    return surface
        .texels[static_cast<std::uint32_t>(v >> 16) % height * width + static_cast<std::uint32_t>(u >> 16) % width];
}

/// A pixel's new colour. In holes the old colour is written again: where texels change fast, a branch costs more.
template <TexelTraits Traits>
[[gnu::always_inline]] inline std::uint8_t seen_through(const EffectTexels& texels, std::uint8_t texel,
                                                        std::uint8_t below) {
    std::uint8_t colour = texel;
    if constexpr (Traits.has_holes || Traits.blends) colour = (*texels.colours)[texel];
    if constexpr (Traits.blends) colour = texels.blend->rows[colour][below];
    if constexpr (Traits.has_holes) {
        const auto keeps = static_cast<std::uint8_t>(-static_cast<int>(texel == kHoleTexel));
        colour = static_cast<std::uint8_t>(colour ^ ((colour ^ below) & keeps));
    }
    return colour;
}

template <TexelTraits Traits>
void draw_effect_blocks(std::span<const TexelBlock> blocks, const EffectTexels& given, std::uint8_t* pixels) {
    const EffectTexels texels = given;  // a copy, which pixel writes cannot alias, stays in registers
    for (const TexelBlock& block : blocks) {
        std::uint32_t u_16 = block.u_16, v_16 = block.v_16;
        const auto u_step = static_cast<std::uint32_t>(block.u_step_16);
        const auto v_step = static_cast<std::uint32_t>(block.v_step_16);
        std::uint8_t* const end = pixels + block.pixel + block.count;
        for (std::uint8_t* pixel = pixels + block.pixel; pixel != end; ++pixel, u_16 += u_step, v_16 += v_step)
            *pixel = seen_through<Traits>(texels, texel_at<Traits>(texels, u_16, v_16), *pixel);
    }
}

template <std::size_t... Index>
constexpr std::array<EffectKernel, sizeof...(Index)> all_kernels(std::index_sequence<Index...>) {
    return {draw_effect_blocks<traits_of(Index)>...};
}
constexpr auto kEffectKernels = all_kernels(std::make_index_sequence<16>());

}  // namespace

EffectKernel plain_effect_kernel(TexelTraits traits) {
    return kEffectKernels[index_of(traits)];
}

EffectKernel effect_kernel(TexelTraits traits, const Kernels& kernels) {
    const bool warps_alone = traits.warps && traits.is_wrapped_by_masks && !traits.has_holes && !traits.blends;
    return warps_alone && kernels.draw_warped ? kernels.draw_warped : plain_effect_kernel(traits);
}

}  // namespace oblong
