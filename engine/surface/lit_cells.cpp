#include "engine/surface/lit_surface.h"

#if defined(__x86_64__) && defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace oblong {

#if defined(__x86_64__) && defined(__SSE2__)

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
[[gnu::always_inline]] inline void light_eight(const EightSteps& shades_24, const std::uint8_t* texels,
                                               const std::uint8_t* colours, std::uint8_t* out) {
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

bool light_cells_by_eights(const LitCells& cells, int mip, const Colormap& colormap) {
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
    return true;
}

#else

bool light_cells_by_eights(const LitCells&, int, const Colormap&) {
    return false;
}

#endif

}  // namespace oblong
