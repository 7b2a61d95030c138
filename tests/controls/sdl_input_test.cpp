#include <SDL.h>
#include <gtest/gtest.h>

#include <list>
#include <map>

#include "game/input/input_mapper.h"
#include "tests/controls/told_controls.h"
#include "tests/controls/virtual_pad.h"

namespace oblong::test {
namespace {

class SdlInputTest : public testing::Test {
  protected:
    static void push(SDL_EventType type, auto fill) {
        SDL_Event event{};
        event.type = type;
        fill(event);
        SDL_PushEvent(&event);
    }
    static void push_key(const std::string& name, bool is_down, bool is_repeat = false, std::uint16_t modifiers = 0) {
        push(is_down ? SDL_KEYDOWN : SDL_KEYUP, [&](SDL_Event& event) {
            event.key.state = is_down ? SDL_PRESSED : SDL_RELEASED;
            event.key.repeat = is_repeat ? 1 : 0;
            event.key.keysym.scancode = static_cast<SDL_Scancode>(input_named(name).code);
            event.key.keysym.mod = modifiers;
        });
    }

    UnseenWindow window_;
};

/// What SDL reports, and what the game makes of it (told_controls.h):
///
///     down W; again W; up W; alt Enter        keys: pressed, repeated by the system, let go, pressed with Alt
///     down 1 110 210; up 1 110 210            a button of the mouse, at a place; `notch 0 -1` of the wheel
///     move 100 200 5 6                        the mouse to a place, by so much
///     capture; free; leave; unfocus           the mouse; the window
///     plug; unplug 0; stick 0 LeftX 30000     gamepads, in the order in which they came; `button 0 A`
class SdlScript : SdlInputTest {
  public:
    SdlScript() { poll(); }
    void run(const ScriptLine& line) {
        for (const Words& words : line.actions) act(words);
        check_controls(line, [this] { return poll(); });
    }

  private:
    void TestBody() override {}
    Controls poll() { return mapper_.take(window_.input->poll(), SDL_GetTicks64()); }
    void act(const Words& words) {
        const std::string& verb = words[0];
        const auto number = [&](std::size_t i) { return i < words.size() ? std::stoi(words[i]) : 0; };
        const bool is_down = verb == "down" || verb == "again";
        if (verb == "move") {
            push(SDL_MOUSEMOTION, [&](SDL_Event& event) {
                event.motion.x = number(1), event.motion.y = number(2);
                event.motion.xrel = number(3), event.motion.yrel = number(4);
            });
        } else if (verb == "notch") {
            push(SDL_MOUSEWHEEL, [&](SDL_Event& event) { event.wheel.x = number(1), event.wheel.y = number(2); });
        } else if (verb == "leave" || verb == "unfocus") {
            push(SDL_WINDOWEVENT, [&](SDL_Event& event) {
                event.window.event = verb == "leave" ? SDL_WINDOWEVENT_LEAVE : SDL_WINDOWEVENT_FOCUS_LOST;
            });
        } else if (verb == "capture" || verb == "free") {
            window_.input->capture_mouse(verb == "capture");
        } else if (verb == "is_captured") {
            EXPECT_EQ(SDL_GetRelativeMouseMode(), words.at(1) == "yes" ? SDL_TRUE : SDL_FALSE);
        } else if (verb == "plug") {
            pads_.emplace_back();
            ASSERT_TRUE(pads_.back().is_plugged_in()) << SDL_GetError();
            poll();
        } else if (verb == "unplug") {
            pad(number(1)).unplug();
        } else if (verb == "stick") {
            pad(number(1)).set(kAxes.at(words.at(2)), number(3));
        } else if (verb == "button") {
            pad(number(1)).press(static_cast<PadButton>(input_named("Pad " + words.at(2)).code));
        } else if (verb == "alt") {
            push_key(words.at(1), true, false, KMOD_LALT);
        } else if (std::isdigit(words.at(1)[0]) != 0) {
            push(is_down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP, [&](SDL_Event& event) {
                event.button.state = is_down ? SDL_PRESSED : SDL_RELEASED;
                event.button.button = static_cast<std::uint8_t>(number(1));
                event.button.x = number(2), event.button.y = number(3);
            });
        } else {
            push_key(words[1], is_down, verb == "again");
        }
    }
    VirtualPad& pad(int number) { return *std::next(pads_.begin(), number); }

