#include "game/menu/menu.h"

#include <gtest/gtest.h>

#include <string>

namespace oblong {
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
    MenuEvent act(MenuAction action) {
        Controls controls;
        controls.menu = {action};
        return menu_.handle(controls, kCanvas, 1, kShown);
    }
    // The pointer in the middle of a row, or at its left.
    MenuEvent point(std::size_t row, bool is_pressed, bool is_left = false) {
        const MenuLayout layout = lay_out(menu_.page(), {menu_.chosen(), 0, 1}, kCanvas);
        const Area& area = layout.items[row].area;
        Controls controls;
        const std::int32_t x = is_left ? area.x + 1 : area.x + area.width - 2, y = area.y + area.height / 2;
        controls.pointer = Pointer{kShown.x_px + 4 * x + 2, 4 * y + 2, true, is_pressed};
        return menu_.handle(controls, kCanvas, 1, kShown);
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
    EXPECT_EQ(menu_.handle(escape, kCanvas, 1, kShown), MenuEvent::WentBack);
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
    menu_.handle(controls, kCanvas, 1, kShown);
    EXPECT_EQ(menu_.chosen(), 1u);
}

TEST_F(MenuOfThree, APressOutsideTheRowsDoesNothing) {
    Controls controls;
    controls.pointer = Pointer{3, 3, true, true};
    EXPECT_EQ(menu_.handle(controls, kCanvas, 1, kShown), MenuEvent::None);
    EXPECT_EQ(menu_.handle(controls, kCanvas, 1, PresentRect{}), MenuEvent::None);  // nothing is shown
    EXPECT_TRUE(menu_.is_open());
}

TEST_F(MenuOfThree, APressAnywhereClosesATextWithoutRows) {
    menu_.open([] { return MenuPage{"Text", "to read"}; });
    Controls controls;
    controls.pointer = Pointer{3, 3, true, false};
    menu_.handle(controls, kCanvas, 1, kShown);
    EXPECT_EQ(menu_.depth(), 2u) << "it only moves";
    controls.pointer = Pointer{3, 3, false, true};
    EXPECT_EQ(menu_.handle(controls, kCanvas, 1, kShown), MenuEvent::WentBack);
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
    menu_.handle(controls, kCanvas, 1, kShown);
    EXPECT_EQ(pressed, input_named("Enter"));
    EXPECT_EQ(menu_.depth(), 2u) << "what is bound is not what it does in a menu";
    controls = {};
    controls.commands = {Action::Menu};
    controls.pressed = input_named("Escape");
    menu_.handle(controls, kCanvas, 1, kShown);
    EXPECT_EQ(pressed, input_named("Enter"));
    EXPECT_EQ(menu_.depth(), 1u);
}

TEST_F(MenuOfThree, ATextTooLongForAPageIsReadToItsEnd) {
    std::string text;
    for (int i = 0; i < 60; ++i) text += "line " + std::to_string(i) + "\n";
    menu_.open([=] { return MenuPage{"Text", text + "end"}; });
    int steps = 0;
    while (act(MenuAction::Down) == MenuEvent::Moved) ASSERT_LT(++steps, 100);
    EXPECT_GT(steps, 20);
    while (act(MenuAction::Up) == MenuEvent::Moved) --steps;
    EXPECT_EQ(steps, 0);
}

}  // namespace
}  // namespace oblong
