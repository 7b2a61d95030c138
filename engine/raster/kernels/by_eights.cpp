#include "engine/raster/kernels/by_eights.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/edges.h"
#include "engine/raster/kernels/eights.h"
#include "engine/raster/row_repeater.h"

namespace oblong {

bool can_cut_by_eights(const BlockCutting& cutting) {
    constexpr Texel kMost = Texel::from_int(1024);
    return cutting.fits_range && cutting.limits.greatest_u < kMost && cutting.limits.greatest_v < kMost;
}

#if defined(OBLONG_EIGHTS)

namespace {

/// texel_of() at eight pixels of a surface.
struct EightTexels {
    EightValues inverse_z, u_over_z, v_over_z;
    Eight least, greatest_u, greatest_v;

    [[OBLONG_INLINE_AVX512]] explicit EightTexels(const BlockCutting& cutting)
        : inverse_z(cutting.gradients.inverse_z),
          u_over_z(cutting.gradients.u_over_z),
          v_over_z(cutting.gradients.v_over_z),
          least(eight_of(cutting.limits.least)),
          greatest_u(eight_of(cutting.limits.greatest_u)),
          greatest_v(eight_of(cutting.limits.greatest_v)) {}

    [[OBLONG_INLINE_AVX512]] EightDepths depths_at(Eight columns, Eight rows) const {
        return EightDepths(inverse_z.at(columns, rows));
    }
    [[OBLONG_INLINE_AVX512]] Eight u_at(Eight columns, Eight rows, const EightDepths& depths) const {
        return clamped(depths.times(u_over_z.at(columns, rows)), least, greatest_u);
    }
    [[OBLONG_INLINE_AVX512]] Eight v_at(Eight columns, Eight rows, const EightDepths& depths) const {
        return clamped(depths.times(v_over_z.at(columns, rows)), least, greatest_v);
    }
};

/// steps_by_division() of u or v over up to 1,024 texels, from entries of kStepReciprocal_36; also steps_by_shift(), as
/// 2^36 / 2^log2 is such an entry.
[[OBLONG_INLINE_AVX512]] inline Eight floored_steps(Eight way, Eight reciprocals_36) {
    return signed_shift(way * reciprocals_36 + eight_of(1 << 26), 36);
}

/// Every third number of `a` and `b`, starting at `from`.
[[OBLONG_INLINE_AVX512]] inline Eight each_third(__m512i a, __m512i b, int from) {
    const __m512i thirds = _mm512_setr_epi32(0, 3, 6, 9, 12, 15, 18, 21, 0, 0, 0, 0, 0, 0, 0, 0);
    const __m512i index = _mm512_add_epi32(thirds, _mm512_set1_epi32(from));
    return as_eight(_mm512_cvtepi32_epi64(_mm512_castsi512_si256(_mm512_permutex2var_epi32(a, index, b))));
}

/// Eight spans; if fewer, padded with zeros.
struct EightSpans {
    Eight row, first, end;

    [[OBLONG_INLINE_AVX512]] EightSpans(const Span* spans, std::size_t count) {
        const std::uint32_t numbers = count < 8 ? (1u << 3 * count) - 1 : 0xffffff;
        const __m512i a = _mm512_maskz_loadu_epi32(static_cast<__mmask16>(numbers), &spans->y);
        const __m512i b = _mm512_maskz_loadu_epi32(static_cast<__mmask16>(numbers >> 16), &spans->y + 16);
        row = each_third(a, b, 0);
        first = each_third(a, b, 1);
        end = each_third(a, b, 2);
    }
};

/// Eight blocks, three words each: pixel and count, u and v, their steps. The first of each pair is the lower half.
struct EightBlocks {
    Eight head, texel, step;

