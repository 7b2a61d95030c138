#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/view/gradients.h"

// Vectors of eight 64-bit numbers, for processors with Instructions::Avx512. Not compiled without SSE2: then the
// compiler was told to use no vectors.
#if defined(__x86_64__) && defined(__SSE2__)
#define OBLONG_EIGHTS 1
// GCC 12 warns of uninitialised values in its own headers.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#include <immintrin.h>
#pragma GCC diagnostic pop

#define OBLONG_AVX512 gnu::target("avx512f,avx512cd,avx512dq,bmi2,lzcnt,popcnt")
#define OBLONG_INLINE_AVX512 OBLONG_AVX512, gnu::always_inline

namespace oblong {

/// Unsigned: they wrap, and >> shifts in zeros.
using Eight = std::uint64_t __attribute__((vector_size(64)));

[[OBLONG_INLINE_AVX512]] inline __m512i as_m512i(Eight values) {
    return reinterpret_cast<__m512i>(values);
}
[[OBLONG_INLINE_AVX512]] inline Eight as_eight(__m512i values) {
    return reinterpret_cast<Eight>(values);
}
[[OBLONG_INLINE_AVX512]] inline Eight eight_of(std::int64_t value) {
    return as_eight(_mm512_set1_epi64(value));
}
/// Of its steps.
template <int Frac>
[[OBLONG_INLINE_AVX512]] inline Eight eight_of(Fixed<std::int64_t, Frac> value) {
    return eight_of(value.raw);
}
[[OBLONG_INLINE_AVX512]] inline Eight load_eight(const std::uint64_t* from) {
    return as_eight(_mm512_loadu_si512(from));
}
[[OBLONG_INLINE_AVX512]] inline void store_eight(Eight values, std::uint64_t* to) {
    _mm512_storeu_si512(to, as_m512i(values));
}
/// `values` with `value` at `place`.
[[OBLONG_INLINE_AVX512]] inline Eight with(Eight values, std::size_t place, std::int64_t value) {
    return as_eight(_mm512_mask_set1_epi64(as_m512i(values), static_cast<__mmask8>(1u << place), value));
}
[[OBLONG_INLINE_AVX512]] inline Eight gathered(const std::int64_t* table, Eight index) {
    return as_eight(_mm512_i64gather_epi64(as_m512i(index), table, sizeof *table));
}
/// The values at these places: 0 to 7 of `a`, 8 to 15 of `b`.
[[OBLONG_INLINE_AVX512]] inline Eight chosen(Eight a, Eight places, Eight b) {
    return as_eight(_mm512_permutex2var_epi64(as_m512i(a), as_m512i(places), as_m512i(b)));
}

[[OBLONG_INLINE_AVX512]] inline Eight lower_half(Eight values) {
    return values & eight_of(0xffffffff);
}
/// Arithmetic shift right.
[[OBLONG_INLINE_AVX512]] inline Eight signed_shift(Eight values, unsigned bits) {
    return as_eight(_mm512_srai_epi64(as_m512i(values), bits));
}
/// The products of the lower halves.
[[OBLONG_INLINE_AVX512]] inline Eight half_product(Eight a, Eight b) {
    return as_eight(_mm512_mul_epu32(as_m512i(a), as_m512i(b)));
}
[[OBLONG_INLINE_AVX512]] inline Eight leading_zeros(Eight values) {
    return as_eight(_mm512_lzcnt_epi64(as_m512i(values)));
}
[[OBLONG_INLINE_AVX512]] inline Eight clamped(Eight values, Eight least, Eight greatest) {
    return as_eight(_mm512_min_epi64(_mm512_max_epi64(as_m512i(values), as_m512i(least)), as_m512i(greatest)));
}

/// Tangents of 2^62 / d in the middle of each eighth of [2^31, 2^32): below the curve by at most 1/1,024.
struct ReciprocalTangents {
    std::array<std::uint64_t, 8> at_zero{}, fall_32{};

    constexpr ReciprocalTangents() {
        for (std::uint64_t i = 0; i < 8; ++i) {
            const std::uint64_t middle = 17 + 2 * i;  // in units of 2^27: 2^31 is 16
            at_zero[i] = (std::uint64_t{1} << 36) / middle - 1;
            fall_32[i] = (std::uint64_t{1} << 40) / (middle * middle) + 1;
        }
    }
};
inline constexpr ReciprocalTangents kReciprocalTangents;

/// DividedReciprocal's 2^60 / divisor, rounded down, for divisors from 2^27 up to 2^28. Newton's method from below:
/// each step squares the relative error, so after two only their rounding remains, a few units of 31 bits. The
/// remainder of the division then gives the missing part of the quotient, or all but one of it.
[[OBLONG_INLINE_AVX512]] inline Eight reciprocals_60(Eight divisor) {
    const Eight d = divisor << 4, eighth = (d >> 28) & eight_of(7);
    const Eight fall_32 = chosen(load_eight(kReciprocalTangents.fall_32.data()), eighth, Eight{});
    const Eight at_zero = chosen(load_eight(kReciprocalTangents.at_zero.data()), eighth, Eight{});
    Eight inverse = at_zero - (half_product(d, fall_32) >> 32);
    for (int step = 0; step < 2; ++step) {
        const Eight missing = eight_of(std::int64_t{1} << 62) - half_product(d, inverse);
        inverse += half_product(missing >> 32, inverse) >> 30;
    }
    const Eight rest = Eight{} - (half_product(d, inverse) << 2);  // 2^64 - d * 4 inverse
    const Eight more = half_product(rest >> 8, inverse) >> 54;
    const Eight quotient = (inverse << 2) + more;
    const __mmask8 is_one_missing = _mm512_cmpge_epu64_mask(as_m512i(rest - half_product(d, more)), as_m512i(d));
    return as_eight(
        _mm512_mask_add_epi64(as_m512i(quotient), is_one_missing, as_m512i(quotient), as_m512i(eight_of(1))));
}

/// Eight Depths that need no clamping.
struct EightDepths {
    Eight mantissa, shift;

    EightDepths() = default;
    [[OBLONG_INLINE_AVX512]] explicit EightDepths(Eight inverse_z) : shift(leading_zeros(inverse_z) - eight_of(4)) {
        mantissa = reciprocals_60((inverse_z << shift) >> 32);
    }
    [[OBLONG_INLINE_AVX512]] Eight times(Eight over_z) const {
        return signed_shift(signed_shift(over_z << shift, 32) * mantissa, 30);
    }
};

/// Evaluates a linear quantity at eight pixels.
struct EightValues {
    Eight origin, per_column, per_row;

    template <class Value>
    [[OBLONG_INLINE_AVX512]] explicit EightValues(const LinearQuantity<Value>& quantity)
        : origin(eight_of(quantity.origin)),
          per_column(eight_of(quantity.per_column)),
          per_row(eight_of(quantity.per_row)) {}
    [[OBLONG_INLINE_AVX512]] Eight at(Eight columns, Eight rows) const {
        return origin + columns * per_column + rows * per_row;
    }
};

}  // namespace oblong

#endif
