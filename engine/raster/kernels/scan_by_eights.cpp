#include "engine/raster/edges.h"
#include "engine/raster/kernels/by_eights.h"
#include "engine/raster/kernels/eights.h"

namespace oblong {

#if defined(OBLONG_EIGHTS)

namespace {

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

void scan_edges_by_eights(std::span<const ScreenVertex>, ScanlineExtents&) {}

#endif

}  // namespace oblong
