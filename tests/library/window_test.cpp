#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "engine/library/oblong.h"
#include "engine/platform/headless.h"
#include "tests/support/folders.h"
#include "tests/support/silent_platform.h"

namespace oblong {
namespace {

constexpr Input kSpace{Device::Key, 44};

InputEvent event(InputEvent::Kind kind, Input input, std::int32_t x = 0, std::int32_t y = 0) {
    return {kind, input, x, y};
}

// A window whose input is `scripts`, one a picture, and then nothing.
struct ScriptedWindow {
    explicit ScriptedWindow(std::vector<PlatformInput> scripts, ScreenMode mode = {})
        : platform(
              100, 70,
              [scripts](std::int64_t poll) {
                  return poll < std::int64_t(scripts.size()) ? scripts[as_size(poll)] : PlatformInput{};
              },
              [](Framebuffer, const Palette&) {}),
          window(platform, mode) {}

    HeadlessPlatform platform;
    Window window;
};

PlatformInput of(std::vector<InputEvent> events) {
    PlatformInput input;
    input.events = std::move(events);
    return input;
}

using Kind = InputEvent::Kind;

TEST(LibraryWindow, KeyIsPressedOnceAndDownUntilItIsLetGo) {
    ScriptedWindow scripted(
        {of({event(Kind::Press, kSpace)}), of({event(Kind::Repeat, kSpace)}), of({event(Kind::Release, kSpace)})});
    Window& window = scripted.window;
    EXPECT_FALSE(window.is_down("Space"));
    window.show();
    EXPECT_TRUE(window.is_down("Space") && window.was_pressed("space"));
    window.show();
    EXPECT_TRUE(window.is_down("Space") && !window.was_pressed("Space"));
    EXPECT_FALSE(window.is_down("Enter"));
    window.show();
    EXPECT_FALSE(window.is_down("Space") || window.was_pressed("Space"));
    EXPECT_TRUE(window.was_released("Space") && !window.was_released("Enter"));
    window.show();
    EXPECT_FALSE(window.was_released("Space"));
}

TEST(LibraryWindow, WhatItLosesIsReleased) {
    ScriptedWindow scripted({of({event(Kind::Press, kSpace), event(Kind::Axis, pad_axis(PadAxis::LeftX, true), 9999)}),
                             of({event(Kind::ReleaseAll, {})})});
    scripted.window.show();
    Window moved_window = std::move(scripted.window);
    EXPECT_TRUE(moved_window.is_down("Space"));
    moved_window.show();
    EXPECT_FALSE(moved_window.is_down("Space"));
}

TEST(LibraryWindow, TypedTextIsThatOfTheLastPicture) {
    PlatformInput typing;
    typing.text = "Ab\b\u00e9\n";
    ScriptedWindow scripted({typing});
    scripted.window.show();
    EXPECT_EQ(scripted.window.typed(), "Ab\b\u00e9\n");
    scripted.window.show();
    EXPECT_EQ(scripted.window.typed(), "");
    std::string text = "x";
    add_typed(text, "\b\bab\u00e9\u00e9\bc");
    EXPECT_EQ(text, "ab\u00e9c");
}

TEST(LibraryWindow, EachGamepadHasItsNumber) {
    const auto of_pad = [](int number, Input input) {
        return Input{input.device, static_cast<std::uint16_t>(input.code + 256 * number)};
    };
    const Input a = pad_button(PadButton::A), stick = pad_axis(PadAxis::LeftY, false);
    PlatformInput pressed = of({event(Kind::Press, a)}), lost;
    pressed.pad_events = {event(Kind::Press, of_pad(2, a)), event(Kind::Axis, of_pad(1, stick), kFullAxis)};
    lost.pad_events = {event(Kind::ReleasePad, of_pad(2, a))};
    ScriptedWindow scripted({pressed, lost});
    Window& window = scripted.window;
    window.show();
    EXPECT_TRUE(window.is_down("Pad A") && window.was_pressed("pad 2 a") && !window.is_down("Pad 1 A"));
    EXPECT_EQ(window.pressure_256("Pad 1 Left Stick Up"), 256);
    window.show();
    EXPECT_TRUE(window.is_down("Pad A") && window.is_down("Pad 1 Left Stick Up") && !window.is_down("Pad 2 A"));
    EXPECT_THROW(window.is_down("Pad 2 Q"), std::runtime_error);
}

// Notes what a window asks of it.
struct NotingPlatform final : test::SilentPlatform {
    void set_icon(std::span<const std::uint8_t> rgba, WindowSize) override { icon.assign(rgba.begin(), rgba.end()); }
    void change_window(const WindowSettings& settings) override { rate = settings.frames_per_second; }

