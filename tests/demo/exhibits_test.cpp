// The exhibits whose lens stands in a cage, and the entrance: each opens for one way to look or to draw the picture, in
// whatever order that comes about, and by itself after a while.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include "engine/base/text.h"
#include "game/simulation/step.h"
#include "tests/support/levels.h"

namespace oblong::exhibits_test {
namespace {

/// What opens a cage: from a place (of the player's middle), a look (degrees; none: any), dials, and a picture that
/// costs this much (thousands of a 486's cycles; 0: any).
struct Exhibit {
    const char* cage;
    std::int32_t x, y, z;
    struct Look {
        std::int32_t yaw, pitch;
    };
    std::optional<Look> look;
    std::string_view dials;
    std::uint16_t work = 0;
};
using Look = Exhibit::Look;

constexpr std::array kExhibits{
    Exhibit{"cage0", 0, -200, 24, Look{90, 0}, ""},
    Exhibit{"cage1", -40, 130, 24, Look{150, -4}, "projection=square display=display"},
    Exhibit{"cage2", 330, 416, 24, Look{0, 0}, ""},
    Exhibit{"cage3", 622, 112, 24, Look{316, -3}, ""},
    Exhibit{"cage3", 850, 112, 24, Look{224, -3}, ""},
    Exhibit{"cage4", 440, 232, 24, {}, "", 3000},
    Exhibit{"cage5", 1090, 190, 24, Look{90, -30}, ""},
    Exhibit{"cage5", 1000, 60, 24, Look{68, -14}, ""},
    Exhibit{"cage5", 1150, 250, 24, Look{150, -40}, ""},
    Exhibit{"cage6", 1400, 416, 24, {}, "isometric=on"},
    Exhibit{"cage7", 1545, 800, 24, {}, "wireframe=over"},
    Exhibit{"cage8", 1120, 890, 184, {}, "zoom=120"},
    Exhibit{"cage9", 1338, 1522, 24, Look{60, -76}, ""},
    Exhibit{"cage10", 1430, 2250, -184, {}, "", 20'000},
    Exhibit{"cage11", -652, 1584, 96, Look{0, 0}, ""},
    Exhibit{"cage11", -730, 1540, 96, Look{20, 0}, ""},
    Exhibit{"cage12", -700, 2318, 72, {}, "accuracy=1991"},
    Exhibit{"cage12", -800, 2480, 72, {}, "accuracy=1991"},
};
constexpr std::uint16_t kDearPicture = 60'000;

/// A visitor and how the picture is drawn.
struct Visit {
    GameState state;
    TickInput input;
};
using Act = std::function<void(Visit&)>;

Act stands(std::int32_t x, std::int32_t y, std::int32_t z) {
    return [=](Visit& visit) { visit.state.player.position = world_vector(x, y, z); };
}
Act looks(const Look& look) {
    return [=](Visit& visit) {
        visit.state.player.yaw = Angle::from_bam(look.yaw * 65'536 / 360);
        visit.state.player.pitch = look.pitch * 65'536 / 360;
    };
}
Act pays(std::uint16_t work) {
    return [=](Visit& visit) { visit.input.work = work; };
}
Act turns(std::size_t dial, std::size_t value) {
    return [=](Visit& visit) { visit.input.view[dial] = static_cast<std::uint8_t>(value); };
}

/// What a visitor does to open an exhibit, and the same done in all wrong ways.
struct Step {
    Act right;
    std::vector<Act> wrong;
};

Step dial_step(std::string_view word) {
    const std::size_t equals = word.find('=');
    const auto dials = all_view_dials();
    const auto dial =
        static_cast<std::size_t>(std::ranges::find(dials, word.substr(0, equals), &ViewDial::key) - dials.begin());
    const std::size_t right = value_named(dials[dial], word.substr(equals + 1)).value();
    Step step{turns(dial, right), {}};
    for (std::size_t value = 0; value < dials[dial].values.size(); ++value)
        if (value != right) step.wrong.push_back(turns(dial, value));
    return step;
}

std::vector<Step> steps_of(const Exhibit& exhibit) {
    std::vector<Step> steps{{stands(exhibit.x, exhibit.y, exhibit.z), {stands(0, -368, 24)}}};
    if (exhibit.look)
        steps.push_back(
            {looks(*exhibit.look), {looks({exhibit.look->yaw + 90, 0}), looks({exhibit.look->yaw + 180, 0})}});
    if (exhibit.work != 0) steps.push_back({pays(exhibit.work), {pays(0), pays(kDearPicture)}});
    std::string_view text = exhibit.dials;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text))
        steps.push_back(dial_step(word));
    return steps;
}

class Exhibits : public testing::Test {
  protected:
    bool is(MoverState::Phase phase, const std::string& cage, const GameState& state) const {
        for (std::size_t i = 0; i < level_.movers.size(); ++i)
            if (bsp_.entities[level_.movers[i].entity].value("targetname") == cage)
                return state.movers.at(i).phase == phase;
        throw std::invalid_argument("no " + cage);
    }
    bool is_shut(const std::string& cage, const GameState& state) const {
        return is(MoverState::Phase::AtStart, cage, state);
    }
    bool is_open(const std::string& cage, const GameState& state) const {
        return is(MoverState::Phase::AtEnd, cage, state);
    }
    void wait(TickInput input, std::int64_t ticks, GameState& state) const {
        for (std::int64_t tick = 0; tick < ticks; ++tick) step(level_, state, input);
    }
    void act(const Act& act, Visit& visit) const {
        act(visit);
        wait(visit.input, 2, visit.state);
    }
    /// At the start, with everything wrong.
    Visit visit_of(const std::vector<Step>& steps) const {
        Visit visit{start_of(level_), {}};
        for (const Step& step : steps) step.wrong.back()(visit);
        return visit;
    }
    /// In the middle of a box.
    GameState inside(const Box& box) const {
        GameState state = start_of(level_);
        const auto middle = [](World a, World b) { return scaled(a + b, 1, 2); };
        state.player.position = {middle(box.mins.x, box.maxs.x), middle(box.mins.y, box.maxs.y),
                                 box.mins.z + World::from_int(24)};
        return state;
    }

