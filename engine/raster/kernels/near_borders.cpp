#include "engine/raster/kernels/kernels.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace oblong {

namespace {

/// Moved up by the error, a coordinate near a whole texel has a fraction below twice the error.
bool is_near_whole(std::uint32_t texel_16, std::uint32_t error_16) {
    return ((texel_16 + error_16) & 0xffff) < 2 * error_16;
}

}  // namespace

std::uint64_t pixels_near_borders_plain(const TexelBlock& block, std::uint32_t error_16) {
    std::uint64_t near = 0;
    std::uint32_t u_16 = block.u_16, v_16 = block.v_16;
    for (std::int32_t i = 0; i < block.count; ++i) {
        near |= std::uint64_t{is_near_whole(u_16, error_16) || is_near_whole(v_16, error_16)} << i;
        u_16 += static_cast<std::uint32_t>(block.u_step_16);
        v_16 += static_cast<std::uint32_t>(block.v_step_16);
    }
    return near;
}

#if defined(__SSE2__)

namespace {

/// The fractions of u or v at eight consecutive pixels; 16-bit lanes wrap as needed.
struct EightFractions {
    __m128i now, step_8;

    EightFractions(std::uint32_t first_16, std::int32_t step_16) {
        const __m128i step = _mm_set1_epi16(static_cast<short>(step_16));
        now = _mm_add_epi16(_mm_set1_epi16(static_cast<short>(first_16)),
                            _mm_mullo_epi16(step, _mm_setr_epi16(0, 1, 2, 3, 4, 5, 6, 7)));
        step_8 = _mm_slli_epi16(step, 3);
    }
    void next() { now = _mm_add_epi16(now, step_8); }
};

}  // namespace

std::uint64_t pixels_near_borders(const TexelBlock& block, std::uint32_t error_16) {
    const __m128i limit = _mm_set1_epi16(static_cast<short>(2 * error_16));
    EightFractions u(block.u_16 + error_16, block.u_step_16), v(block.v_16 + error_16, block.v_step_16);
    std::uint64_t far = 0;
    for (std::int32_t i = 0; i < block.count; i += 8) {
        // limit - fraction, saturating at 0.
        const __m128i below = _mm_or_si128(_mm_subs_epu16(limit, u.now), _mm_subs_epu16(limit, v.now));
        const __m128i is_far = _mm_cmpeq_epi16(below, _mm_setzero_si128());
        far |= std::uint64_t{static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(is_far, is_far))) & 0xff} << i;
        u.next();
        v.next();
    }
    return ~far & (~std::uint64_t{0} >> (64 - block.count));
}

#else

std::uint64_t pixels_near_borders(const TexelBlock& block, std::uint32_t error_16) {
    return pixels_near_borders_plain(block, error_16);
}

#endif

}  // namespace oblong
