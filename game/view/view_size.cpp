#include "game/view/view_size.h"

#include <algorithm>

#include "engine/view/projection.h"

namespace oblong {

// An even part of an even picture, so that columns can be doubled and it is in the middle.
PlacedView place_view(const ScreenMode& picture, const ViewSize& size) {
    const auto part = [&](std::int32_t whole_px) {
        return size.size_100 >= 100 ? whole_px : std::max(whole_px * size.size_100 / 200, 1) * 2;
    };
    const std::int32_t width_px = part(picture.width_px) & ~int{size.doubles_columns};
    const std::int32_t height_px = part(picture.height_px);
    const Area area{(picture.width_px - width_px) / 2, (picture.height_px - height_px) / 2, width_px, height_px};
    const Ratio display = picture.display * Ratio{width_px, picture.width_px} * Ratio{picture.height_px, height_px};
    return {area, {size.doubles_columns ? width_px / 2 : width_px, height_px, display.reduced()}};
}

ViewSize drawable_size(const PicturePreferences& picture) {
    const ScreenMode mode = place_view(picture.mode, picture).mode;
    const bool is_possible = std::min(mode.width_px, mode.height_px) > 0 &&
                             is_drawable(make_projection(mode, picture.field_of_view, picture.corrects_projection));
    return is_possible ? static_cast<const ViewSize&>(picture) : ViewSize{};
}

void double_columns(Framebuffer drawn, Framebuffer shown) {
    for (std::int32_t y = 0; y < drawn.height_px; ++y) {
        const std::uint8_t* const from = drawn.row(y);
        std::uint8_t* to = shown.row(y);
        for (std::int32_t x = 0; x < drawn.width_px; ++x, to += 2) to[0] = to[1] = from[x];
    }
}

BorderColours::BorderColours(const Palette& palette)
    : board(nearest_colour(palette, {44, 32, 26})),
      lit(nearest_colour(palette, {108, 84, 60})),
      dark(nearest_colour(palette, {12, 8, 8})) {}

void draw_around(const Area& view, const BorderColours& colours, Framebuffer picture) {
    const std::int32_t right = view.x + view.width, bottom = view.y + view.height;
    for (const Area& side :
         {Area{0, 0, picture.width_px, view.y}, Area{0, bottom, picture.width_px, picture.height_px - bottom},
          Area{0, view.y, view.x, view.height}, Area{right, view.y, picture.width_px - right, view.height}})
        fill_area(picture, side, colours.board);
    fill_area(picture, {view.x - 1, view.y - 1, view.width + 1, 1}, colours.dark);
    fill_area(picture, {view.x - 1, view.y, 1, view.height}, colours.dark);
    fill_area(picture, {view.x, bottom, view.width + 1, 1}, colours.lit);
    fill_area(picture, {right, view.y - 1, 1, view.height + 1}, colours.lit);
}

}  // namespace oblong
