#include <algorithm>
#include <array>

#include "engine/raster/kernels/by_eights.h"
#include "engine/raster/kernels/eights.h"

namespace oblong {

#if defined(OBLONG_EIGHTS)

namespace {

/// A quantity's upper halves at eight consecutive pixels.
class EightUpperHalves {
  public:
    [[OBLONG_INLINE_AVX512]] explicit EightUpperHalves(const OctaveRow::Scaled& quantity)
        : step_(eight_of(static_cast<std::int64_t>(quantity.step))),
          first_(eight_of(static_cast<std::int64_t>(quantity.first)) + Eight{0, 1, 2, 3, 4, 5, 6, 7} * step_) {}
    [[OBLONG_INLINE_AVX512]] Eight from(std::int32_t pixel) const {
        return signed_shift(first_ + eight_of(pixel) * step_, 32);
    }

  private:
    Eight step_, first_;
};

/// u and v of eight pixels, each times 2^46.
class EightCoordinates {
  public:
    [[OBLONG_INLINE_AVX512]] explicit EightCoordinates(const OctaveRow& row)
        : u_over_z_(row.u_over_z()), v_over_z_(row.v_over_z()) {}

    [[OBLONG_INLINE_AVX512]] Eight u_46(std::int32_t pixel, Eight depths) const {
        return u_over_z_.from(pixel) * depths;
    }
    [[OBLONG_INLINE_AVX512]] Eight v_46(std::int32_t pixel, Eight depths) const {
        return v_over_z_.from(pixel) * depths;
    }

  private:
    EightUpperHalves u_over_z_, v_over_z_;
};

/// Two texels more in `eight`, collected there as one store takes less time than eight.
template <int kFirst>
[[OBLONG_INLINE_AVX512]] inline void fetch_two(std::int64_t offsets, const std::uint8_t* texels, __m128i& eight) {
    eight = _mm_insert_epi8(eight, texels[static_cast<std::uint32_t>(offsets)], kFirst);
    eight = _mm_insert_epi8(eight, texels[static_cast<std::uint64_t>(offsets) >> 32], kFirst + 1);
}

[[OBLONG_INLINE_AVX512]] inline void fetch_eight(__m256i offsets, const std::uint8_t* texels, std::uint8_t* out) {
    __m128i eight = _mm_setzero_si128();
    fetch_two<0>(_mm256_extract_epi64(offsets, 0), texels, eight);
    fetch_two<2>(_mm256_extract_epi64(offsets, 1), texels, eight);
    fetch_two<4>(_mm256_extract_epi64(offsets, 2), texels, eight);
    fetch_two<6>(_mm256_extract_epi64(offsets, 3), texels, eight);
    _mm_storel_epi64(reinterpret_cast<__m128i*>(out), eight);
}

/// Fetches the texels of eight pixels.
class EightTexelsOfRow {
  public:
    [[OBLONG_INLINE_AVX512]] explicit EightTexelsOfRow(const OctaveRow& row)
        : at_(row),
          u_mask_(eight_of(static_cast<std::int64_t>(row.u_mask()))),
          row_mask_(eight_of(static_cast<std::int64_t>(row.row_mask()))),
          to_row_(46 - row.stride_log2()),
          texels_(row.texels()) {}

    [[OBLONG_INLINE_AVX512]] void fetch(std::int32_t pixel, Eight depths, std::uint8_t* out) const {
        fetch_columns(pixel, depths, at_.u_46(pixel, depths) >> 46 & u_mask_, out);
    }
    /// With known columns of texels.
    [[OBLONG_INLINE_AVX512]] void fetch_columns(std::int32_t pixel, Eight depths, Eight u, std::uint8_t* out) const {
        const Eight offsets = (at_.v_46(pixel, depths) >> to_row_ & row_mask_) | u;
        fetch_eight(_mm512_cvtepi64_epi32(as_m512i(offsets)), texels_, out);
    }

  private:
    EightCoordinates at_;
    Eight u_mask_, row_mask_;
    int to_row_;
    const std::uint8_t* texels_;
};

/// A WarpTable in registers.
class WarpRegisters {
  public:
    [[OBLONG_INLINE_AVX512]] explicit WarpRegisters(const WarpTable& warp) {
        for (std::size_t i = 0; i < kRegisters; ++i) entries_16_[i] = _mm512_loadu_si512(&warp.shift_16[i * 16]);
    }
    /// shift_at() of sixteen coordinates.
    [[OBLONG_INLINE_AVX512]] __m512i shifts_at(__m512i texels_16) const {
        const __m512i entries = _mm512_srli_epi32(texels_16, 16);
        const __mmask16 in_second = _mm512_test_epi32_mask(entries, _mm512_set1_epi32(32));
        const __mmask16 in_upper = _mm512_test_epi32_mask(entries, _mm512_set1_epi32(64));
        return _mm512_mask_blend_epi32(in_upper,
                                       _mm512_mask_blend_epi32(in_second, at_pair(0, entries), at_pair(2, entries)),
                                       _mm512_mask_blend_epi32(in_second, at_pair(4, entries), at_pair(6, entries)));
    }