    [[OBLONG_INLINE_AVX512]] static EightBlocks load(const TexelBlock* from) {
        const auto* const words = reinterpret_cast<const std::uint64_t*>(from);
        const Eight a = load_eight(words), b = load_eight(words + 8), c = load_eight(words + 16);
        return {chosen(chosen(a, Eight{0, 3, 6, 9, 12, 15, 0, 0}, b), Eight{0, 1, 2, 3, 4, 5, 10, 13}, c),
                chosen(chosen(a, Eight{1, 4, 7, 10, 13, 0, 0, 0}, b), Eight{0, 1, 2, 3, 4, 8, 11, 14}, c),
                chosen(chosen(a, Eight{2, 5, 8, 11, 14, 0, 0, 0}, b), Eight{0, 1, 2, 3, 4, 9, 12, 15}, c)};
    }
    [[OBLONG_INLINE_AVX512]] void store(TexelBlock* to) const {
        auto* const words = reinterpret_cast<std::uint64_t*>(to);
        const Eight a = chosen(head, Eight{0, 8, 0, 1, 9, 0, 2, 10}, texel);
        const Eight b = chosen(head, Eight{0, 3, 11, 0, 4, 12, 0, 5}, texel);
        const Eight c = chosen(head, Eight{13, 0, 6, 14, 0, 7, 15, 0}, texel);
        store_eight(chosen(a, Eight{0, 1, 8, 3, 4, 9, 6, 7}, step), words);
        store_eight(chosen(b, Eight{10, 1, 2, 11, 4, 5, 12, 7}, step), words + 8);
        store_eight(chosen(c, Eight{0, 13, 2, 3, 14, 5, 6, 15}, step), words + 16);
    }
};

/// Up to seven blocks of a row: their first pixels, and the first pixel of the next block or the row's last pixel.
class RowPart {
  public:
    static constexpr std::size_t kMost = 7;

    /// Takes the first of `blocks`.
    [[OBLONG_INLINE_AVX512]] void set(std::span<const TexelBlock> blocks, const Span& row, std::int32_t pitch,
                                      const EightTexels& texels) {
        count_ = std::min(blocks.size(), kMost);
        above_ = EightBlocks::load(blocks.data());
        Eight columns = lower_half(above_.head) - eight_of(row.y * pitch);
        const Eight log2 = eight_of(63) - leading_zeros(above_.head >> 32);
        reciprocals_36_ = eight_of(std::int64_t{1} << 36) >> log2;
        if (count_ == blocks.size()) {
            columns = with(columns, count_, row.end - 1);
            reciprocals_36_ = with(reciprocals_36_, count_ - 1, item(kStepReciprocal_36, blocks.back().count - 1));
        }
        depths_ = texels.depths_at(columns, Eight{});
        v_over_z_ = texels.v_over_z.at(columns, Eight{});
    }
    /// Appends the same blocks for another row, `pixels` further on, where v/z is `more_v_over_z` greater than in row
    /// 0.
    [[OBLONG_INLINE_AVX512]] TexelBlock* append(Eight pixels, Eight more_v_over_z, const EightTexels& texels,
                                                TexelBlock* out) const {
        const Eight v = clamped(depths_.times(v_over_z_ + more_v_over_z), texels.least, texels.greatest_v);
        const Eight v_way = chosen(v, Eight{1, 2, 3, 4, 5, 6, 7, 7}, v) - v;
        EightBlocks{above_.head + pixels, lower_half(above_.texel) | v << 32,
                    lower_half(above_.step) | floored_steps(v_way, reciprocals_36_) << 32}
            .store(out);
        return out + count_;
    }

  private:
    std::size_t count_;
    EightBlocks above_;
    EightDepths depths_;
    Eight v_over_z_;  ///< in row 0
    Eight reciprocals_36_;
};

[[OBLONG_INLINE_AVX512]] inline __m256i floors(Eight columns) {
    return _mm512_cvtepi64_epi32(as_m512i(signed_shift(columns, ScreenWalker::kFractionBits)));
}

[[OBLONG_INLINE_AVX512]] inline void write_by_eights(const ScreenWalker& walker, std::int32_t count,
                                                     std::int32_t* columns) {
    const auto slope = walker.slope();
    Eight at = eight_of(walker.exact_column()) + eight_of(slope) * Eight{0, 1, 2, 3, 4, 5, 6, 7};
    for (const Eight step = eight_of(slope * 8); count > 8; count -= 8, columns += 8, at += step)
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(columns), floors(at));
    const auto rest = static_cast<__mmask16>((1u << count) - 1);
    _mm512_mask_storeu_epi32(columns, rest, _mm512_castsi256_si512(floors(at)));
}

}  // namespace

