#include <gtest/gtest.h>

#include <sstream>

#include "engine/base/input_error.h"
#include "game/options/preferences_store.h"
#include "tests/preferences/named.h"

namespace oblong {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream input(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(input, line);) lines.push_back(line);
    return lines;
}

std::string with(const std::string& text, const std::string& name, const Preferences& now) {
    return with_values(text, {&test::preference_named(name)}, now);
}

TEST(OptionsText, HasHelpAndValuesAboveEachName) {
    const std::vector<std::string> lines = lines_of(write_preferences({}));
    for (const Preference& row : all_preferences()) {
        const auto at = std::find(lines.begin(), lines.end(), row.name + " = " + row.text(Preferences{}));
        ASSERT_NE(at, lines.end()) << row.name;
        ASSERT_GE(at - lines.begin(), 3);
        EXPECT_EQ(*(at - 2), "# " + row.label + ": " + row.help + ".");
        EXPECT_EQ((at - 1)->rfind("# " + row.values, 0), 0u);
    }
}

TEST(OptionsText, NamesBrokenLinesAndKeepsAllOthers) {
    const ReadPreferences read = read_preferences(
        "brightness = 2 # for e1m7\n"
        "fov = wide\n"
        "; nothing\n"
        "colour = red\n"
        "[sounds]\n"
        "volume = 30\n"
        "x\n"
        "mouse-sensitivity = 9\n"
        "gamma\n"
        "\t crt  =  on\r\n"
        "invert-look\n"
        "music-volume = \"20\"\n"
        "volume = 40\n"
        "gamma = -1\n"
        "gamma = 1e1\n"
        "fov 100\n"
        "light-set = on\n");  // of an earlier version
    EXPECT_EQ(read.preferences.light().brightness_100, 200);
    EXPECT_EQ(read.preferences.volume_100, 40);
    EXPECT_EQ(read.preferences.music_volume_100, 20);
    EXPECT_TRUE(read.preferences.has_crt_look);
    EXPECT_TRUE(read.preferences.inverts_look) << "a name alone is on, as on the command line";
    const std::vector<std::pair<std::size_t, std::string>> expected{
        {2, "fov: 'wide', expected 1 to 179 degrees"},
        {4, "'colour' is unknown, expected a name that this version writes; the line is kept"},
        {5, "'[sounds]', expected NAME = VALUE"},
        {7, "'x', expected NAME = VALUE; the line is kept"},
        {8, "mouse-sensitivity: '9', expected 10 to 1000"},
        {9, "'gamma', expected NAME = VALUE"},
        {13, "'volume' is already set in line 6, expected each name once: this line counts"},
        {14, "gamma: '-1', expected 0.5 to 2"},
        {15, "gamma: '1e1', expected 0.5 to 2"},
        {16, "'fov 100', expected NAME = VALUE; the line is kept"}};
    ASSERT_EQ(read.faults.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(read.faults[i].line, expected[i].first);
        EXPECT_EQ(read.faults[i].what, expected[i].second);
    }
}

TEST(OptionsText, TakesAByteOrderMarkAndLineEndsOfOldMacs) {
    for (const std::string text : {"\xef\xbb\xbf"
                                   "fov = 100\n",
                                   "# wide\rfov = 100\r"}) {
        const ReadPreferences read = read_preferences(text);
        EXPECT_TRUE(read.faults.empty());
        EXPECT_EQ(read.preferences.field_of_view, read_preferences("fov = 100\n").preferences.field_of_view);
        EXPECT_NE(read.preferences.field_of_view, Preferences{}.field_of_view);
    }
}

TEST(OptionsText, OfManyFaultsTheFirstAreNamed) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += "n" + std::to_string(i) + "=1\n";
    const ReadPreferences read = read_preferences(text);
    ASSERT_EQ(read.faults.size(), 17u);
    EXPECT_EQ(read.faults.back().line, 17u);
    EXPECT_EQ(read.faults.back().what, "this line and 19983 others are wrong too");
}

TEST(OptionsText, RefusesAViewThatCannotBeDrawnAndKeepsTheRest) {
    const ReadPreferences read = read_preferences("mode = 64x48\nvolume = 10\nfov = 179\n");
    ASSERT_EQ(read.faults.size(), 1u);
    EXPECT_EQ(read.faults.front().line, 3u);
    EXPECT_EQ(read.preferences.mode, ScreenMode{});
    EXPECT_EQ(read.preferences.volume_100, 10);
}

