#include <gtest/gtest.h>

#include <set>

#include "engine/accuracy/accuracy.h"
#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "tests/support/folders.h"
#include "tests/support/patterns.h"

namespace oblong::test {
namespace {

Accuracy with(const std::string& text) {
    Accuracy accuracy;
    parse_dial(text, accuracy);
    return accuracy;
}

TEST(Dials, EachSettingIsReadBackByItsNameAndChangesOneDialOnly) {
    for (const Dial& dial : all_dials())
        for (const DialSetting& setting : dial.settings) {
            const Accuracy accuracy = with(std::string(dial.name) + "=" + std::string(setting.name));
            EXPECT_EQ(dial.get(accuracy), setting.value) << dial.name;
            EXPECT_EQ(value_text(dial, setting.value), setting.name);
            Accuracy rest = accuracy;
            dial.set(rest, dial.get(Accuracy{}));
            EXPECT_EQ(rest, Accuracy{}) << dial.name;
        }
}

TEST(Dials, NamesDiffer) {
    std::set<std::string_view> names;
    for (const Dial& dial : all_dials()) {
        EXPECT_TRUE(names.insert(dial.name).second) << dial.name;
        EXPECT_EQ(dial_named(dial.name), &dial);
        EXPECT_LE(dial.caption.size(), 20u) << dial.name;
        std::set<std::string_view> settings;
        for (const DialSetting& setting : dial.settings) EXPECT_TRUE(settings.insert(setting.name).second) << dial.name;
    }
    EXPECT_EQ(dial_named("focus"), nullptr);
}

/// `dial<&Accuracy::MEMBER>("NAME"` in the table of dials, and `accuracy.MEMBER` or `accuracy().MEMBER` in the file
/// that the dial names.
TEST(Dials, AreReadInTheFileThatTheyName) {
    const std::string table = read_text(source_folder() + "/engine/accuracy/accuracy.cpp");
    const std::vector<Groups> entries = all_matches(table, "dial<&Accuracy::(\\w+)>\\(\\s*\"([^\"]+)\"");
    for (const Groups& entry : entries) {
        const Dial* const dial = dial_named(entry[2]);
        ASSERT_NE(dial, nullptr) << entry[2];
        const std::string text = read_text(source_folder() + "/" + std::string(dial->read_in));
        EXPECT_TRUE(is_found(text, "accuracy(\\(\\))?\\." + entry[1] + "\\b")) << dial->name << " in " << dial->read_in;
    }
    EXPECT_EQ(entries.size(), all_dials().size());
}

TEST(Dials, TurnStopsAtBothEndsAndPassesEverySetting) {
    for (const Dial& dial : all_dials()) {
        Accuracy accuracy;
        turn(dial, -100, accuracy);
        for (const DialSetting& setting : dial.settings) {
            EXPECT_EQ(dial.get(accuracy), setting.value) << dial.name;
            turn(dial, 1, accuracy);
        }
        EXPECT_EQ(dial.get(accuracy), dial.settings.back().value) << dial.name;
    }
}

TEST(Dials, NumbersBetweenTheSettingsAreTakenToo) {
    EXPECT_EQ(with("pixel-bound=0.5").pixel_bound_256, 128);
    EXPECT_EQ(with("pixel-bound=16").pixel_bound_256, 4096);
    EXPECT_EQ(with("view-bits=7").view_bits, 7);
    EXPECT_EQ(with("mip-bias=-3").mip_bias, -3);
    EXPECT_EQ(value_text(*dial_named("pixel-bound"), 1), "0.00390625");
    EXPECT_EQ(value_text(*dial_named("mip-bias"), -3), "-3");
}

TEST(Dials, WhatIsNoSettingIsRefused) {
    Accuracy accuracy;
    for (const char* text : {"", "=", "perspective", "perspective=", "perspective=every7", "focus=1", "subpixel-bits=9",
                             "subpixel-bits=-1", "shades=48", "shades=0", "pixel-bound=0", "pixel-bound=17",
                             "view-bits=1e1", "dither=yes", "mip-bias=4", " edges=exact"})
        EXPECT_THROW(parse_dial(text, accuracy), UsageError) << text;
    EXPECT_EQ(accuracy, Accuracy{});
}

TEST(Presets, AreReadBackByTheirNames) {
    for (const Preset preset : kPresets) EXPECT_EQ(preset_named(name_of(preset)), preset);
    EXPECT_EQ(accuracy_of(Preset::Bounded), Accuracy{});
    EXPECT_EQ(parse_accuracy(Preset::Year1991, {"subpixel-bits=4", "subpixel-bits=2"}).subpixel_bits, 2);
}

}  // namespace
}  // namespace oblong::test
