#include "engine/platform/input_mapper.h"

#include <gtest/gtest.h>

namespace oblong {
namespace {

using Commands = std::vector<Command>;
using Menu = std::vector<MenuAction>;

Input named(const char* name) {
    return input_named(name);
}

TEST(InputMapper, AHeldKeyMovesUntilItIsLetGo) {
    InputMapper mapper;
    mapper.press(named("W"));
    EXPECT_TRUE(mapper.take(0).forward);
    EXPECT_TRUE(mapper.take(0).forward);
    mapper.release(named("W"));
    EXPECT_FALSE(mapper.take(0).forward);
}

TEST(InputMapper, AKeyPressedAndLetGoBetweenTwoPollsCountsOnce) {
    InputMapper mapper;
    mapper.press(named("Space"));
    mapper.release(named("Space"));
    EXPECT_TRUE(mapper.take(0).jump);
    EXPECT_FALSE(mapper.take(0).jump);
}

TEST(InputMapper, TwoInputsOfAMoveHoldItTogether) {
    InputMapper mapper;
    mapper.press(named("Left Shift"));
    mapper.press(named("Right Shift"));
    mapper.release(named("Left Shift"));
    mapper.take(0);
    EXPECT_TRUE(mapper.take(0).walk_slowly);
}

TEST(InputMapper, KeysOfPanelsAreKeptApart) {
    InputMapper mapper;
    mapper.press(named("Up"));
    const Controls controls = mapper.take(0);
    EXPECT_FALSE(controls.forward);
    EXPECT_TRUE(controls.panel_keys.forward);
    EXPECT_EQ(controls.commands, Commands{Command::DialUp});
}

TEST(InputMapper, CommandsComeOnceForEachPressAndThoseOfPanelsAgainWhileHeld) {
    InputMapper mapper;
    for (const char* name : {"F1", "Left"}) {
        mapper.press(named(name));
        mapper.repeat(named(name));
        mapper.repeat(named(name));
    }
    EXPECT_EQ(mapper.take(0).commands,
              (Commands{Command::ShowHelp, Command::DialCoarser, Command::DialCoarser, Command::DialCoarser}));
    EXPECT_TRUE(mapper.take(0).commands.empty());
}

TEST(InputMapper, InMenusDirectionsAreRepeatedAndAcceptIsNot) {
    InputMapper mapper;
    for (const char* name : {"Down", "Enter"}) {
        mapper.press(named(name));
        mapper.repeat(named(name));
    }
    EXPECT_EQ(mapper.take(0).menu, (Menu{MenuAction::Down, MenuAction::Down, MenuAction::Accept}));
}

TEST(InputMapper, MenusAreWorkedByThePadAlone) {
    InputMapper mapper;
    for (const char* name : {"Pad Up", "Pad A", "Pad B", "Pad Start"}) mapper.press(named(name));
    mapper.move_axis(named("Pad Left Stick Down"), kFullAxis);
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.menu, (Menu{MenuAction::Up, MenuAction::Accept, MenuAction::Back, MenuAction::Down}));
    EXPECT_EQ(std::count(controls.commands.begin(), controls.commands.end(), Command::Menu), 1);
}

TEST(InputMapper, APadsDirectionIsRepeatedByTheClockWhileItIsHeld) {
    InputMapper mapper;
    mapper.press(named("Pad Down"));
    int times = 0;
    for (std::uint64_t ms = 1000; ms <= 2000; ms += 10) times += static_cast<int>(mapper.take(ms).menu.size());
    EXPECT_GE(times, 5);
    EXPECT_LE(times, 8);
    mapper.release(named("Pad Down"));
    EXPECT_TRUE(mapper.take(5000).menu.empty());
}

TEST(InputMapper, EscapeAndStartOpenTheMenuWhateverIsBound) {
    InputMapper mapper;
    mapper.use({});
    for (const char* name : {"Escape", "Pad Start"}) {
        mapper.press(named(name));
        EXPECT_EQ(mapper.take(0).commands, Commands{Command::Menu}) << name;
    }
}

TEST(InputMapper, SticksMoveByHowFarTheyArePushed) {
    InputMapper mapper;
    mapper.move_axis(named("Pad Left Stick Up"), 20'000);
    mapper.move_axis(named("Pad Left Stick Left"), 3'000);
    mapper.move_axis(named("Pad Right Stick Right"), 40'000);
    mapper.move_axis(named("Pad Right Stick Down"), 5);
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.walk_stick, (Stick{-3'000, 20'000}));
    EXPECT_EQ(controls.look_stick, (Stick{kFullAxis, -5}));
    EXPECT_FALSE(controls.forward || controls.turn_right);
}

TEST(InputMapper, ATriggerIsAButtonThatDoesNotFlutter) {
    InputMapper mapper;
    const Input trigger = named("Pad Right Trigger");
    mapper.move_axis(trigger, 16'000);
    EXPECT_FALSE(mapper.take(0).jump);
    mapper.move_axis(trigger, 17'000);
    EXPECT_TRUE(mapper.take(0).jump);
    mapper.move_axis(trigger, 15'000);  // a little back: still held
    EXPECT_TRUE(mapper.take(0).jump);
    mapper.move_axis(trigger, 12'000);
    EXPECT_FALSE(mapper.take(0).jump);
}

TEST(InputMapper, LettingGoOfAllEndsEverything) {
    InputMapper mapper;
    for (const char* name : {"W", "Up", "Space", "Mouse 1", "Pad A"}) mapper.press(named(name));
    mapper.move_axis(named("Pad Left Stick Up"), kFullAxis);
    mapper.release_all();
    const Controls controls = mapper.take(0);
    EXPECT_EQ(static_cast<const HeldMoves&>(controls), HeldMoves{});
    EXPECT_EQ(controls.panel_keys, HeldMoves{});
    EXPECT_EQ(controls.walk_stick, Stick{});
    EXPECT_FALSE(controls.holds_button);
}

TEST(InputMapper, APadThatIsUnpluggedLeavesTheKeysHeld) {
    InputMapper mapper;
    mapper.press(named("W"));
    mapper.press(named("Pad A"));
    mapper.take(0);
    mapper.release_pad();
    const Controls controls = mapper.take(0);
    EXPECT_TRUE(controls.forward);
    EXPECT_FALSE(controls.jump);
}

TEST(InputMapper, TheLastPressIsReportedForRebindingAlsoWhereNothingIsBound) {
    InputMapper mapper;
    EXPECT_FALSE(mapper.take(0).pressed);
    mapper.press(named("W"));
    mapper.press(named("F20"));
    EXPECT_EQ(mapper.take(0).pressed, named("F20"));
    EXPECT_FALSE(mapper.take(0).pressed);
    mapper.move_axis(named("Pad Left Trigger"), kFullAxis);
    EXPECT_EQ(mapper.take(0).pressed, named("Pad Left Trigger"));
}

TEST(InputMapper, OtherBindingsActAtOnce) {
    InputMapper mapper;
    Bindings bindings;
    set_inputs(bindings, Move::Jump, "W Wheel-Up");
    set_inputs(bindings, Command::Torch, "Mouse-4");
    set_inputs(bindings, Move::Forward, "Pad-Right-Trigger");
    mapper.use(bindings);
    mapper.press(named("W"));
    mapper.press(named("Mouse 4"));
    mapper.move_axis(named("Pad Right Trigger"), 16'384);
    const Controls controls = mapper.take(0);
    EXPECT_TRUE(controls.jump);
    EXPECT_FALSE(controls.forward);  // but by the trigger, half of the speed:
    EXPECT_EQ(controls.walk_stick, (Stick{0, 16'384}));
    EXPECT_EQ(controls.commands, Commands{Command::Torch});
}

TEST(InputMapper, AFreeMouseClicksInsteadOfWalking) {
    InputMapper mapper;
    mapper.click(named("Mouse 2"));
    const Controls controls = mapper.take(0);
    EXPECT_FALSE(controls.forward);
    EXPECT_EQ(controls.menu, Menu{MenuAction::Back});
    EXPECT_EQ(controls.pressed, named("Mouse 2"));
    mapper.press(named("Mouse 2"));  // captured
    EXPECT_TRUE(mapper.take(0).forward);
}

}  // namespace
}  // namespace oblong
