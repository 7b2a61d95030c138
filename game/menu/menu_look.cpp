#include "game/menu/menu_look.h"

#include <algorithm>
#include <map>

#include "engine/base/table.h"
#include "game/menu/menu_layout.h"

namespace oblong {
namespace {

constexpr int kVeilBrightness = 104;  // of 256
constexpr std::array<Rgb8, kLetteringRamp> kRamp{
    {{255, 240, 192}, {255, 220, 136}, {248, 192, 88}, {232, 156, 56}, {204, 116, 36}, {164, 80, 24}, {120, 52, 16}}};
constexpr Rgb8 kPlain{208, 196, 176}, kDimText{152, 140, 120}, kTextBar{104, 56, 20}, kEdge{232, 156, 56};

// One cell with a bright upper edge. From 4 pixels on, it leaves a gap to the next cell.
void draw_cell(Framebuffer canvas, std::int32_t x, std::int32_t y, LetterCell cell, std::uint8_t colour,
               std::uint8_t lit) {
    const std::int32_t gap_x = cell.width_px >= 4, gap_y = cell.height_px >= 4;
    fill_area(canvas, {x, y, cell.width_px - gap_x, cell.height_px - gap_y}, colour);
    if (gap_y != 0) fill_area(canvas, {x, y, cell.width_px - gap_x, 1}, lit);
}

}  // namespace

MenuLook::MenuLook(const Palette& palette)
    : text(text_colours_of(palette)),
      plain(nearest_colour(palette, kPlain)),
      dim(nearest_colour(palette, kDimText)),
      bar(nearest_colour(palette, kTextBar)),
      edge(nearest_colour(palette, kEdge)),
      veil(darker_colours(palette, kVeilBrightness)) {
    std::transform(kRamp.begin(), kRamp.end(), ramp.begin(), [&](Rgb8 rgb) { return nearest_colour(palette, rgb); });
}

Area lettering_size(std::string_view line, LetterCell cell) {
    int top = 0;
    for_each_dot(line, [&](int, int row) { top = std::min(top, row); });
    const std::int32_t columns = text_width_px(line) - 1;
    return {0, top * cell.height_px, std::max(columns, 0) * cell.width_px, kLetteringRamp * cell.height_px};
}

namespace {

constexpr std::int32_t kPanelMargin_px = 3;

// In large letters with visible pixels and a shadow; (x, y) is its top left corner.
void draw_lettering(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view line, LetterCell cell,
                    const MenuLook& look) {
    const std::int32_t shadow_x = std::max(cell.width_px / 2, 1), shadow_y = std::max(cell.height_px / 2, 1);
    for_each_dot(line, [&](std::int32_t column, std::int32_t row) {
        fill_area(
            canvas,
            {x + column * cell.width_px + shadow_x, y + row * cell.height_px + shadow_y, cell.width_px, cell.height_px},
            look.text.dark);
    });
    const auto shade = [&](int row) { return item(look.ramp, std::clamp(row, 0, kLetteringRamp - 1)); };
    for_each_dot(line, [&](std::int32_t column, std::int32_t row) {
        draw_cell(canvas, x + column * cell.width_px, y + row * cell.height_px, cell, shade(row), shade(row - 2));
    });
}

class PageDrawing {
  public:
    PageDrawing(const MenuPage& page, const MenuView& view, const MenuLayout& layout, const MenuLook& look,
                Framebuffer canvas)
        : page_(page), view_(view), layout_(layout), look_(look), canvas_(canvas) {}

    void draw() const {
        recolour_area(canvas_, {0, 0, canvas_.width_px, canvas_.height_px}, look_.veil);
        const Area& body = layout_.body;
        recolour_area(canvas_,
                      {body.x - kPanelMargin_px, body.y - kPanelMargin_px, body.width + 2 * kPanelMargin_px,
                       body.height + 2 * kPanelMargin_px},
                      look_.veil);
        if (page_.is_title) hide_behind_name();
        draw_lettering(canvas_, layout_.title.x, layout_.title.y, page_.title, layout_.title_cell, look_);
        for (const MenuLayout::Item& item : layout_.items) draw_item(item);
        draw_scroll_marks();
        for (std::size_t i = 0; i < layout_.help.size(); ++i)
            draw_centred(layout_.help_y + static_cast<std::int32_t>(i) * kLineHeight_px * layout_.scale,
                         layout_.help[i], look_.dim);
    }

  private:
    TextColours colours_of(std::uint8_t bright) const { return {bright, look_.text.dark, layout_.scale}; }

    void draw_centred(std::int32_t y, const std::string& line, std::uint8_t colour) const {
        const std::int32_t x = (canvas_.width_px - text_width_px(line) * layout_.scale) / 2;
        draw_text(canvas_, x, y, line, colours_of(colour));
    }

