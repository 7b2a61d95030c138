#include "engine/raster/kernels/avx2_texels.h"
#include "engine/raster/kernels/effect_kernels.h"

namespace oblong {

namespace {

constexpr TexelTraits kWarpsAlone{true, false, false, true};

}  // namespace

#if defined(__x86_64__) && defined(__SSE2__)

namespace {

/// Texels of a surface that warps.
class EightWarpedTexels {
  public:
    [[OBLONG_AVX2]] explicit EightWarpedTexels(const EffectTexels& texels)
        : texels_(texels.surface), shifts_(reinterpret_cast<const int*>(texels.warp->shift_16.data())) {}

    [[OBLONG_AVX2, gnu::always_inline]] __m256i at(const EightCoordinates& at) const {
        return texels_.at(at.plus({shift_at(at.v), shift_at(at.u)}));
    }

  private:
    [[OBLONG_AVX2, gnu::always_inline]] __m256i shift_at(__m256i texels_16) const {
        static_assert(WarpTable::kEntries == 128);
        const __m256i entry = _mm256_and_si256(_mm256_srli_epi32(texels_16, 16), _mm256_set1_epi32(127));
        return _mm256_i32gather_epi32(shifts_, entry, 4);
    }

    EightTexels texels_;
    const int* shifts_;
};

}  // namespace

[[OBLONG_AVX2]] void draw_warped_blocks_avx2(std::span<const TexelBlock> blocks, const EffectTexels& given,
                                             std::uint8_t* pixels) {
    const EffectTexels texels = given;
    const EffectKernel draw_one_by_one = effect_kernel(kWarpsAlone, false);
    if (!EightTexels::can_draw(texels.surface)) return draw_one_by_one(blocks, texels, pixels);
    const EightWarpedTexels eight(texels);
    for (const TexelBlock& block : blocks) {
        if (block.count < kSixteen)
            draw_one_by_one({&block, 1}, texels, pixels);
        else
            draw_by_sixteens(block, eight, pixels + block.pixel);
    }
}

#else

void draw_warped_blocks_avx2(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels) {
    effect_kernel(kWarpsAlone, false)(blocks, texels, pixels);
}

#endif

}  // namespace oblong
