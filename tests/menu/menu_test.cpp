#include "game/menu/menu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "engine/draw/drawing.h"
#include "game/menu/menu_layout.h"
#include "tests/support/palettes.h"

namespace oblong::test::menu_layout_test {
namespace {

constexpr CanvasSize kCanvas{320, 200};
// Four pixels of the window for one of the canvas, 100 from its left border.
constexpr PresentRect kShown{100, 0, 1280, 800, 4, 4, false, 0, false};

// A menu of three rows: one that is accepted, one that is changed, one that closes.
class MenuOfThree : public testing::Test {
  protected:
    void SetUp() override {
        menu_.open([this] {
            MenuPage page{"Three"};
            page.rows.push_back({"First", "", "", [this] { ++accepted_; }});
            page.rows.push_back(
                {"Second", std::to_string(value_), "", nullptr, [this](int steps) { value_ += steps; }});
            page.rows.push_back({"Third", "", "", [this] { menu_.close(); }});
            return page;
        });
    }
    MenuEvent handle(const Controls& controls) { return menu_.handle(controls, kCanvas, 1, kShown); }
    MenuEvent act(MenuAction action) {
        Controls controls;
        controls.menu = {action};
        return handle(controls);
    }
    MenuEvent point_at(std::int32_t x_px, std::int32_t y_px, bool has_moved, bool is_pressed) {
        Controls controls;
        controls.pointer = Pointer{x_px, y_px, has_moved, is_pressed};
        return handle(controls);
    }
    static std::string numbered_lines(int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += "line " + std::to_string(i) + "\n";
        return text;
    }
    // The pointer in the middle of a row, or at its left.
    MenuEvent point(std::size_t row, bool is_pressed, bool is_left = false) {
        const MenuLayout layout = lay_out(menu_.page(), {menu_.chosen(), 0, 1}, kCanvas);
        const Area& area = layout.items[row].area;
        const std::int32_t x = is_left ? area.x + 1 : area.x + area.width - 2, y = area.y + area.height / 2;
        return point_at(kShown.x_px + 4 * x + 2, 4 * y + 2, true, is_pressed);
    }

    // The picture of the menu, as text.
    std::string drawn() const {
        std::string pixels(320 * 200, ' ');
        menu_.draw(1, MenuLook(grey_palette()), grey_palette(),
                   {reinterpret_cast<std::uint8_t*>(pixels.data()), 320, 200, 320});
        return pixels;
    }