    std::vector<std::uint8_t> icon;
    std::int32_t rate = 0;
};

TEST(LibraryWindow, IconAndRateReachThePlatform) {
    NotingPlatform platform;
    Window window(platform, {});
    window.palette.colours[7] = {1, 2, 3};
    window.set_icon({2, 1, {7, kTransparent}});
    ASSERT_EQ(platform.icon.size(), 8u);
    EXPECT_EQ(std::vector(platform.icon.begin(), platform.icon.begin() + 4), (std::vector<std::uint8_t>{1, 2, 3, 255}));
    EXPECT_EQ(platform.icon[7], 0);
    window.set_rate(30);
    window.show();
    EXPECT_EQ(platform.rate, 30);
}

// The free mouse reports clicks, the captured one presses.
TEST(LibraryWindow, AButtonIsDownUntilItIsLetGoAlsoOfTheFreeMouse) {
    for (const Kind press : {Kind::Click, Kind::Press}) {
        ScriptedWindow scripted(
            {of({event(press, mouse_button(1))}), of({}), of({event(Kind::Release, mouse_button(1))})});
        std::string down, pressed;
        for (int picture = 0; picture < 4; ++picture) {
            scripted.window.show();
            down += scripted.window.is_down("Mouse 1") ? '1' : '0';
            pressed += scripted.window.was_pressed("Mouse 1") ? '1' : '0';
        }
        EXPECT_EQ(down + " " + pressed, "1100 1000");
    }
}

TEST(LibraryWindow, NotchesAndQuickPressesAreCounted) {
    const Input wheel{Device::MouseWheel, 0};
    std::vector<InputEvent> notches;
    for (int i = 0; i < 5; ++i) notches.insert(notches.end(), {event(Kind::Press, wheel), event(Kind::Release, wheel)});
    notches.push_back(event(Kind::Press, kSpace));
    ScriptedWindow scripted({of(notches)});
    scripted.window.show();
    EXPECT_EQ(scripted.window.press_count("Wheel Up"), 5);
    EXPECT_EQ(scripted.window.press_count("Space"), 1);
    EXPECT_EQ(scripted.window.press_count("Enter"), 0);
    scripted.window.show();
    EXPECT_EQ(scripted.window.press_count("Wheel Up"), 0);
}

// Between two pictures.
TEST(LibraryWindow, QuickPressIsNotLost) {
    ScriptedWindow scripted({of({event(Kind::Press, kSpace), event(Kind::Release, kSpace)})});
    scripted.window.show();
    EXPECT_TRUE(scripted.window.was_pressed("Space") && !scripted.window.is_down("Space"));
}

TEST(LibraryWindow, SticksArePressedByDegreesAndTheWheelForAPicture) {
    const Input stick = pad_axis(PadAxis::LeftX, true), wheel{Device::MouseWheel, 0};
    ScriptedWindow scripted({of({event(Kind::Axis, stick, kFullAxis / 8), event(Kind::Press, wheel)}),
                             of({event(Kind::Axis, stick, kFullAxis)}), of({event(Kind::Axis, stick, 0)})});
    Window& window = scripted.window;
    const std::string right = name_of(stick);
    window.show();
    EXPECT_NEAR(window.pressure_256(right), 32, 1);
    EXPECT_FALSE(window.is_down(right));
    EXPECT_TRUE(window.was_pressed("Wheel Up"));
    window.show();
    EXPECT_EQ(window.pressure_256(right), 256);
    EXPECT_TRUE(window.is_down(right));
    EXPECT_FALSE(window.is_down("Wheel Up"));
    window.show();
    EXPECT_EQ(window.pressure_256(right), 0);
}

// 1600x1200 of the platform hold 320x200 on 4:3 in 5x6 pixels each.
TEST(LibraryWindow, MouseIsOverThePixelThatIsShownThere) {
    PlatformInput input;
    input.pointer = Pointer{5 * 17 + 4, 6 * 101, true, false};
    ScriptedWindow scripted({input, of({event(Kind::MouseMotion, {}, 3, -4), event(Kind::MouseMotion, {}, 1, 1)})});
    scripted.window.show();
    EXPECT_EQ(scripted.window.mouse(), (PixelPosition{17, 101}));
    scripted.window.show();
    EXPECT_EQ(scripted.window.mouse_motion(), (PixelPosition{4, -3}));
    scripted.window.show();
    EXPECT_EQ(scripted.window.mouse_motion(), (PixelPosition{}));
}

// As far as numbers reach.
TEST(LibraryWindow, MouseAndSticksOfAnotherPlatformMayReportAnyNumbers) {
    using Limits = std::numeric_limits<std::int32_t>;
    constexpr std::int32_t least = Limits::min(), most = Limits::max();
    PlatformInput input = of({event(Kind::MouseMotion, {}, most, least), event(Kind::MouseMotion, {}, 9, -9),
                              event(Kind::Axis, pad_axis(PadAxis::LeftX, true), most)});
    input.pointer = Pointer{most, least, true, false};
    ScriptedWindow scripted({input}, {4096, 4096, {4, 3}});
    scripted.window.show();
    EXPECT_EQ(scripted.window.mouse_motion(), (PixelPosition{most, least}));
    EXPECT_EQ(scripted.window.mouse(), (PixelPosition{most, least}));
    EXPECT_EQ(scripted.window.pressure_256("Pad Left Stick Right"), 256);
}

TEST(LibraryWindow, EndsWhenItIsClosed) {
    ScriptedWindow scripted({});
    EXPECT_TRUE(scripted.window.show());
    scripted.window.close();
    EXPECT_FALSE(scripted.window.show());
}

TEST(LibraryWindow, UnknownInputsAndModesAreRefused) {
    ScriptedWindow scripted({});
    EXPECT_THROW(scripted.window.is_down("Spaze"), std::runtime_error);
    for (const ScreenMode mode :
         {ScreenMode{0, 200, {4, 3}}, ScreenMode{320, 5000, {4, 3}}, ScreenMode{320, -1, {4, 3}},
          ScreenMode{320, 200, {4, 0}}, ScreenMode{320, 200, {-4, 3}}, ScreenMode{320, 200, {101, 1}},
          ScreenMode{320, 200, {10'001, 10'000}}}) {
        EXPECT_THROW(Window(scripted.platform, mode), std::runtime_error);
        EXPECT_THROW(scripted.window.set_mode(mode), std::runtime_error);
        EXPECT_THROW(Stage({}, mode), std::runtime_error);
    }
}

TEST(LibraryWindow, AreOpenedAndUsedOnOneThread) {
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    Window here("here");
    std::vector<std::string> said;
    const auto refused = [&](auto work) {
        try {
            work();
        } catch (const std::runtime_error& error) {
            said.push_back(error.what());
        }
    };
    std::thread elsewhere([&] {
        refused([] { Window("there"); });
        refused([&] { here.show(); });
    });
    elsewhere.join();
    EXPECT_EQ(said, (std::vector<std::string>{"window: another is open on another thread, expected all on one",
                                              "window: used on another thread than it was opened on, expected that"}));
    EXPECT_TRUE(here.show());
    Window("here, too").show();
    unsetenv("SDL_VIDEODRIVER");
}

struct HeadlessEnvironment {
    explicit HeadlessEnvironment(const std::string& value) { setenv("OBLONG_HEADLESS", value.c_str(), 1); }
    ~HeadlessEnvironment() { unsetenv("OBLONG_HEADLESS"); }
};

TEST(LibraryHeadless, DrawsSoManyPicturesAndSavesTheLast) {
    const test::TemporaryFolder folder;
    const HeadlessEnvironment environment("70:" + folder.path("last.png"));
    Window window("nowhere", {64, 40, {4, 3}});
    window.palette = {};
    for (std::size_t i = 0; i < 256; ++i) window.palette.colours[i] = {static_cast<std::uint8_t>(i), 1, 2};
    int pictures = 0;
    do {
        set_pixel(window.canvas(), pictures % 64, 0, static_cast<std::uint8_t>(pictures + 1));
        ++pictures;
    } while (window.show());
    EXPECT_EQ(pictures, 70);
    EXPECT_NEAR(double(window.time_ms()), 1000, 1);
    const Picture saved = load_picture(folder.path("last.png"), window.palette);
    EXPECT_EQ(checksum(window.canvas()), checksum(Picture(saved).canvas()));
    EXPECT_EQ(saved.pixels[5], 70);
    EXPECT_EQ(load_palette(folder.path("last.png")).colours, window.palette.colours);
}

TEST(LibraryHeadless, WrongWordsAreRefused) {
    for (const char* wrong : {"", "0", "-1", "x", "5x", ":a.png", "99999999999999999999"}) {
        const HeadlessEnvironment environment(wrong);
        EXPECT_THROW(Window("nowhere"), std::runtime_error) << wrong;
    }
}

TEST(LibrarySpeaker, IsSilentWithoutADeviceButSaysWhatIsWrong) {
    const HeadlessEnvironment environment("1");
    Speaker speaker;
    EXPECT_NE(speaker.problem(), "");
    const std::int32_t sound = speaker.add({1, 2, 3}, 22'050);
    EXPECT_NO_THROW(speaker.play(sound));
    EXPECT_THROW(speaker.play(sound + 1), std::runtime_error);
    EXPECT_THROW(speaker.play(-1), std::runtime_error);
    EXPECT_THROW(speaker.load("/nowhere/a.flac"), std::runtime_error);
    EXPECT_THROW(speaker.play_music("/nowhere/a.mod"), std::runtime_error);
    const test::TemporaryFolder folder;
    EXPECT_THROW(speaker.play_music(folder.write("no.mod", std::string(3000, 'x'))), std::runtime_error);
    EXPECT_NO_THROW(speaker.play_music(test::source_folder() + std::string("/assets/music/title.mod")));
}

}  // namespace
}  // namespace oblong
