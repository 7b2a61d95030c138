// Seed 3 (Notes): textures in perspective, and pictures in 256 colours.

#include "engine/pictures/picture.h"
#include "tools/gallery/filled_triangle.h"

namespace oblong {

namespace {

constexpr ColourRange kGreys{0, 16};  ///< of the demo level's palette

/// Red, green and blue.
Vec channels_of(Rgb8 colour) {
    return {static_cast<double>(colour.red), static_cast<double>(colour.green), static_cast<double>(colour.blue)};
}

/// A picture of a ball before an evening sky, from the top left corner, (0, 0), to the bottom right one, (wide, 1).
Vec colour_at(double x, double y, double wide) {
    const double right = (x - wide / 2) / 0.34, down = (y - 0.52) / 0.34, square = right * right + down * down;
    const auto mixed = [](const Vec& from, const Vec& to, double part) { return from + (to - from) * part; };
    if (square >= 1) return mixed({18, 26, 74}, {226, 142, 84}, y * y);
    const double towards_light = (-0.5 * right - 0.6 * down + 0.62 * std::sqrt(1 - square));
    return mixed({34, 20, 40}, {240, 214, 176}, std::max(towards_light, 0.0));
}

std::uint8_t whole(double channel) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0, 255.0)));
}

PngImage make_picture(const Area& area, Ratio pixel, bool is_grey) {
    const double shape = number_of(pixel);
    const double wide = area.width * shape / area.height;
    PngImage image{area.width, area.height, {}, {}};
    for (std::int32_t y = 0; y < area.height; ++y)
        for (std::int32_t x = 0; x < area.width; ++x) {
            const Vec c = colour_at((x + 0.5) * shape / area.height, (y + 0.5) / area.height, wide);
            const Rgb8 colour{whole(c.x), whole(c.y), whole(c.z)};
            const std::uint8_t grey = whole(luminance_1000(colour) / 1000.0);
            image.colours.push_back({is_grey ? Rgb8{grey, grey, grey} : colour});
        }
    return image;
}

constexpr std::int32_t kBlock = 8;  ///< pixels a side

/// The error of the blocks' means, averaged over blocks and channels.
double block_error(const PngImage& image, const std::vector<std::uint8_t>& indices, const Palette& palette) {
    double sum = 0;
    int count = 0;
    for (std::int32_t top = 0; top + kBlock <= image.height_px; top += kBlock)
        for (std::int32_t left = 0; left + kBlock <= image.width_px; left += kBlock) {
            Vec off;
            for (std::int32_t i = 0; i < kBlock * kBlock; ++i) {
                const std::int32_t place = (top + i / kBlock) * image.width_px + left + i % kBlock;
                off = off + (channels_of(item(palette.colours, item(indices, place))) -
                             channels_of(item(image.colours, place).colour));
            }
            sum += (std::abs(off.x) + std::abs(off.y) + std::abs(off.z)) / (kBlock * kBlock);
            count += 3;
        }
    return sum / count;
}

/// The same picture with the nearest colours and dithered, side by side.
Figures draw_quantisation(const RowInput& input, Canvas& canvas) {
    const Palette& palette = input.assets.colormap.palette;
    const bool is_grey = input.values[0] == 1;
    const std::int32_t width = canvas.width_px / 2 - 6, top = kHeader_px + 4;
    const Area left{4, top, width, canvas.height_px - kFooter_px - top - 14};
    if (std::min(width, left.height) < kBlock) return {};
    const PngImage image = make_picture(left, input.mode.pixel(), is_grey);
    const auto error_by = [&](Dither dither, std::int32_t x, const char* name) {
        const auto indices = indices_of(image, palette, is_grey ? kGreys : kOrdinaryColours, dither);
        for (std::int32_t i = 0; i < image.width_px * image.height_px; ++i)
            set_pixel(canvas, x + i % width, top + i / width, item(indices, i));
        canvas.write(x, top + left.height + 4, name);
        return block_error(image, indices, palette);
    };
    const double nearest = error_by(Dither::None, left.x, "nearest colour"),
                 dithered = error_by(Dither::FloydSteinberg, canvas.width_px - 4 - width, "Floyd-Steinberg");
    return {{"mean error, dithered", "below half of " + decimal_text(nearest, "%.2f"), decimal_text(dithered, "%.2f"),
             dithered < nearest / 2},
            {"mean error, nearest colours", decimal_text(nearest, "%.2f")}};
}

