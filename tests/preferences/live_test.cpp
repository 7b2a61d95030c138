#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>

#include "engine/platform/headless.h"
#include "game/program/session.h"
#include "tests/preferences/named.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

// What a frame of a game gives to the window.
struct Shown {
    std::vector<std::uint8_t> pixels;
    std::int32_t width_px, height_px;
    Palette palette;
    PresentRect rect;
    std::uint64_t state_hash;
    std::int64_t tick;
};

constexpr std::int64_t kFrames = 24, kChanged = 8;

class LivePreferences : public testing::Test {
  protected:
    // A walk ahead and to the right; the preferences change at frame kChanged.
    std::vector<Shown> play(const std::function<void(Preferences&)>& change, const ViewOptions& start = {},
                            std::int64_t frames = kFrames) const {
        ViewOptions options = start;
        Controls controls;
        controls.moves = {Action::Forward, Action::Right, Action::TurnLeft};
        controls.mouse_x = mouse_x_;
        HeadlessPlatform platform(
            frames, 35, [](std::int64_t) { return PlatformInput{}; }, [](Framebuffer, const Palette&) {});
        Session session(loaded_, {}, options, TickInputSource(start_of(loaded_->level), std::nullopt, false), platform);
        std::vector<Shown> all;
        for (std::int64_t frame = 0; platform.is_open(); ++frame) {
            if (frame == kChanged) change(options.preferences);
            platform.poll();
            session.advance(controls, platform.now_us());
            const ShownPicture picture = session.draw(false);
            const Framebuffer canvas = picture.canvas;
            all.push_back({{canvas.pixels, canvas.pixels + pixel_count(canvas.width_px, canvas.height_px)},
                           canvas.width_px,
                           canvas.height_px,
                           picture.palette,
                           picture.rect,
                           hash_of(session.state()),
                           session.state().tick});
            platform.present(canvas, picture.palette, picture.rect);
        }
        return all;
    }

    // "NAME VALUE"
    static std::function<void(Preferences&)> setting(const std::string& change) {
        const std::size_t space = change.find(' ');
        return [=](Preferences& preferences) {
            test::preference_named(change.substr(0, space)).parse(preferences, change.substr(space + 1));
        };
    }

    const std::function<void(Preferences&)> nothing_ = [](Preferences&) {};
    const std::shared_ptr<const LoadedLevel> loaded_ =
        std::make_shared<const LoadedLevel>(LevelFiles{"", "", test::build_folder() + "/assets", ""});
    std::int32_t mouse_x_ = 0;  // moved in each frame
};

// In the frame in which it is changed, and in none before; the game in it stays the same.
TEST_F(LivePreferences, ThePictureChangesAtOnceAndTheGameDoesNot) {
    const std::vector<Shown> plain = play(nothing_);
    ASSERT_EQ(plain.size(), static_cast<std::size_t>(kFrames));
    for (const std::string change :
         {"fov 100", "display 16:9", "aspect-projection square", "brightness 2", "accuracy 1991",
          "dial-subpixel-bits 0", "dial-shades 16", "dial-light nearest", "dial-dither on", "dial-perspective affine",
          "view-bob 100", "view-roll 100", "text-size 2"}) {
        const std::vector<Shown> changed = play(setting(change));
        for (std::size_t frame = 0; frame < changed.size(); ++frame) {
            const bool is_changed = frame >= static_cast<std::size_t>(kChanged);
            EXPECT_EQ(changed[frame].pixels != plain[frame].pixels, is_changed) << change << ", frame " << frame;
            EXPECT_EQ(changed[frame].state_hash, plain[frame].state_hash) << change;
        }
    }
}

// As if the game had begun with it.
TEST_F(LivePreferences, AnotherModeMakesThePictureAnew) {
    ViewOptions large;
    large.preferences.mode = {400, 300, {4, 3}};
    const std::vector<Shown> begun = play(nothing_, large), changed = play(setting("mode 400x300"));
    EXPECT_EQ(changed[kChanged - 1].width_px, 320);
    for (std::size_t frame = kChanged; frame < begun.size(); ++frame) {
        EXPECT_EQ(changed[frame].width_px, 400);
        EXPECT_EQ(changed[frame].height_px, 300);
        EXPECT_EQ(changed[frame].pixels, begun[frame].pixels) << frame;
        EXPECT_EQ(changed[frame].rect, begun[frame].rect);
    }
}

