#include "game/program/session.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>

#include "engine/platform/headless.h"
#include "tests/support/folders.h"
#include "tests/support/silent_platform.h"

namespace oblong::test::session_test {
namespace {

using Picture = std::vector<std::uint8_t>;
using Presses = std::map<std::int64_t, std::vector<Action>>;

constexpr std::int64_t kFrames = 40;

PlatformInput no_input(std::int64_t) {
    return {};
}

class SessionOfTheDemo : public testing::Test {
  protected:
    // Walks ahead in a turn with keys pressed at some frames; the demo that it recorded is in demo_.
    std::vector<Picture> play(const Presses& presses, bool by_arrows = false) {
        std::vector<Picture> pictures;
        const auto script = [&](std::int64_t frame) {
            Controls controls;
            (by_arrows ? controls.panel_moves : controls.moves) = {Action::Forward, Action::TurnRight};
            if (const auto found = presses.find(frame); found != presses.end()) controls.commands = found->second;
            return controls;
        };
        HeadlessPlatform platform(kFrames, 35, no_input, [&](Framebuffer picture, const Palette&) {
            pictures.emplace_back(picture.pixels, picture.row(picture.height_px));
        });
        ViewOptions view_options;
        Session session(loaded_, {}, view_options, TickInputSource(start_of(loaded_->level), std::nullopt, true),
                        platform);
        for (std::int64_t frame = 0; platform.is_open(); ++frame) {
            platform.poll();
            session.advance(script(frame), platform.now_us());
            const ShownPicture picture = session.draw(false);
            platform.present(picture.canvas, picture.palette, picture.rect);
        }
        demo_ = session.input().recorded();
        for (DemoTick& tick : demo_.ticks) {
            tick.input.view = kUsualView;
            tick.input.work = 0;
        }
        return pictures;
    }

