#include "game/menu/menu_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "engine/draw/text.h"

namespace oblong::test::menu_layout_test {
namespace {

std::string random_text(std::mt19937& random, int longest) {
    std::string text(random() % static_cast<unsigned>(longest + 1), ' ');
    for (char& letter : text) letter = random() % 5 == 0 ? ' ' : static_cast<char>('a' + random() % 26);
    return text;
}

MenuPage random_page(std::mt19937& random) {
    MenuPage page{random_text(random, 12), random() % 3 == 0 ? random_text(random, 300) : ""};
    page.is_title = random() % 4 == 0;
    const auto rows = random() % 30;
    for (std::size_t i = 0; i < rows; ++i) {
        MenuRow row{random_text(random, 40), random_text(random, 30), random_text(random, 120), [] {}};
        if (random() % 6 == 0) row.picture = MenuPicture{8, 5, std::vector<Rgb8>(40)};
        page.rows.push_back(row);
    }
    return page;
}

bool is_in(const Area& area, CanvasSize canvas) {
    return area.x >= 0 && area.y >= 0 && area.x + area.width <= canvas.width_px &&
           area.y + area.height <= canvas.height_px;
}

bool overlap(const Area& a, const Area& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

void expect_apart(const MenuLayout& layout, CanvasSize canvas) {
    std::vector<Area> areas{layout.title};
    for (const MenuLayout::Item& item : layout.items) areas.push_back(item.area);
    if (!layout.help.empty())
        areas.push_back({0, layout.help_y, canvas.width_px,
                         static_cast<std::int32_t>(layout.help.size()) * kLineHeight_px * layout.scale});
    if (layout.picture) areas.push_back(*layout.picture);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        EXPECT_TRUE(is_in(areas[i], canvas)) << i << " at " << canvas.width_px << "x" << canvas.height_px;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(overlap(areas[i], areas[j]))
                << j << ", " << i << " at " << canvas.width_px << "x" << canvas.height_px;
    }
}

TEST(MenuLayout, NothingOverlapsOrLeavesTheCanvas) {
    std::mt19937 random(1);
    for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i) {
        const MenuPage page = random_page(random);
        const std::size_t chosen = page.rows.empty() ? 0 : random() % page.rows.size();
        for (const CanvasSize canvas :
             {CanvasSize{320, 200}, CanvasSize{320, 240}, CanvasSize{640, 480}, CanvasSize{400, 300}})
            for (const std::int32_t text_scale : {1, 2})
                expect_apart(lay_out(page, {chosen, random() % 40, text_scale}, canvas), canvas);
    }
}

// From the first row down by the keys: each is shown whole while it is chosen.
TEST(MenuLayout, EveryRowCanBeSeen) {
    std::mt19937 random(2);
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        const MenuPage page = random_page(random);
        std::size_t first = 0;
        for (std::size_t row = 0; row < page.rows.size(); ++row) {
            const MenuLayout layout = lay_out(page, {row, first, 1 + static_cast<std::int32_t>(i % 2)}, {320, 200});
            first = layout.first;
            const auto is_chosen = [&](const MenuLayout::Item& item) { return item.row == row; };
            EXPECT_TRUE(std::any_of(layout.items.begin(), layout.items.end(), is_chosen)) << row;
        }
    }
}

// The text above the rows too, where it fits.
TEST(MenuLayout, AShortTextIsSeenWithTheFirstRow) {
    MenuPage page{"Quit", "Quit the game?", {{"No", "", "", [] {}}, {"Yes", "", "", [] {}}}};
    for (const std::int32_t text_scale : {1, 2}) {
        const MenuLayout layout = lay_out(page, {0, 0, text_scale}, {320, 200});
        EXPECT_EQ(layout.items.front().text, "Quit the game?");
        EXPECT_EQ(layout.items.back().row, 1u);
        EXPECT_FALSE(layout.has_more_above || layout.has_more_below);
    }
}

TEST(MenuLayout, LargeTextIsTwiceAsLargeAndSmallModesKeepTheirColumns) {
    const MenuPage page{"Page", "", {{"Row", "", "", [] {}}}};
    EXPECT_EQ(lay_out(page, {0, 0, 1}, {320, 200}).scale, 1);
    EXPECT_EQ(lay_out(page, {0, 0, 2}, {320, 200}).scale, 2);
    EXPECT_EQ(lay_out(page, {0, 0, 1}, {640, 480}).scale, 2);
    EXPECT_EQ(lay_out(page, {0, 0, 2}, {640, 480}).scale, 4);
    EXPECT_EQ(lay_out(page, {0, 0, 2}, {160, 100}).scale, 1);
    EXPECT_EQ(lay_out(page, {0, 0, 2}, {8, 8}).scale, 1);
}

TEST(MenuLayout, LongLinesAreCut) {
    EXPECT_EQ(cut_to("abcdef", 6), "abcdef");
    EXPECT_EQ(cut_to("abcdef", 5), "abc..");
    EXPECT_EQ(cut_to("abcdef", 1), ".");
    EXPECT_EQ(cut_to("abcdef", 0), "");
}

}  // namespace
}  // namespace oblong::test::menu_layout_test
