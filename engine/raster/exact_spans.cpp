#include "engine/raster/exact_spans.h"

#include <algorithm>
#include <bit>

namespace oblong {

namespace {

/// The fetch of all kernels.
std::uint8_t texel_from(const SurfaceView& surface, std::uint32_t u, std::uint32_t v) {
    return surface.texels[((v & surface.v_mask) << surface.stride_log2) + (u & surface.u_mask)];
}

/// 1/z, u/z and v/z from a pixel on, shifted so that 1/z has 60 bits, as Depth does at each pixel.
struct ShiftedRow {
    std::int64_t inverse_z, u_over_z, v_over_z;
    std::int64_t inverse_z_step, u_step, v_step;

    ShiftedRow(const TextureGradients& gradients, std::int32_t column, std::int32_t row, int shift) {
        const auto shifted = [shift](auto number) { return number.raw * (std::int64_t{1} << shift); };
        inverse_z = shifted(gradients.inverse_z.at(column, row));
        u_over_z = shifted(gradients.u_over_z.at(column, row));
        v_over_z = shifted(gradients.v_over_z.at(column, row));
        inverse_z_step = shifted(gradients.inverse_z.per_column);
        u_step = shifted(gradients.u_over_z.per_column);
        v_step = shifted(gradients.v_over_z.per_column);
    }

    void step() {
        inverse_z += inverse_z_step;
        u_over_z += u_step;
        v_over_z += v_step;
    }
};

/// Pixels of one row over which 1/z has the same number of bits.
struct Octave {
    std::int32_t first, end;
    int shift;  ///< that brings 1/z to 60 bits; below 0: 1/z is outside of what can be drawn without clamping
};

/// From `first` on, up to `end` at most.
Octave octave_from(std::int32_t first, std::int32_t end, InverseZ inverse_z, InverseZ step) {
    constexpr int kLeastShift = 0, kGreatestShift = 35;  // of 1/z from 2^24 to 2^60
    const int shift = std::countl_zero(static_cast<std::uint64_t>(inverse_z.raw)) - 4;
    if (shift < kLeastShift || shift > kGreatestShift) return {first, first + 1, -1};
    if (step == InverseZ{}) return {first, end, shift};
    const std::int64_t least = std::int64_t{1} << (59 - shift);
    const std::int64_t room = step > InverseZ{} ? 2 * least - 1 - inverse_z.raw : inverse_z.raw - least;
    return {first, static_cast<std::int32_t>(std::min<std::int64_t>(end, first + room / absolute(step).raw + 1)),
            shift};
}

/// Whether u or v at a pixel is so far within its limits that rounding can't reach them. The limits are linear in 1/z:
/// what holds at both ends of a run holds between.
bool is_well_within(std::int64_t over_z, std::int64_t inverse_z, Texel least, Texel greatest) {
    constexpr Texel kMargin = Texel::from_raw(128);
    const std::int64_t texel_z = (over_z >> 32) * (std::int64_t{1} << 30), z = inverse_z >> 32;
    return texel_z >= (least + kMargin).raw * z && texel_z <= (greatest - kMargin).raw * z;
}

bool is_well_within(const ShiftedRow& at, const TexelLimits& limits) {
    return is_well_within(at.u_over_z, at.inverse_z, limits.least, limits.greatest_u) &&
           is_well_within(at.v_over_z, at.inverse_z, limits.least, limits.greatest_v);
}

/// A division a pixel and nothing else: Depth's arithmetic where nothing is clamped.
void draw_octave(ShiftedRow at, const SurfaceView& surface, std::uint8_t* out, std::uint8_t* end) {
    const std::uint8_t* const texels = surface.texels;
    const std::int64_t u_mask = surface.u_mask, row_mask = std::int64_t{surface.v_mask} << surface.stride_log2;
    const int row_shift = 46 - surface.stride_log2;
    for (; out != end; ++out, at.step()) {
        const auto depth =
            static_cast<std::int64_t>((std::uint64_t{1} << 60) / static_cast<std::uint64_t>(at.inverse_z >> 32));
        const std::int64_t u_46 = (at.u_over_z >> 32) * depth, v_46 = (at.v_over_z >> 32) * depth;
        *out = texels[((v_46 >> row_shift) & row_mask) | ((u_46 >> 46) & u_mask)];
    }
}

void draw_clamped(const Octave& octave, std::int32_t row, const TextureGradients& gradients, const TexelLimits& limits,
                  const SurfaceView& surface, std::uint8_t* out) {
    for (std::int32_t column = octave.first; column < octave.end; ++column) {
        const TexelPosition texel = texel_at(gradients, limits, column, row);
        out[column] = texel_from(surface, texel.u_16 >> 16, texel.v_16 >> 16);
    }
}

bool needs_no_clamp(const Octave& octave, std::int32_t row, const TextureGradients& gradients,
                    const TexelLimits& limits) {
    return octave.shift >= 0 && is_well_within(ShiftedRow(gradients, octave.first, row, octave.shift), limits) &&
           is_well_within(ShiftedRow(gradients, octave.end - 1, row, octave.shift), limits);
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
                draw_octave({gradients, octave.first, span.y, octave.shift}, surface, row + octave.first,
                            row + octave.end);
            else
                draw_clamped(octave, span.y, gradients, limits, surface, row);
            column = octave.end;
        }
    }
}

}  // namespace oblong
