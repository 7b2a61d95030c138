#include "game/menu/menu_layout.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/draw/drawing.h"

namespace oblong {
namespace {

constexpr std::int32_t kRowPadding_px = 1;  // above and below a row's text, at scale 1
constexpr std::int32_t kRowColumns = 2;     // before a label: the mark of the chosen row
constexpr std::int32_t kValueColumns = 4;   // around a value: "< value >"
constexpr std::int32_t kGap_px = 5;
constexpr std::int32_t kScrollMark_px = 6;  // below the last row, at scale 1
constexpr std::size_t kHelpLines = 2;       // the least room for help
constexpr std::int32_t kMostColumns = 50;
constexpr std::int32_t kPictureAspect_100 = 75;  // height to width of the area for a picture

std::int32_t columns_of(const std::string& text) {
    return static_cast<std::int32_t>(letters_in(text));
}

std::vector<std::string> wrapped_lines(const std::string& text, std::int32_t columns) {
    if (text.empty()) return {};
    const std::vector<std::string_view> lines = lines_of(text, columns * kGlyphAdvance_px);
    return {lines.begin(), lines.end()};
}

// Lays out a page, from its title down.
class PageLayout {
  public:
    PageLayout(const MenuPage& page, const MenuView& view, CanvasSize canvas)
        : page_(page), view_(view), canvas_(canvas) {
        out_.scale = text_scale_in(canvas.width_px, canvas.height_px, view.text_scale);
        line_px_ = kLineHeight_px * out_.scale;
        column_px_ = kGlyphAdvance_px * out_.scale;
        place_title();
        place_help();
        place_body();
        make_items();
        choose_first();
        place_items();
    }
    MenuLayout take() { return std::move(out_); }

  private:
    std::int32_t columns_in(std::int32_t width_px) const { return std::max(width_px / column_px_, 1); }

    void place_title() {
        const std::int32_t by_canvas = std::max(std::min(canvas_.width_px / 320, canvas_.height_px / 200), 1);
        LetterCell cell{2 * by_canvas, 2 * by_canvas};
        if (page_.is_title) cell = {6 * by_canvas, 6 * by_canvas};
        Area size = lettering_size(page_.title, cell);
        const std::int32_t room_px = canvas_.width_px - 2 * kTextMargin_px;
        while (cell.width_px > 1 && (size.width > room_px || size.height > canvas_.height_px / 4)) {
            cell = {cell.width_px - 1, cell.height_px - 1};
            size = lettering_size(page_.title, cell);
        }
        out_.title_cell = cell;
        const std::int32_t y = std::max(std::min(canvas_.height_px / 20, 3 * kGap_px), -size.y);
        out_.title = {(canvas_.width_px - size.width) / 2, y, size.width, size.height};
    }

    void place_help() {
        const auto lines_for = [&](const std::string& help) {
            return wrapped_lines(help, columns_in(canvas_.width_px - 2 * kTextMargin_px));
        };
        const bool has_own = view_.chosen < page_.rows.size() && !page_.rows[view_.chosen].help.empty();
        out_.help = lines_for(has_own ? page_.rows[view_.chosen].help : page_.help);
        // The longest help of the page, so that the rows do not move with the choice.
        std::size_t most = lines_for(page_.help).size();
        for (const MenuRow& row : page_.rows) most = std::max(most, lines_for(row.help).size());
        const auto room = as_size(canvas_.height_px / line_px_ * 2 / 5);
        if (out_.help.size() > room) out_.help.resize(room);
        help_lines_ =
            most == 0 ? 0 : static_cast<std::int32_t>(std::clamp(most, kHelpLines, std::max(room, kHelpLines)));
        out_.help_y =
            canvas_.height_px - kTextMargin_px - std::max(static_cast<std::int32_t>(out_.help.size()), 1) * line_px_;
    }

    bool has_picture() const {
        return canvas_.width_px >= kMostColumns * column_px_ &&
               std::any_of(page_.rows.begin(), page_.rows.end(),
                           [](const MenuRow& row) { return row.picture.has_value(); });
    }

    std::int32_t wanted_columns() const {
        std::int32_t columns = page_.text.empty() ? 0 : kMostColumns;
        for (const MenuRow& row : page_.rows) {
            const std::int32_t value = row.value.empty() ? 0 : columns_of(row.value) + kValueColumns + 2;
            columns = std::max(columns, 2 * kRowColumns + columns_of(row.label) + value);
        }
        return std::min(columns, kMostColumns);
    }