    // A dark band across the canvas, so that texts in the picture do not mix with the game's name.
    void hide_behind_name() const {
        const std::int32_t accents = -lettering_size(page_.title, layout_.title_cell).y;
        const std::int32_t top = layout_.title.y - accents - 2 * kPanelMargin_px,
                           height = layout_.title.height + accents + 4 * kPanelMargin_px;
        for (int i = 0; i < 2; ++i) recolour_area(canvas_, {0, top, canvas_.width_px, height}, look_.veil);
    }

    void draw_item(const MenuLayout::Item& item) const {
        if (!item.row)
            draw_text(canvas_, item.area.x, item.area.y, item.text, colours_of(look_.plain));
        else
            draw_row(page_.rows[*item.row], item, *item.row == view_.chosen);
    }

    void draw_bar(const Area& area) const {
        fill_area(canvas_, area, look_.bar);
        fill_area(canvas_, {area.x, area.y, area.width, 1}, look_.edge);
        fill_area(canvas_, {area.x, area.y + area.height - 1, area.width, 1}, look_.edge);
    }

    void draw_row(const MenuRow& row, const MenuLayout::Item& item, bool is_chosen) const {
        const std::int32_t scale = layout_.scale, column = kGlyphAdvance_px * scale;
        const Area& area = item.area;
        const std::uint8_t usual = row.accept || row.change ? look_.plain : look_.dim;
        const TextColours colours = colours_of(is_chosen ? look_.text.bright : usual);
        if (is_chosen) draw_bar(area);
        if (is_chosen) draw_text(canvas_, area.x + scale, area.y + scale + scale / 2, ">", colours);
        const std::int32_t columns = area.width / column - 2;
        draw_text(canvas_, area.x + 2 * column, area.y + scale + scale / 2, cut_to(row.label, columns), colours);
        if (!row.value.empty()) draw_value(row, item, is_chosen, colours);
    }

    void draw_value(const MenuRow& row, const MenuLayout::Item& item, bool is_chosen, TextColours colours) const {
        const std::int32_t column = kGlyphAdvance_px * layout_.scale;
        const std::int32_t right = item.area.x + item.area.width, y = item.value_y + layout_.scale / 2;
        const std::string value = cut_to(row.value, item.area.width / column - 4);
        const std::int32_t x = right - 2 * column - text_width_px(value) * layout_.scale;
        draw_text(canvas_, x, y, value, colours);
        if (!is_chosen || !row.change) return;
        draw_text(canvas_, x - 2 * column, y, "<", colours);
        draw_text(canvas_, right - column, y, ">", colours);
    }

    // A small triangle on the body's border, on a side with more items.
    void draw_scroll_marks() const {
        const Area& body = layout_.body;
        const std::int32_t middle = body.x + body.width / 2, size = 3 * layout_.scale;
        for (std::int32_t i = 0; i < size; ++i) {
            const Area line{middle - i, 0, 2 * i + 1, 1};
            if (layout_.has_more_above)
                fill_area(canvas_, {line.x, body.y - kPanelMargin_px - size + i, line.width, 1}, look_.edge);
            if (layout_.has_more_below)
                fill_area(canvas_, {line.x, body.y + body.height + kPanelMargin_px + size - i - 1, line.width, 1},
                          look_.edge);
        }
    }

    const MenuPage& page_;
    const MenuView& view_;
    const MenuLayout& layout_;
    const MenuLook& look_;
    Framebuffer canvas_;
};

// Scaled to the largest size that fits the area in the picture's own shape; nearest pixel.
void draw_picture(const MenuPicture& picture, const Area& area, const MenuLook& look, const Palette& palette,
                  Framebuffer canvas) {
    if (picture.width_px <= 0 || picture.height_px <= 0) return;
    const std::int32_t height = std::min(area.height, area.width * picture.height_px / picture.width_px);
    const std::int32_t width = height * picture.width_px / picture.height_px;
    fill_area(canvas, {area.x - 1, area.y - 1, width + 2, height + 2}, look.edge);
    std::map<std::int32_t, std::uint8_t> nearest;  // a picture has few colours, and is drawn each frame
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const std::int32_t from = y * picture.height_px / height * picture.width_px + x * picture.width_px / width;
            const Rgb8 colour = item(*picture.pixels, from);
            const auto [found, is_new] = nearest.try_emplace(colour.red << 16 | colour.green << 8 | colour.blue);
            if (is_new) found->second = nearest_colour(palette, colour);
            set_pixel(canvas, area.x + x, area.y + y, found->second);
        }
}

}  // namespace

void draw_menu(const MenuPage& page, const MenuView& view, const MenuLook& look, const Palette& palette,
               Framebuffer canvas) {
    const MenuLayout layout = lay_out(page, view, {canvas.width_px, canvas.height_px});
    PageDrawing(page, view, layout, look, canvas).draw();
    if (layout.picture && view.chosen < page.rows.size() && page.rows[view.chosen].picture)
        draw_picture(*page.rows[view.chosen].picture, *layout.picture, look, palette, canvas);
}

}  // namespace oblong