TEST(OptionsText, APresetComesBeforeItsDialsWhereverItsLineIs) {
    const ReadPreferences read = read_preferences("dial-perspective = every8\naccuracy = 1991\n");
    Accuracy expected = accuracy_of(Preset::Year1991);
    expected.texturing = Texturing::Every8;
    EXPECT_EQ(read.preferences.accuracy, expected);
}

// What a user wrote by hand stays, byte for byte, but for the one value.
TEST(OptionsText, ChangesOnlyTheValue) {
    Preferences now;
    now.set_light({140});
    const auto brighter = [&](const std::string& text) { return with(text, "brightness", now); };
    EXPECT_EQ(brighter("# mine\n\nunknown = 7\nbrightness=1\nfov = 90\n"),
              "# mine\n\nunknown = 7\nbrightness= 1.4\nfov = 90\n");
    EXPECT_EQ(brighter("  brightness   =   1.25   # dark here\n"), "  brightness   =   1.4   # dark here\n");
    EXPECT_EQ(brighter("brightness = 1#dark\r\n"), "brightness = 1.4 #dark\r\n");
    EXPECT_EQ(brighter("brightness = 1\r\nfov = 80\r\n"), "brightness = 1.4\r\nfov = 80\r\n");
    EXPECT_EQ(brighter("brightness = # none\n"), "brightness = 1.4 # none\n");
    EXPECT_EQ(brighter("brightness = nonsense\n"), "brightness = 1.4\n") << "a broken line is mended";
    EXPECT_EQ(brighter("brightness = 1\n# later:\nbrightness = 2\n"), "brightness = 1\n# later:\nbrightness = 1.4\n")
        << "the later one counts";
    EXPECT_EQ(brighter("brightness"), "brightness = 1.4\n");
    for (const char* text : {"", "# mine\n", "fov = 80"}) {
        const std::string added = brighter(text);
        EXPECT_EQ(added.rfind(text, 0), 0u);
        EXPECT_EQ(read_preferences(added).preferences.light().brightness_100, 140);
    }
}

TEST(OptionsText, EveryValueIsChangedInItsLineAlone) {
    const Preferences changed = test::all_changed();
    const std::string text = write_preferences({});
    for (const Preference& row : all_preferences()) {
        const std::vector<std::string> before = lines_of(text), after = lines_of(with(text, row.name, changed));
        ASSERT_EQ(after.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool is_own = before[i].rfind(row.name + " = ", 0) == 0;
            EXPECT_EQ(after[i], is_own ? row.name + " = " + row.text(changed) : before[i]);
        }
    }
}

// Whichever line is broken: all others are read, and what is written over it is read back.
TEST(OptionsText, ABrokenLineLosesNoOther) {
    const Preferences written = test::all_changed();
    const std::string text = write_preferences(written);
    for (const Preference& broken : all_preferences())
        for (const std::string& damage : {broken.name + " = nonsense", "\x7f" + broken.name, "[" + broken.name + "="}) {
            const std::string line = broken.name + " = " + broken.text(written);
            std::string damaged = text;
            damaged.replace(damaged.find("\n" + line + "\n") + 1, line.size(), damage);
            const ReadPreferences read = read_preferences(damaged);
            ASSERT_EQ(read.faults.size(), 1u) << damage;
            for (const Preference& row : all_preferences()) {
                const bool is_of_preset = broken.name == "accuracy" && row.text(written) == "preset";
                if (row.name == broken.name || is_of_preset) continue;
                EXPECT_EQ(row.shown(read.preferences), row.shown(written)) << row.name << " beside " << damage;
            }
            const std::string mended = with(damaged, broken.name, written);
            EXPECT_EQ(read_preferences(mended).preferences, written) << damage;
        }
}

TEST(OptionsText, RefusesWhatIsNoText) {
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 7919 >> 3);
    EXPECT_THROW(read_preferences(bytes), InputError);
    EXPECT_TRUE(read_preferences("").faults.empty());
}

}  // namespace
}  // namespace oblong
