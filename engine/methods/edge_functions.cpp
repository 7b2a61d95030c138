#include <algorithm>
#include <bit>

#include "engine/methods/triangles.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace oblong {

PixelRange inside_edges_plain(const EdgeRow& row, std::int32_t count) {
    auto [a, b, c] = row.value;
    PixelRange inside{count, count};
    for (std::int32_t column = 0; column < count; ++column) {
        const bool is_inside = (a | b | c) >= 0;
        if (is_inside && inside.first == count) inside.first = column;
        if (!is_inside && inside.first < count) {
            inside.end = column;
            break;
        }
        a += row.step[0];
        b += row.step[1];
        c += row.step[2];
    }
    return inside;
}

#if defined(__SSE2__)

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

#else

PixelRange inside_edges_sse2(const EdgeRow& row, std::int32_t count) {
    return inside_edges_plain(row, count);
}

#endif

}  // namespace oblong
