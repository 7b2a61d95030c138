#include "game/menu/menu.h"

#include <algorithm>
#include <utility>

namespace oblong {
namespace {

bool is_inside(const Area& area, std::int32_t x, std::int32_t y) {
    return x >= area.x && x < area.x + area.width && y >= area.y && y < area.y + area.height;
}

// Whether a step scrolls: a page without rows, or the text above the first row, if that is chosen and more is there.
bool is_scrolled(const MenuPage& page, std::size_t chosen, int steps, const MenuLayout& layout) {
    if (page.rows.empty()) return true;
    if (chosen > 0) return false;
    const auto is_first = [](const MenuLayout::Item& item) { return item.row == std::size_t{0}; };
    return steps < 0 ? layout.has_more_above : std::none_of(layout.items.begin(), layout.items.end(), is_first);
}

}  // namespace

void Menu::open(MenuPageMaker make_page) {
    const std::size_t first_chosen = make_page().first_chosen;
    pages_.push_back({std::move(make_page), first_chosen, 0});
}

MenuEvent Menu::handle(const Controls& controls, CanvasSize canvas, std::int32_t text_scale, const PresentRect& shown) {
    MenuEvent event = MenuEvent::None;
    const auto note = [&](MenuEvent next) { event = next == MenuEvent::None ? event : next; };
    if (is_open() && page().press) return take_press(controls);
    if (controls.pointer) note(point(*controls.pointer, canvas, text_scale, shown));
    for (const MenuAction action : controls.menu)
        if (is_open()) note(act(action, canvas, text_scale));
    for (const Action command : controls.commands)
        if (is_open() && (command == Action::Menu || command == page().closed_by)) note(go_back(page()));
    return event;
}

MenuEvent Menu::take_press(const Controls& controls) {
    const MenuPage waiting = page();
    if (controls.pressed ? is_reserved(*controls.pressed) : controls.has(Action::Menu)) return go_back(waiting);
    if (!controls.pressed) return MenuEvent::None;
    waiting.press(*controls.pressed);
    return MenuEvent::Accepted;
}

MenuEvent Menu::act(MenuAction action, CanvasSize canvas, std::int32_t text_scale) {
    const MenuPage shown = page();
    if (action == MenuAction::Up || action == MenuAction::Down)
        return move(shown, action == MenuAction::Up ? -1 : 1, canvas, text_scale);
    if (action == MenuAction::Left || action == MenuAction::Right)
        return change(shown, action == MenuAction::Left ? -1 : 1);
    return action == MenuAction::Accept ? accept(shown) : go_back(shown);
}

// Wraps from the last row to the first.
MenuEvent Menu::move(const MenuPage& page, int steps, CanvasSize canvas, std::int32_t text_scale) {
    OpenPage& open = pages_.back();
    const std::size_t count = page.rows.size();
    if (const MenuLayout layout = layout_of(page, canvas, text_scale); is_scrolled(page, open.chosen, steps, layout)) {
        if (steps > 0 ? !layout.has_more_below : !layout.has_more_above) return MenuEvent::None;
        open.first = steps > 0 ? layout.first + 1 : layout.first - 1;
        return MenuEvent::Moved;
    }
    open.chosen = (std::min(open.chosen, count - 1) + (steps > 0 ? 1 : count - 1)) % count;
    open.first = layout_of(page, canvas, text_scale).first;
    return MenuEvent::Moved;
}

// A row's function may close the page, so it is called from `page`, a copy.
MenuEvent Menu::change(const MenuPage& page, int steps) {
    const std::size_t row = pages_.back().chosen;
    if (row >= page.rows.size() || !page.rows[row].change) return MenuEvent::None;
    page.rows[row].change(steps);
    return MenuEvent::Changed;
}

MenuEvent Menu::accept(const MenuPage& page) {
    const std::size_t row = pages_.back().chosen;
    if (page.rows.empty()) return go_back(page);
    if (row >= page.rows.size() || !page.rows[row].accept) return change(page, 1);
    page.rows[row].accept();
    return MenuEvent::Accepted;
}

MenuEvent Menu::go_back(const MenuPage& page) {
    if (page.back)
        page.back();
    else
        close();
    return MenuEvent::WentBack;
}

// Motion over a row chooses it. A press on it accepts it, or changes it: down in its left half, up in its right half. A
// press on a page without rows closes it.
MenuEvent Menu::point(const Pointer& pointer, CanvasSize canvas, std::int32_t text_scale, const PresentRect& shown) {
    if (!is_open() || shown.width_px <= 0 || shown.height_px <= 0) return MenuEvent::None;
    if (!pointer.has_moved && !pointer.is_pressed) return MenuEvent::None;
    const auto x =
        static_cast<std::int32_t>(std::int64_t{pointer.x_px - shown.x_px} * canvas.width_px / shown.width_px);
    const auto y =
        static_cast<std::int32_t>(std::int64_t{pointer.y_px - shown.y_px} * canvas.height_px / shown.height_px);
    const MenuPage current = page();
    if (current.rows.empty() && pointer.is_pressed) return go_back(current);
    const MenuLayout layout = layout_of(current, canvas, text_scale);
    for (const MenuLayout::Item& item : layout.items) {
        if (!item.row || !is_inside(item.area, x, y)) continue;
        OpenPage& open = pages_.back();
        const bool is_new = std::exchange(open.chosen, *item.row) != *item.row;
        open.first = layout.first;
        if (!pointer.is_pressed) return is_new ? MenuEvent::Moved : MenuEvent::None;
        const MenuRow& row = current.rows[*item.row];
        const bool is_left = x < item.area.x + item.area.width / 2;
        return row.change && !row.accept ? change(current, is_left ? -1 : 1) : accept(current);
    }
    return MenuEvent::None;
}

MenuLayout Menu::layout_of(const MenuPage& page, CanvasSize canvas, std::int32_t text_scale) const {
    return lay_out(page, {pages_.back().chosen, pages_.back().first, text_scale}, canvas);
}

void Menu::draw(std::int32_t text_scale, const MenuLook& look, const Palette& palette, Framebuffer canvas) const {
    if (!is_open()) return;
    draw_menu(page(), {chosen(), pages_.back().first, text_scale}, look, palette, canvas);
}

}  // namespace oblong