[[OBLONG_AVX512]] TexelBlock* cut_whole_spans_by_eights(std::span<const Span> spans, std::int32_t pitch,
                                                        const BlockCutting& cutting, TexelBlock* out) {
    const EightTexels texels(cutting);
    while (!spans.empty()) {
        const std::size_t count = std::min<std::size_t>(spans.size(), 8);
        const auto [row, first, end] = EightSpans(spans.data(), count);
        const Eight last = end - eight_of(1), steps = (last - first) & eight_of(kStepReciprocals - 1);
        const Eight reciprocals_36 = gathered(kStepReciprocal_36.data(), steps);
        const EightDepths depths = texels.depths_at(first, row), last_depths = texels.depths_at(last, row);
        const Eight u = texels.u_at(first, row, depths), v = texels.v_at(first, row, depths);
        const Eight u_step = floored_steps(texels.u_at(last, row, last_depths) - u, reciprocals_36);
        const Eight v_step = floored_steps(texels.v_at(last, row, last_depths) - v, reciprocals_36);
        const Eight pixel = row * eight_of(pitch) + first;
        EightBlocks{pixel | (end - first) << 32, u | v << 32, lower_half(u_step) | v_step << 32}.store(out);
        out += count;
        spans = spans.subspan(count);
    }
    return out;
}

[[OBLONG_AVX512]] TexelBlock* repeat_rows_by_eights(const Span& above, std::span<const TexelBlock> blocks,
                                                    std::span<const Span> spans, std::int32_t pitch,
                                                    const BlockCutting& cutting, TexelBlock* out) {
    const EightTexels texels(cutting);
    std::array<RowPart, RowRepeater<DividedReciprocal>::kMostEnds / RowPart::kMost + 1> parts;
    std::size_t part_count = 0;
    for (std::size_t first = 0; first < blocks.size(); first += RowPart::kMost)
        parts[part_count++].set(blocks.subspan(first), above, pitch, texels);
    for (const Span& span : spans) {
        const Eight pixels = eight_of(std::int64_t{span.y - above.y} * pitch);
        const Eight v_over_z = eight_of(cutting.gradients.v_over_z.per_row * span.y);
        for (std::size_t i = 0; i < part_count; ++i) out = parts[i].append(pixels, v_over_z, texels, out);
    }
    return out;
}

[[OBLONG_AVX512]] void scan_edges_by_eights(std::span<const ScreenVertex> vertices, ScanlineExtents& rows) {
    std::int32_t* const left = rows.left.data();
    std::int32_t* const right = rows.right.data();
    ScreenVertex from = vertices.back();
    for (const ScreenVertex& vertex : vertices) {
        const SideEdge edge(from, vertex);
        from = vertex;
        const auto [first, end] = edge.rows({rows.first, rows.end});
        if (first >= end) continue;
        write_by_eights(ScreenWalker(edge.top, edge.bottom, first), end - first,
                        (edge.is_right ? right : left) + first);
    }
}

#else

TexelBlock* cut_whole_spans_by_eights(std::span<const Span>, std::int32_t, const BlockCutting&, TexelBlock* out) {
    return out;
}
TexelBlock* repeat_rows_by_eights(const Span&, std::span<const TexelBlock>, std::span<const Span>, std::int32_t,
                                  const BlockCutting&, TexelBlock* out) {
    return out;
}
void scan_edges_by_eights(std::span<const ScreenVertex>, ScanlineExtents&) {}

#endif

}  // namespace oblong
