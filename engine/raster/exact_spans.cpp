#include "engine/raster/exact_spans.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

#include "engine/raster/block_steps.h"
#include "engine/raster/kernels/near_borders.h"

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

/// The texel of a pixel by a division, by Depth's arithmetic where nothing is clamped.
struct DividedTexel {
    std::int64_t inverse_z_28, depth;  ///< the upper half of 1/z, and 2^60 / it
    std::int64_t u_46, v_46;
};

/// 1/z, u/z and v/z over an octave, brought to 60 bits; modulo 2^64, as long as the values at its pixels fit.
class OctaveRow {
  public:
    OctaveRow(const Octave& octave, std::int32_t row, const TextureGradients& gradients, const SurfaceView& surface)
        : inverse_z_(gradients.inverse_z, octave, row),
          u_over_z_(gradients.u_over_z, octave, row),
          v_over_z_(gradients.v_over_z, octave, row),
          texels_(surface.texels),
          u_mask_(surface.u_mask),
          row_mask_(std::uint64_t{surface.v_mask} << surface.stride_log2),
          stride_log2_(surface.stride_log2) {}

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

    /// A division a pixel and nothing else.
    void draw_divided(std::int32_t first, std::int32_t end, std::uint8_t* out) const {
        std::uint64_t inverse_z = inverse_z_.at(first), u_over_z = u_over_z_.at(first), v_over_z = v_over_z_.at(first);
        const auto upper_half = [](std::uint64_t value) { return static_cast<std::int64_t>(value) >> 32; };
        const OctaveRow row = *this;  // a copy that no pixel written can change: it stays in registers
        for (std::uint8_t* pixel = out + first; pixel != out + end; ++pixel) {
            const std::int64_t depth = depth_of(upper_half(inverse_z));
            *pixel = row.colour_at({0, depth, upper_half(u_over_z) * depth, upper_half(v_over_z) * depth});
            inverse_z += row.inverse_z_.step;
            u_over_z += row.u_over_z_.step;
            v_over_z += row.v_over_z_.step;
        }
    }

  private:
    static std::int64_t depth_of(std::int64_t inverse_z_28) {
        return static_cast<std::int64_t>((std::uint64_t{1} << 60) / static_cast<std::uint64_t>(inverse_z_28));
    }

    struct Scaled {
        std::uint64_t first, step;

        template <class Value>
        Scaled(const LinearQuantity<Value>& quantity, const Octave& octave, std::int32_t row)
            : first(static_cast<std::uint64_t>(quantity.at(octave.first, row).raw) << octave.shift),
              step(static_cast<std::uint64_t>(quantity.per_column.raw) << octave.shift) {}
        std::uint64_t at(std::int32_t pixel) const { return first + step * static_cast<std::uint64_t>(pixel); }
        std::int64_t upper_half(std::int32_t pixel) const { return static_cast<std::int64_t>(at(pixel)) >> 32; }
    };

    Scaled inverse_z_, u_over_z_, v_over_z_;
    const std::uint8_t* texels_;
    std::uint64_t u_mask_, row_mask_;
    int stride_log2_;
};

/// Texels, 16.16.
TexelPosition position_of(const DividedTexel& texel) {
    return {static_cast<std::uint32_t>(texel.u_46 >> 30), static_cast<std::uint32_t>(texel.v_46 >> 30)};
}

/// Pixels of an octave between two that are divided, the first of which is one of them.
struct Piece {
    DividedTexel from, to;
    std::int32_t count;
};

/// By how many units of 2^-16 texel the line between a piece's ends may be off a pixel's own texel coordinates.
///
/// On the way from one end to the other a Moebius function leaves its chord by (sqrt k - 1) / (sqrt k + 1) <= (k - 1) /
/// 4 of the way, k being the ratio of the ends' 1/z. Rounding 1/z to 28 bits moves a texel by a 2^-27th, 32 units at
/// 65,536 texels; rounding u/z by 8 units more, and to 16 bits by one: so ends and pixel are each within 41 units of
/// the truth, and the true way is 82 longer at most, of which a quarter counts, since k < 2. The step, floored, loses
/// less than a unit a pixel.
std::int64_t line_error_16(const Piece& piece) {
    constexpr std::int64_t kRounding_16 = 41 + 41 + 21;
    const TexelPosition from = position_of(piece.from), to = position_of(piece.to);
    const std::int64_t rise_28 = std::abs(piece.to.inverse_z_28 - piece.from.inverse_z_28) + 1;
    const std::int64_t ratio_28 = (rise_28 * (std::max(piece.from.depth, piece.to.depth) + 1) >> 32) + 1;
    const std::int64_t way_16 =
        std::max(std::abs(std::int64_t{to.u_16} - from.u_16), std::abs(std::int64_t{to.v_16} - from.v_16));
    return (way_16 * ratio_28 >> 30) + 1 + kRounding_16 + piece.count;
}

