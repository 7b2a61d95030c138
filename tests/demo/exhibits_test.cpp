// The exhibits whose lens stands in a cage: each opens for one way to draw the picture, and by itself after three
// minutes.

#include <gtest/gtest.h>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "game/simulation/step.h"
#include "tests/support/folders.h"

namespace oblong::exhibits_test {
namespace {

class Exhibits : public testing::Test {
  protected:
    /// Into GameLevel::triggers: those that ask for a view.
    std::vector<std::size_t> asking() const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < level_.triggers.size(); ++i)
            if (level_.triggers[i].view) found.push_back(i);
        return found;
    }
    const MoverState& cage_of(const std::string& name, const GameState& state) const {
        for (std::size_t i = 0; i < level_.movers.size(); ++i)
            if (bsp_.entities[level_.movers[i].entity].value("targetname") == name) return state.movers.at(i);
        throw std::invalid_argument("no " + name);
    }
    std::string cage_name(std::size_t trigger) const {
        return bsp_.entities[level_.triggers[trigger].entity].value("target");
    }
    /// In the middle of a box.
    GameState inside(const Box& box) const {
        GameState state = start_of(level_);
        const auto middle = [](World a, World b) { return scaled(a + b, 1, 2); };
        state.player.position = {middle(box.mins.x, box.maxs.x), middle(box.mins.y, box.maxs.y),
                                 box.mins.z + World::from_int(24)};
        return state;
    }
    Angle yaw_of(std::size_t trigger) const {
        const auto& direction = level_.triggers[trigger].view->direction;
        return direction ? arctangent2(convert<World>(direction->y), convert<World>(direction->x)) : Angle{};
    }
    bool looks_up(std::size_t trigger) const {
        const auto& direction = level_.triggers[trigger].view->direction;
        return direction && direction->z > Unit{};
    }

    const Level bsp_ = read_bsp(read_file(test::build_folder() + "/assets/demo.bsp"));
    const GameLevel level_ = make_game_level(bsp_);
};

constexpr std::uint16_t kDearPicture = 60'000;

void wait(const GameLevel& level, TickInput input, int ticks, GameState& state) {
    for (int tick = 0; tick < ticks; ++tick) step(level, state, input);
}

TEST_F(Exhibits, OpenForTheirViewAndForNoOther) {
    EXPECT_EQ(asking().size(), 12u) << "of eleven exhibits, the mirror's from two sides";
    for (const std::size_t trigger : asking()) {
        const ViewCondition& view = *level_.triggers[trigger].view;
        GameState state = inside(*level_.triggers[trigger].box);
        state.player.yaw = yaw_of(trigger) + Angle::from_bam(16'384);
        TickInput input;
        input.work = kDearPicture;
        wait(level_, input, 100, state);
        EXPECT_EQ(cage_of(cage_name(trigger), state).phase, MoverState::Phase::AtStart) << cage_name(trigger);
        const std::optional<ViewDialKind> dial = asked_dial(level_, state);
        for (std::size_t i = 0; i < kViewDials; ++i) {
            input.view[i] = view.dials[i].value_or(input.view[i]);
            EXPECT_TRUE(!view.dials[i] || dial) << "the verb turns nothing there";
        }
        state.player.yaw = yaw_of(trigger);
        if (looks_up(trigger)) state.player.pitch = -Player::kSteepestPitch;
        if (view.asks_for_work()) input.work = view.most_work;
        wait(level_, input, 100, state);
        EXPECT_EQ(cage_of(cage_name(trigger), state).phase, MoverState::Phase::AtEnd) << cage_name(trigger);
    }
}

TEST_F(Exhibits, AreOpenForWhoOnlyWantsToWalk) {
    GameState state = start_of(level_);
    TickInput input;
    input.buttons = kVisitButton;
    step(level_, state, input);
    wait(level_, {}, 100, state);
    for (const std::size_t trigger : asking())
        EXPECT_EQ(cage_of(cage_name(trigger), state).phase, MoverState::Phase::AtEnd) << cage_name(trigger);
}

TEST_F(Exhibits, OpenByThemselvesThreeMinutesAfterTheVisitorCame) {
    for (std::size_t door = 0; door < level_.triggers.size(); ++door) {
        const std::string called = bsp_.entities[level_.triggers[door].entity].value("target");
        if (!called.starts_with("patience") || level_.triggers[door].kind != TriggerKind::Multiple) continue;
        const std::string cage = "cage" + called.substr(8);
        GameState state = inside(*level_.triggers[door].box);
        TickInput input;
        input.work = kDearPicture;
        wait(level_, input, 179 * static_cast<int>(kTicksPerSecond), state);
        EXPECT_EQ(cage_of(cage, state).phase, MoverState::Phase::AtStart) << cage;
        wait(level_, input, 4 * static_cast<int>(kTicksPerSecond), state);
        EXPECT_EQ(cage_of(cage, state).phase, MoverState::Phase::AtEnd) << cage;
    }
}

TEST_F(Exhibits, HideFourSecretsThatAreFoundByTouch) {
    std::size_t found = 0;
    for (const Trigger& trigger : level_.triggers) {
        if (!trigger.is_secret) continue;
        EXPECT_NE(bsp_.entities[trigger.entity].value("netname"), "") << "what the end says was missed";
        GameState state = inside(trigger.box.value());
        wait(level_, {}, 2, state);
        EXPECT_EQ(state.progress.found_secrets, 1);
        ++found;
    }
    EXPECT_EQ(found, 4u);
}

}  // namespace
}  // namespace oblong::exhibits_test
