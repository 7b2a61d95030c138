#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "engine/base/range_probe.h"
#include "engine/fixed/divide.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/native/native.h"
#include "engine/fixed/reciprocal.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// What is known of 1/z, u/z and v/z where blocks end: they may have to be clamped before multiplication; they fit; or
/// also their steps have 32 bits, which saves i386 a product each.
enum class PerspectiveRange { MayOverflow, Fits, FitsWithShortSteps };

/// value + step * count modulo 2^64.
template <PerspectiveRange Range, int Frac>
inline auto stepped_in(Fixed<std::int64_t, Frac> value, Fixed<std::int64_t, Frac> step, std::uint32_t count) {
    if constexpr (Range != PerspectiveRange::FitsWithShortSteps) return stepped(value, step, count);
    const auto way = native::product_to_64(static_cast<std::int32_t>(step.raw), static_cast<std::int32_t>(count));
    return stepped(value, Fixed<std::int64_t, Frac>::from_raw(way), 1);
}

/// The same for a count of 2^log2: by shifts, but on i386, where those of 64 bits take longer than products.
template <PerspectiveRange Range, int Frac>
inline auto stepped_by_power(Fixed<std::int64_t, Frac> value, Fixed<std::int64_t, Frac> step, int log2) {
    if constexpr (native::kHasShortRegisters) return stepped_in<Range>(value, step, std::uint32_t{1} << log2);
    const auto way = static_cast<std::int64_t>(step.bits() << log2);
    return stepped(value, Fixed<std::int64_t, Frac>::from_raw(way), 1);
}

/// LinearQuantity::at_shown().
template <PerspectiveRange Range, class Value>
inline Value value_at(const LinearQuantity<Value>& quantity, std::int32_t column, std::int32_t row) {
    const Value in_first_row =
        stepped_in<Range>(quantity.origin, quantity.per_column, static_cast<std::uint32_t>(column));
    return stepped_in<Range>(in_first_row, quantity.per_row, static_cast<std::uint32_t>(row));
}

/// 1/z, u/z, v/z at one pixel.
struct Perspective {
    InverseZ inverse_z;
    TexelOverZ u_over_z, v_over_z;

    template <PerspectiveRange Range = PerspectiveRange::Fits>
    static Perspective at(const TextureGradients& gradients, std::int32_t column, std::int32_t row) {
        const Perspective here{value_at<Range>(gradients.inverse_z, column, row),
                               value_at<Range>(gradients.u_over_z, column, row),
                               value_at<Range>(gradients.v_over_z, column, row)};
        note_range<"1/z at a block's end">(here.inverse_z);
        note_range<"u/z, v/z at a block's end">(here.u_over_z);
        note_range<"u/z, v/z at a block's end">(here.v_over_z);
        return here;
    }
};

/// std::clamp by value, so that the compiler keeps all in registers.
template <class Number>
constexpr Number clamp_value(Number value, Number least, Number greatest) {
    value = value < least ? least : value;
    return value > greatest ? greatest : value;
}

/// A texel clamped to limits of 32 bits, in raw steps.
inline std::uint32_t texel_within(Texel texel, Texel least, Texel greatest) {
    if constexpr (native::kHasShortRegisters) {
        const auto high = static_cast<std::int32_t>(texel.raw >> 32);
        auto steps = static_cast<std::uint32_t>(texel.raw);
        if (high != 0) steps = high < 0 ? 0 : ~std::uint32_t{0};
        return clamp_value(steps, static_cast<std::uint32_t>(least.raw), static_cast<std::uint32_t>(greatest.raw));
    }
    return static_cast<std::uint32_t>(clamp_value(texel, least, greatest).raw);
}

/// value * 2^shift / 2^32, floored; value * 2^shift fits 64 bits. `shift` is below 32 unless MayBeLong.
template <bool MayBeLong>
inline std::int32_t upper_half(std::int64_t value, int shift) {
    if constexpr (native::kHasShortRegisters) {
        if (MayBeLong && shift >= 32)
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << (shift & 31));
        return static_cast<std::int32_t>(native::shift_left(value, shift).bits);
    }
    return static_cast<std::int32_t>(floor_shift(value * (std::int64_t{1} << shift), 32));
}

/// 2^92 / (value * 2^shift), whose divisor is from 2^59 to 2^60. One 64-bit division, relative error below 2^-26.
struct DividedReciprocal {
    static constexpr std::int64_t kLeast = (std::int64_t{1} << 32) + 1;

    static std::int64_t of(std::int64_t value, int shift) {
        if constexpr (native::kHasShortRegisters) return kLeast + above_least<true>(value, shift);
        return static_cast<std::int64_t>(
            divide(std::uint64_t{1} << 60, static_cast<std::uint64_t>(upper_half<true>(value, shift))).quotient);
    }

    /// of() - kLeast. With d from 2^27 to 2^28 - 1, that is (2^60 - 2^32 d - d) / d.
    template <bool MayBeLong>
    static std::uint32_t above_least(std::int64_t value, int shift) {
        const auto divisor = static_cast<std::uint32_t>(upper_half<MayBeLong>(value, shift));
        return native::divide_to_32(std::uint64_t{(1u << 28) - 1 - divisor} << 32 | (0 - divisor), divisor).quotient;
    }
};

