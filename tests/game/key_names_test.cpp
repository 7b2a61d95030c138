#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/platform/headless.h"
#include "game/input/bindings.h"
#include "game/program/view_options.h"
#include "tests/support/folders.h"
#include "tests/support/patterns.h"
#include "tests/support/silent_platform.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

const HeadlessPlatform kPlatform(1, 35, nullptr, nullptr);

TEST(KeyNames, AreThoseThatAreBoundOnTheDeviceInUse) {
    Bindings bindings = default_bindings();
    const KeyNames keys(bindings, kPlatform, false), pad(bindings, kPlatform, true);
    EXPECT_EQ(keys.in("{jump} jumps, {torch} lights, {menu} stops"), "Space jumps, L lights, Escape stops");
    EXPECT_EQ(pad.in("{jump} jumps, {torch} lights, {menu} stops"), "Pad A jumps, Pad B lights, Pad Start stops");
    EXPECT_EQ(pad.in("{help}: keys"), "F1: keys") << "the pad has no button for it";
    set_inputs(bindings, Action::Jump, "J");
    EXPECT_EQ(keys.in("{jump}"), "J");
    set_inputs(bindings, Action::Jump, "none");
    EXPECT_EQ(keys.in("{jump}"), "none");
    EXPECT_EQ(keys.in("{no such} {jump"), "{no such} {jump");
}

struct TouchScreen : test::SilentPlatform {
    std::string local_name_of(Input input) const override {
        const std::string name = name_of(input);
        return name == "Escape" ? "Menu" : name == "Enter" ? "OK" : name == "Space" ? "Jump" : "";
    }
};

// A phone's page has four buttons; the menu's page of keys does the rest.
TEST(KeyNames, SayHowATouchScreenReachesWhatHasNoButton) {
    const Bindings bindings = default_bindings();
    const TouchScreen screen;
    const KeyNames names(bindings, screen, false);
    EXPECT_EQ(names.in("{jump} jumps, {help}: help, {menu} stops"), "Jump jumps, Menu, Keys: help, Menu stops");
    EXPECT_EQ(names.in("{choose} choose, {accept} accepts"), "Taps choose, OK accepts");
    for (const ActionRow& row : all_actions())
        EXPECT_FALSE(test::is_found(names.in("{" + std::string(row.name) + "}"), R"x(\bF[1-9])x")) << row.name;
    EXPECT_EQ(names.in("{no such} {jump"), "{no such} {jump");
}

// In messages, captions and help of the game: they are named as they are bound, by KeyNames alone.
TEST(KeyNames, StandInNoTextOfTheGame) {
    const std::string literal = R"x("((?:[^"\\]|\\.)*)")x";
    const std::string key =
        R"x((^|[^A-Za-z0-9-])(F[1-9][0-2]?|Tab|Esc|Escape|Enter|Backspace|Insert|Page (Up|Down)|WASD|)x"
        R"x([Aa]rrows?|Shift|Ctrl|Space|Pad [A-Z]\w*)([^A-Za-z0-9-]|$))x";
    for (const auto& entry : fs::recursive_directory_iterator(test::source_folder() + "/game")) {
        const std::string name = entry.path().filename().string();
        // The names themselves; a window of its own, whose keys are the same for all.
        if (entry.path().extension() != ".cpp" || name == "bindings.cpp" || name == "error_window.cpp") continue;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            if (line.find("#include") != line.npos || line.find("Alt+Enter") != line.npos)
                continue;  // bound to nothing
            for (const test::Groups& text : test::all_matches(line, literal))
                EXPECT_FALSE(test::is_found(text[1], key)) << entry.path() << ": " << text[1];
        }
    }
}

// Keys of one letter too, which a search for names does not find.
TEST(KeyNames, AreAskedForByTheMessageOfEachCommand) {
    const Bindings bindings = default_bindings();
    for (const ActionRow& row : all_actions()) {
        if (is_move(row.action)) continue;
        ViewOptions options;
        for (int times = 0; times < 4; ++times) {
            const std::string message = apply(row.action, options, {1600, 1200});
            const std::string name = KeyNames(bindings, kPlatform, false).of(row.action);
            EXPECT_FALSE(message.starts_with(name + " ")) << message;
        }
    }
}

}  // namespace
}  // namespace oblong
