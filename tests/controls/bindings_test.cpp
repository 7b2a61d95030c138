#include "game/input/bindings.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

constexpr std::array<Hands, kHandsCount> kAllHands{Hands::Both, Hands::Left, Hands::Right};

Input key(std::uint16_t code) {
    return {Device::Key, code};
}

std::vector<Input> all_inputs() {
    std::vector<Input> inputs;
    for (std::uint16_t code = 1; code < 512; ++code) inputs.push_back(key(code));
    for (std::uint16_t number = 1; number < 32; ++number) inputs.push_back(mouse_button(number));
    for (std::uint16_t turn = 0; turn < 4; ++turn) inputs.push_back({Device::MouseWheel, turn});
    for (std::uint16_t button = 0; button < 21; ++button) inputs.push_back({Device::PadButton, button});
    for (std::uint16_t half = 0; half < 8; ++half) inputs.push_back({Device::PadAxis, half});
    inputs.push_back(pad_axis(PadAxis::LeftTrigger, true));
    inputs.push_back(pad_axis(PadAxis::RightTrigger, true));
    return inputs;
}

TEST(Input, EveryNameIsOfOneInputAndLeadsBackToIt) {
    std::set<std::string> names;
    for (const Input input : all_inputs()) {
        const std::string name = name_of(input);
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_EQ(input_named(name), input) << name;
    }
}

TEST(Input, KeysAreCalledAsOnAUsKeyboard) {
    EXPECT_EQ(name_of(key(26)), "W");  // USB HID Usage Tables 1.4, page 7
    EXPECT_EQ(name_of(key(4)), "A");
    EXPECT_EQ(name_of(key(29)), "Z");
    EXPECT_EQ(name_of(key(30)), "1");
    EXPECT_EQ(name_of(key(39)), "0");
    EXPECT_EQ(name_of(key(69)), "F12");
    EXPECT_EQ(name_of(key(82)), "Up");
    EXPECT_EQ(name_of(key(225)), "Left Shift");
    EXPECT_EQ(name_of(key(135)), "Key 135");
    EXPECT_EQ(name_of(mouse_button(1)), "Mouse 1");
    EXPECT_EQ(name_of(pad_button(PadButton::A)), "Pad A");
    EXPECT_EQ(name_of(pad_axis(PadAxis::LeftY, false)), "Pad Left Stick Up");
}

TEST(Input, NamesAreReadInAnyCaseAndWithHyphens) {
    EXPECT_EQ(input_named("LEFT-shift"), key(225));
    EXPECT_EQ(input_named("w"), key(26));
    EXPECT_EQ(input_named("pad-left-trigger"), pad_axis(PadAxis::LeftTrigger, true));
    for (const char* wrong : {"", "Key", "Key ", "Key 0", "Key 512", "Key 99999999999", "Key -1", "Mouse 0", "Mouse 32",
                              "Pad", "Pad-", "Wheel", "Wheel Round", "AA", "\xc3\xa9"})
        EXPECT_THROW(input_named(wrong), InputError) << wrong;
}

TEST(Bindings, EveryActionHasOneRow) {
    std::set<Action> actions;
    std::set<std::string_view> names, labels;
    for (const ActionRow& row : all_actions()) {
        EXPECT_TRUE(actions.insert(row.action).second) << row.name;
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(labels.insert(row.label).second) << row.label;
        EXPECT_LE(row.label.size(), 20u) << row.label;
    }
    EXPECT_EQ(actions.size(), static_cast<std::size_t>(kActionCount));
}

TEST(Bindings, DefaultsBindEveryActionAndNoInputTwice) {
    for (const Hands hands : kAllHands) {
        const Bindings bindings = default_bindings(hands);
        for (const ActionRow& row : all_actions()) EXPECT_FALSE(bindings.inputs_of(row.action).empty()) << row.name;
        for (const Conflict& conflict : conflicts_of(bindings)) ADD_FAILURE() << name_of(conflict.input);
    }
}

