#include "game/input/input_mapper.h"

#include <gtest/gtest.h>

namespace oblong {
namespace {

using Commands = std::vector<Action>;
using Menu = std::vector<MenuAction>;

const Bindings kBindings = default_bindings();

Input named(const char* name) {
    return input_named(name);
}

TEST(InputMapper, AHeldKeyMovesUntilItIsLetGo) {
    InputMapper mapper(kBindings);
    mapper.press(named("W"));
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Forward));
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Forward));
    mapper.release(named("W"));
    EXPECT_FALSE(mapper.take(0).moves.has(Action::Forward));
}

TEST(InputMapper, AKeyPressedAndLetGoBetweenTwoPollsCountsOnce) {
    InputMapper mapper(kBindings);
    mapper.press(named("Space"));
    mapper.release(named("Space"));
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Jump));
    EXPECT_FALSE(mapper.take(0).moves.has(Action::Jump));
}

TEST(InputMapper, TwoInputsOfAMoveHoldItTogether) {
    InputMapper mapper(kBindings);
    mapper.press(named("Left Shift"));
    mapper.press(named("Right Shift"));
    mapper.release(named("Left Shift"));
    mapper.take(0);
    EXPECT_TRUE(mapper.take(0).moves.has(Action::WalkSlowly));
}

TEST(InputMapper, KeysOfPanelsAreKeptApart) {
    InputMapper mapper(kBindings);
    mapper.press(named("Up"));
    const Controls controls = mapper.take(0);
    EXPECT_FALSE(controls.moves.has(Action::Forward));
    EXPECT_TRUE(controls.panel_moves.has(Action::Forward));
    EXPECT_EQ(controls.commands, Commands{Action::DialUp});
}

TEST(InputMapper, CommandsComeOnceForEachPressAndThoseOfPanelsAgainWhileHeld) {
    InputMapper mapper(kBindings);
    for (const char* name : {"F1", "Left"}) {
        mapper.press(named(name));
        mapper.repeat(named(name));
        mapper.repeat(named(name));
    }
    EXPECT_EQ(mapper.take(0).commands,
              (Commands{Action::ShowHelp, Action::DialCoarser, Action::DialCoarser, Action::DialCoarser}));
    EXPECT_TRUE(mapper.take(0).commands.empty());
}

TEST(InputMapper, InMenusDirectionsAreRepeatedAndAcceptIsNot) {
    InputMapper mapper(kBindings);
    for (const char* name : {"Down", "Enter"}) {
        mapper.press(named(name));
        mapper.repeat(named(name));
    }
    EXPECT_EQ(mapper.take(0).menu, (Menu{MenuAction::Down, MenuAction::Down, MenuAction::Accept}));
}

TEST(InputMapper, MenusAreWorkedByThePadAlone) {
    InputMapper mapper(kBindings);
    for (const char* name : {"Pad Up", "Pad A", "Pad B", "Pad Start"}) mapper.press(named(name));
    mapper.move_axis(named("Pad Left Stick Down"), kFullAxis);
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.menu, (Menu{MenuAction::Up, MenuAction::Accept, MenuAction::Back, MenuAction::Down}));
    EXPECT_EQ(std::count(controls.commands.begin(), controls.commands.end(), Action::Menu), 1);
}

TEST(InputMapper, APadsDirectionIsRepeatedByTheClockWhileItIsHeld) {
    InputMapper mapper(kBindings);
    mapper.press(named("Pad Down"));
    int times = 0;
    for (std::uint64_t ms = 1000; ms <= 2000; ms += 10) times += static_cast<int>(mapper.take(ms).menu.size());
    EXPECT_GE(times, 5);
    EXPECT_LE(times, 8);
    mapper.release(named("Pad Down"));
    EXPECT_TRUE(mapper.take(5000).menu.empty());
}

TEST(InputMapper, EscapeAndStartOpenTheMenuWhateverIsBound) {
    const Bindings none;
    InputMapper mapper(none);
    for (const char* name : {"Escape", "Pad Start"}) {
        mapper.press(named(name));
        EXPECT_EQ(mapper.take(0).commands, Commands{Action::Menu}) << name;
    }
}

