#include "engine/effects/sky.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "engine/base/table.h"
#include "engine/fixed/root.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/view/gradients.h"

namespace oblong {

namespace {

constexpr int kLeastCellLog2 = 3, kGreatestCellLog2 = 6;
/// Texels from the zenith to the horizon in a 128-texel sky: Quake's 6 * (128 / 2 - 1).
constexpr std::int64_t kDomeRadius_texels = 378;

/// The positions of the layers at one time.
struct SkyScroll {
    std::int64_t background_16;   ///< texels, 16.16, along both axes
    std::int32_t clouds_further;  ///< relative to the background, whole texels
};

SkyScroll scroll_at(std::int64_t time_ms, std::int32_t size) {
    const std::int64_t background_16 = time_ms % kSkyPeriod_ms * size * 65536 / kSkyPeriod_ms;
    return {background_16, static_cast<std::int32_t>(background_16 >> 16)};
}

/// Texels, 16.16.
struct SkyPosition {
    std::int64_t u_16, v_16;
};

/// Maps directions to texels of a sky.
class Dome {
  public:
    Dome(std::int32_t size, std::int64_t offset_16)
        : radius_texels_(kDomeRadius_texels * size / 128), offset_16_(offset_16) {}

    /// Of a direction of view, of any length.
    SkyPosition at(const Vec3<DirectionPart>& direction) const {
        const std::int64_t x_16 = floor_of<16>(direction.x), y_16 = floor_of<16>(direction.y);
        const std::int64_t z_16 = floor_of<16>(direction.z) * 3;
        const auto square = static_cast<std::uint64_t>(x_16 * x_16 + y_16 * y_16 + z_16 * z_16);
        const ReciprocalRoot root = reciprocal_root(std::max<std::uint64_t>(square, 1));
        return {texels_of(x_16, root), texels_of(y_16, root)};
    }

  private:
    std::int64_t texels_of(std::int64_t part_16, const ReciprocalRoot& root) const {
        const std::int64_t cosine_30 = floor_shift(part_16 * root.mantissa, root.shift);
        return floor_shift(cosine_30 * radius_texels_, 14) + offset_16_;
    }

    std::int64_t radius_texels_, offset_16_;
};

/// The length of cells, in which texels are interpolated along a row: the longest whose error is below a texel of a
/// 128-texel sky.
///
/// Linear interpolation over n pixels has an error of n^2 / 8 times the largest second derivative along the row. With
/// all heights tripled, the directions of a row are A + x B, where x is the column / multiplier: a line at the distance
/// p = |A x B| / |B| from the eye. Its directions turn by an angle of tangent x |B| / p, so the dome's second
/// derivative is at most radius |B|^2 / p^2 = radius |B|^4 / |A x B|^2, per multiplier^2. p is large for rows high in
/// the sky.
class CellLengths {
  public:
    CellLengths(const Basis& axes, const Projection& projection, const ViewDirections& directions)
        : directions_(directions), middle_column_(projection.width_px / 2) {
        along_15_ = {floor_of<15>(axes.right.x), floor_of<15>(axes.right.y), floor_of<15>(axes.right.z) * 3};
        const std::int64_t square_15 = squared_length_30(along_15_) >> 15;
        // May be less than a sixteenth pixel in small modes; then all cells have the least length.
        const std::int64_t pixels_4 =
            std::clamp(floor_of<4>(projection.x.multiplier), std::int64_t{1}, std::int64_t{kLargestMode_px} << 4);
        for (int log2 = kLeastCellLog2 + 1; log2 <= kGreatestCellLog2; ++log2) {
            const std::int64_t bend_34 = (kDomeRadius_texels << 2 * log2) * (square_15 + 1) * (square_15 + 1) * 32;
            const std::int64_t least_30 = bend_34 / (pixels_4 * pixels_4);
            item(least_squares_30_, log2) = least_30 + (least_30 >> 8) + 1;  // more than rounding errors
        }
    }

    int log2_of(std::int32_t row) const {
        const Vec3<DirectionPart> middle = directions_.at(middle_column_, row);
        const Parts a{floor_of<15>(middle.x), floor_of<15>(middle.y), floor_of<15>(middle.z) * 3};
        const Parts& b = along_15_;
        const std::int64_t square_30 = squared_length_30(
            {(a.y * b.z - a.z * b.y) >> 15, (a.z * b.x - a.x * b.z) >> 15, (a.x * b.y - a.y * b.x) >> 15});
        int log2 = kLeastCellLog2;
        while (log2 < kGreatestCellLog2 && square_30 >= item(least_squares_30_, log2 + 1)) ++log2;
        return log2;
    }