    inline static const std::map<std::string, PadAxis> kAxes{{"LeftX", PadAxis::LeftX},
                                                             {"LeftY", PadAxis::LeftY},
                                                             {"RightX", PadAxis::RightX},
                                                             {"Left", PadAxis::LeftTrigger}};
    Bindings bindings_ = default_bindings();
    InputMapper mapper_{bindings_};
    std::list<VirtualPad> pads_;
};

constexpr Script kReported[] = {
    {"KeysWalkAndCommand", "down W; down F1; again F1; up F1: moves = forward, commands = help \n up W: moves ="},
    {"AltWithEnterOrTabIsTheWindowsOwn", R"(
        alt Enter; up Enter; alt Tab: menu =, commands =, full_screen = yes
        : full_screen =
    )"},
    // It rests where the window was opened.
    {"AFreeMousePointsInPixelsOfTheWindow", R"(
        : pointer =
        move 95 194 0 0: pointer = 95 194
        move 100 200 5 6: pointer = 100 200 moved, mouse = 0 0
        down 1 110 210; up 1 110 210: pointer = 110 210 pressed, pressed = Mouse 1
        : pointer = 110 210
        leave: pointer =
    )"},
    {"ACapturedMouseTurnsAndItsButtonsAct", R"(
        move 1 1 500 500; capture; is_captured yes: mouse = 0 0     # it was before
        move 0 0 7 -3; move 0 0 1 1; down 3: mouse = 8 -2, moves = forward, pointer =, held =
        down 2; up 2: moves = forward jump
        down 1: held = yes
        free: moves =
    )"},
    {"TheWheelGoesThroughMenusNotchByNotch", R"(
        notch 0 2; notch 0 -1: menu = up up down
        notch -2147483648 -2147483648
        : menu = down down down down down down down down down down down down down down down down
    )"},
    {"LosingTheFocusLetsGoOfAllAndFreesTheMouse", R"(
        plug; capture; down W; down 3; stick 0 LeftX 30000; button 0 A: moves = forward jump, walk = 30000 0
        unfocus: moves =, walk = 0 0
        is_captured no
    )"},
    {"APadMayComeAndGoInTheGame", R"(
        plug: walk = 0 0
        stick 0 LeftY -20000; stick 0 RightX 10000; button 0 A
        : walk = 0 20000, look = 10000 0, moves = jump, menu = up accept
        unplug 0: walk = 0 0, moves =
        plug; button 1 Start: commands = menu
    )"},
    {"AGentlePushOfTheOnlyPadActs", "plug; stick 0 LeftX 6000: walk = 6000 0"},
    {"TriggersAreButtons", R"(
        plug; stick 0 Left 32767: moves = walk-slowly, pressed = Pad Left Trigger
        stick 0 Left -32768: moves =
    )"},
    // The second lies beside, a little off its middle.
    {"ThePadUsedLastActs", R"(
        plug; plug; stick 0 LeftX 30000: walk = 30000 0
        stick 1 LeftX -3000: walk = 30000 0
        stick 1 LeftX -30000: walk = -30000 0
        unplug 1: walk = 0 0
        button 0 A: moves = jump
    )"},
};
void report(const Script& script) {
    SdlScript sdl;
    for (const ScriptLine& line : script_lines(script.text)) sdl.run(line);
}
OBLONG_SCRIPTS(SdlScripts, kReported, report);

TEST_F(SdlInputTest, ScancodesAreTheNumbersOfTheNames) {
    for (const auto& [name, code] : {std::pair{"W", SDL_SCANCODE_W},
                                     {"Right Ctrl", SDL_SCANCODE_RCTRL},
                                     {"Keypad Enter", SDL_SCANCODE_KP_ENTER},
                                     {"F24", SDL_SCANCODE_F24},
                                     {"Less", SDL_SCANCODE_NONUSBACKSLASH},
                                     {"0", SDL_SCANCODE_0}})
        EXPECT_EQ(input_named(name).code, code) << name;
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
        push(SDL_TEXTINPUT, [&](SDL_Event& event) { SDL_strlcpy(event.text.text, text, sizeof event.text.text); });
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
    window_.input->poll();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("ignored"), std::string::npos);
    wheel.press(PadButton::A);
    const PlatformInput input = window_.input->poll();
    EXPECT_TRUE(input.events.empty() && input.pad_events.empty());
}

// Of German, French and Czech keyboards; a Cyrillic one's keys keep their American names.
TEST(KeyLetters, AreThoseOfTheUsersKeyboard) {
    for (const auto& [code_point, name] :
         {std::pair{0x77, "W"}, {0x5b, "["}, {0xf6, "ö"}, {0xdf, "ß"}, {0xe9, "é"}, {0x159, "ř"}})
        EXPECT_EQ(name_of_letter(code_point), name) << code_point;
    for (const int other : {0, 0x20, 0x7f, 0xb2, 0x446, int{SDLK_F1}}) EXPECT_EQ(name_of_letter(other), "") << other;
}

TEST_F(SdlInputTest, LocalNamesArePrintable) {
    for (const auto& [input, name] :
         {std::pair{"W", "W"}, {"Left Bracket", "["}, {"Left Shift", "Left Shift"}, {"Pad A", "Pad A"}})
        EXPECT_EQ(window_.input->local_name_of(input_named(input)), name);
}

}  // namespace
}  // namespace oblong::test