void expect_moves_by(Hands hands, const std::function<bool(Input)>& is_near) {
    const Bindings bindings = default_bindings(hands);
    for (int move = 0; move < kMoveCount; ++move)
        for (const Input input : bindings.inputs_of(static_cast<Action>(move)))
            EXPECT_TRUE(input.device != Device::Key || is_near(input)) << name_of(input);
}

// The keys of a US keyboard under one hand: the left one's columns up to T, G, B; the right one's from Insert on.
TEST(Bindings, OneHandReachesEveryMove) {
    const std::set<std::string> left{"Q", "W", "E", "R", "T", "A", "S",   "D",          "F",         "G",
                                     "Z", "X", "C", "V", "B", "1", "Tab", "Left Shift", "Left Ctrl", "Space"};
    expect_moves_by(Hands::Left, [&](Input input) { return left.count(name_of(input)) != 0; });
    expect_moves_by(Hands::Right, [](Input input) {
        return (input.code >= 73 && input.code <= 99) || input.code == 228 || input.code == 229;
    });
}

TEST(Bindings, TextOfEveryActionLeadsBackToTheSameBindings) {
    for (const Hands hands : kAllHands) {
        const Bindings bindings = default_bindings(hands);
        Bindings read = default_bindings(Hands::Both);
        for (const ActionRow& row : all_actions()) set_inputs(read, row.action, inputs_to_text(bindings, row.action));
        EXPECT_EQ(read, bindings);
    }
}

TEST(Bindings, BrokenTextChangesNothing) {
    Bindings bindings = default_bindings();
    for (const char* wrong : {"W Nonsense", "Escape", "W,S", "A B C D E F G", "Pad-Start"})
        EXPECT_THROW(set_inputs(bindings, Action::Forward, wrong), InputError) << wrong;
    EXPECT_EQ(bindings, default_bindings());
    set_inputs(bindings, Action::Forward, "none");
    EXPECT_TRUE(bindings.inputs_of(Action::Forward).empty());
    EXPECT_EQ(inputs_to_text(bindings, Action::Forward), "none");
    set_inputs(bindings, Action::Forward, "  mouse-1\tF24 ");
    EXPECT_EQ(inputs_to_text(bindings, Action::Forward), "Mouse-1 F24");
}

TEST(Bindings, ConflictsNameTheInputAndAllItsActions) {
    Bindings bindings = default_bindings();
    bindings.bind(Action::Jump, input_named("W"));
    bindings.bind(Action::Torch, input_named("W"));
    const std::vector<Conflict> conflicts = conflicts_of(bindings);
    ASSERT_EQ(conflicts.size(), 1u);
    EXPECT_EQ(name_of(conflicts[0].input), "W");
    EXPECT_EQ(conflicts[0].actions, (std::vector<Action>{Action::Forward, Action::Jump, Action::Torch}));
    bindings.unbind(Action::Jump, input_named("W"));
    bindings.unbind(Action::Forward, input_named("W"));
    EXPECT_TRUE(conflicts_of(bindings).empty());
}

TEST(Bindings, KeysOfPanelsClashWithCommandsButNotWithMoves) {
    Bindings bindings = default_bindings();
    bindings.bind(Action::Jump, input_named("Left"));  // turns left, too
    EXPECT_EQ(conflicts_of(bindings).size(), 1u);
    bindings = default_bindings();
    bindings.bind(Action::Torch, input_named("Page-Up"));
    EXPECT_EQ(conflicts_of(bindings).size(), 1u);
}

TEST(Bindings, AnActionKeepsItsLastInputsAndNeverAReservedOne) {
    Bindings bindings;
    for (std::uint16_t code = 4; code < 14; ++code) bindings.bind(Action::Jump, key(code));
    bindings.bind(Action::Jump, key(13));
    bindings.bind(Action::Jump, input_named("Escape"));
    EXPECT_EQ(inputs_to_text(bindings, Action::Jump), "E F G H I J");
}

}  // namespace
}  // namespace oblong