/// Pieces whose texels lie almost on a line wait to be drawn by a kernel.
class LinePieces {
  public:
    LinePieces(const OctaveRow& row, BlockKernel kernel, const SurfaceView& surface, std::uint8_t* out)
        : row_(row), kernel_(kernel), surface_(surface), out_(out) {}

    /// From a pixel of the octave on.
    void add(const Piece& piece, std::int32_t pixel, std::int64_t error_16) {
        if (count_ == blocks_.size()) draw();
        const TexelPosition from = position_of(piece.from);
        const TexelStep step = steps_by_division(from, position_of(piece.to), piece.count);
        errors_16_[count_] = static_cast<std::uint32_t>(error_16);
        blocks_[count_++] = {
            static_cast<std::uint32_t>(pixel), piece.count, from.u_16, from.v_16, step.u_16, step.v_16};
    }
    /// On lines, but where they are so near the border of a texel that a pixel's own may be the next.
    void draw() {
        if (count_ == 0) return;
        kernel_(std::span(blocks_).first(count_), surface_, out_);
        for (std::size_t i = 0; i < count_; ++i)
            for (std::uint64_t near = pixels_near_borders(blocks_[i], errors_16_[i]); near != 0; near &= near - 1) {
                const auto pixel = static_cast<std::int32_t>(blocks_[i].pixel) + std::countr_zero(near);
                out_[pixel] = row_.colour_at(row_.at(pixel));
            }
        count_ = 0;
    }

  private:
    const OctaveRow& row_;
    const BlockKernel kernel_;
    const SurfaceView& surface_;
    std::uint8_t* const out_;
    std::size_t count_ = 0;
    std::array<TexelBlock, 32> blocks_;
    std::array<std::uint32_t, 32> errors_16_;
};

constexpr std::int32_t kShortestPiece = 4, kLongestPiece = 32;

/// How a face's pieces have been so far.
struct PieceLengths {
    std::int32_t next = kShortestPiece;  ///< pixels: twice as long after a piece whose error was small
    std::int32_t divided = 0;            ///< pixels that are divided one by one before the next piece is tried ...
    std::int32_t patience = 256;  ///< ... where not even the shortest one is almost a line: twice as many each time
};

/// The same bytes as by a division at each pixel, with two for each piece whose texels lie almost on a line. `out` is
/// the octave's first pixel.
void draw_octave(const Octave& octave, const OctaveRow& row, BlockKernel kernel, const SurfaceView& surface,
                 PieceLengths& lengths, std::uint8_t* out) {
    constexpr std::int64_t kMost_16 = 2048;  // beyond, too many pixels would be near a border
    const std::int32_t end = octave.end - octave.first;
    if (!kernel) return row.draw_divided(0, end, out);
    LinePieces pieces(row, kernel, surface, out);
    for (std::int32_t pixel = 0; pixel < end;) {
        const std::int32_t left = end - 1 - pixel, count = left < 2 * lengths.next ? left : lengths.next;
        if (lengths.divided > 0 || count < kShortestPiece) {
            const std::int32_t divided_end = std::min(pixel + std::max(lengths.divided, kShortestPiece), end);
            row.draw_divided(pixel, divided_end, out);
            lengths.divided = std::max(lengths.divided - (divided_end - pixel), 0);
            pixel = divided_end;
            continue;
        }
        const Piece piece{row.at(pixel), row.at(pixel + count), count};
        const std::int64_t error_16 = line_error_16(piece);
        if (error_16 <= kMost_16) {
            pieces.add(piece, pixel, error_16);
            pixel += count;
            lengths.patience = PieceLengths{}.patience;
            if (error_16 < kMost_16 / 8) lengths.next = std::min(lengths.next * 2, kLongestPiece);
        } else if (count / 2 >= kShortestPiece) {
            lengths.next = count / 2;
        } else {
            lengths = {kShortestPiece, lengths.patience, std::min(lengths.patience * 2, 65536)};
        }
    }
    pieces.draw();
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
                      const SurfaceView& surface, BlockKernel kernel, Framebuffer out) {
    PieceLengths lengths;
    for (const Span& span : spans) {
        std::uint8_t* const row = out.row(span.y);
        for (std::int32_t column = span.first; column < span.end;) {
            const Octave octave =
                octave_from(column, span.end, gradients.inverse_z.at(column, span.y), gradients.inverse_z.per_column);
            if (needs_no_clamp(octave, span.y, gradients, limits)) {
                const OctaveRow divided(octave, span.y, gradients, surface);
                draw_octave(octave, divided, kernel, surface, lengths, row + octave.first);
            } else {
                draw_clamped(octave, span.y, gradients, limits, surface, row);
            }
            column = octave.end;
        }
    }
}

}  // namespace oblong