  private:
    using Parts = Vec3<std::int64_t>;
    static std::int64_t squared_length_30(const Parts& parts_15) {
        return parts_15.x * parts_15.x + parts_15.y * parts_15.y + parts_15.z * parts_15.z;
    }

    const ViewDirections& directions_;
    std::int32_t middle_column_;
    Parts along_15_;
    std::array<std::int64_t, kGreatestCellLog2 + 1> least_squares_30_{};  ///< least |A x B|^2 for cells of this length
};

/// Walks along a row from cell to cell. Cells begin at multiples of their length, not where spans begin, so that the
/// sky does not change when something covers a part of it.
class CellWalk {
  public:
    CellWalk(const Dome& dome, const ViewDirections& directions, int cell_log2, std::int32_t column, std::int32_t row)
        : dome_(dome),
          cell_log2_(cell_log2),
          per_cell_{directions.x.per_column * (std::int64_t{1} << cell_log2),
                    directions.y.per_column * (std::int64_t{1} << cell_log2),
                    directions.z.per_column * (std::int64_t{1} << cell_log2)},
          direction_(directions.at(column, row)),
          to_(dome.at(direction_)) {}

    /// The next cell's pixels from `first` on.
    TexelBlock next(std::uint32_t pixel, std::int32_t first, std::int32_t count) {
        const SkyPosition from = to_;
        direction_ = direction_ + per_cell_;
        to_ = dome_.at(direction_);
        const std::int64_t u_step = floor_shift(to_.u_16 - from.u_16, cell_log2_);
        const std::int64_t v_step = floor_shift(to_.v_16 - from.v_16, cell_log2_);
        return {pixel,
                count,
                static_cast<std::uint32_t>(from.u_16 + u_step * first),
                static_cast<std::uint32_t>(from.v_16 + v_step * first),
                static_cast<std::int32_t>(u_step),
                static_cast<std::int32_t>(v_step)};
    }

