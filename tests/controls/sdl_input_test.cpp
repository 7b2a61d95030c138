#include <SDL.h>
#include <gtest/gtest.h>

#include "game/input/input_mapper.h"
#include "tests/controls/virtual_pad.h"

namespace oblong::test {
namespace {

using Commands = std::vector<Action>;

class SdlInputTest : public testing::Test {
  protected:
    void SetUp() override { poll(); }

    /// What the game makes of what SDL reported.
    Controls poll() { return mapper_.take(window_.input->poll(), SDL_GetTicks64()); }

    void push_key(const char* name, bool is_down, bool is_repeat = false, std::uint16_t modifiers = 0) {
        SDL_Event event{};
        event.type = is_down ? SDL_KEYDOWN : SDL_KEYUP;
        event.key.state = is_down ? SDL_PRESSED : SDL_RELEASED;
        event.key.repeat = is_repeat ? 1 : 0;
        event.key.keysym.scancode = static_cast<SDL_Scancode>(input_named(name).code);
        event.key.keysym.mod = modifiers;
        SDL_PushEvent(&event);
    }
    void push_button(std::uint8_t button, bool is_down, std::int32_t x = 0, std::int32_t y = 0) {
        SDL_Event event{};
        event.type = is_down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
        event.button.state = is_down ? SDL_PRESSED : SDL_RELEASED;
        event.button.button = button;
        event.button.x = x;
        event.button.y = y;
        SDL_PushEvent(&event);
    }
    void push_motion(std::int32_t x, std::int32_t y, std::int32_t right, std::int32_t down) {
        SDL_Event event{};
        event.type = SDL_MOUSEMOTION;
        event.motion.x = x;
        event.motion.y = y;
        event.motion.xrel = right;
        event.motion.yrel = down;
        SDL_PushEvent(&event);
    }
    void push_wheel(std::int32_t x, std::int32_t y) {
        SDL_Event event{};
        event.type = SDL_MOUSEWHEEL;
        event.wheel.x = x;
        event.wheel.y = y;
        SDL_PushEvent(&event);
    }
    void push_window(SDL_WindowEventID what) {
        SDL_Event event{};
        event.type = SDL_WINDOWEVENT;
        event.window.event = static_cast<std::uint8_t>(what);
        SDL_PushEvent(&event);
    }