/// The same by a table method.
struct TabledReciprocal {
    ReciprocalMethod method;

    std::int64_t of(std::int64_t value, int shift) const {
        return std::int64_t{mantissa_reciprocal(static_cast<std::uint32_t>(value << shift >> 28), method)} * 4;
    }
};

/// z as a reciprocal of 33 bits and a scale. If fits_range(), all ranges give the same values.
template <class Reciprocal, PerspectiveRange Range>
struct Depth {
    static constexpr bool kClamps = Range == PerspectiveRange::MayOverflow;

    /// Whether only what the mantissa is above DividedReciprocal::kLeast is stored.
    static constexpr bool kIsShort =
        native::kHasShortRegisters && !kClamps && std::is_same_v<Reciprocal, DividedReciprocal>;

    /// 2^60 / (the leading 28 bits of 1/z), in (2^32, 2^33]; of the tables also a little less
    std::conditional_t<kIsShort, std::uint32_t, std::int64_t> mantissa = 0;
    TexelOverZ greatest_over_z;  ///< for larger u/z, u would exceed 65,535 texels
    int shift = 0;               ///< brings 1/z to 60 bits

    Depth() = default;
    Depth(InverseZ inverse_z, Reciprocal reciprocal) {
        const std::int64_t positive =
            kClamps ? clamp_value(inverse_z, kLeastInverseZ, kGreatestInverseZ).raw : inverse_z.raw;
        if (positive == 0) __builtin_unreachable();  // fits_range(); saves i386 two tests of a half for 0
        shift = std::countl_zero(static_cast<std::uint64_t>(positive)) - 4;
        if constexpr (kIsShort)
            mantissa = reciprocal.template above_least<false>(positive, shift);
        else
            mantissa = reciprocal.of(positive, shift);
        if constexpr (kClamps) greatest_over_z = TexelOverZ::from_raw(positive * 4 - 4);
    }

    /// (u/z) * z; clamped to 0 to 65,535 texels if it may overflow.
    Texel times(TexelOverZ over_z) const requires(!kIsShort) {
        using Scaled = Fixed<std::int64_t, 60>;
        if constexpr (kClamps) over_z = clamp_value(over_z, {}, greatest_over_z);
        const std::int64_t product = std::int64_t{upper_half<kClamps>(over_z.raw, shift)} * mantissa;
        note_range<"u/z, normalised">(Scaled::from_raw(over_z.raw * (std::int64_t{1} << shift)));
        note_range<"u/z x reciprocal">(Scaled::from_raw(product));
        return Texel::from_raw(floor_shift(product, 30));
    }

    /// The same in steps, clamped to limits of 32 bits.
    std::uint32_t times(TexelOverZ over_z, Texel least, Texel greatest) const {
        if constexpr (kClamps || !native::kHasShortRegisters)
            return texel_within(times(over_z), least, greatest);
        else
            return short_times(over_z, least, greatest);
    }

  private:
    /// times() where a number of 64 bits takes two registers; `shift` is 1 or more here.
    std::uint32_t short_times(TexelOverZ over_z, Texel least, Texel greatest) const {
        const ShiftedUpper upper = native::shift_left(over_z.raw, shift);
        if (upper.is_below_zero) return static_cast<std::uint32_t>(least.raw);
        const std::uint32_t size = upper.bits, low = static_cast<std::uint32_t>(mantissa);
        std::uint64_t product = 0;
        if constexpr (kIsShort) {
            product = native::product_above_one(size, low);
        } else {
            const std::uint64_t lower = native::product_to_64(size, low);
            const std::uint32_t high = size * static_cast<std::uint32_t>(mantissa >> 32);
            product =
                std::uint64_t{high + static_cast<std::uint32_t>(lower >> 32)} << 32 | static_cast<std::uint32_t>(lower);
        }
        // In units of four steps: one comparison where the limits are not near.
        const auto first = static_cast<std::uint32_t>(least.raw), last = static_cast<std::uint32_t>(greatest.raw);
        const std::uint32_t first_4 = first / 4 + 1, count_4 = std::max(first_4, last / 4) - first_4;
        const auto steps = static_cast<std::uint32_t>(upper_half<false>(static_cast<std::int64_t>(product), 2));
        const auto high = static_cast<std::uint32_t>(product >> 32);
        if (native::is_in_range(high, first_4, count_4)) [[likely]]
            return steps;
        return high > ~std::uint32_t{0} >> 2 ? last : clamp_value(steps, first, last);
    }
};

template <class Reciprocal, PerspectiveRange Range>
inline TexelPosition texel_of(const Perspective& at, const Depth<Reciprocal, Range>& depth, const TexelLimits& limits) {
    return {depth.times(at.u_over_z, limits.least, limits.greatest_u),
            depth.times(at.v_over_z, limits.least, limits.greatest_v)};
}

}  // namespace oblong
