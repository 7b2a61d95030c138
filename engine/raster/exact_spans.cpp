#include "engine/raster/exact_spans.h"

#include <algorithm>
#include <bit>

namespace oblong {

namespace {

/// The fetch of all kernels.
std::uint8_t texel_from(const SurfaceView& surface, std::uint32_t u, std::uint32_t v) {
    return surface.texels[((v & surface.v_mask) << surface.stride_log2) + (u & surface.u_mask)];
}

/// 1/z, u/z and v/z from a pixel on.
struct RowPosition {
    InverseZ inverse_z;
    TexelOverZ u_over_z, v_over_z;

    RowPosition(const TextureGradients& gradients, std::int32_t column, std::int32_t row)
        : inverse_z(gradients.inverse_z.at(column, row)),
          u_over_z(gradients.u_over_z.at(column, row)),
          v_over_z(gradients.v_over_z.at(column, row)) {}
};

/// value * 2^bits modulo 2^64: steps need not fit, as long as the values that they lead to do.
std::int64_t shifted_up(std::int64_t value, int bits) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << bits);
}

/// Pixels of one row over which 1/z has the same number of bits.
struct Octave {
    std::int32_t first, end;
    int shift;  ///< that brings 1/z to 60 bits, as Depth does at each pixel; below 0: 1/z would have to be clamped
};

/// From `first` on, up to `end` at most.
Octave octave_from(std::int32_t first, std::int32_t end, InverseZ inverse_z, InverseZ step) {
    if (inverse_z < kLeastInverseZ || inverse_z >= kGreatestInverseZ) return {first, first + 1, -1};
    const int shift = std::countl_zero(static_cast<std::uint64_t>(inverse_z.raw)) - 4;
    if (step == InverseZ{}) return {first, end, shift};
    const std::int64_t least = std::int64_t{1} << (59 - shift);
    const std::int64_t room = step > InverseZ{} ? 2 * least - 1 - inverse_z.raw : inverse_z.raw - least;
    return {first, static_cast<std::int32_t>(std::min<std::int64_t>(end, first + room / absolute(step).raw + 1)),
            shift};
}

/// Whether u or v at a pixel is so far within its limits that rounding can't reach them. The limits are linear in 1/z:
/// what holds at both ends of a run holds between.
bool is_well_within(TexelOverZ over_z, InverseZ inverse_z, int shift, Texel least, Texel greatest) {
    constexpr Texel kMargin = Texel::from_raw(128);
    // 65,536 texels and more would not fit when shifted.
    if (over_z < TexelOverZ{} || over_z.raw >= inverse_z.raw * 4) return false;
    const std::int64_t texel_z = (shifted_up(over_z.raw, shift) >> 32) * (std::int64_t{1} << 30);
    const std::int64_t z = shifted_up(inverse_z.raw, shift) >> 32;
    return texel_z >= (least + kMargin).raw * z && texel_z <= (greatest - kMargin).raw * z;
}

bool is_well_within(const RowPosition& at, int shift, const TexelLimits& limits) {
    return is_well_within(at.u_over_z, at.inverse_z, shift, limits.least, limits.greatest_u) &&
           is_well_within(at.v_over_z, at.inverse_z, shift, limits.least, limits.greatest_v);
}

/// Steps in 64 bits, modulo 2^64.
class ShiftedStepper {
  public:
    ShiftedStepper(std::int64_t value, std::int64_t step, int shift)
        : value_(static_cast<std::uint64_t>(shifted_up(value, shift))),
          step_(static_cast<std::uint64_t>(shifted_up(step, shift))) {}

    std::int64_t upper_half() const { return static_cast<std::int64_t>(value_) >> 32; }
    void step() { value_ += step_; }

  private:
    std::uint64_t value_, step_;
};

/// A division a pixel and nothing else: Depth's arithmetic where nothing is clamped.
void draw_octave(const Octave& octave, std::int32_t row, const TextureGradients& gradients, const SurfaceView& surface,
                 std::uint8_t* out) {
    const RowPosition at(gradients, octave.first, row);
    ShiftedStepper inverse_z(at.inverse_z.raw, gradients.inverse_z.per_column.raw, octave.shift);
    ShiftedStepper u_over_z(at.u_over_z.raw, gradients.u_over_z.per_column.raw, octave.shift);
    ShiftedStepper v_over_z(at.v_over_z.raw, gradients.v_over_z.per_column.raw, octave.shift);
    const std::uint8_t* const texels = surface.texels;
    const std::int64_t u_mask = surface.u_mask, row_mask = std::int64_t{surface.v_mask} << surface.stride_log2;
    const int row_shift = 46 - surface.stride_log2;
    for (std::uint8_t* pixel = out + octave.first; pixel != out + octave.end; ++pixel) {
        const auto depth =
            static_cast<std::int64_t>((std::uint64_t{1} << 60) / static_cast<std::uint64_t>(inverse_z.upper_half()));
        const std::int64_t u_46 = u_over_z.upper_half() * depth, v_46 = v_over_z.upper_half() * depth;
        *pixel = texels[((v_46 >> row_shift) & row_mask) | ((u_46 >> 46) & u_mask)];
        inverse_z.step();
        u_over_z.step();
        v_over_z.step();
    }
}

void draw_clamped(const Octave& octave, std::int32_t row, const TextureGradients& gradients, const TexelLimits& limits,
                  const SurfaceView& surface, std::uint8_t* out) {
    for (std::int32_t column = octave.first; column < octave.end; ++column) {
        const TexelPosition texel = texel_at(gradients, limits, column, row);
        out[column] = texel_from(surface, texel.u_16 >> 16, texel.v_16 >> 16);
    }
}

/// Over a row of 4,096 pixels such steps do not wrap: values between two ends are between them.
bool is_gentle(const TextureGradients& gradients) {
    constexpr auto kSteepest = TexelOverZ::from_raw(std::int64_t{1} << 48);
    const TexelOverZ u = gradients.u_over_z.per_column, v = gradients.v_over_z.per_column;
    return u < kSteepest && u > -kSteepest && v < kSteepest && v > -kSteepest;
}

bool needs_no_clamp(const Octave& octave, std::int32_t row, const TextureGradients& gradients,
                    const TexelLimits& limits) {
    return octave.shift >= 0 && is_gentle(gradients) &&
           is_well_within(RowPosition(gradients, octave.first, row), octave.shift, limits) &&
           is_well_within(RowPosition(gradients, octave.end - 1, row), octave.shift, limits);
}

}  // namespace

void draw_exact_spans(std::span<const Span> spans, const TextureGradients& gradients, const TexelLimits& limits,
                      const SurfaceView& surface, Framebuffer out) {
    for (const Span& span : spans) {
        std::uint8_t* const row = out.row(span.y);
        for (std::int32_t column = span.first; column < span.end;) {
            const Octave octave =
                octave_from(column, span.end, gradients.inverse_z.at(column, span.y), gradients.inverse_z.per_column);
            if (needs_no_clamp(octave, span.y, gradients, limits))
                draw_octave(octave, span.y, gradients, surface, row);
            else
                draw_clamped(octave, span.y, gradients, limits, surface, row);
            column = octave.end;
        }
    }
}

}  // namespace oblong
