#include <algorithm>
#include <bit>

#include "engine/raster/kernels/kernels.h"

#if defined(__x86_64__) && defined(__SSE2__)
#include <emmintrin.h>

namespace oblong {

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

std::uint64_t pixels_near_borders_sse2(const TexelBlock& block, std::uint32_t error_16) {
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

namespace {

constexpr std::int32_t kLanes = 8;

/// An edge function at eight pixels in a row.
struct EdgeValues {
    __m128i low, high, step;

    EdgeValues(std::int64_t value, std::int64_t step_1) {
        const auto at_lane = [=](int lane) { return static_cast<std::int32_t>(value + step_1 * lane); };
        low = _mm_set_epi32(at_lane(3), at_lane(2), at_lane(1), at_lane(0));
        high = _mm_set_epi32(at_lane(7), at_lane(6), at_lane(5), at_lane(4));
        step = _mm_set1_epi32(static_cast<std::int32_t>(step_1 * kLanes));
    }
    void next() {
        low = _mm_add_epi32(low, step);
        high = _mm_add_epi32(high, step);
    }
};

/// A bit for each of eight pixels: one of the functions is below 0.
unsigned outside_bits(const EdgeValues& a, const EdgeValues& b, const EdgeValues& c) {
    const __m128i low = _mm_or_si128(_mm_or_si128(a.low, b.low), c.low);
    const __m128i high = _mm_or_si128(_mm_or_si128(a.high, b.high), c.high);
    const __m128i signs = _mm_packs_epi16(_mm_packs_epi32(low, high), _mm_setzero_si128());
    return static_cast<unsigned>(_mm_movemask_epi8(signs));
}

}  // namespace

PixelRange inside_edges_sse2(const EdgeRow& row, std::int32_t count) {
    EdgeValues a(row.value[0], row.step[0]), b(row.value[1], row.step[1]), c(row.value[2], row.step[2]);
    std::int32_t first = count;
    for (std::int32_t column = 0; column < count; column += kLanes) {
        unsigned outside = outside_bits(a, b, c);
        a.next();
        b.next();
        c.next();
        if (first == count) {
            const int before = std::countr_one(outside);
            if (before >= kLanes) continue;
            first = std::min(column + before, count);
            outside &= ~0u << before;
        }
        if (outside != 0) return {first, std::min(column + std::countr_zero(outside), count)};
    }
    return {first, count};
}

namespace {

/// Eight numbers of an arithmetic sequence.
struct EightSteps {
    __m128i first, second;

    EightSteps(std::int32_t number, std::int32_t step)
        : first(_mm_setr_epi32(number, number + step, number + 2 * step, number + 3 * step)),
          second(_mm_add_epi32(first, _mm_set1_epi32(4 * step))) {}
    void operator+=(const EightSteps& steps) {
        first = _mm_add_epi32(first, steps.first);
        second = _mm_add_epi32(second, steps.second);
    }
};

void look_up_four(std::int64_t places, const std::uint8_t* colours, std::uint8_t* out) {
    const auto four = static_cast<std::uint64_t>(places);
    out[0] = colours[four & 0xffff];
    out[1] = colours[four >> 16 & 0xffff];
    out[2] = colours[four >> 32 & 0xffff];
    out[3] = colours[four >> 48];
}

/// Writes eight texels in these shades; their indices in the colormap have 16 bits.
inline void light_eight(const EightSteps& shades_24, const std::uint8_t* texels, const std::uint8_t* colours,
                        std::uint8_t* out) {
    const __m128i shades = _mm_packs_epi32(_mm_srli_epi32(shades_24.first, 24), _mm_srli_epi32(shades_24.second, 24));
    const __m128i eight = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(texels));
    const __m128i places = _mm_or_si128(_mm_slli_epi16(shades, 8), _mm_unpacklo_epi8(eight, _mm_setzero_si128()));
    look_up_four(_mm_cvtsi128_si64(places), colours, out);
    look_up_four(_mm_cvtsi128_si64(_mm_unpackhi_epi64(places, places)), colours, out + 4);
}

/// Each column's shade changes linearly from row to row; its step changes linearly from column to column.
template <int Mip>
void light_cell(const std::int32_t* upper_16, const std::int32_t* lower_16, const std::uint8_t* texels,
                const LitCells& cells, const std::uint8_t* colours, std::uint8_t* out) {
    constexpr int kCell = 16 >> Mip;
    const std::int32_t left_of_row_20 = (lower_16[0] - upper_16[0]) * (1 << Mip),
                       right_of_row_20 = (lower_16[1] - upper_16[1]) * (1 << Mip);
    const std::int32_t step_24 = (upper_16[1] - upper_16[0]) * (16 << Mip),
                       step_of_row_24 = (right_of_row_20 - left_of_row_20) * (1 << Mip);
    EightSteps first_24(upper_16[0] * 256, step_24), second_24(upper_16[0] * 256 + 8 * step_24, step_24);
    const EightSteps first_of_row_24(left_of_row_20 * 16, step_of_row_24),
        second_of_row_24(left_of_row_20 * 16 + 8 * step_of_row_24, step_of_row_24);
    const std::ptrdiff_t width = cells.texture_width, stride = cells.stride;
    for (int row = 0; row < kCell; ++row, texels += width, out += stride) {
        light_eight(first_24, texels, colours, out);
        first_24 += first_of_row_24;
        if constexpr (kCell == 8) continue;
        light_eight(second_24, texels + 8, colours, out + 8);
        second_24 += second_of_row_24;
    }
}

}  // namespace

void light_cells_sse2(const LitCells& cells, int mip, const Colormap& colormap) {
    const int cell = 16 >> mip;
    const std::uint8_t* const colours = colormap.shades[0].data();
    std::int32_t u = cells.first_u;
    std::uint8_t* out = cells.out;
    for (std::int32_t column = 1; column < cells.columns; ++column, out += cell) {
        const std::int32_t *const upper_16 = cells.upper_16 + column - 1, *const lower_16 = upper_16 + cells.columns;
        (mip == 0 ? light_cell<0> : light_cell<1>)(upper_16, lower_16, cells.texels + u, cells, colours, out);
        u += cell;
        if (u == cells.texture_width) u = 0;
    }
}

}  // namespace oblong

#endif
