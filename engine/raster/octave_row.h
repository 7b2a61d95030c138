#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "engine/base/table.h"
#include "engine/fixed/divide.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/raster/texture_blocks.h"

namespace oblong {

/// value * 2^bits modulo 2^64: steps may wrap if the values at the pixels fit.
inline std::int64_t shifted_up(std::int64_t value, int bits) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << bits);
}

/// Pixels of a row where 1/z has the same number of bits.
struct Octave {
    std::int32_t first, end;
    int shift;  ///< brings 1/z to 60 bits, as in Depth; negative: 1/z has to be clamped
};

/// Starts at `first` and ends at `end` at the latest.
inline Octave octave_from(std::int32_t first, std::int32_t end, InverseZ inverse_z, InverseZ step) {
    if (inverse_z < kLeastInverseZ || inverse_z >= kGreatestInverseZ) return {first, first + 1, -1};
    const int shift = std::countl_zero(inverse_z.bits()) - 4;
    if (step == InverseZ{}) return {first, end, shift};
    // Most spans are one octave; this test for it needs no division. Steps of a unit a pixel or more may wrap.
    const InverseZ last = stepped(inverse_z, step, end - 1 - first);
    const std::uint64_t differing_bits = inverse_z.bits() ^ last.bits();
    if (is_within(step, InverseZ::from_int(1)) && differing_bits >> (59 - shift) == 0) return {first, end, shift};
    const InverseZ least = InverseZ::from_raw(std::int64_t{1} << (59 - shift));
    const InverseZ room = step > InverseZ{} ? least * 2 - InverseZ::ulp() - inverse_z : inverse_z - least;
    return {first, static_cast<std::int32_t>(std::min<std::int64_t>(end, first + room / absolute(step) + 1)), shift};
}

/// The texel of a pixel by a division, in Depth's arithmetic without clamping.
struct DividedTexel {
    std::int64_t inverse_z_28, depth;  ///< the upper half of 1/z, and 2^60 / that
    std::int64_t u_46, v_46;
};

/// Values shared by the pixels of a column, for surfaces whose 1/z is the same in all rows, as on walls in a
/// view without pitch and roll.
struct ColumnTexel {
    std::int64_t depth;  ///< DividedTexel's
    std::uint64_t u;     ///< column of texels, if u is also the same in all rows
};

/// 1/z, u/z and v/z over an octave, shifted to 60 bits, modulo 2^64; the values at its pixels must fit.
class OctaveRow {
  public:
    /// A quantity at the octave's first pixel, and its step.
    struct Scaled {
        std::uint64_t first, step;

        template <class Value>
        Scaled(const LinearQuantity<Value>& quantity, const Octave& octave, std::int32_t row)
            : first(quantity.at(octave.first, row).bits() << octave.shift),
              step(quantity.per_column.bits() << octave.shift) {}
        std::uint64_t at(std::int32_t pixel) const { return first + step * static_cast<std::uint64_t>(pixel); }
        std::int64_t upper_half(std::int32_t pixel) const { return static_cast<std::int64_t>(at(pixel)) >> 32; }
    };

    OctaveRow(const Octave& octave, std::int32_t row, const TextureGradients& gradients, const SurfaceView& surface)
        : inverse_z_(gradients.inverse_z, octave, row),
          u_over_z_(gradients.u_over_z, octave, row),
          v_over_z_(gradients.v_over_z, octave, row),
          texels_(surface.texels),
          u_mask_(surface.u_mask),
          row_mask_(std::uint64_t{surface.v_mask} << surface.stride_log2),
          stride_log2_(surface.stride_log2) {}

    const Scaled& inverse_z() const { return inverse_z_; }
    const Scaled& u_over_z() const { return u_over_z_; }
    const Scaled& v_over_z() const { return v_over_z_; }
    const std::uint8_t* texels() const { return texels_; }
    std::uint64_t u_mask() const { return u_mask_; }
    std::uint64_t row_mask() const { return row_mask_; }
    int stride_log2() const { return stride_log2_; }

    /// `pixel` counts from the octave's first.
    DividedTexel at(std::int32_t pixel) const {
        const std::int64_t inverse_z_28 = inverse_z_.upper_half(pixel);
        const std::int64_t depth = depth_of(inverse_z_28);
        return {inverse_z_28, depth, u_over_z_.upper_half(pixel) * depth, v_over_z_.upper_half(pixel) * depth};
    }
    std::uint8_t colour_at(const DividedTexel& texel) const {
        const auto u_46 = static_cast<std::uint64_t>(texel.u_46), v_46 = static_cast<std::uint64_t>(texel.v_46);
        return texels_[((v_46 >> (46 - stride_log2_)) & row_mask_) | ((u_46 >> 46) & u_mask_)];
    }

    /// Whether u and v at a pixel are within their limits in spite of rounding. Both are within 114,687 texels of 0
    /// (fits_range).
    bool is_well_within(std::int32_t pixel, const TexelLimits& limits) const {
        constexpr std::int64_t kMargin_16 = 128;
        const std::int64_t z = inverse_z_.upper_half(pixel), least = (limits.least.raw + kMargin_16) * z;
        const auto is_between = [&](std::int64_t over_z, Texel greatest) {
            const std::int64_t scaled = over_z * (std::int64_t{1} << 30);
            return scaled >= least && scaled <= (greatest.raw - kMargin_16) * z;
        };
        return is_between(u_over_z_.upper_half(pixel), limits.greatest_u) &&
               is_between(v_over_z_.upper_half(pixel), limits.greatest_v);
    }

