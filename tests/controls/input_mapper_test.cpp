#include "game/input/input_mapper.h"

#include <gtest/gtest.h>

namespace oblong {
namespace {

using Commands = std::vector<Action>;
using Menu = std::vector<MenuAction>;

const Bindings kBindings = default_bindings();

class InputMapperTest : public testing::Test {
  protected:
    void press(std::initializer_list<const char*> names) {
        for (const char* name : names) mapper.press(input_named(name));
    }

    InputMapper mapper{kBindings};
};

TEST_F(InputMapperTest, AHeldKeyMovesUntilItIsLetGo) {
    press({"W"});
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Forward));
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Forward));
    mapper.release(input_named("W"));
    EXPECT_FALSE(mapper.take(0).moves.has(Action::Forward));
}

TEST_F(InputMapperTest, AKeyPressedAndLetGoBetweenTwoPollsCountsOnce) {
    press({"Space"});
    mapper.release(input_named("Space"));
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Jump));
    EXPECT_FALSE(mapper.take(0).moves.has(Action::Jump));
}

TEST_F(InputMapperTest, TwoInputsOfAMoveHoldItTogether) {
    press({"Left Shift", "Right Shift"});
    mapper.release(input_named("Left Shift"));
    mapper.take(0);
    EXPECT_TRUE(mapper.take(0).moves.has(Action::WalkSlowly));
}

TEST_F(InputMapperTest, KeysOfPanelsAreKeptApart) {
    press({"Up"});
    const Controls controls = mapper.take(0);
    EXPECT_FALSE(controls.moves.has(Action::Forward));
    EXPECT_TRUE(controls.panel_moves.has(Action::Forward));
    EXPECT_EQ(controls.commands, Commands{Action::DialUp});
}

TEST_F(InputMapperTest, CommandsComeOnceForEachPressAndThoseOfPanelsAgainWhileHeld) {
    for (const char* name : {"F1", "Left"}) {
        mapper.press(input_named(name));
        mapper.repeat(input_named(name));
        mapper.repeat(input_named(name));
    }
    EXPECT_EQ(mapper.take(0).commands,
              (Commands{Action::ShowHelp, Action::DialCoarser, Action::DialCoarser, Action::DialCoarser}));
    EXPECT_TRUE(mapper.take(0).commands.empty());
}

TEST_F(InputMapperTest, InMenusDirectionsAreRepeatedAndAcceptIsNot) {
    for (const char* name : {"Down", "Enter"}) {
        mapper.press(input_named(name));
        mapper.repeat(input_named(name));
    }
    EXPECT_EQ(mapper.take(0).menu, (Menu{MenuAction::Down, MenuAction::Down, MenuAction::Accept}));
}

TEST_F(InputMapperTest, MenusAreWorkedByThePadAlone) {
    press({"Pad Up", "Pad A", "Pad B", "Pad Start"});
    mapper.move_axis(input_named("Pad Left Stick Down"), kFullAxis);
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.menu, (Menu{MenuAction::Up, MenuAction::Accept, MenuAction::Back, MenuAction::Down}));
    EXPECT_EQ(std::count(controls.commands.begin(), controls.commands.end(), Action::Menu), 1);
}

TEST_F(InputMapperTest, APadsDirectionIsRepeatedByTheClockWhileItIsHeld) {
    press({"Pad Down"});
    int times = 0;
    for (std::uint64_t ms = 1000; ms <= 2000; ms += 10) times += static_cast<int>(mapper.take(ms).menu.size());
    EXPECT_GE(times, 5);
    EXPECT_LE(times, 8);
    mapper.release(input_named("Pad Down"));
    EXPECT_TRUE(mapper.take(5000).menu.empty());
}

TEST(InputMapper, EscapeAndStartOpenTheMenuWhateverIsBound) {
    const Bindings none;
    InputMapper mapper(none);
    for (const char* name : {"Escape", "Pad Start"}) {
        mapper.press(input_named(name));
        EXPECT_EQ(mapper.take(0).commands, Commands{Action::Menu}) << name;
    }
}

