#include <algorithm>

#include "engine/base/table.h"
#include "game/saves/saved_game.h"

namespace oblong {
namespace {

// The columns or rows, at least one, that a pixel of the small picture covers.
PixelRange covered_by(std::int32_t index, std::int32_t small_px, std::int32_t large_px) {
    const auto edge = [&](std::int32_t i) { return static_cast<std::int32_t>(std::int64_t{i} * large_px / small_px); };
    const std::int32_t first = edge(index);
    return {first, std::max(first + 1, edge(index + 1))};
}

Rgb8 mean_colour(Framebuffer picture, const Palette& palette, PixelRange columns, PixelRange rows) {
    std::int64_t red = 0, green = 0, blue = 0;
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        for (std::int32_t x = columns.first; x < columns.end; ++x) {
            const Rgb8 colour = item(palette.colours, picture.row(y)[x]);
            red += colour.red, green += colour.green, blue += colour.blue;
        }
    const std::int64_t count = std::int64_t{columns.end - columns.first} * (rows.end - rows.first);
    const auto mean = [count](std::int64_t sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
    return {mean(red), mean(green), mean(blue)};
}

}  // namespace

Thumbnail make_thumbnail(Framebuffer picture, const Palette& palette) {
    Thumbnail thumbnail;
    auto pixel = thumbnail.pixels.begin();
    for (std::int32_t y = 0; y < Thumbnail::kHeight_px; ++y)
        for (std::int32_t x = 0; x < Thumbnail::kWidth_px; ++x)
            *pixel++ = mean_colour(picture, palette, covered_by(x, Thumbnail::kWidth_px, picture.width_px),
                                   covered_by(y, Thumbnail::kHeight_px, picture.height_px));
    return thumbnail;
}

}  // namespace oblong
