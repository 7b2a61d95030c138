#include "game/input/input_mapper.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/controls/told_controls.h"
#include "tests/support/named_action.h"

namespace oblong::test {
namespace {

/// What is done with inputs of these names, and the controls that are taken after it: see told_controls.h.
/// `bind jump W` binds an action, `bind` none at all.
class MapperScript {
  public:
    void run(const ScriptLine& line) {
        for (const Words& words : line.actions) act(words);
        check_controls(line, [this] { return mapper_.take(0); });
    }

  private:
    void act(const Words& words) {
        const std::string& verb = words[0];
        using Work = void (InputMapper::*)(Input);
        const std::map<std::string, Work> works{{"press", &InputMapper::press},
                                                {"repeat", &InputMapper::repeat},
                                                {"release", &InputMapper::release},
                                                {"click", &InputMapper::click}};
        if (verb == "let_go")
            mapper_.release_all();
        else if (verb == "unplug")
            mapper_.release_pad();
        else if (verb == "push")
            mapper_.move_axis(input_named(words.at(1)), std::stoi(words.at(2)));
        else if (verb == "bind" && words.size() == 1)
            bindings_ = {};
        else if (verb == "bind")
            set_inputs(bindings_, action_named(words[1]), joined(words, 2));
        else
            for (std::size_t i = 1; i < words.size(); ++i) (mapper_.*works.at(verb))(input_named(words[i]));
    }

    Bindings bindings_ = default_bindings();
    InputMapper mapper_{bindings_};
};

constexpr Script kMapped[] = {
    {"AHeldKeyMovesUntilItIsLetGo", R"(
        press W: moves = forward
        : moves = forward
        release W: moves =
    )"},
    {"AKeyPressedAndLetGoBetweenTwoPollsCountsOnce", "press Space; release Space: moves = jump \n : moves ="},
    {"TwoInputsOfAMoveHoldItTogether", R"(
        press Left-Shift Right-Shift; release Left-Shift: moves = walk-slowly
        : moves = walk-slowly
    )"},
    {"KeysOfPanelsAreKeptApart", "press Up: moves =, panel = forward, commands = dial-up"},
    {"CommandsComeOnceForEachPressAndThoseOfPanelsAgainWhileHeld", R"(
        press F1; repeat F1 F1; press Left; repeat Left Left: commands = help dial-coarser dial-coarser dial-coarser
        : commands =
    )"},
    {"InMenusDirectionsAreRepeatedAndAcceptIsNot",
     "press Down; repeat Down; press Enter; repeat Enter: menu = down down accept"},
    {"MenusAreWorkedByThePadAlone", R"(
        press Pad-Up Pad-A Pad-B Pad-Start; push Pad-Left-Stick-Down 32767
        : menu = up accept back down, commands = dial-up torch menu
    )"},
    {"EscapeOpensTheMenuWhateverIsBound", "bind; press Escape: commands = menu \n press Pad-Start: commands = menu"},
    {"SticksMoveByHowFarTheyArePushed", R"(
        push Pad-Left-Stick-Up 20000; push Pad-Left-Stick-Left 3000
        push Pad-Right-Stick-Right 40000; push Pad-Right-Stick-Down 5: walk = -3000 20000, look = 32767 -5, moves =
    )"},
    // A little back it is still held.
    {"ATriggerIsAButtonThatDoesNotFlutter", R"(
        push Pad-Left-Trigger 16000: moves =
        push Pad-Left-Trigger 17000: moves = walk-slowly
        push Pad-Left-Trigger 15000: moves = walk-slowly
        push Pad-Left-Trigger 12000: moves =
    )"},
    {"LettingGoOfAllEndsEverything", R"(
        press W Up Space Mouse-1 Pad-A; push Pad-Left-Stick-Up 32767; let_go: moves =, panel =, walk = 0 0, held =
    )"},
    {"APadThatIsUnpluggedLeavesTheKeysHeld", "press W Pad-A: moves = forward jump \n unplug: moves = forward"},
    {"TheLastPressIsReportedForRebindingAlsoWhereNothingIsBound", R"(
        : pressed =
        press W F20: pressed = F20
        : pressed =
        push Pad-Left-Trigger 32767: pressed = Pad Left Trigger
    )"},
    // The trigger halfway: half of the speed.
    {"OtherBindingsActAtOnce", R"(
        bind; bind jump W Wheel-Up; bind torch Mouse-4; bind forward Pad-Right-Trigger
        press W Mouse-4; push Pad-Right-Trigger 16384: moves = jump, walk = 0 16384, commands = torch
    )"},
    {"AFreeMouseClicksInsteadOfWalking", R"(
        click Mouse-2: moves =, menu = back, pressed = Mouse 2
        press Mouse-2: moves = forward      # captured
    )"},
};
void map_inputs(const Script& script) {
    MapperScript mapper;
    for (const ScriptLine& line : script_lines(script.text)) mapper.run(line);
}
OBLONG_SCRIPTS(InputMapperScripts, kMapped, map_inputs);

TEST(InputMapper, APadsDirectionIsRepeatedByTheClockWhileItIsHeld) {
    const Bindings bindings = default_bindings();
    InputMapper mapper(bindings);
    mapper.press(input_named("Pad Down"));
    int times = 0;
    for (std::uint64_t ms = 1000; ms <= 2000; ms += 10) times += static_cast<int>(mapper.take(ms).menu.size());
    EXPECT_GE(times, 5);
    EXPECT_LE(times, 8);
    mapper.release(input_named("Pad Down"));
    EXPECT_TRUE(mapper.take(5000).menu.empty());
}

}  // namespace
}  // namespace oblong::test
