#include "engine/raster/exact_spans.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

#include "engine/raster/block_steps.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/raster/octave_row.h"
#include "engine/raster/perspective.h"

namespace oblong {

namespace {

std::uint8_t texel_from(const SurfaceView& surface, std::uint32_t u, std::uint32_t v) {
    return surface.texels[((v & surface.v_mask) << surface.stride_log2) + (u & surface.u_mask)];
}

/// Texels, 16.16.
TexelPosition position_of(const DividedTexel& texel) {
    return {static_cast<std::uint32_t>(texel.u_46 >> 30), static_cast<std::uint32_t>(texel.v_46 >> 30)};
}

/// `count` pixels of an octave: texels of the first pixel and of the one after the last are found by division.
struct Piece {
    DividedTexel from, to;
    std::int32_t count;
};

/// The largest error, in 2^-16 texel, of texture coordinates interpolated between a piece's ends.
///
/// A Moebius function differs from its chord by at most (sqrt k - 1) / (sqrt k + 1) <= (k - 1) / 4 of its change, k
/// being the ratio of the ends' 1/z. Rounding 1/z to 28 bits moves a texel by 2^-27 of its coordinate, 32 units at
/// 65,536 texels; rounding u/z by 8 units more, and to 16 bits by one. So ends and pixel are each within 41 units of
/// the exact value, and the exact change is at most 82 larger, of which a quarter counts, as k < 2. The floored step
/// loses less than a unit a pixel.
std::int64_t line_error_16(const Piece& piece) {
    constexpr std::int64_t kRounding_16 = 41 + 41 + 21;
    const TexelPosition from = position_of(piece.from), to = position_of(piece.to);
    const std::int64_t rise_28 = std::abs(piece.to.inverse_z_28 - piece.from.inverse_z_28) + 1;
    const std::int64_t ratio_28 = (rise_28 * (std::max(piece.from.depth, piece.to.depth) + 1) >> 32) + 1;
    const std::int64_t way_16 =
        std::max(std::abs(std::int64_t{to.u_16} - from.u_16), std::abs(std::int64_t{to.v_16} - from.v_16));
    return (way_16 * ratio_28 >> 30) + 1 + kRounding_16 + piece.count;
}

/// Collects pieces whose texture coordinates are almost linear, and draws them with a kernel.
class LinePieces {
  public:
    LinePieces(const OctaveRow& row, const Kernels& kernels, const SurfaceView& surface, std::uint8_t* out)
        : row_(row), kernels_(kernels), surface_(surface), out_(out) {}

    /// `pixel` counts from the octave's first.
    void add(const Piece& piece, std::int32_t pixel, std::int64_t error_16) {
        if (count_ == blocks_.size()) draw();
        const TexelPosition from = position_of(piece.from);
        const TexelStep step = steps_by_division(from, position_of(piece.to), piece.count);
        errors_16_[count_] = static_cast<std::uint32_t>(error_16);
        blocks_[count_++] = {
            static_cast<std::uint32_t>(pixel), piece.count, from.u_16, from.v_16, step.u_16, step.v_16};
    }
    /// Draws the pieces; pixels so near a texel's border that the exact texel may be the next are divided.
    void draw() {
        if (count_ == 0) return;
        kernels_.draw_blocks(std::span(blocks_).first(count_), surface_, out_);
        for (std::size_t i = 0; i < count_; ++i)
            for (std::uint64_t near = kernels_.pixels_near_borders(blocks_[i], errors_16_[i]); near != 0;
                 near &= near - 1) {
                const auto pixel = static_cast<std::int32_t>(blocks_[i].pixel) + std::countr_zero(near);
                out_[pixel] = row_.colour_at(row_.at(pixel));
                ++divisions_;
            }
        count_ = 0;
    }
    std::int64_t divisions() const { return divisions_; }  ///< made by draw()

