#include "game/program/session.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>

#include "engine/platform/headless/headless.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

using Picture = std::vector<std::uint8_t>;
using Presses = std::map<std::int64_t, std::vector<Action>>;

constexpr std::int64_t kFrames = 40;

class SessionOfTheDemo : public testing::Test {
  protected:
    void SetUp() override {
        const std::string assets = test::build_folder() + "/assets";
        if (!std::filesystem::exists(assets + "/demo.bsp")) GTEST_SKIP() << "the demo level is not built";
        loaded_ = std::make_shared<const LoadedLevel>(LevelFiles{"", "", assets, ""});
    }

    // Walks ahead in a turn with keys pressed at some frames; the demo that it recorded is in demo_.
    std::vector<Picture> play(const Presses& presses, bool by_arrows = false) {
        std::vector<Picture> pictures;
        const auto script = [&](std::int64_t frame) {
            Controls controls;
            (by_arrows ? controls.panel_moves : controls.moves) = {Action::Forward, Action::TurnRight};
            if (const auto found = presses.find(frame); found != presses.end()) controls.commands = found->second;
            return controls;
        };
        HeadlessPlatform platform(
            kFrames, 35, [](std::int64_t) { return PlatformInput{}; },
            [&](Framebuffer picture, const Palette&) {
                pictures.emplace_back(picture.pixels,
                                      picture.pixels + pixel_count(picture.width_px, picture.height_px));
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
        demo_ = encode_demo(session.input().recorded());
        return pictures;
    }

    std::shared_ptr<const LoadedLevel> loaded_;
    std::vector<std::uint8_t> demo_;
};

constexpr Action kPanel = Action::LabPanel, kMap = Action::ErrorMap, kSplit = Action::SplitView,
                 kFlip = Action::FlipSettings, kGuide = Action::AspectGuide, kFour = Action::FourAspects;

// Messages over the picture end after 2.5 s, or longer: the pictures are compared with those of a run that shows none.
TEST_F(SessionOfTheDemo, TheLabLeavesNoTraceInTheGame) {
    const std::vector<Picture> plain = play({{1, {kGuide}}, {20, {kGuide}}});
    const std::vector<std::uint8_t> plain_demo = demo_;
    const std::vector<Picture> watched = play({{1, {kPanel, kMap, kSplit, kFlip, kGuide}},
                                               {10, {kFour}},
                                               {15, {kFour}},
                                               {20, {kPanel, kMap, kSplit, kFlip, kGuide}}});
    EXPECT_EQ(demo_, plain_demo);
    ASSERT_EQ(watched.size(), plain.size());
    EXPECT_EQ(watched[0], plain[0]);
    for (std::size_t frame = 1; frame < 20; ++frame) EXPECT_NE(watched[frame], plain[frame]) << frame;
    constexpr std::size_t kBelowMessage = 320 * 40;
    for (std::size_t frame = 20; frame < plain.size(); ++frame)
        EXPECT_TRUE(std::equal(plain[frame].begin() + kBelowMessage, plain[frame].end(),
                               watched[frame].begin() + kBelowMessage))
            << frame;
}

// F6 draws the view twice more; a torch lights the picture alone.
TEST_F(SessionOfTheDemo, CostTorchAndTubeLeaveNoTraceInTheGame) {
    const std::vector<Picture> plain = play({});
    const std::vector<std::uint8_t> plain_demo = demo_;
    const std::vector<Picture> watched = play({{1, {Action::FrameCost, Action::Torch, Action::CrtLook}},
                                               {30, {Action::FrameCost, Action::Torch, Action::CrtLook}}});
    EXPECT_EQ(demo_, plain_demo);
    ASSERT_EQ(watched.size(), plain.size());
    for (std::size_t frame = 1; frame < 30; ++frame) EXPECT_NE(watched[frame], plain[frame]) << frame;
    constexpr std::size_t kBelowMessage = 320 * 40;
    for (std::size_t frame = 30; frame < plain.size(); ++frame)
        EXPECT_TRUE(std::equal(plain[frame].begin() + kBelowMessage, plain[frame].end(),
                               watched[frame].begin() + kBelowMessage))
            << frame;
}

TEST_F(SessionOfTheDemo, MapAndEdgesLeaveNoTraceInTheGame) {
    const std::vector<Picture> plain = play({});
    const std::vector<std::uint8_t> plain_demo = demo_;
    const std::vector<Picture> watched = play({{1, {Action::Automap, Action::Wireframe}},
                                               {15, {Action::Automap, Action::Wireframe}},
                                               {30, {Action::Automap, Action::Wireframe}}});
    EXPECT_EQ(demo_, plain_demo);
    ASSERT_EQ(watched.size(), plain.size());
    for (std::size_t frame = 1; frame < 30; ++frame) EXPECT_NE(watched[frame], plain[frame]) << frame;
    constexpr std::size_t kBelowMessage = 320 * 40;
    for (std::size_t frame = 30; frame < plain.size(); ++frame)
        EXPECT_TRUE(std::equal(plain[frame].begin() + kBelowMessage, plain[frame].end(),
                               watched[frame].begin() + kBelowMessage))
            << frame;
}

TEST_F(SessionOfTheDemo, OtherViewsLeaveNoTraceInTheGame) {
    const std::vector<Picture> plain = play({});
    const std::vector<std::uint8_t> plain_demo = demo_;
    const std::vector<Picture> watched = play({{1, {Action::Isometric}},
                                               {10, {Action::Isometric, Action::ZoomIn, Action::ZoomIn}},
                                               {20, {Action::ZoomOut, Action::ZoomOut}}});
    EXPECT_EQ(demo_, plain_demo);
    ASSERT_EQ(watched.size(), plain.size());
    for (std::size_t frame = 1; frame < 20; ++frame) EXPECT_NE(watched[frame], plain[frame]) << frame;
    constexpr std::size_t kBelowMessage = 320 * 40;
    for (std::size_t frame = 20; frame < plain.size(); ++frame)
        EXPECT_TRUE(std::equal(plain[frame].begin() + kBelowMessage, plain[frame].end(),
                               watched[frame].begin() + kBelowMessage))
            << frame;
}

TEST_F(SessionOfTheDemo, ArrowsWalkUnlessTheLabIsOpen) {
    play({});
    const std::vector<std::uint8_t> walked = demo_;
    play({}, true);
    EXPECT_EQ(demo_, walked);
    play({{0, {kPanel}}}, true);
    EXPECT_NE(demo_, walked);
}

}  // namespace
}  // namespace oblong