TEST_F(LivePreferences, TheWindowChangesAtOnceAndThePictureDoesNot) {
    const std::vector<Shown> plain = play(nothing_);
    const auto rect_with = [&](const std::string& change) {
        const std::vector<Shown> changed = play(setting(change));
        EXPECT_EQ(changed[kChanged - 1].rect, plain[0].rect) << change;
        EXPECT_EQ(changed[kChanged].pixels, plain[kChanged].pixels) << change;
        EXPECT_NE(changed[kChanged].rect, plain[kChanged].rect) << change;
        return changed[kChanged].rect;
    };
    EXPECT_TRUE(rect_with("crt on").has_crt_look);
    const PresentRect square = rect_with("aspect-display square");
    EXPECT_EQ(square.height_px * 8, square.width_px * 5);
    const std::vector<Shown> dark = play(setting("gamma 1.8"));
    EXPECT_EQ(dark[kChanged].pixels, plain[kChanged].pixels);
    EXPECT_EQ(dark[kChanged - 1].palette.colours, plain[kChanged - 1].palette.colours);
    EXPECT_NE(dark[kChanged].palette.colours, plain[kChanged].palette.colours);
}

TEST_F(LivePreferences, WhatTheWindowIsToldFollowsThePreferences) {
    const Preferences changed = test::all_changed();
    EXPECT_EQ(window_settings_of(Preferences{}), (WindowSettings{false, true, 144}));
    EXPECT_EQ(window_settings_of(changed), (WindowSettings{true, false, changed.frame_cap_hz}));
    EXPECT_NE(changed.frame_cap_hz, 144);
}

// The signs of the map and the edges, of each scheme in colours of its own.
TEST_F(LivePreferences, ColoursOfSignsChangeAtOnce) {
    ViewOptions options;
    options.map = MapView::PlayerUp;
    options.wireframe = Wireframe::Over;
    const std::vector<Shown> plain = play(nothing_, options), red_green = play(setting("colours red-green"), options),
                             blue_yellow = play(setting("colours blue-yellow"), options);
    EXPECT_EQ(red_green[kChanged - 1].pixels, plain[kChanged - 1].pixels);
    EXPECT_NE(red_green[kChanged].pixels, plain[kChanged].pixels);
    EXPECT_NE(blue_yellow[kChanged].pixels, plain[kChanged].pixels);
    EXPECT_NE(blue_yellow[kChanged].pixels, red_green[kChanged].pixels);
}

TEST_F(LivePreferences, SteeringChangesAtOnce) {
    mouse_x_ = 4;
    const std::vector<Shown> plain = play(nothing_);
    for (const std::string change : {"mouse-sensitivity 300", "always-run off"}) {
        const std::vector<Shown> changed = play(setting(change));
        EXPECT_EQ(changed[kChanged - 1].state_hash, plain[kChanged - 1].state_hash) << change;
        EXPECT_NE(changed.back().state_hash, plain.back().state_hash) << change;
    }
}

// Slow motion changes when a tick comes, not what is in it.
TEST_F(LivePreferences, SlowMotionLeadsThroughTheSameStates) {
    const std::vector<Shown> plain = play(nothing_);
    ViewOptions slow;
    slow.preferences.game_speed_100 = 25;
    const std::vector<Shown> slowed = play(nothing_, slow, 4 * kFrames);
    std::map<std::int64_t, std::uint64_t> hash_of_tick;
    for (const Shown& shown : plain) hash_of_tick[shown.tick] = shown.state_hash;
    std::size_t compared = 0;
    for (const Shown& shown : slowed) {
        const auto found = hash_of_tick.find(shown.tick);
        if (found == hash_of_tick.end()) continue;
        EXPECT_EQ(shown.state_hash, found->second) << "tick " << shown.tick;
        ++compared;
    }
    EXPECT_GE(compared, 3 * static_cast<std::size_t>(kFrames));
    EXPECT_EQ(slowed.back().tick, plain.back().tick);
}

}  // namespace
}  // namespace oblong