TEST(InputMapper, SticksMoveByHowFarTheyArePushed) {
    InputMapper mapper(kBindings);
    mapper.move_axis(named("Pad Left Stick Up"), 20'000);
    mapper.move_axis(named("Pad Left Stick Left"), 3'000);
    mapper.move_axis(named("Pad Right Stick Right"), 40'000);
    mapper.move_axis(named("Pad Right Stick Down"), 5);
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.walk_stick, (Stick{-3'000, 20'000}));
    EXPECT_EQ(controls.look_stick, (Stick{kFullAxis, -5}));
    EXPECT_FALSE(controls.moves.has(Action::Forward) || controls.moves.has(Action::TurnRight));
}

TEST(InputMapper, ATriggerIsAButtonThatDoesNotFlutter) {
    InputMapper mapper(kBindings);
    const Input trigger = named("Pad Right Trigger");
    mapper.move_axis(trigger, 16'000);
    EXPECT_FALSE(mapper.take(0).moves.has(Action::Jump));
    mapper.move_axis(trigger, 17'000);
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Jump));
    mapper.move_axis(trigger, 15'000);  // a little back: still held
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Jump));
    mapper.move_axis(trigger, 12'000);
    EXPECT_FALSE(mapper.take(0).moves.has(Action::Jump));
}

TEST(InputMapper, LettingGoOfAllEndsEverything) {
    InputMapper mapper(kBindings);
    for (const char* name : {"W", "Up", "Space", "Mouse 1", "Pad A"}) mapper.press(named(name));
    mapper.move_axis(named("Pad Left Stick Up"), kFullAxis);
    mapper.release_all();
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.moves, Moves{});
    EXPECT_EQ(controls.panel_moves, Moves{});
    EXPECT_EQ(controls.walk_stick, Stick{});
    EXPECT_FALSE(controls.holds_button);
}

TEST(InputMapper, APadThatIsUnpluggedLeavesTheKeysHeld) {
    InputMapper mapper(kBindings);
    mapper.press(named("W"));
    mapper.press(named("Pad A"));
    mapper.take(0);
    mapper.release_pad();
    const Controls controls = mapper.take(0);
    EXPECT_TRUE(controls.moves.has(Action::Forward));
    EXPECT_FALSE(controls.moves.has(Action::Jump));
}

TEST(InputMapper, TheLastPressIsReportedForRebindingAlsoWhereNothingIsBound) {
    InputMapper mapper(kBindings);
    EXPECT_FALSE(mapper.take(0).pressed);
    mapper.press(named("W"));
    mapper.press(named("F20"));
    EXPECT_EQ(mapper.take(0).pressed, named("F20"));
    EXPECT_FALSE(mapper.take(0).pressed);
    mapper.move_axis(named("Pad Left Trigger"), kFullAxis);
    EXPECT_EQ(mapper.take(0).pressed, named("Pad Left Trigger"));
}

TEST(InputMapper, OtherBindingsActAtOnce) {
    Bindings bindings;
    InputMapper mapper(bindings);
    set_inputs(bindings, Action::Jump, "W Wheel-Up");
    set_inputs(bindings, Action::Torch, "Mouse-4");
    set_inputs(bindings, Action::Forward, "Pad-Right-Trigger");
    mapper.press(named("W"));
    mapper.press(named("Mouse 4"));
    mapper.move_axis(named("Pad Right Trigger"), 16'384);
    const Controls controls = mapper.take(0);
    EXPECT_TRUE(controls.moves.has(Action::Jump));
    EXPECT_FALSE(controls.moves.has(Action::Forward));  // but by the trigger, half of the speed:
    EXPECT_EQ(controls.walk_stick, (Stick{0, 16'384}));
    EXPECT_EQ(controls.commands, Commands{Action::Torch});
}

TEST(InputMapper, AFreeMouseClicksInsteadOfWalking) {
    InputMapper mapper(kBindings);
    mapper.click(named("Mouse 2"));
    const Controls controls = mapper.take(0);
    EXPECT_FALSE(controls.moves.has(Action::Forward));
    EXPECT_EQ(controls.menu, Menu{MenuAction::Back});
    EXPECT_EQ(controls.pressed, named("Mouse 2"));
    mapper.press(named("Mouse 2"));  // captured
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Forward));
}

}  // namespace
}  // namespace oblong
