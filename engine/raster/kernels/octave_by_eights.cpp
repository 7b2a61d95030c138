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

/// The offsets of eight pixels' texels in the surface.
class EightOffsets {
  public:
    [[OBLONG_INLINE_AVX512]] explicit EightOffsets(const OctaveRow& row)
        : u_over_z_(row.u_over_z()),
          v_over_z_(row.v_over_z()),
          u_mask_(eight_of(static_cast<std::int64_t>(row.u_mask()))),
          row_mask_(eight_of(static_cast<std::int64_t>(row.row_mask()))),
          to_row_(46 - row.stride_log2()) {}

    [[OBLONG_INLINE_AVX512]] Eight row_from(std::int32_t pixel, Eight depths) const {
        return (v_over_z_.from(pixel) * depths) >> to_row_ & row_mask_;
    }
    [[OBLONG_INLINE_AVX512]] Eight column_from(std::int32_t pixel, Eight depths) const {
        return (u_over_z_.from(pixel) * depths) >> 46 & u_mask_;
    }

  private:
    EightUpperHalves u_over_z_, v_over_z_;
    Eight u_mask_, row_mask_;
    int to_row_;
};

[[OBLONG_INLINE_AVX512]] inline void fetch_two(std::int64_t offsets, const std::uint8_t* texels, std::uint8_t* out) {
    out[0] = texels[static_cast<std::uint32_t>(offsets)];
    out[1] = texels[static_cast<std::uint64_t>(offsets) >> 32];
}

[[OBLONG_INLINE_AVX512]] inline void fetch_eight(Eight offsets, const std::uint8_t* texels, std::uint8_t* out) {
    const __m256i halves = _mm512_cvtepi64_epi32(as_m512i(offsets));
    fetch_two(_mm256_extract_epi64(halves, 0), texels, out);
    fetch_two(_mm256_extract_epi64(halves, 1), texels, out + 2);
    fetch_two(_mm256_extract_epi64(halves, 2), texels, out + 4);
    fetch_two(_mm256_extract_epi64(halves, 3), texels, out + 6);
}

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

struct DrawDivided {
    EightUpperHalves inverse_z;
    EightOffsets offsets;
    const std::uint8_t* texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const {
        const Eight depths = reciprocals_60(inverse_z.from(pixel));
        fetch_eight(offsets.row_from(pixel, depths) | offsets.column_from(pixel, depths), texels, out + pixel);
    }
};

struct DrawAtOneDepth {
    Eight depths;
    EightOffsets offsets;
    const std::uint8_t* texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const {
        fetch_eight(offsets.row_from(pixel, depths) | offsets.column_from(pixel, depths), texels, out + pixel);
    }
};

struct DrawAtDepths {
    const ColumnTexel* columns;
    EightOffsets offsets;
    const std::uint8_t* texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const {
        const Eight depths = each_second(columns + pixel, false);
        fetch_eight(offsets.row_from(pixel, depths) | offsets.column_from(pixel, depths), texels, out + pixel);
    }
};

struct DrawColumns {
    const ColumnTexel* columns;
    EightOffsets offsets;
    const std::uint8_t* texels;
    std::uint8_t* out;

    [[OBLONG_INLINE_AVX512]] void from(std::int32_t pixel) const {
        const Eight depths = each_second(columns + pixel, false), u = each_second(columns + pixel, true);
        fetch_eight(offsets.row_from(pixel, depths) | u, texels, out + pixel);
    }
};

}  // namespace

[[OBLONG_AVX512]] std::int32_t draw_divided_by_eights(const OctaveRow& row, std::int32_t count, std::uint8_t* out) {
    const EightUpperHalves inverse_z(row.inverse_z());
    if (row.is_constant()) {
        draw_all(count, DrawAtOneDepth{reciprocals_60(inverse_z.from(0)), EightOffsets(row), row.texels(), out});
        return 1;
    }
    draw_all(count, DrawDivided{inverse_z, EightOffsets(row), row.texels(), out});
    return count;
}

[[OBLONG_AVX512]] void draw_at_depths_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count,
                                                std::uint8_t* out) {
    draw_all(count, DrawAtDepths{columns, EightOffsets(row), row.texels(), out});
}

[[OBLONG_AVX512]] void draw_columns_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count,
                                              std::uint8_t* out) {
    draw_all(count, DrawColumns{columns, EightOffsets(row), row.texels(), out});
}

#else

std::int32_t draw_divided_by_eights(const OctaveRow& row, std::int32_t count, std::uint8_t* out) {
    return row.draw_divided(0, count, out);
}
void draw_at_depths_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out) {
    row.draw_at_depths(columns, count, out);
}
void draw_columns_by_eights(const OctaveRow& row, const ColumnTexel* columns, std::int32_t count, std::uint8_t* out) {
    row.draw_columns(columns, count, out);
}

#endif

}  // namespace oblong