    void place_body() {
        const std::int32_t room_px = canvas_.width_px - 2 * kTextMargin_px;
        std::int32_t width = std::min(wanted_columns() * column_px_, room_px);
        const std::int32_t top = out_.title.y + out_.title.height + kGap_px + out_.title_cell.height_px;
        const std::int32_t bottom =
            canvas_.height_px - kTextMargin_px - help_lines_ * line_px_ - kScrollMark_px * out_.scale;
        std::int32_t left = (canvas_.width_px - width) / 2;
        if (has_picture()) {
            const std::int32_t picture_px = room_px * 2 / 5;
            width = room_px - picture_px - 2 * kGap_px;
            left = kTextMargin_px;
            out_.picture = Area{canvas_.width_px - kTextMargin_px - picture_px, top, picture_px,
                                picture_px * kPictureAspect_100 / 100};
        }
        out_.body = {left, std::min(top, bottom), width, std::max(bottom - top, 0)};
    }

    bool has_own_line_for_value(const MenuRow& row) const {
        return !row.value.empty() && kRowColumns + columns_of(row.label) + 1 + columns_of(row.value) + kValueColumns >
                                         columns_in(out_.body.width);
    }

    void make_items() {
        const std::int32_t padding = kRowPadding_px * out_.scale;
        for (std::string& line : wrapped_lines(page_.text, columns_in(out_.body.width)))
            items_.push_back({{0, 0, out_.body.width, line_px_}, std::move(line), std::nullopt, 0});
        if (!items_.empty() && !page_.rows.empty())
            items_.push_back({{0, 0, out_.body.width, line_px_ / 2}, "", std::nullopt, 0});
        for (std::size_t i = 0; i < page_.rows.size(); ++i) {
            const bool is_double = has_own_line_for_value(page_.rows[i]);
            const std::int32_t height = (is_double ? 2 : 1) * line_px_ + 2 * padding;
            items_.push_back({{0, 0, out_.body.width, height}, "", i, padding + (is_double ? line_px_ : 0)});
        }
    }

    // The number of items from `first` on that fit; at least one.
    std::size_t shown_from(std::size_t first) const {
        std::int32_t height = 0;
        std::size_t last = first;
        for (; last < items_.size(); ++last) {
            height += items_[last].area.height;
            if (height > out_.body.height && last > first) break;
        }
        return last - first;
    }

    void choose_first() {
        std::size_t first = std::min(view_.first, items_.empty() ? 0 : items_.size() - 1);
        while (first > 0 && first - 1 + shown_from(first - 1) == items_.size()) --first;  // no empty room at the end
        const auto is_chosen = [&](const MenuLayout::Item& item) { return item.row == view_.chosen; };
        const auto chosen = as_size(std::find_if(items_.begin(), items_.end(), is_chosen) - items_.begin());
        if (chosen < items_.size()) {
            if (view_.chosen == 0 && shown_from(0) > chosen) first = 0;  // shows the text above the first row
            first = std::min(first, chosen);
            while (view_.chosen > 0 && first + shown_from(first) <= chosen) ++first;
        }
        out_.first = first;
    }

    void place_items() {
        const std::size_t shown = items_.empty() ? 0 : shown_from(out_.first);
        std::int32_t y = out_.body.y;
        for (std::size_t i = out_.first; i < out_.first + shown; ++i) {
            MenuLayout::Item item = items_[i];
            item.area.x = out_.body.x;
            item.area.y = y;
            item.value_y += y;
            y += item.area.height;
            out_.items.push_back(std::move(item));
        }
        out_.body.height = y - out_.body.y;
        out_.has_more_above = out_.first > 0;
        out_.has_more_below = out_.first + shown < items_.size();
    }

    const MenuPage& page_;
    const MenuView& view_;
    const CanvasSize canvas_;
    std::int32_t line_px_ = 0, column_px_ = 0, help_lines_ = 0;
    std::vector<MenuLayout::Item> items_;
    MenuLayout out_;
};

}  // namespace

MenuRow& MenuPage::add(std::string label, std::string row_help, std::function<void()> accept) {
    rows.push_back({std::move(label), "", in_capitals(std::move(row_help), 1), std::move(accept)});
    return rows.back();
}

MenuLayout lay_out(const MenuPage& page, const MenuView& view, CanvasSize canvas) {
    return PageLayout(page, view, canvas).take();
}

std::string cut_to(const std::string& line, std::int32_t columns) {
    if (columns_of(line) <= columns) return line;
    const auto kept = as_size(std::max(columns - 2, 0));
    return std::string(first_letters(line, kept)) + std::string("..").substr(0, as_size(std::clamp(columns, 0, 2)));
}

}  // namespace oblong
