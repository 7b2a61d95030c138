#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/io/files.h"
#include "game/input/bindings.h"
#include "game/input/route.h"
#include "game/simulation/items.h"
#include "game/simulation/step.h"
#include "game/sound/sound_scene.h"
#include "tests/demo/demo_level.h"
#include "tests/support/refusal.h"

namespace oblong {
namespace {

constexpr std::size_t kLenses = 12;

/// The walk that the build records, and the states that it leads to.
class RecordedWalk : public testing::Test {
  protected:
    template <class Visit>
    void replay(Visit visit) const {
        GameState state = start_of(game_level_);
        for (const DemoTick& tick : demo_.ticks) {
            step(game_level_, state, tick.input);
            ASSERT_EQ(hash_of(state), tick.state_hash) << "tick " << state.tick;
            visit(state);
        }
    }

    const Level level_ = test::read_level("demo");
    const GameLevel game_level_ = make_game_level(level_);
    const Demo demo_ = test::recorded_walk();
};

TEST_F(RecordedWalk, IsTheWalkOfTheRouteOnThisLevel) {
    const auto route = parse_route(read_file(test::source_folder() + "/assets/walk.csv"));
    EXPECT_EQ(walk_route(game_level_, route), demo_);
}

TEST_F(RecordedWalk, FindsAllLensesAndEndsTheLevelInTwoToFourMinutes) {
    GameState last;
    replay([&](const GameState& state) { last = state; });
    const ItemCount lenses = count_items(game_level_, last, ItemClass::Lens);
    EXPECT_EQ(lenses.all, static_cast<std::int32_t>(kLenses));
    EXPECT_EQ(lenses.taken, lenses.all);
    EXPECT_EQ(last.progress.found_secrets, 0) << "it gives none away";
    EXPECT_TRUE(last.has_ended);
    EXPECT_GE(last.tick, 120 * kTicksPerSecond);
    EXPECT_LE(last.tick, 240 * kTicksPerSecond);
}

TEST_F(RecordedWalk, ShowsEveryMessageOfTheLevelButThoseOfWaysThatItDoesNotTake) {
    std::set<std::string> shown;
    replay([&](const GameState& state) {
        if (state.message.shown >= 0) shown.insert(game_level_.messages[static_cast<std::size_t>(state.message.shown)]);
    });
    std::size_t lenses = 0;
    for (const Entity& entity : level_.entities) {
        const std::string message = entity.value("message");
        if (entity.value("classname") == "item_lens") lenses += shown.contains(message);
    }
    EXPECT_EQ(lenses, kLenses - 1) << "that of the last one gives way to what the tower says";
    EXPECT_TRUE(shown.contains("All twelve lenses: the tower is open"));
    EXPECT_GE(shown.size(), 2 * kLenses + 3) << "a caption on entering each room";
}

TEST_F(RecordedWalk, TurnsAtAPacePleasantToWatch) {
    constexpr int kFastest = 65'536 * 100 / 360 / static_cast<int>(kTicksPerSecond);  // 100 degrees a second
    constexpr int kLargestJerk = 65'536 * 11 / 360 / static_cast<int>(kTicksPerSecond);
    int before = 0;
    for (const DemoTick& tick : demo_.ticks) {
        EXPECT_LE(std::abs(tick.input.yaw), kFastest);
        EXPECT_LE(std::abs(tick.input.yaw - before), kLargestJerk);
        before = tick.input.yaw;
    }
}

TEST_F(RecordedWalk, LightsAWindowOfTheTowerWithEachLens) {
    std::size_t lenses = 0;
    const auto lit = [&](const GameState& state) {
        return static_cast<std::size_t>(std::ranges::count(state.walls, WallState::ShowsOtherFrames));
    };
    replay([&](const GameState& state) {
        lenses = static_cast<std::size_t>(count_items(game_level_, state, ItemClass::Lens).taken);
        ASSERT_EQ(lit(state), lenses) << "tick " << state.tick;
    });
    EXPECT_EQ(lenses, kLenses);
    std::set<std::string> names, colours;
    for (const Item& item : game_level_.items) {
        names.insert(level_.entities[item.entity].value("netname"));
        colours.insert(level_.entities[item.entity].value("glass"));
    }
    EXPECT_EQ(names.size(), kLenses);
    EXPECT_EQ(colours.size(), kLenses) << "each has its own";
}

TEST_F(RecordedWalk, FollowsALampThatIsARoomAheadAndInNobodysWay) {
    const auto lamp = static_cast<std::size_t>(std::ranges::find(game_level_.movers, MoverKind::Train, &Mover::kind) -
                                               game_level_.movers.begin());
    ASSERT_LT(lamp, game_level_.movers.size());
    const Mover& mover = game_level_.movers[lamp];
    std::set<std::uint32_t> stops;
    Box box{};
    replay([&](const GameState& state) {
        box = box_of(game_level_.model(mover.model).box).moved(offset_of(mover, state.movers[lamp]));
        EXPECT_FALSE(box.grown(world_vector(4, 4, 4)).overlaps(player_box(state.player.position))) << state.tick;
        if (is_at_rest(state.movers[lamp])) stops.insert(state.movers[lamp].leg);
    });
    EXPECT_EQ(stops.size(), 14u) << "one for each room, the distance and the tower";
    EXPECT_TRUE(box.overlaps(Box{world_vector(480, 1930, 48), world_vector(544, 1990, 200)})) << "before the tower";
}

TEST_F(RecordedWalk, HearsTheRainUnmuffledInAllOfItsCourt) {
    SoundScene scene(game_level_);
    GameState before = start_of(game_level_);
    int ticks_in_court = 0;
    replay([&](const GameState& state) {
        scene.note_tick(before, state, {});
        before = state;
        const test::Point p = test::to_point(state.player.position);
        if (p.x < 1184 || p.y < 1408 || p.y > 1824 || p.z < 0) return;
        ++ticks_in_court;
        const auto& sounds = scene.audible().sounds;
        const auto rain = std::ranges::find(sounds, Sound::Rain, &AudibleSound::sound);
        ASSERT_NE(rain, sounds.end()) << "tick " << state.tick;
        EXPECT_FALSE(rain->levels.is_muffled) << "tick " << state.tick;
    });
    EXPECT_GT(ticks_in_court, 10 * kTicksPerSecond);
}

/// Lines of 320 pixels have room for 53 letters of 6.
TEST(DemoCaptions, AreOfOneOrTwoLinesThatFitThePicture) {
    const Level level = test::read_level("demo");
    std::size_t count = 0;
    for (const Entity& entity : level.entities) {
        std::string message = entity.value("message");
        if (message.empty()) continue;
        ++count;
        for (std::size_t key = message.find('{'); key != std::string::npos; key = message.find('{')) {
            const std::string action = message.substr(key + 1, message.find('}') - key - 1);
            EXPECT_TRUE(std::ranges::count(all_actions(), action, &ActionRow::name) == 1) << action;
            message.replace(key, action.size() + 2, "F11");
        }
        std::size_t lines = 1;
        for (std::size_t end = message.find("\\n"); end != std::string::npos; end = message.find("\\n"), ++lines) {
            EXPECT_LE(end, 50u) << message;
            message.erase(0, end + 2);
        }
        EXPECT_LE(message.size(), 50u) << message;
        EXPECT_LE(lines, 2u) << message;
    }
    EXPECT_GT(count, 2 * kLenses);
}

std::vector<Waypoint> route_of(const std::string& text) {
    return parse_route({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Route, IsReadFromACsvFile) {
    const auto route =
        route_of("x,y,z,speed,wait,yaw,pitch,jump\n-10,20,,,,,,\n1,2,3,100,20,90,-45,1\n0,0,,,,32768,,\n");
    ASSERT_EQ(route.size(), 3u);
    EXPECT_EQ(route[0].x, -10);
    EXPECT_EQ(route[0].speed_100, 50);
    EXPECT_FALSE(route[0].least_feet || route[0].yaw || route[0].jumps);
    EXPECT_EQ(route[1].least_feet, 3);
    EXPECT_EQ(route[1].wait_ticks, 70) << "two seconds";
    EXPECT_EQ(route[1].yaw, kQuarterTurn);
    EXPECT_EQ(route[1].pitch, -8192);
    EXPECT_TRUE(route[1].jumps);
    EXPECT_EQ(route[1].line, 3u);
    EXPECT_EQ(route[2].yaw, Angle::from_bam(8 * 65536 / 360)) << "after 91 turns";
}

TEST(Route, TurnsDialsFromAPlaceOn) {
    const auto route = route_of(
        "x,y,z,speed,wait,yaw,pitch,jump,view\n1,2,,,,,,,\n3,4,,,5,,,,accuracy=1991 work=900\n5,6,,,,,,,zoom=40\n");
    EXPECT_EQ(route[0].view, kUsualView);
    EXPECT_EQ(route[1].view, (ViewDials{0, 1, 0, 0, 0, 0}));
    EXPECT_EQ(route[2].view, (ViewDials{0, 1, 0, 0, 0, 4}));
    EXPECT_EQ(route[0].work, 0);
    EXPECT_EQ(route[2].work, 900);
}

TEST(Route, NamesTheLineThatIsWrong) {
    const std::string header = "x,y,z,speed,wait,yaw,pitch,jump", with_view = header + ",view\n1,2,,,,,,,";
    const auto expect_fault = [](const std::string& text, const char* said) {
        EXPECT_NE(test::refusal([&] { route_of(text + "\n"); }).find(said), std::string::npos) << text;
    };
    expect_fault("x,y\n1,2", "line 1");
    expect_fault(header, "no waypoint");
    expect_fault(header + "\n1,2,,,,,,\n1,,,,,,,", "line 3");
    for (const char* line : {"1,2", "1,2,,,,,,,", "1,b,,,,,,", "1,2.5,,,,,,", "1,2,,101,,,,", "1,2,,,-1,,,",
                             "1,2,,,,,81,", "1,2,,,,,,2", "1,99999,,,,,,"})
        expect_fault(header + "\n" + line, "line 2");
    for (const char* view : {"accuracy=1992", "isometric", "work=-1", "work=32768", "mip=none"})
        expect_fault(with_view + view, "line 2");
}

TEST(Route, SaysWhereTheVisitorIsStuck) {
    const Level level = test::read_level("demo");
    const auto route = route_of("x,y,z,speed,wait,yaw,pitch,jump\n0,-300,,,,,,\n140,-160,,,,,,\n400,-160,,,,,,\n");
    const std::string fault = test::refusal([&] { walk_route(make_game_level(level), route); });
    EXPECT_NE(fault.find("stuck at 143 -16"), std::string::npos) << fault;
}

}  // namespace
}  // namespace oblong
