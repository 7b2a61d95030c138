#include "game/options/preference_table.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engine/accuracy/accuracy.h"
#include "engine/programs/arguments.h"
#include "tests/preferences/named.h"

namespace oblong {
namespace {

// The values at which a menu ends. Those of other preferences go round: their count.
const std::map<std::string, std::pair<std::string, std::string>> kEnds{{"fov", {"30", "140"}},
                                                                       {"mode", {"160x100", "1600x1200"}},
                                                                       {"display", {"5:4", "7:3"}},
                                                                       {"view-size", {"30", "100"}},
                                                                       {"brightness", {"0.25", "8"}},
                                                                       {"gamma", {"0.5", "2"}},
                                                                       {"frame-cap", {"0", "240"}},
                                                                       {"view-bob", {"0", "200"}},
                                                                       {"view-roll", {"0", "200"}},
                                                                       {"game-speed", {"25", "100"}},
                                                                       {"text-size", {"1", "2"}},
                                                                       {"mouse-sensitivity", {"10", "1000"}},
                                                                       {"gamepad-sensitivity", {"10", "400"}},
                                                                       {"gamepad-dead-zone", {"0", "90"}},
                                                                       {"volume", {"0", "100"}},
                                                                       {"sounds-volume", {"0", "100"}},
                                                                       {"music-volume", {"0", "100"}}};
const std::map<std::string, std::size_t> kCounts{
    {"aspect-projection", 2}, {"aspect-display", 3}, {"scaling", 4},      {"crt", 2},
    {"tube-light", 2},        {"dac6", 2},           {"whole-screen", 2}, {"vsync", 2},
    {"accuracy", 6},          {"machine", 4},        {"flashes", 3},      {"colours", 3},
    {"captions", 2},          {"invert-look", 2},    {"always-run", 2},   {"double-columns", 2}};

bool is_dial(const Preference& row) {
    return row.name.starts_with("dial-");
}

// All values that steps in one direction reach, until they are at an end or round.
std::vector<std::string> reached(const Preference& row, int step) {
    Preferences preferences;
    std::vector<std::string> values{row.shown(preferences)};
    for (int i = 0; i < 100; ++i) {
        row.change(preferences, step);
        if (row.shown(preferences) == values.back() || row.shown(preferences) == values.front()) break;
        values.push_back(row.shown(preferences));
    }
    return values;
}

TEST(PreferenceTable, NamesEachRowOnceAndFitsAMenu) {
    std::set<std::string> names;
    for (const Preference& row : all_preferences()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.label.empty() || row.help.empty() || row.values.empty()) << row.name;
        EXPECT_LE(row.label.size(), 20u) << row.label;
        EXPECT_LE(row.shown(Preferences{}).size(), 20u) << row.name;
        EXPECT_EQ(row.help.find('\n'), std::string::npos) << row.name;
        EXPECT_TRUE(is_dial(row) || kEnds.contains(row.name) || kCounts.contains(row.name)) << row.name;
    }
    EXPECT_EQ(names.size(), kEnds.size() + kCounts.size() + all_dials().size());
}

TEST(PreferenceTable, EveryValueOfAMenuIsWrittenAndReadBack) {
    for (const Preference& row : all_preferences())
        for (const int step : {1, -1}) {
            Preferences preferences;
            for (int i = 0; i < 30; ++i) {
                row.change(preferences, step);
                Preferences read;
                row.parse(read, row.text(preferences));
                EXPECT_EQ(read, preferences) << row.name << ' ' << row.text(preferences);
            }
        }
}

TEST(PreferenceTable, NumbersStopAtTheirEnds) {
    for (const auto& [name, ends] : kEnds) {
        const Preference& row = test::preference_named(name);
        for (const auto& [step, end] : {std::pair{-1, ends.first}, std::pair{1, ends.second}}) {
            Preferences preferences;
            for (int i = 0; i < 50; ++i) row.change(preferences, step);
            EXPECT_EQ(row.text(preferences), end) << name;
            Preferences at_once;
            row.change(at_once, 50 * step);
            EXPECT_EQ(at_once, preferences) << name;
        }
    }
}

TEST(PreferenceTable, NamesGoRoundInBothDirections) {
    for (const auto& [name, count] : kCounts)
        for (const int step : {1, -1}) {
            const Preference& row = test::preference_named(name);
            EXPECT_EQ(reached(row, step).size(), count) << name;
            EXPECT_EQ(row.is_switch, count == 2 && name != "aspect-projection") << name;
            Preferences round;
            for (std::size_t i = 0; i < count; ++i) row.change(round, step);
            EXPECT_EQ(round, Preferences{}) << name;
        }
}

TEST(PreferenceTable, EveryDialReachesAllItsSettings) {
    for (const Dial& dial : all_dials()) {
        const Preference& row = test::preference_named("dial-" + std::string(dial.name));
        Preferences preferences;
        row.change(preferences, -static_cast<int>(dial.settings.size()));
        for (const DialSetting& setting : dial.settings) {
            EXPECT_EQ(dial.get(preferences.accuracy), setting.value) << row.name;
            EXPECT_EQ(row.shown(preferences), setting.name);
            row.change(preferences, 1);
        }
    }
}

// "preset" follows the preset; a value stays.
TEST(PreferenceTable, APresetTurnsTheDialsThatWereLeftToIt) {
    const Preference& dial = test::preference_named("dial-perspective");
    Preferences preferences;
    EXPECT_EQ(dial.text(preferences), "preset");
    dial.parse(preferences, "every8");
    EXPECT_EQ(dial.text(preferences), "every8");
    test::preference_named("accuracy").parse(preferences, "1991");
    EXPECT_EQ(preferences.accuracy, accuracy_of(Preset::Year1991));
    EXPECT_EQ(dial.text(preferences), "preset");
    EXPECT_EQ(dial.shown(preferences), "affine");
}

TEST(PreferenceTable, RefusesWhatIsNoValueAndChangesNothing) {
    for (const Preference& row : all_preferences())
        for (const char* text : {"", "nonsense", "-1", "1e3", "nan", "99999999999999999999", "4:", "x", "0x10"}) {
            Preferences preferences;
            try {
                row.parse(preferences, text);
                EXPECT_EQ(row.name, "dial-mip-bias") << text << " is a value of this one alone";
            } catch (const UsageError& error) {
                EXPECT_EQ(std::string(error.what()).rfind(is_dial(row) ? "--dial" : "--" + row.name + ": ", 0), 0u)
                    << error.what();
                EXPECT_NE(std::string(error.what()).find("expected "), std::string::npos) << error.what();
                EXPECT_EQ(preferences, Preferences{}) << row.name;
            }
        }
}

// A mode of few pixels can't show a wide view: a menu leaves out what can't be drawn.
TEST(PreferenceTable, NoStepLeadsToAViewThatCannotBeDrawn) {
    const std::array<const char*, 3> names{"fov", "mode", "display"};
    Preferences preferences;
    preferences.mode = {64, 48, {4, 3}};
    std::uint32_t random = 1;
    for (int i = 0; i < 300; ++i) {
        random = random * 1664525 + 1013904223;
        test::preference_named(names[random >> 24 & 3 ? (random >> 24) % 3 : 0])
            .change(preferences, random >> 16 & 1 ? 3 : -2);
        EXPECT_NO_THROW(check_view(preferences.mode, preferences.field_of_view));
    }
}

TEST(PreferenceTable, DegreesKeepTheirDecimals) {
    const Preference& row = test::preference_named("fov");
    for (const char* text : {"90", "73.74", "1", "179", "100.5", "59.0000001", "120.125"}) {
        Preferences preferences;
        row.parse(preferences, text);
        EXPECT_EQ(row.text(preferences), text);
    }
}

TEST(PreferenceTable, StretchIsAnotherNameForFillingTheWindow) {
    Preferences preferences;
    test::preference_named("scaling").parse(preferences, "stretch");
    EXPECT_EQ(preferences.shown_as, ShownAs::FillWindow);
    EXPECT_EQ(preferences.scaling, Scaling::SharpBilinear);
}

// Each game's light is its own: the museum's in values of their own, all others' in one.
TEST(PreferenceTable, LightIsKeptAGame) {
    Preferences played;
    EXPECT_EQ(played.light(), (Light{100, 100, false})) << "frames of the museum stay as they are";
    test::preference_named("gamma").parse(played, "1.2");
    played.game = kQuake;
    EXPECT_EQ(played.light(), (Light{100, 100, true})) << "made on tubes";
    test::preference_named("brightness").parse(played, "1.4");
    played.game = "my_mod.2";
    test::preference_named("tube-light").parse(played, "off");
    Preferences read;
    for (const KeptValue* value : all_kept_values()) value->parse(read, value->text(played));
    EXPECT_EQ(read.lights, played.lights);
    EXPECT_EQ(read.light_of(kMuseum), (Light{100, 120, false}));
    EXPECT_EQ(read.light_of(kQuake), (Light{140, 100, true}));
    EXPECT_EQ(read.light_of("my_mod.2"), (Light{100, 100, false}));
    EXPECT_EQ(read.light_of("another"), (Light{100, 100, true}));
}

TEST(PreferenceTable, LightsOfGamesThatSayNothingAreRefusedWhole) {
    const auto values = all_kept_values();
    const KeptValue& lights = **std::ranges::find(values, "game-lights", &KeptValue::name);
    for (const char* text : {"quake", "quake:1", "quake:1:1", "quake:1:1:maybe", "quake:9:1:on", "quake:1:3:on",
                             "museum:1:1:on", ":1:1:on", "a:1:1:on:", "a:1:1:on b", "a:x:1:on"}) {
        Preferences preferences;
        EXPECT_THROW(lights.parse(preferences, text), UsageError) << text;
        EXPECT_EQ(preferences, Preferences{}) << text;
    }
}

}  // namespace
}  // namespace oblong