    /// Draws pixels with known depths; colour(row, texel) gives a pixel's colour.
    template <class Colour>
    void draw_at_depths(const ColumnTexel* columns, std::int32_t count, std::uint8_t* out, Colour colour) const {
        draw_pixels(
            0, count, out, [columns]() mutable { return columns++->depth; }, colour);
    }
    void draw_at_depths(const ColumnTexel* columns, std::int32_t count, std::uint8_t* out) const {
        draw_at_depths(columns, count, out, kPlain);
    }

    /// Draws pixels with known depths and columns of texels.
    void draw_columns(const ColumnTexel* columns, std::int32_t count, std::uint8_t* out) const {
        const OctaveRow row = *this;  // a copy, which pixel writes cannot alias, stays in registers
        std::uint64_t v_over_z = row.v_over_z_.first;
        const int to_row = 46 - row.stride_log2_;
        for (std::uint8_t* const end = out + count; out != end; ++out, ++columns, v_over_z += row.v_over_z_.step) {
            const auto v_46 = static_cast<std::uint64_t>(upper_half(v_over_z) * columns->depth);
            *out = row.texels_[((v_46 >> to_row) & row.row_mask_) | columns->u];
        }
    }

    /// Draws with one division a pixel, or one in all if 1/z is constant. colour(row, texel) gives a pixel's colour.
    /// Returns the number of divisions.
    template <class Colour>
    std::int32_t draw_divided(std::int32_t first, std::int32_t end, std::uint8_t* out, Colour colour) const {
        if (is_constant()) {
            const std::int64_t depth = depth_of(inverse_z_.upper_half(first));
            draw_pixels(
                first, end, out, [depth] { return depth; }, colour);
            return 1;
        }
        const auto next_depth = [inverse_z = inverse_z_.at(first), step = inverse_z_.step]() mutable {
            const std::int64_t depth = depth_of(upper_half(inverse_z));
            inverse_z += step;
            return depth;
        };
        draw_pixels(first, end, out, next_depth, colour);
        return end - first;
    }
    std::int32_t draw_divided(std::int32_t first, std::int32_t end, std::uint8_t* out) const {
        return draw_divided(first, end, out, kPlain);
    }

    /// Whether 1/z is the same in all columns, as on floors in a view without pitch and roll.
    bool is_constant() const { return inverse_z_.step == 0; }

    /// 2^60 / the upper half of 1/z.
    static std::int64_t depth_of(std::int64_t inverse_z_28) {
        return static_cast<std::int64_t>(
            divide(std::uint64_t{1} << 60, static_cast<std::uint64_t>(inverse_z_28)).quotient);
    }

  private:
    static constexpr auto kPlain = [](const auto& row, const DividedTexel& texel) { return row.colour_at(texel); };

    static std::int64_t upper_half(std::uint64_t value) { return static_cast<std::int64_t>(value) >> 32; }

    template <class NextDepth, class Colour>
    void draw_pixels(std::int32_t first, std::int32_t end, std::uint8_t* out, NextDepth next_depth,
                     Colour colour) const {
        std::uint64_t u_over_z = u_over_z_.at(first), v_over_z = v_over_z_.at(first);
        const OctaveRow row = *this;  // a copy, which pixel writes cannot alias, stays in registers
        for (std::uint8_t* pixel = out + first; pixel != out + end; ++pixel) {
            const std::int64_t depth = next_depth();
            *pixel = colour(row, {0, depth, upper_half(u_over_z) * depth, upper_half(v_over_z) * depth});
            u_over_z += row.u_over_z_.step;
            v_over_z += row.v_over_z_.step;
        }
    }

    Scaled inverse_z_, u_over_z_, v_over_z_;
    const std::uint8_t* texels_;
    std::uint64_t u_mask_, row_mask_;
    int stride_log2_;
};

/// The colours of a surface that warps.
struct WarpedColours {
    const WarpTable& warp;

    std::uint8_t operator()(const OctaveRow& row, const DividedTexel& texel) const {
        const auto u_16 = static_cast<std::uint32_t>(texel.u_46 >> 30),
                   v_16 = static_cast<std::uint32_t>(texel.v_46 >> 30);
        const std::uint64_t u = (u_16 + shift_at(warp, v_16)) >> 16, v = (v_16 + shift_at(warp, u_16)) >> 16;
        return row.texels()[(v << row.stride_log2() & row.row_mask()) | (u & row.u_mask())];
    }
};

/// All columns of a surface whose 1/z is the same in all rows: one division a column.
class ColumnTexels {
  public:
    /// The most columns: 16 KB of the stack, of which DOS has 192.
    static constexpr std::int32_t kMost = 1024;

    ColumnTexels(const TextureGradients& gradients, const SurfaceView& surface, const ScreenRectangle& columns)
        : first_(columns.first_column) {
        for (std::int32_t column = first_; column < columns.end_column; ++column) {
            const InverseZ inverse_z = gradients.inverse_z.at(column, columns.first_row);
            const Octave octave = octave_from(column, column + 1, inverse_z, {});
            if (octave.shift < 0) continue;
            const std::int64_t depth = OctaveRow::depth_of(shifted_up(inverse_z.raw, octave.shift) >> 32);
            const TexelOverZ u_over_z = gradients.u_over_z.at(column, columns.first_row);
            const auto u_46 = static_cast<std::uint64_t>((shifted_up(u_over_z.raw, octave.shift) >> 32) * depth);
            oblong::item(texels_, column - first_) = {depth, (u_46 >> 46) & surface.u_mask};
        }
    }
    /// Those from `column` on; undefined where 1/z is clamped.
    const ColumnTexel* from(std::int32_t column) const { return texels_.data() + (column - first_); }

  private:
    std::int32_t first_;
    std::array<ColumnTexel, kMost> texels_;  ///< set in `columns` only
};

}  // namespace oblong