  private:
    const OctaveRow& row_;
    const Kernels& kernels_;
    const SurfaceView& surface_;
    std::uint8_t* const out_;
    std::size_t count_ = 0;
    std::int64_t divisions_ = 0;
    std::array<TexelBlock, 32> blocks_;
    std::array<std::uint32_t, 32> errors_16_;
};

constexpr std::int32_t kShortestPiece = 4, kLongestPiece = 32;

/// The state of the search for a face's pieces.
struct PieceLengths {
    std::int32_t next = kShortestPiece;  ///< pixels; doubled after a piece with a small error
    std::int32_t divided = 0;            ///< pixels to divide one by one before the next piece is tried
    /// The next `divided`, if even the shortest piece is not almost linear; doubled each time.
    std::int32_t next_divided = 32;
};

/// Draws the same bytes as a division at each pixel would, with two divisions for each piece that is almost linear.
/// `out` is the octave's first pixel. Returns the number of divisions.
std::int64_t draw_octave(const Octave& octave, const OctaveRow& row, const Kernels* kernels, const SurfaceView& surface,
                         PieceLengths& lengths, std::uint8_t* out) {
    constexpr std::int64_t kMost_16 = 2048;  // above this, too many pixels are near a border
    const std::int32_t end = octave.end - octave.first;
    if (!kernels || row.is_constant()) return row.draw_divided(0, end, out);
    LinePieces pieces(row, *kernels, surface, out);
    std::int64_t divisions = 0;
    for (std::int32_t pixel = 0; pixel < end;) {
        const std::int32_t left = end - 1 - pixel, count = left < 2 * lengths.next ? left : lengths.next;
        if (lengths.divided > 0 || count < kShortestPiece) {
            const std::int32_t divided_end = std::min(pixel + std::max(lengths.divided, kShortestPiece), end);
            divisions += row.draw_divided(pixel, divided_end, out);
            lengths.divided = std::max(lengths.divided - (divided_end - pixel), 0);
            pixel = divided_end;
            continue;
        }
        const Piece piece{row.at(pixel), row.at(pixel + count), count};
        divisions += 2;
        const std::int64_t error_16 = line_error_16(piece);
        if (error_16 <= kMost_16) {
            pieces.add(piece, pixel, error_16);
            pixel += count;
            lengths.next_divided = PieceLengths{}.next_divided;
            if (error_16 < kMost_16 / 8) lengths.next = std::min(lengths.next * 2, kLongestPiece);
        } else if (count / 2 >= kShortestPiece) {
            lengths.next = count / 2;
        } else {
            lengths = {kShortestPiece, lengths.next_divided, std::min(lengths.next_divided * 2, 128)};
        }
    }
    pieces.draw();
    return divisions + pieces.divisions();
}

/// fits_range() for an octave; it allows steeper gradients.
bool is_in_range(const Octave& octave, std::int32_t row, const TextureGradients& gradients) {
    // Such steps do not wrap over a row of 4,096 pixels, so all values are between those of the ends.
    constexpr auto kSteepest = TexelOverZ::from_raw(std::int64_t{1} << 48);
    const auto fits = [&](std::int32_t column) {
        const Perspective at = Perspective::at(gradients, column, row);
        const auto beyond = TexelOverZ::from_raw(7 * at.inverse_z.raw);
        return is_within(at.u_over_z, beyond) && is_within(at.v_over_z, beyond);
    };
    return octave.shift >= 0 && is_within(gradients.u_over_z.per_column, kSteepest) &&
           is_within(gradients.v_over_z.per_column, kSteepest) && fits(octave.first) && fits(octave.end - 1);
}

/// An octave without the pixels at its ends that are not within the limits. These are linear in 1/z: if two pixels are
/// within them, so are all between.
Octave within_limits(const Octave& octave, const OctaveRow& row, const TexelLimits& limits) {
    std::int32_t first = 0, end = octave.end - octave.first;
    while (first < end && !row.is_well_within(first, limits)) ++first;
    while (first < end && !row.is_well_within(end - 1, limits)) --end;
    return {octave.first + first, octave.first + end, octave.shift};
}

/// Calls draw(octave, row, pixels) where nothing has to be clamped, and colour_at(position) for all other pixels.
/// Returns the number of divisions.
template <class DrawOctave, class ColourAt>
std::int64_t draw_octaves(std::span<const Span> spans, const BlockCutting& cutting, const SurfaceView& surface,
                          Framebuffer out, DrawOctave draw, ColourAt colour_at) {
    const TextureGradients& gradients = cutting.gradients;
    std::int64_t divisions = 0;
    for (const Span& span : spans) {
        std::uint8_t* const pixels = out.row(span.y);
        const auto draw_clamped = [&](std::int32_t first, std::int32_t end) {
            divisions += end - first;
            for (std::int32_t column = first; column < end; ++column)
                pixels[column] = colour_at(texel_at(gradients, cutting.limits, column, span.y));
        };
        for (std::int32_t column = span.first; column < span.end;) {
            const Octave octave =
                octave_from(column, span.end, gradients.inverse_z.at(column, span.y), gradients.inverse_z.per_column);
            if (!cutting.fits_range && !is_in_range(octave, span.y, gradients)) {
                draw_clamped(column, octave.end);
                column = octave.end;
                continue;
            }
            OctaveRow row(octave, span.y, gradients, surface);
            Octave within = octave;
            if (!row.is_well_within(0, cutting.limits) ||
                !row.is_well_within(octave.end - 1 - column, cutting.limits)) {
                within = within_limits(octave, row, cutting.limits);
                row = OctaveRow(within, span.y, gradients, surface);
            }
            draw_clamped(column, within.first);
            if (within.first < within.end) divisions += draw(within, row, pixels + within.first);
            draw_clamped(within.end, octave.end);
            column = octave.end;
        }
    }
    return divisions;
}

/// Whether the spans are in rows whose 1/z is the same, so that a column's division serves all of them.
bool shares_columns(std::span<const Span> spans, const TextureGradients& gradients) {
    if (spans.size() <= 1 || gradients.inverse_z.per_row != InverseZ{}) return false;
    const ScreenRectangle rectangle = rectangle_around(spans);
    return rectangle.end_column - rectangle.first_column <= ColumnTexels::kMost;
}

/// draw_octaves() for these: calls draw(row, columns, count, pixels).
template <class DrawColumns, class ColourAt>
std::int64_t draw_with_columns(std::span<const Span> spans, const BlockCutting& cutting, const SurfaceView& surface,
                               Framebuffer out, DrawColumns draw, ColourAt colour_at) {
    const ScreenRectangle rectangle = rectangle_around(spans);
    const ColumnTexels columns(cutting.gradients, surface, rectangle);
    const auto draw_octave = [&](const Octave& octave, const OctaveRow& row, std::uint8_t* pixels) {
        draw(row, columns.from(octave.first), octave.end - octave.first, pixels);
        return 0;
    };
    return rectangle.end_column - rectangle.first_column +
           draw_octaves(spans, cutting, surface, out, draw_octave, colour_at);
}

}  // namespace

std::int64_t draw_exact_spans(std::span<const Span> spans, const BlockCutting& cutting, const SurfaceView& surface,
                              const Kernels* kernels, Framebuffer out) {
    const TextureGradients& gradients = cutting.gradients;
    const auto colour_at = [&](TexelPosition texel) { return texel_from(surface, texel.u_16 >> 16, texel.v_16 >> 16); };
    if (shares_columns(spans, gradients)) {
        const bool is_upright = gradients.u_over_z.per_row == TexelOverZ{};
        const auto draw = [&](const OctaveRow& row, const ColumnTexel* columns, std::int32_t count,
                              std::uint8_t* pixels) {
            is_upright ? row.draw_columns(columns, count, pixels) : row.draw_at_depths(columns, count, pixels);
        };
        return draw_with_columns(spans, cutting, surface, out, draw, colour_at);
    }
    PieceLengths lengths;
    SurfaceView wrapping = surface;
    wrapping.holds_blocks = false;  // pieces are not cut to limits
    const auto draw = [&](const Octave& octave, const OctaveRow& row, std::uint8_t* pixels) {
        return draw_octave(octave, row, kernels, wrapping, lengths, pixels);
    };
    return draw_octaves(spans, cutting, surface, out, draw, colour_at);
}

std::int64_t draw_exact_warped_spans(std::span<const Span> spans, const BlockCutting& cutting,
                                     const EffectTexels& texels, Framebuffer out) {
    const SurfaceView& surface = texels.surface;
    const WarpTable& warp = *texels.warp;
    const auto colour_at = [&](TexelPosition texel) {
        const std::uint32_t u_16 = texel.u_16 + shift_at(warp, texel.v_16);
        return texel_from(surface, u_16 >> 16, (texel.v_16 + shift_at(warp, texel.u_16)) >> 16);
    };
    if (shares_columns(spans, cutting.gradients)) {
        const auto draw = [&](const OctaveRow& row, const ColumnTexel* columns, std::int32_t count,
                              std::uint8_t* pixels) {
            row.draw_at_depths(columns, count, pixels, WarpedColours{warp});
        };
        return draw_with_columns(spans, cutting, surface, out, draw, colour_at);
    }
    const auto draw = [&](const Octave& octave, const OctaveRow& row, std::uint8_t* pixels) {
        return row.draw_divided(0, octave.end - octave.first, pixels, WarpedColours{warp});
    };
    return draw_octaves(spans, cutting, surface, out, draw, colour_at);
}

}  // namespace oblong