    Menu menu_;
    int accepted_ = 0, value_ = 0;
};

TEST_F(MenuOfThree, UpAndDownGoRound) {
    EXPECT_EQ(act(MenuAction::Up), MenuEvent::Moved);
    EXPECT_EQ(menu_.chosen(), 2u);
    act(MenuAction::Down);
    EXPECT_EQ(menu_.chosen(), 0u);
    act(MenuAction::Down);
    EXPECT_EQ(menu_.chosen(), 1u);
}

TEST_F(MenuOfThree, LeftAndRightChangeAValueAndNothingElse) {
    EXPECT_EQ(act(MenuAction::Right), MenuEvent::None);
    act(MenuAction::Down);
    EXPECT_EQ(act(MenuAction::Right), MenuEvent::Changed);
    act(MenuAction::Right);
    act(MenuAction::Left);
    EXPECT_EQ(value_, 1);
    act(MenuAction::Accept);  // a step on
    EXPECT_EQ(value_, 2);
    EXPECT_EQ(menu_.page().rows[1].value, "2");
    EXPECT_EQ(accepted_, 0);
}

TEST_F(MenuOfThree, AcceptDoesWhatTheRowIsFor) {
    EXPECT_EQ(act(MenuAction::Accept), MenuEvent::Accepted);
    EXPECT_EQ(accepted_, 1);
    act(MenuAction::Up);
    act(MenuAction::Accept);
    EXPECT_FALSE(menu_.is_open());
    EXPECT_EQ(act(MenuAction::Accept), MenuEvent::None);
}

TEST_F(MenuOfThree, BackAndEscapeCloseThePageOrDoWhatItSays) {
    int asked = 0;
    menu_.open([&] { return MenuPage{"Asks", "Really?", {}, 0, "", false, [&] { ++asked; }}; });
    EXPECT_EQ(act(MenuAction::Back), MenuEvent::WentBack);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(menu_.depth(), 2u);
    menu_.close();
    Controls escape;
    escape.commands = {Action::Menu};
    EXPECT_EQ(handle(escape), MenuEvent::WentBack);
    EXPECT_FALSE(menu_.is_open());
}

TEST_F(MenuOfThree, ThePointerChoosesChangesAndAccepts) {
    EXPECT_EQ(point(2, false), MenuEvent::Moved);
    EXPECT_EQ(menu_.chosen(), 2u);
    EXPECT_EQ(point(2, false), MenuEvent::None);
    point(1, true);
    EXPECT_EQ(value_, 1);
    point(1, true, true);
    EXPECT_EQ(value_, 0);
    EXPECT_EQ(point(0, true), MenuEvent::Accepted);
    EXPECT_EQ(accepted_, 1);
}

TEST_F(MenuOfThree, APointerThatRestsChoosesNothing) {
    const MenuLayout layout = lay_out(menu_.page(), {0, 0, 1}, kCanvas);
    const Area& area = layout.items[2].area;
    Controls controls;
    controls.pointer = Pointer{kShown.x_px + 4 * (area.x + 8), 4 * (area.y + 4), false, false};
    controls.menu = {MenuAction::Down};
    handle(controls);
    EXPECT_EQ(menu_.chosen(), 1u);
}

TEST_F(MenuOfThree, APressOutsideTheRowsDoesNothing) {
    EXPECT_EQ(point_at(3, 3, true, true), MenuEvent::None);
    Controls controls;
    controls.pointer = Pointer{3, 3, true, true};
    EXPECT_EQ(menu_.handle(controls, kCanvas, 1, PresentRect{}), MenuEvent::None);  // nothing is shown
    EXPECT_TRUE(menu_.is_open());
}

TEST_F(MenuOfThree, APressAnywhereClosesATextWithoutRows) {
    menu_.open([] { return MenuPage{"Text", "to read"}; });
    point_at(3, 3, true, false);
    EXPECT_EQ(menu_.depth(), 2u) << "it only moves";
    EXPECT_EQ(point_at(3, 3, false, true), MenuEvent::WentBack);
    EXPECT_EQ(menu_.depth(), 1u);
}

TEST_F(MenuOfThree, APageThatWaitsForAKeyTakesAnyButEscape) {
    std::optional<Input> pressed;
    menu_.open([&] {
        MenuPage page{"Key", "Press a key"};
        page.press = [&](Input input) { pressed = input; };
        return page;
    });
    Controls controls;
    controls.menu = {MenuAction::Accept};
    controls.pressed = input_named("Enter");
    handle(controls);
    EXPECT_EQ(pressed, input_named("Enter"));
    EXPECT_EQ(menu_.depth(), 2u) << "what is bound is not what it does in a menu";
    controls = {};
    controls.commands = {Action::Menu};
    controls.pressed = input_named("Mouse 5");  // which opens the menu, too, but may be bound to something else
    handle(controls);
    EXPECT_EQ(pressed, input_named("Mouse 5"));
    EXPECT_EQ(menu_.depth(), 2u);
    controls.pressed = input_named("Escape");
    handle(controls);
    EXPECT_EQ(pressed, input_named("Mouse 5"));
    EXPECT_EQ(menu_.depth(), 1u);
}

TEST_F(MenuOfThree, ATextTooLongForAPageIsReadToItsEnd) {
    menu_.open([] { return MenuPage{"Text", numbered_lines(60) + "end"}; });
    int steps = 0;
    while (act(MenuAction::Down) == MenuEvent::Moved) ASSERT_LT(++steps, 100);
    EXPECT_GT(steps, 20);
    while (act(MenuAction::Up) == MenuEvent::Moved) --steps;
    EXPECT_EQ(steps, 0);
}

// It opens at its beginning; what follows comes with the keys, then the rows.
TEST_F(MenuOfThree, ALongTextAboveRowsIsReadFromItsBeginning) {
    menu_.open([] { return MenuPage{"Text", numbered_lines(30), {{"No", "", "", [] {}}, {"Yes", "", "", [] {}}}}; });
    const std::string top = drawn();
    EXPECT_EQ(act(MenuAction::Up), MenuEvent::Moved);
    EXPECT_EQ(menu_.chosen(), 1u);
    act(MenuAction::Down);  // to the first row, with the end of the text
    EXPECT_NE(drawn(), top);
    int steps = 0;
    for (; drawn() != top; ++steps) {
        ASSERT_LT(steps, 100);
        EXPECT_EQ(act(MenuAction::Up), MenuEvent::Moved);
        EXPECT_EQ(menu_.chosen(), 0u);
    }
    EXPECT_GT(steps, 10);
    while (menu_.chosen() == 0) {
        ASSERT_GE(--steps, -3);
        EXPECT_EQ(act(MenuAction::Down), MenuEvent::Moved);
    }
}

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
        if (random() % 6 == 0) row.picture = MenuPicture{8, 5, std::make_shared<std::vector<Rgb8>>(40)};
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
    if (layout.has_more_below) {
        const Area& body = layout.body;
        areas.push_back({body.x + body.width / 2, body.y + body.height, 1, 3 + 3 * layout.scale});  // the mark
    }
    SCOPED_TRACE(std::to_string(canvas.width_px) + "x" + std::to_string(canvas.height_px));
    for (std::size_t i = 0; i < areas.size(); ++i) {
        EXPECT_TRUE(is_in(areas[i], canvas)) << i;
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(areas[i], areas[j])) << j << ", " << i;
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

// From the first row down by the keys: each is shown whole while it is chosen, the first one after a long text above
// it.
TEST(MenuLayout, EveryRowCanBeSeen) {
    std::mt19937 random(2);
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        const MenuPage page = random_page(random);
        std::size_t first = 0;
        for (std::size_t row = 0; row < page.rows.size(); ++row) {
            const auto lay_out_from = [&](std::size_t item) {
                return lay_out(page, {row, item, 1 + static_cast<std::int32_t>(i % 2)}, {320, 200});
            };
            const auto is_shown = [&](const MenuLayout& layout) {
                return std::ranges::any_of(layout.items, [&](const auto& item) { return item.row == row; });
            };
            MenuLayout layout = lay_out_from(first);
            while (row == 0 && !page.text.empty() && !is_shown(layout) && layout.has_more_below)
                layout = lay_out_from(layout.first + 1);
            first = layout.first;
            EXPECT_TRUE(is_shown(layout)) << row;
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
    EXPECT_EQ(cut_to("Größe", 5), "Größe");
    EXPECT_EQ(cut_to("äöüÄÖÜ", 5), "äöü..");
}

TEST(MenuLayout, CountsLetters) {
    const auto layout_of = [](const std::string& label) {
        return lay_out({"Page", "", {{label, "value", "", [] {}}}}, {0, 0, 1}, {320, 200});
    };
    for (const std::size_t letters : {4u, 20u, 34u, 38u, 39u}) {
        std::string accented;
        for (std::size_t i = 0; i < letters; ++i) accented += "é";
        const MenuLayout expected = layout_of(std::string(letters, 'e')), layout = layout_of(accented);
        EXPECT_EQ(layout.body, expected.body) << letters;
        EXPECT_EQ(layout.items.at(0).value_y, expected.items.at(0).value_y) << letters;
    }
}

// The accents of large letters, too.
TEST(MenuLayout, TitlesAreInTheCanvas) {
    for (const CanvasSize canvas : {CanvasSize{320, 200}, CanvasSize{640, 400}, CanvasSize{1280, 800}}) {
        MenuPage page{"HOHLE"};
        page.is_title = true;
        const MenuLayout plain = lay_out(page, {}, canvas);
        EXPECT_EQ(plain.title.y, std::min(canvas.height_px / 20, 15));
        page.title = "ÉÖHLE";
        const MenuLayout accented = lay_out(page, {}, canvas);
        EXPECT_EQ(accented.title_cell.width_px, plain.title_cell.width_px);
        EXPECT_EQ(accented.title.width, plain.title.width);
        EXPECT_EQ(accented.title.y, 2 * accented.title_cell.height_px);
    }
    EXPECT_EQ(lettering_size("ö", {2, 3}), (Area{0, 0, 10, 21}));
    EXPECT_EQ(lettering_size("é", {2, 3}), (Area{0, -3, 10, 21}));
    EXPECT_EQ(lettering_size("É", {2, 3}), (Area{0, -6, 10, 21}));
}

// As bright as a letter's first row, before a band that is dark from above the accents to below the letters.
TEST(MenuLook, LargeLettersHaveTheirAccents) {
    std::vector<std::uint8_t> pixels(320 * 200, 255);
    const Framebuffer canvas{pixels.data(), 320, 200, 320};
    const Palette palette = grey_palette();
    const MenuLook look(palette);
    MenuPage page{"ÉI"};
    page.is_title = true;
    draw_menu(page, {}, look, palette, canvas);
    const MenuLayout layout = lay_out(page, {}, {320, 200});
    const std::int32_t cell = layout.title_cell.width_px, middle = cell / 2;
    const auto colour = [&](std::int32_t column, std::int32_t row) {
        return canvas.row(layout.title.y + row * cell + middle)[layout.title.x + column * cell + middle];
    };
    EXPECT_EQ(colour(3, -2), look.ramp[0]);
    EXPECT_EQ(colour(2, -1), look.ramp[0]);
    EXPECT_EQ(colour(8, 0), look.ramp[0]);
    EXPECT_EQ(colour(0, 1), look.ramp[1]);
    for (std::int32_t y = 0; y < layout.title.y + layout.title.height; ++y)
        EXPECT_EQ(canvas.row(y)[0], canvas.row(layout.title.y)[0]) << y;
    EXPECT_LT(canvas.row(layout.title.y)[0], canvas.row(199)[0]);
}

}  // namespace
}  // namespace oblong::test::menu_layout_test
