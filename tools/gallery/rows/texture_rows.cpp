// Seed 3 (Notes): pictures on surfaces, in 256 colours.

#include "engine/pictures/picture.h"
#include "tools/gallery/canvas.h"

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
    canvas.fill(kGround);
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

}  // namespace

std::vector<Row> texture_rows() {
    return {{"texture-quantise", draw_quantisation, {choice_parameter("palette", {"224 colours", "16 greys"})}}};
}

}  // namespace oblong
