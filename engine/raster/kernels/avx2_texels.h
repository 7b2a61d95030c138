#pragma once

#include <cstdint>

#include "engine/raster/kernels/kernels.h"

#if defined(__x86_64__) && defined(__SSE2__)

#include <immintrin.h>

namespace oblong {

// The compiler is asked for AVX2 in these functions and nowhere else.
#define OBLONG_AVX2 gnu::target("avx2")

inline constexpr std::int32_t kSixteen = 16;

/// u and v of eight neighbouring pixels.
struct EightCoordinates {
    __m256i u, v;

    [[OBLONG_AVX2, gnu::always_inline]] EightCoordinates plus(const EightCoordinates& step) const {
        return {_mm256_add_epi32(u, step.u), _mm256_add_epi32(v, step.v)};
    }
    [[OBLONG_AVX2, gnu::always_inline]] EightCoordinates times(__m256i factor) const {
        return {_mm256_mullo_epi32(u, factor), _mm256_mullo_epi32(v, factor)};
    }
};

/// Reads texels in groups of four, at offsets that are multiples of four: such a group lies in one row of the surface,
/// and within a line of the processor's cache if the surface does.
class EightTexels {
  public:
    /// Rows of four texels at least, and no more than 32,768 of them, since _mm256_madd_epi16 has signs.
    static bool can_draw(const SurfaceView& surface) { return surface.stride_log2 >= 2 && surface.v_mask < 0x8000; }

    [[OBLONG_AVX2]] explicit EightTexels(const SurfaceView& surface)
        : masks_(_mm256_set1_epi32(static_cast<int>(surface.v_mask << 16 | surface.u_mask >> 2))),
          factors_(_mm256_set1_epi32(static_cast<int>(0x10000u << (surface.stride_log2 - 2) | 1))),
          texels_(reinterpret_cast<const int*>(surface.texels)) {}

    /// Each in the lowest byte of its lane, with others above.
    [[OBLONG_AVX2, gnu::always_inline]] __m256i at(const EightCoordinates& at) const {
        const __m256i row_and_group = _mm256_blend_epi16(at.v, _mm256_srli_epi32(at.u, 18), 0x55);
        const __m256i group = _mm256_madd_epi16(_mm256_and_si256(row_and_group, masks_), factors_);
        const __m256i bits_before = _mm256_and_si256(_mm256_srli_epi32(at.u, 13), _mm256_set1_epi32(24));
        return _mm256_srlv_epi32(_mm256_i32gather_epi32(texels_, group, 4), bits_before);
    }

  private:
    __m256i masks_;    ///< of v, and of u / 4
    __m256i factors_;  ///< groups of four in a row, and 1
    const int* texels_;
};

/// What packing leaves in pairs of 16 bytes becomes one row.
[[OBLONG_AVX2, gnu::always_inline]] inline __m256i in_order(__m256i packed) {
    return _mm256_permutevar8x32_epi32(packed, _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
}

/// The lowest byte of each lane, in each four bytes of its half.
[[OBLONG_AVX2, gnu::always_inline]] inline __m256i lowest_bytes(__m256i lanes) {
    return _mm256_shuffle_epi8(lanes, _mm256_set1_epi32(0x0c080400));
}

/// Draws 16 pixels: eight, and the eight that are a step further.
template <class Texels>
[[OBLONG_AVX2, gnu::always_inline]] inline void draw_16(const Texels& texels, const EightCoordinates& at,
                                                        const EightCoordinates& step_8, std::uint8_t* out) {
    const __m256i first = lowest_bytes(texels.at(at)), second = lowest_bytes(texels.at(at.plus(step_8)));
    const __m256i mixed = in_order(_mm256_blend_epi32(first, second, 0xaa));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm256_castsi256_si128(mixed));
}

/// A block of kSixteen pixels at least. The last 16 may overlap those before: nothing beyond them is written or read.
template <class Texels>
[[OBLONG_AVX2, gnu::always_inline]] inline void draw_by_sixteens(const TexelBlock& block, const Texels& texels,
                                                                 std::uint8_t* out) {
    const __m256i all = _mm256_broadcastsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(&block.u_16)));
    const EightCoordinates first{_mm256_shuffle_epi32(all, 0x00), _mm256_shuffle_epi32(all, 0x55)};
    const EightCoordinates step{_mm256_shuffle_epi32(all, 0xaa), _mm256_shuffle_epi32(all, 0xff)};
    const EightCoordinates step_8{_mm256_slli_epi32(step.u, 3), _mm256_slli_epi32(step.v, 3)};
    const EightCoordinates step_16{_mm256_slli_epi32(step.u, 4), _mm256_slli_epi32(step.v, 4)};
    EightCoordinates at = first.plus(step.times(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7)));
    std::uint8_t* const last = out + block.count - kSixteen;
    for (; out < last; out += kSixteen, at = at.plus(step_16)) draw_16(texels, at, step_8, out);
    draw_16(texels, at.plus(step.times(_mm256_set1_epi32(static_cast<int>(last - out)))), step_8, last);
}

}  // namespace oblong

#endif