/// A floor tile as two triangles: near side at depth 1, far side at depth `far`.
struct Tile {
    std::array<Vec, 4> corners;  ///< on the canvas: near left, near right, far right, far left
    double far_depth;
};
constexpr std::array<Vec, 4> kTexels{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// Both coordinates at a pixel: interpolated directly, or as u/z, v/z and divided by 1/z.
struct TileTexture {
    ScreenTriangle triangle;
    LinearQuantity<CornerQuantity> u, v, inverse_z;

    TileTexture(const Tile& tile, const std::array<int, 3>& corners, bool is_perspective) {
        std::array<CornerQuantity, 3> us, vs, inverses;
        for (std::size_t i = 0; i < 3; ++i) {
            const double over = is_perspective && corners[i] >= 2 ? 1 / tile.far_depth : 1;
            const Vec texel = item(kTexels, corners[i]) * over;
            triangle[i] = vertex_at(item(tile.corners, corners[i]));
            us[i] = fixed_of<CornerQuantity>(texel.x);
            vs[i] = fixed_of<CornerQuantity>(texel.y);
            inverses[i] = fixed_of<CornerQuantity>(over);
        }
        u = quantity_over(triangle, us);
        v = quantity_over(triangle, vs);
        inverse_z = quantity_over(triangle, inverses);
    }
    Vec at_pixel(std::int32_t x, std::int32_t y) const {
        const double over = number_of(inverse_z.at(x, y));
        return {number_of(u.at(x, y)) / over, number_of(v.at(x, y)) / over};
    }
};

constexpr std::array<std::array<int, 3>, 2> kHalves{{{0, 3, 2}, {0, 2, 1}}};

void draw_tile(const Tile& tile, bool is_perspective, Canvas& canvas) {
    const std::array colours{canvas.input.colour({196, 176, 136}), canvas.input.colour({72, 56, 48})};
    for (const auto& half : kHalves) {
        const TileTexture texture(tile, half, is_perspective);
        fill_triangle(texture.triangle, canvas, [&](std::int32_t x, std::int32_t y) {
            const Vec texel = texture.at_pixel(x, y);
            return item(colours,
                        (static_cast<int>(std::floor(texel.x * 8)) + static_cast<int>(std::floor(texel.y * 8))) & 1);
        });
    }
}

/// The texel half way up the left side of the screen, between depth 1 and `far`: v is 0 to 1 along it.
double middle_of_side(double far_depth, bool is_perspective) {
    const Tile tile{{{{0.5, 64.5}, {40.5, 64.5}, {30.5, 0.5}, {0.5, 0.5}}}, far_depth};
    return TileTexture(tile, kHalves[0], is_perspective).at_pixel(0, 32).y;
}

Figures draw_perspective(const RowInput& input, Canvas& canvas) {
    const double far_depth = input.number(0), half = canvas.width_px / 2.0, near_y = canvas.height_px - kFooter_px - 4,
                 horizon = kHeader_px + 6, far_y = horizon + (near_y - horizon) / far_depth;
    canvas.fill(kNight);
    for (const bool is_perspective : {false, true}) {
        const double middle = half * (is_perspective ? 1.5 : 0.5), across = half * 0.47, far = across / far_depth;
        draw_tile(
            {{{{middle - across, near_y}, {middle + across, near_y}, {middle + far, far_y}, {middle - far, far_y}}},
             far_depth},
            is_perspective, canvas);
        canvas.write(static_cast<std::int32_t>(middle - half / 2) + kTextMargin_px, kHeader_px + 2,
                     is_perspective ? "u/z, v/z, 1/z" : "u, v");
    }
    return {{"u half way along an edge, by u/z and 1/z", 1 / (1 + far_depth), middle_of_side(far_depth, true), 1e-6},
            {"u half way along an edge, by u itself", 0.5, middle_of_side(far_depth, false), 1e-6}};
}

}  // namespace

std::vector<Row> texture_rows() {
    return {{"perspective-correct", draw_perspective, {{"far depth", 2, 9, 1, 3}}},
            {"texture-quantise", draw_quantisation, {{"palette", {"224 colours", "16 greys"}}}}};
}

}  // namespace oblong