TEST_F(InputMapperTest, SticksMoveByHowFarTheyArePushed) {
    mapper.move_axis(input_named("Pad Left Stick Up"), 20'000);
    mapper.move_axis(input_named("Pad Left Stick Left"), 3'000);
    mapper.move_axis(input_named("Pad Right Stick Right"), 40'000);
    mapper.move_axis(input_named("Pad Right Stick Down"), 5);
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.walk_stick, (Stick{-3'000, 20'000}));
    EXPECT_EQ(controls.look_stick, (Stick{kFullAxis, -5}));
    EXPECT_FALSE(controls.moves.has(Action::Forward) || controls.moves.has(Action::TurnRight));
}

TEST_F(InputMapperTest, ATriggerIsAButtonThatDoesNotFlutter) {
    const Input trigger = input_named("Pad Left Trigger");
    mapper.move_axis(trigger, 16'000);
    EXPECT_FALSE(mapper.take(0).moves.has(Action::WalkSlowly));
    mapper.move_axis(trigger, 17'000);
    EXPECT_TRUE(mapper.take(0).moves.has(Action::WalkSlowly));
    mapper.move_axis(trigger, 15'000);  // a little back: still held
    EXPECT_TRUE(mapper.take(0).moves.has(Action::WalkSlowly));
    mapper.move_axis(trigger, 12'000);
    EXPECT_FALSE(mapper.take(0).moves.has(Action::WalkSlowly));
}

TEST_F(InputMapperTest, LettingGoOfAllEndsEverything) {
    press({"W", "Up", "Space", "Mouse 1", "Pad A"});
    mapper.move_axis(input_named("Pad Left Stick Up"), kFullAxis);
    mapper.release_all();
    const Controls controls = mapper.take(0);
    EXPECT_EQ(controls.moves, Moves{});
    EXPECT_EQ(controls.panel_moves, Moves{});
    EXPECT_EQ(controls.walk_stick, Stick{});
    EXPECT_FALSE(controls.holds_button);
}

TEST_F(InputMapperTest, APadThatIsUnpluggedLeavesTheKeysHeld) {
    press({"W", "Pad A"});
    mapper.take(0);
    mapper.release_pad();
    const Controls controls = mapper.take(0);
    EXPECT_TRUE(controls.moves.has(Action::Forward));
    EXPECT_FALSE(controls.moves.has(Action::Jump));
}

TEST_F(InputMapperTest, TheLastPressIsReportedForRebindingAlsoWhereNothingIsBound) {
    EXPECT_FALSE(mapper.take(0).pressed);
    press({"W", "F20"});
    EXPECT_EQ(mapper.take(0).pressed, input_named("F20"));
    EXPECT_FALSE(mapper.take(0).pressed);
    mapper.move_axis(input_named("Pad Left Trigger"), kFullAxis);
    EXPECT_EQ(mapper.take(0).pressed, input_named("Pad Left Trigger"));
}

TEST(InputMapper, OtherBindingsActAtOnce) {
    Bindings bindings;
    InputMapper mapper(bindings);
    set_inputs(bindings, Action::Jump, "W Wheel-Up");
    set_inputs(bindings, Action::Torch, "Mouse-4");
    set_inputs(bindings, Action::Forward, "Pad-Right-Trigger");
    mapper.press(input_named("W"));
    mapper.press(input_named("Mouse 4"));
    mapper.move_axis(input_named("Pad Right Trigger"), 16'384);
    const Controls controls = mapper.take(0);
    EXPECT_TRUE(controls.moves.has(Action::Jump));
    EXPECT_FALSE(controls.moves.has(Action::Forward));  // but by the trigger, half of the speed:
    EXPECT_EQ(controls.walk_stick, (Stick{0, 16'384}));
    EXPECT_EQ(controls.commands, Commands{Action::Torch});
}

TEST_F(InputMapperTest, AFreeMouseClicksInsteadOfWalking) {
    mapper.click(input_named("Mouse 2"));
    const Controls controls = mapper.take(0);
    EXPECT_FALSE(controls.moves.has(Action::Forward));
    EXPECT_EQ(controls.menu, Menu{MenuAction::Back});
    EXPECT_EQ(controls.pressed, input_named("Mouse 2"));
    mapper.press(input_named("Mouse 2"));  // captured
    EXPECT_TRUE(mapper.take(0).moves.has(Action::Forward));
}

}  // namespace
}  // namespace oblong