  private:
    const Dome dome_;
    const int cell_log2_;
    const Vec3<DirectionPart> per_cell_;
    Vec3<DirectionPart> direction_;
    SkyPosition to_;
};

/// Constant during a frame.
struct DomeView {
    Dome dome;
    const ViewDirections& directions;
    CellLengths cells;
};

TexelBlock* append_cells(const Span& span, const DomeView& view, std::int32_t pitch, TexelBlock* blocks) {
    const int cell_log2 = view.cells.log2_of(span.y);
    const std::int32_t size_px = 1 << cell_log2, start = span.first & -size_px;
    CellWalk walk(view.dome, view.directions, cell_log2, start, span.y);
    for (std::int32_t cell = start; cell < span.end; cell += size_px) {
        const std::int32_t first = std::max(cell, span.first), end = std::min(cell + size_px, span.end);
        *blocks++ = walk.next(static_cast<std::uint32_t>(span.y * pitch + first), first - cell, end - first);
    }
    return blocks;
}

/// Cuts spans into blocks and passes them to `draw`, some hundred at a time. Returns the number of blocks.
template <class Draw>
std::int64_t draw_cells(std::span<const Span> spans, const DomeView& view, std::int32_t pitch, Draw draw) {
    constexpr std::int32_t kMostOfSpan = (kLargestMode_px >> kLeastCellLog2) + 1;
    std::array<TexelBlock, kMostOfSpan + 256> blocks;
    TexelBlock* end = blocks.data();
    std::int64_t count = 0;
    const auto draw_waiting = [&] {
        draw(std::span<const TexelBlock>(blocks.data(), end));
        count += end - blocks.data();
        end = blocks.data();
    };
    for (const Span& span : spans) {
        if (end - blocks.data() > 256) draw_waiting();
        end = append_cells(span, view, pitch, end);
    }
    draw_waiting();
    return count;
}

/// Eight bytes of `front`, or of `back` where `front` is 0: adding 127 leaves the highest bit clear only for 0.
void overlay_8(const std::uint8_t* front, const std::uint8_t* back, std::uint8_t* out) {
    constexpr std::uint64_t kOnes = 0x0101010101010101;
    std::uint64_t above, below;
    std::memcpy(&above, front, 8);
    std::memcpy(&below, back, 8);
    const std::uint64_t is_set = (((above & kOnes * 127) + kOnes * 127) | above) >> 7 & kOnes;
    above |= below & ~(is_set * 255);
    std::memcpy(out, &above, 8);
}

/// The same for any number of bytes; the last eight may overlap those before.
void overlay(const std::uint8_t* front, const std::uint8_t* back, std::int32_t count, std::uint8_t* out) {
    if (count < 8) {
        for (std::int32_t i = 0; i < count; ++i) out[i] = front[i] != 0 ? front[i] : back[i];
        return;
    }
    for (std::int32_t i = 0; i < count - 8; i += 8) overlay_8(front + i, back + i, out + i);
    overlay_8(front + count - 8, back + count - 8, out + count - 8);
}

/// Combines both layers in one texture, the clouds shifted against the background.
void compose_layers(const SkyTexture& sky, std::int32_t clouds_further, std::uint8_t* out) {
    const std::int32_t until_edge = sky.size - clouds_further;
    for (std::int32_t v = 0; v < sky.size; ++v, out += sky.size) {
        const std::uint8_t* const clouds = sky.texels + ((v + clouds_further) & (sky.size - 1)) * sky.stride;
        const std::uint8_t* const background = sky.texels + v * sky.stride + sky.size;
        overlay(clouds + clouds_further, background, until_edge, out);
        overlay(clouds, background + until_edge, clouds_further, out + until_edge);
    }
}

SurfaceView tile_of(std::span<const std::uint8_t> texels, std::int32_t size) {
    const auto mask = static_cast<std::uint32_t>(size - 1);
    return {texels.data(), size, size, std::countr_zero(static_cast<std::uint32_t>(size)), mask, mask};
}

/// For skies too large to compose: looks up both layers at each pixel.
void draw_both_layers(std::span<const TexelBlock> blocks, const SkyTexture& sky, std::int32_t clouds_further,
                      std::uint8_t* pixels) {
    const auto mask = static_cast<std::uint32_t>(sky.size - 1), further = static_cast<std::uint32_t>(clouds_further);
    const auto texel = [&](std::uint32_t u, std::uint32_t v) {
        return sky.texels + static_cast<std::int64_t>(v & mask) * sky.stride + (u & mask);
    };
    for (const TexelBlock& block : blocks)
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(block.count); ++i) {
            const std::uint32_t u = (block.u_16 + static_cast<std::uint32_t>(block.u_step_16) * i) >> 16;
            const std::uint32_t v = (block.v_16 + static_cast<std::uint32_t>(block.v_step_16) * i) >> 16;
            const std::uint8_t cloud = *texel(u + further, v + further), behind = texel(u, v)[sky.size];
            const auto is_hole = static_cast<std::uint8_t>(-static_cast<int>(cloud == 0));  // without a branch
            pixels[block.pixel + i] = static_cast<std::uint8_t>(cloud | (behind & is_hole));
        }
}

/// Composing a texel takes a ninth of the time that a lookup of both layers adds to a pixel.
bool is_worth_composing(std::int64_t pixels, std::int32_t size) {
    return size <= 1024 && std::int64_t{size} * size <= 8 * pixels;
}

}  // namespace

SkyNow compose_sky(const SkyTexture& texture, std::int64_t time_ms, std::int64_t pixels, SkyLayers& layers) {
    const std::int32_t clouds_further = scroll_at(time_ms, texture.size).clouds_further;
    if (layers.texture != texture || layers.clouds_further != clouds_further) {
        if (!is_worth_composing(pixels, texture.size)) return {texture, time_ms, {}};
        layers.tile.resize(as_size(texture.size) * as_size(texture.size));
        compose_layers(texture, clouds_further, layers.tile.data());
        layers.texture = texture;
        layers.clouds_further = clouds_further;
    }
    return {texture, time_ms, layers.tile};
}

std::int64_t draw_sky(std::span<const Span> spans, const SkyNow& sky, const Basis& axes, const Projection& projection,
                      Framebuffer out, BlockKernel draw_blocks) {
    const std::int32_t size = sky.texture.size;
    const SkyScroll scroll = scroll_at(sky.time_ms, size);
    // Three times the size exceeds the dome's radius, so that no coordinate is negative.
    const Dome dome(size, scroll.background_16 + std::int64_t{3 * 65536} * size);
    const ViewDirections directions = make_view_directions(axes, projection);
    const DomeView view{dome, directions, CellLengths(axes, projection, directions)};
    if (sky.tile.empty())
        return draw_cells(spans, view, out.pitch, [&](std::span<const TexelBlock> blocks) {
            draw_both_layers(blocks, sky.texture, scroll.clouds_further, out.pixels);
        });
    const SurfaceView tile = tile_of(sky.tile, size);
    return draw_cells(spans, view, out.pitch,
                      [&](std::span<const TexelBlock> blocks) { draw_blocks(blocks, tile, out.pixels); });
}

}  // namespace oblong