    const std::shared_ptr<const LoadedLevel> loaded_ =
        std::make_shared<const LoadedLevel>(LevelFiles{"", "", test::build_folder() + "/assets", ""});
    Demo demo_;  ///< but for how its pictures were drawn
};

constexpr Action kPanel = Action::LabPanel, kMap = Action::ErrorMap, kSplit = Action::SplitView,
                 kFlip = Action::FlipSettings, kGuide = Action::AspectGuide, kFour = Action::FourAspects;

struct Watching {
    const char* name;
    Presses plain, watched;  ///< in both the messages that stay longer than the rest are the same
    std::size_t until;       ///< from frame 1 on, the picture is another
};

void PrintTo(const Watching& watching, std::ostream* out) {
    *out << watching.name;
}

class WatchedSession : public SessionOfTheDemo, public testing::WithParamInterface<Watching> {};

// Whatever is shown over the game or beside it: the demo is the same, and so is each picture before it and after it,
// but for the messages at the top, which end after 2.5 s or longer.
TEST_P(WatchedSession, LeavesNoTraceInTheGame) {
    const auto& [name, plain_presses, watched_presses, until] = GetParam();
    const std::vector<Picture> plain = play(plain_presses);
    const Demo plain_demo = demo_;
    const std::vector<Picture> watched = play(watched_presses);
    EXPECT_EQ(demo_, plain_demo);
    ASSERT_EQ(watched.size(), plain.size());
    constexpr std::size_t kBelowMessage = 320 * 40;
    for (std::size_t frame = 0; frame < plain.size(); ++frame) {
        const auto skipped = static_cast<std::ptrdiff_t>(frame == 0 ? 0 : kBelowMessage);
        if (frame > 0 && frame < until)
            EXPECT_NE(watched[frame], plain[frame]) << frame;
        else
            EXPECT_TRUE(
                std::equal(plain[frame].begin() + skipped, plain[frame].end(), watched[frame].begin() + skipped))
                << frame;
    }
}

const std::vector<Action> kCostTorchAndTube{Action::FrameCost, Action::Torch, Action::CrtLook},
    kMapAndEdges{Action::Automap, Action::Wireframe};

INSTANTIATE_TEST_SUITE_P(
    Of, WatchedSession,
    testing::Values(Watching{"Lab",
                             {{1, {kGuide}}, {20, {kGuide}}},
                             {{1, {kPanel, kMap, kSplit, kFlip, kGuide}},
                              {10, {kFour}},
                              {15, {kFour}},
                              {20, {kPanel, kMap, kSplit, kFlip, kGuide}}},
                             20},
                    // F6 draws the view twice more; a torch lights the picture alone.
                    Watching{"CostTorchAndTube", {}, {{1, kCostTorchAndTube}, {30, kCostTorchAndTube}}, 30},
                    Watching{"MapAndEdges", {}, {{1, kMapAndEdges}, {15, kMapAndEdges}, {30, kMapAndEdges}}, 30},
                    Watching{"OtherViews",
                             {},
                             {{1, {Action::Isometric}},
                              {10, {Action::Isometric, Action::ZoomIn, Action::ZoomIn}},
                              {20, {Action::ZoomOut, Action::ZoomOut}}},
                             20}),
    [](const auto& each) { return std::string(each.param.name); });

// Exact pixels are mostly those of `bounded`; before, the right side was drawn over the map, bright and without lines.
TEST_F(SessionOfTheDemo, MapAndEdgesAreOnBothSidesOfASplitPicture) {
    const Picture whole = play({{1, kMapAndEdges}})[5];
    std::vector<Action> split = kMapAndEdges;
    split.push_back(kSplit);
    const Picture halves = play({{1, split}})[5];
    std::int32_t different = 0, compared = 0;
    for (std::int32_t y = 40; y < 160; ++y)  // between the messages at the top and the notes below
        for (std::int32_t x = 162; x < 320; ++x, ++compared)
            different += whole[pixel_count(320, y) + as_size(x)] != halves[pixel_count(320, y) + as_size(x)];
    EXPECT_LT(different, compared / 5);
    EXPECT_NE(halves, whole);
}

TEST_F(SessionOfTheDemo, WhatAKeyShowsIsSeenWhateverWasOpen) {
    const auto is_seen = [&](Action open, Action asked) {
        const Picture before = play({{1, {open}}})[12], after = play({{1, {open}}, {10, {asked}}})[12];
        constexpr std::ptrdiff_t kTop = 320 * 40, kEnd = 320 * 80;  // below messages, above the lab's panel
        return !std::equal(before.begin() + kTop, before.begin() + kEnd, after.begin() + kTop);
    };
    EXPECT_TRUE(is_seen(kPanel, Action::Automap));
    for (const Action asked : {Action::Automap, Action::Wireframe, Action::FrameCost, Action::Inspect, Action::Log,
                               kGuide, kPanel, kMap, kSplit, kFlip})
        EXPECT_TRUE(is_seen(kFour, asked)) << static_cast<int>(asked);
}

struct UprightWindow final : SilentPlatform {
    WindowSize window_size() const override { return {720, 1280}; }
};

// 200x320 for 9:16 has the shape 4:3 in 135 of its rows.
TEST_F(SessionOfTheDemo, TheThumbnailOfAnUprightPictureIsOfItsMiddle) {
    UprightWindow platform;
    ViewOptions view_options;
    Session session(loaded_, {}, view_options, TickInputSource(start_of(loaded_->level), std::nullopt, false),
                    platform);
    const Thumbnail thumbnail = session.thumbnail();
    const ShownPicture shown = session.draw(true);
    const Framebuffer middle = part_of(shown.canvas, {0, 92, 200, 135});
    EXPECT_TRUE(thumbnail.pixels == make_thumbnail(middle, shown.palette).pixels);
    EXPECT_FALSE(thumbnail.pixels == make_thumbnail(shown.canvas, shown.palette).pixels);
}

TEST_F(SessionOfTheDemo, ArrowsWalkUnlessTheLabIsOpen) {
    play({});
    const Demo walked = demo_;
    play({}, true);
    EXPECT_EQ(demo_, walked);
    play({{0, {kPanel}}}, true);
    EXPECT_NE(demo_, walked);
}

// Backwards to the levers behind the start and along them. Who watches the demo keeps the machine that he has.
TEST_F(SessionOfTheDemo, ALeverSetsTheMachineOfWhoPullsIt) {
    ViewOptions view_options;
    const auto watch = [&](std::optional<Demo> demo, Action along) {
        HeadlessPlatform platform(60, 35, no_input, [](Framebuffer, const Palette&) {});
        Controls controls;
        controls.moves = {Action::Back, along};
        Session session(loaded_, {}, view_options, TickInputSource(start_of(loaded_->level), std::move(demo), true),
                        platform);
        for (; platform.is_open(); platform.present({}, {}, {})) {
            platform.poll();
            session.advance(controls, platform.now_us());
        }
        demo_ = session.input().recorded();
        return session.messages().front();
    };
    EXPECT_EQ(watch({}, Action::Right), "M Machine: 486 at 66 MHz");
    EXPECT_EQ(view_options.preferences.machine, Processor::I486);
    const Demo pulled = demo_;
    EXPECT_EQ(watch({}, Action::Left), "M Machine: today's") << "the last of the row";
    EXPECT_EQ(view_options.preferences.machine, std::nullopt);
    EXPECT_NE(watch(pulled, Action::Left), "M Machine: 486 at 66 MHz");
    EXPECT_EQ(view_options.preferences.machine, std::nullopt);
}

// From within the great lens.
TEST_F(SessionOfTheDemo, EndsWithAnIntermissionWhoseSecondHalfHasThePaceOfA386) {
    const std::int64_t wait = loaded_->level.intermission->wait_ticks;
    HeadlessPlatform platform(wait + 4, 35, no_input, [](Framebuffer, const Palette&) {});
    ViewOptions view_options;
    Session session(loaded_, {.open_meter = open_reference_meter}, view_options,
                    TickInputSource(start_of(loaded_->level), std::nullopt, false), platform);
    GameState at_lens = start_of(loaded_->level);
    at_lens.player.position = world_vector(424, 1804, 500);
    session.restore(at_lens);
    std::uint64_t longest_us[2]{};
    std::set<Picture> pictures[2];
    while (platform.is_open()) {
        platform.poll();
        session.advance({}, platform.now_us());
        const Framebuffer canvas = session.draw(false).canvas;
        const std::int64_t ticks = session.ticks_since_end();
        EXPECT_EQ(ticks > 0, session.state().has_ended && session.state().tick > 1);
        const std::size_t half = ticks * 2 >= wait && ticks < wait ? 1 : 0;
        longest_us[half] = std::max(longest_us[half], session.shows_until_us() - platform.now_us());
        pictures[half].emplace(canvas.pixels, canvas.row(canvas.height_px));
        platform.present(canvas, Palette{}, {});
    }
    EXPECT_EQ(longest_us[0], 0u);
    EXPECT_GT(longest_us[1], 500'000u) << "microseconds";
    EXPECT_GT(pictures[0].size(), 200u) << "it turns";
    const std::string figures = session.figures();
    EXPECT_TRUE(figures.starts_with("Picture (bounded): 486 at 66 MHz: ")) << figures;
    EXPECT_NE(figures.find("\nIts worst texel: 0.3"), std::string::npos) << figures;
}

}  // namespace
}  // namespace oblong::test::session_test