    const Level bsp_ = test::read_level("demo");
    const GameLevel level_ = make_game_level(bsp_);
};

TEST_F(Exhibits, AreAllThatAskForAView) {
    std::set<std::string> asking, tested;
    for (const Trigger& trigger : level_.triggers)
        if (trigger.view) asking.insert(bsp_.entities[trigger.entity].value("target"));
    for (const Exhibit& exhibit : kExhibits) tested.insert(exhibit.cage);
    EXPECT_EQ(asking, tested);
}

TEST_F(Exhibits, OpenWithTheLastStepInEveryOrderAndStayShutForEachDoneWrong) {
    for (const Exhibit& exhibit : kExhibits) {
        const std::vector<Step> steps = steps_of(exhibit);
        std::vector<std::size_t> order(steps.size());
        std::iota(order.begin(), order.end(), 0);
        do {
            Visit visit = visit_of(steps);
            for (const std::size_t i : order) {
                for (const Act& wrong : steps[i].wrong) act(wrong, visit);
                EXPECT_TRUE(is_shut(exhibit.cage, visit.state)) << exhibit.cage << ", before step " << i;
                act(steps[i].right, visit);
            }
            EXPECT_FALSE(is_shut(exhibit.cage, visit.state)) << exhibit.cage;
            EXPECT_TRUE(exhibit.dials.empty() || asked_dial(level_, visit.state)) << "the verb turns nothing there";
            wait({}, 100, visit.state);
            EXPECT_TRUE(is_open(exhibit.cage, visit.state)) << exhibit.cage;
        } while (std::ranges::next_permutation(order).found);
    }
}

TEST_F(Exhibits, TheEntranceOpensForWhoWalksInAsEverybodyDoesAndNotForWhoLooksAtTheCarpet) {
    for (const std::int32_t pitch : {0, 20}) {
        Visit visit{start_of(level_), {}};
        looks({90, pitch})(visit);
        visit.input.forward = 127;
        wait(visit.input, 3 * kTicksPerSecond, visit.state);
        EXPECT_EQ(is_open("cage0", visit.state), pitch == 0);
        EXPECT_EQ(visit.state.player.position.y > World{}, pitch == 0);
    }
}

TEST_F(Exhibits, AreOpenForWhoOnlyWantsToWalk) {
    GameState state = start_of(level_);
    TickInput input;
    input.buttons = kVisitButton;
    step(level_, state, input);
    wait({}, 100, state);
    for (const Exhibit& exhibit : kExhibits) EXPECT_TRUE(is_open(exhibit.cage, state)) << exhibit.cage;
}

// The entrance after a quarter of one.
TEST_F(Exhibits, OpenByThemselvesThreeMinutesAfterTheVisitorCame) {
    int opened = 0;
    for (const Trigger& door : level_.triggers) {
        const std::string called = bsp_.entities[door.entity].value("target");
        if (!called.starts_with("patience") || door.kind != TriggerKind::Multiple) continue;
        const std::string cage = "cage" + called.substr(8);
        GameState state = inside(*door.box);
        TickInput input;
        input.work = kDearPicture;
        wait(input, (cage == "cage0" ? 14 : 179) * kTicksPerSecond, state);
        EXPECT_TRUE(is_shut(cage, state)) << cage;
        wait(input, 4 * kTicksPerSecond, state);
        EXPECT_TRUE(is_open(cage, state)) << cage;
        ++opened;
    }
    EXPECT_EQ(opened, 13);
}

TEST_F(Exhibits, HideFourSecretsThatAreFoundByTouch) {
    std::size_t found = 0;
    for (const Trigger& trigger : level_.triggers) {
        if (!trigger.is_secret) continue;
        EXPECT_NE(bsp_.entities[trigger.entity].value("netname"), "") << "what the end says was missed";
        GameState state = inside(trigger.box.value());
        wait({}, 2, state);
        EXPECT_EQ(state.progress.found_secrets, 1);
        ++found;
    }
    EXPECT_EQ(found, 4u);
}

}  // namespace
}  // namespace oblong::exhibits_test