    UnseenWindow window_;
    Bindings bindings_ = default_bindings();
    InputMapper mapper_{bindings_};
};

TEST_F(SdlInputTest, ScancodesAreTheNumbersOfTheNames) {
    EXPECT_EQ(input_named("W").code, SDL_SCANCODE_W);
    EXPECT_EQ(input_named("Right Ctrl").code, SDL_SCANCODE_RCTRL);
    EXPECT_EQ(input_named("Keypad Enter").code, SDL_SCANCODE_KP_ENTER);
    EXPECT_EQ(input_named("F24").code, SDL_SCANCODE_F24);
    EXPECT_EQ(input_named("Less").code, SDL_SCANCODE_NONUSBACKSLASH);
    EXPECT_EQ(input_named("0").code, SDL_SCANCODE_0);
}

TEST_F(SdlInputTest, KeysWalkAndCommand) {
    push_key("W", true);
    push_key("F1", true);
    push_key("F1", true, true);
    push_key("F1", false);
    const Controls controls = poll();
    EXPECT_TRUE(controls.moves.has(Action::Forward));
    EXPECT_EQ(controls.commands, Commands{Action::ShowHelp});
    push_key("W", false);
    EXPECT_FALSE(poll().moves.has(Action::Forward));
}

TEST_F(SdlInputTest, AltWithEnterOrTabIsTheWindowsOwn) {
    push_key("Enter", true, false, KMOD_LALT);
    push_key("Enter", false, false, KMOD_LALT);
    push_key("Tab", true, false, KMOD_LALT);
    const Controls controls = poll();
    EXPECT_TRUE(controls.menu.empty());
    EXPECT_TRUE(controls.commands.empty());
    EXPECT_TRUE(controls.changes_full_screen);
    EXPECT_FALSE(poll().changes_full_screen) << "once";
}

TEST_F(SdlInputTest, AFreeMousePointsInPixelsOfTheWindow) {
    EXPECT_FALSE(poll().pointer);
    push_motion(95, 194, 0, 0);
    Controls controls = poll();
    ASSERT_TRUE(controls.pointer);
    EXPECT_FALSE(controls.pointer->has_moved) << "it rests where the window was opened";
    push_motion(100, 200, 5, 6);
    controls = poll();
    EXPECT_EQ(controls.pointer->x_px, 100);
    EXPECT_EQ(controls.pointer->y_px, 200);
    EXPECT_TRUE(controls.pointer->has_moved);
    EXPECT_FALSE(controls.pointer->is_pressed);
    EXPECT_EQ(controls.mouse_x, 0);
    push_button(SDL_BUTTON_LEFT, true, 110, 210);
    push_button(SDL_BUTTON_LEFT, false, 110, 210);
    controls = poll();
    EXPECT_TRUE(controls.pointer->is_pressed);
    EXPECT_FALSE(controls.pointer->has_moved);
    EXPECT_EQ(controls.pointer->x_px, 110);
    EXPECT_EQ(controls.pressed, mouse_button(1));
    EXPECT_FALSE(poll().pointer->is_pressed);
    push_window(SDL_WINDOWEVENT_LEAVE);
    EXPECT_FALSE(poll().pointer);
}

TEST_F(SdlInputTest, ACapturedMouseTurnsAndItsButtonsAct) {
    push_motion(1, 1, 500, 500);  // before it is captured
    window_.input->capture_mouse(true);
    ASSERT_EQ(SDL_GetRelativeMouseMode(), SDL_TRUE);
    EXPECT_EQ(poll().mouse_x, 0);
    push_motion(0, 0, 7, -3);
    push_motion(0, 0, 1, 1);
    push_button(SDL_BUTTON_RIGHT, true);
    push_button(SDL_BUTTON_MIDDLE, true);
    push_button(SDL_BUTTON_MIDDLE, false);
    Controls controls = poll();
    EXPECT_EQ(controls.mouse_x, 8);
    EXPECT_EQ(controls.mouse_y, -2);
    EXPECT_TRUE(controls.moves.has(Action::Forward));
    EXPECT_TRUE(controls.moves.has(Action::Jump));
    EXPECT_FALSE(controls.pointer);
    EXPECT_FALSE(controls.holds_button);
    push_button(SDL_BUTTON_LEFT, true);
    EXPECT_TRUE(poll().holds_button);
    window_.input->capture_mouse(false);
    EXPECT_FALSE(poll().moves.has(Action::Forward));
}

TEST_F(SdlInputTest, TheWheelGoesThroughMenusNotchByNotch) {
    push_wheel(0, 2);
    push_wheel(0, -1);
    EXPECT_EQ(poll().menu, (std::vector<MenuAction>{MenuAction::Up, MenuAction::Up, MenuAction::Down}));
    push_wheel(INT32_MIN, INT32_MIN);
    EXPECT_LE(poll().menu.size(), 16u);
}

TEST_F(SdlInputTest, LosingTheFocusLetsGoOfAllAndFreesTheMouse) {
    VirtualPad pad;
    poll();
    window_.input->capture_mouse(true);
    push_key("W", true);
    push_button(SDL_BUTTON_RIGHT, true);
    pad.set(PadAxis::LeftX, 30'000);
    pad.press(PadButton::A);
    Controls controls = poll();
    EXPECT_TRUE(controls.moves.has(Action::Forward) && controls.moves.has(Action::Jump));
    EXPECT_GT(controls.walk_stick.x, 0);
    push_window(SDL_WINDOWEVENT_FOCUS_LOST);
    controls = poll();
    EXPECT_EQ(controls.moves, Moves{});
    EXPECT_EQ(controls.walk_stick, Stick{});
    EXPECT_EQ(SDL_GetRelativeMouseMode(), SDL_FALSE);
}

TEST_F(SdlInputTest, APadMayComeAndGoInTheGame) {
    {
        VirtualPad pad;
        ASSERT_TRUE(pad.is_plugged_in()) << SDL_GetError();
        EXPECT_EQ(poll().walk_stick, Stick{});
        pad.set(PadAxis::LeftY, -20'000);
        pad.set(PadAxis::RightX, 10'000);
        pad.press(PadButton::A);
        const Controls controls = poll();
        EXPECT_EQ(controls.walk_stick, (Stick{0, 20'000}));
        EXPECT_EQ(controls.look_stick, (Stick{10'000, 0}));
        EXPECT_TRUE(controls.moves.has(Action::Jump));
        EXPECT_EQ(controls.menu, (std::vector<MenuAction>{MenuAction::Up, MenuAction::Accept}));
    }
    const Controls without = poll();
    EXPECT_EQ(without.walk_stick, Stick{});
    EXPECT_FALSE(without.moves.has(Action::Jump));
    VirtualPad again;
    poll();
    again.press(PadButton::Start);
    EXPECT_EQ(poll().commands, Commands{Action::Menu});
}

TEST_F(SdlInputTest, AGentlePushOfTheOnlyPadActs) {
    VirtualPad pad;
    poll();
    pad.set(PadAxis::LeftX, 6'000);
    EXPECT_EQ(poll().walk_stick, (Stick{6'000, 0}));
}

TEST_F(SdlInputTest, TriggersAreButtons) {
    VirtualPad pad;
    poll();
    pad.set(PadAxis::LeftTrigger, INT16_MAX);
    Controls controls = poll();
    EXPECT_TRUE(controls.moves.has(Action::WalkSlowly));
    EXPECT_EQ(controls.pressed, input_named("Pad Left Trigger"));
    pad.set(PadAxis::LeftTrigger, INT16_MIN);
    EXPECT_FALSE(poll().moves.has(Action::WalkSlowly));
}

TEST_F(SdlInputTest, ThePadUsedLastActs) {
    VirtualPad first, second;
    poll();
    first.set(PadAxis::LeftX, 30'000);
    EXPECT_EQ(poll().walk_stick.x, 30'000);
    second.set(PadAxis::LeftX, -3'000);  // lies beside, a little off its middle
    EXPECT_EQ(poll().walk_stick.x, 30'000);
    second.set(PadAxis::LeftX, -30'000);
    EXPECT_EQ(poll().walk_stick.x, -30'000);
    second.unplug();
    EXPECT_EQ(poll().walk_stick.x, 0);
    first.press(PadButton::A);
    EXPECT_TRUE(poll().moves.has(Action::Jump));
}

TEST_F(SdlInputTest, EachPadIsToldByItselfUnderTheLeastFreeNumber) {
    const auto told = [&] {
        std::string text;
        for (const InputEvent& event : window_.input->poll().pad_events) {
            if (event.kind == InputEvent::Kind::Axis) continue;
            text += event.kind == InputEvent::Kind::Press ? "+" : event.kind == InputEvent::Kind::Release ? "-" : "x";
            text += std::to_string(event.input.code);
        }
        return text;
    };
    VirtualPad first, second;
    told();
    second.press(PadButton::A);
    first.press(PadButton::B);
    EXPECT_EQ(told(), "+512+257");
    first.unplug();
    EXPECT_EQ(told(), "-257x256");
    VirtualPad again;
    told();
    again.press(PadButton::A);
    second.release(PadButton::A);
    EXPECT_EQ(told(), "+256-512");
}

TEST_F(SdlInputTest, TextIsToldWithBackspaceAndEnter) {
    const auto push_text = [](const char* text) {
        SDL_Event event{};
        event.type = SDL_TEXTINPUT;
        SDL_strlcpy(event.text.text, text, sizeof event.text.text);
        SDL_PushEvent(&event);
    };
    push_text("a");
    push_key("Backspace", true);
    push_key("Backspace", true, true);
    push_text("\u00e9");
    push_key("Enter", true, false, KMOD_LALT);
    push_key("Enter", true);
    EXPECT_EQ(window_.input->poll().text, "a\b\b\u00e9\n");
    EXPECT_EQ(window_.input->poll().text, "");
}

TEST_F(SdlInputTest, ADeviceThatSdlDoesNotKnowIsIgnoredAndNamed) {
    testing::internal::CaptureStderr();
    VirtualPad wheel(SDL_JOYSTICK_TYPE_WHEEL);
    poll();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("ignored"), std::string::npos);
    wheel.press(PadButton::A);
    EXPECT_FALSE(poll().moves.has(Action::Jump));
}

// Of German, French and Czech keyboards; a Cyrillic one's keys keep their American names.
TEST(KeyLetters, AreThoseOfTheUsersKeyboard) {
    for (const auto& [code_point, name] :
         {std::pair{0x77, "W"}, {0x5b, "["}, {0xf6, "ö"}, {0xdf, "ß"}, {0xe9, "é"}, {0x159, "ř"}})
        EXPECT_EQ(name_of_letter(code_point), name) << code_point;
    for (const int other : {0, 0x20, 0x7f, 0xb2, 0x446, int{SDLK_F1}}) EXPECT_EQ(name_of_letter(other), "") << other;
}

TEST_F(SdlInputTest, LocalNamesArePrintable) {
    EXPECT_EQ(window_.input->local_name_of(input_named("W")), "W");
    EXPECT_EQ(window_.input->local_name_of(input_named("Left Bracket")), "[");
    EXPECT_EQ(window_.input->local_name_of(input_named("Left Shift")), "Left Shift");
    EXPECT_EQ(window_.input->local_name_of(input_named("Pad A")), "Pad A");
}

}  // namespace
}  // namespace oblong::test