  private:
    static constexpr std::size_t kRegisters = WarpTable::kEntries / 16;

    [[OBLONG_INLINE_AVX512]] __m512i at_pair(std::size_t first, __m512i entries) const {
        return _mm512_permutex2var_epi32(entries_16_[first], entries, entries_16_[first + 1]);
    }

    __m512i entries_16_[kRegisters];
};

/// Fetches the texels of eight pixels of a surface that warps.
class EightWarpedFetch {
  public:
    [[OBLONG_INLINE_AVX512]] EightWarpedFetch(const SurfaceView& surface, const WarpTable& warp)
        : warp_(warp),
          masks_(halves(_mm256_set1_epi32(static_cast<int>(surface.u_mask)),
                        _mm256_set1_epi32(static_cast<int>(surface.v_mask)))),
          stride_log2_(_mm_cvtsi32_si128(surface.stride_log2)),
          texels_(surface.texels) {}

    [[OBLONG_INLINE_AVX512]] static __m512i halves(__m256i lower, __m256i upper) {
        return _mm512_inserti64x4(_mm512_castsi256_si512(lower), upper, 1);
    }
    /// u of the pixels in the lower half, v in the upper: texels, 16.16.
    [[OBLONG_INLINE_AVX512]] void fetch(__m512i uv_16, std::uint8_t* out) const {
        const __m512i shifts_16 = warp_.shifts_at(_mm512_shuffle_i64x2(uv_16, uv_16, 0b01'00'11'10));
        const __m512i uv = _mm512_and_si512(_mm512_srli_epi32(_mm512_add_epi32(uv_16, shifts_16), 16), masks_);
        const __m256i rows = _mm256_sll_epi32(_mm512_extracti64x4_epi64(uv, 1), stride_log2_);
        fetch_eight(_mm256_or_si256(rows, _mm512_castsi512_si256(uv)), texels_, out);
    }

  private:
    WarpRegisters warp_;
    __m512i masks_;
    __m128i stride_log2_;
    const std::uint8_t* texels_;
};

class EightWarpedTexels {
  public:
    [[OBLONG_INLINE_AVX512]] EightWarpedTexels(const OctaveRow& row, const EffectTexels& texels)
        : at_(row), warped_(texels.surface, *texels.warp) {}

    [[OBLONG_INLINE_AVX512]] void fetch(std::int32_t pixel, Eight depths, std::uint8_t* out) const {
        warped_.fetch(EightWarpedFetch::halves(_mm512_cvtepi64_epi32(as_m512i(at_.u_46(pixel, depths) >> 30)),
                                               _mm512_cvtepi64_epi32(as_m512i(at_.v_46(pixel, depths) >> 30))),
                      out);
    }

  private:
    EightCoordinates at_;
    EightWarpedFetch warped_;
};

/// The first or second words of eight columns.
[[OBLONG_INLINE_AVX512]] inline Eight each_second(const ColumnTexel* columns, bool is_second) {
    const auto* const words = reinterpret_cast<const std::uint64_t*>(columns);
    const Eight places = Eight{0, 2, 4, 6, 8, 10, 12, 14} + eight_of(is_second);
    return chosen(load_eight(words), places, load_eight(words + 8));
}

/// Draws eight pixels at a time; the last eight may overlap those before.
template <class DrawEight>
[[OBLONG_INLINE_AVX512]] inline void draw_all(std::int32_t count, const DrawEight& draw_eight) {
    for (std::int32_t pixel = 0; pixel < count - 8; pixel += 8) draw_eight.from(pixel);
    draw_eight.from(count - 8);
}

template <class Texels>
struct DrawDivided {
    EightUpperHalves inverse_z;
    Texels texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const {
        texels.fetch(pixel, reciprocals_60(inverse_z.from(pixel)), out + pixel);
    }
};

template <class Texels>
struct DrawAtOneDepth {
    Eight depths;
    Texels texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const { texels.fetch(pixel, depths, out + pixel); }
};

template <class Texels>
struct DrawAtDepths {
    const ColumnTexel* columns;
    Texels texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const {
        texels.fetch(pixel, each_second(columns + pixel, false), out + pixel);
    }
};

struct DrawColumns {
    const ColumnTexel* columns;
    EightTexelsOfRow texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const {
        texels.fetch_columns(pixel, each_second(columns + pixel, false), each_second(columns + pixel, true),
                             out + pixel);
    }
};

template <class Texels>
[[OBLONG_INLINE_AVX512]] inline std::int32_t draw_divided(const OctaveRow& row, const Texels& texels,
                                                          std::int32_t count, std::uint8_t* out) {
    const EightUpperHalves inverse_z(row.inverse_z());
    if (row.is_constant()) {
        draw_all(count, DrawAtOneDepth<Texels>{reciprocals_60(inverse_z.from(0)), texels, out});
        return 1;
    }
    draw_all(count, DrawDivided<Texels>{inverse_z, texels, out});
    return count;
}

}  // namespace

[[OBLONG_AVX512]] std::int32_t draw_divided_by_eights(const OctaveRow& row, std::int32_t count, std::uint8_t* out) {
    return draw_divided(row, EightTexelsOfRow(row), count, out);
}

[[OBLONG_AVX512]] std::int32_t draw_warped_by_eights(const OctaveRow& row, const EffectTexels& texels,
                                                     std::int32_t count, std::uint8_t* out) {
    return draw_divided(row, EightWarpedTexels(row, texels), count, out);
}

[[OBLONG_AVX512]] void draw_at_depths_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count,
                                                std::uint8_t* out) {
    draw_all(count, DrawAtDepths<EightTexelsOfRow>{columns, EightTexelsOfRow(row), out});
}

[[OBLONG_AVX512]] void draw_warped_at_depths_by_eights(const OctaveRow& row, const EffectTexels& texels,
                                                       const ColumnTexel* columns, std::int32_t count,
                                                       std::uint8_t* out) {
    draw_all(count, DrawAtDepths<EightWarpedTexels>{columns, EightWarpedTexels(row, texels), out});
}

[[OBLONG_AVX512]] void draw_columns_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count,
                                              std::uint8_t* out) {
    draw_all(count, DrawColumns{columns, EightTexelsOfRow(row), out});
}

/// Of blocks of fewer than eight pixels, those beyond the end are drawn elsewhere.
[[OBLONG_AVX512]] void draw_warped_blocks_by_eights(std::span<const TexelBlock> blocks, const EffectTexels& texels,
                                                    std::uint8_t* pixels) {
    const EightWarpedFetch warped(texels.surface, *texels.warp);
    const __m512i places =
        EightWarpedFetch::halves(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    for (const TexelBlock& block : blocks) {
        const __m512i first_16 = EightWarpedFetch::halves(_mm256_set1_epi32(static_cast<int>(block.u_16)),
                                                          _mm256_set1_epi32(static_cast<int>(block.v_16)));
        const __m512i steps_16 =
            EightWarpedFetch::halves(_mm256_set1_epi32(block.u_step_16), _mm256_set1_epi32(block.v_step_16));
        std::uint8_t* const out = pixels + block.pixel;
        __m512i uv_16 = _mm512_add_epi32(first_16, _mm512_mullo_epi32(steps_16, places));
        if (block.count < kFewestByEights) {
            std::uint8_t drawn[kFewestByEights];
            warped.fetch(uv_16, drawn);
            std::copy_n(drawn, block.count, out);
            continue;
        }
        const std::int32_t last = block.count - 8;
        const __m512i to_last_16 = _mm512_mullo_epi32(steps_16, _mm512_set1_epi32(last));
        const __m512i last_16 = _mm512_add_epi32(uv_16, to_last_16), eight_steps_16 = _mm512_slli_epi32(steps_16, 3);
        for (std::int32_t pixel = 0; pixel < last; pixel += 8, uv_16 = _mm512_add_epi32(uv_16, eight_steps_16))
            warped.fetch(uv_16, out + pixel);
        warped.fetch(last_16, out + last);
    }
}

#else

void draw_warped_blocks_by_eights(std::span<const TexelBlock> blocks, const EffectTexels& texels,
                                  std::uint8_t* pixels) {
    effect_kernel(kWarpsAlone, Instructions::Baseline)(blocks, texels, pixels);
}
std::int32_t draw_divided_by_eights(const OctaveRow& row, std::int32_t count, std::uint8_t* out) {
    return row.draw_divided(0, count, out);
}
std::int32_t draw_warped_by_eights(const OctaveRow& row, const EffectTexels& texels, std::int32_t count,
                                   std::uint8_t* out) {
    return row.draw_divided(0, count, out, WarpedColours{*texels.warp});
}
void draw_at_depths_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out) {
    row.draw_at_depths(columns, count, out);
}
void draw_warped_at_depths_by_eights(const OctaveRow& row, const EffectTexels& texels, const ColumnTexel* columns,
                                     std::int32_t count, std::uint8_t* out) {
    row.draw_at_depths(columns, count, out, WarpedColours{*texels.warp});
}
void draw_columns_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out) {
    row.draw_columns(columns, count, out);
}

#endif

}  // namespace oblong
