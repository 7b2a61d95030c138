#include "game/view/hud.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <sstream>

#include "engine/draw/drawing.h"

namespace oblong {
namespace {

std::string random_text(std::mt19937& random, int longest) {
    std::string text(1 + random() % static_cast<unsigned>(longest), 'm');
    for (char& letter : text)
        if (random() % 6 == 0) letter = random() % 8 == 0 ? '\n' : ' ';
    return text;
}

std::vector<std::string> random_texts(std::mt19937& random, unsigned most, int longest) {
    std::vector<std::string> texts(random() % (most + 1));
    for (std::string& text : texts) text = random_text(random, longest);
    return texts;
}

// No two parts share a row, and all are in the canvas.
TEST(Hud, NothingOverlaps) {
    std::mt19937 random(4);
    std::vector<std::uint8_t> pixels(640 * 480);
    CostText cost;
    cost.frame = "99999 us a frame, 999 frames a second, 12 movers";
    cost.passes.resize(8), cost.effects.resize(6);
    for (int i = 0; i < 20'000 && !testing::Test::HasFailure(); ++i) {
        const bool is_small = random() % 2 == 0;
        const Framebuffer canvas{pixels.data(), is_small ? 320 : 640, is_small ? 200 : 480, 640};
        const HudText text{random_texts(random, 3, 60), random_texts(random, 2, 200),
                           random() % 3 == 0 ? &cost : nullptr};
        const TextColours colours{255, 0, 1 + static_cast<std::int32_t>(random() % 2)};
        const bool has_messages = random() % 2 == 0;
        const auto bottom = static_cast<std::int32_t>(random() % 201);
        const HudLayout layout = lay_out_hud(text, has_messages, bottom, colours, canvas);
        std::vector<int> owners(480);
        std::vector<RowRange> parts = layout.notes;
        parts.insert(parts.end(), {layout.captions, layout.cost, layout.messages});
        for (const RowRange& part : parts)
            for (std::int32_t row = part.top; row < part.bottom; ++row) {
                ASSERT_GE(row, 0);
                ASSERT_LT(row, canvas.height_px);
                EXPECT_EQ(++owners[static_cast<std::size_t>(row)], 1) << row << " in run " << i;
            }
    }
}

TEST(Hud, AMessageComesFirstThenCaptionsNotesAndCost) {
    std::vector<std::uint8_t> pixels(320 * 200);
    const Framebuffer canvas{pixels.data(), 320, 200, 320};
    const TextColours colours{255, 0, 1};
    CostText cost;
    cost.frame = "1 us a frame";
    const HudText text{{"[door]"}, {"a wall"}, &cost};
    const HudLayout roomy = lay_out_hud(text, true, 200, colours, canvas);
    EXPECT_EQ(roomy.captions.bottom, 200);
    EXPECT_EQ(roomy.notes[0].bottom, roomy.captions.top);
    EXPECT_EQ(roomy.cost.bottom, roomy.notes[0].top);
    EXPECT_EQ(roomy.messages.bottom, roomy.cost.top);
    const HudLayout narrow = lay_out_hud(text, true, 24, colours, canvas);
    EXPECT_GE(narrow.messages.height(), kLineHeight_px);
    EXPECT_EQ(narrow.captions.height(), kLineHeight_px);
    EXPECT_EQ(narrow.notes[0].height() + narrow.cost.height(), 0);
}

using Lines = std::vector<std::string>;
constexpr std::uint64_t kSecond_us = 1'000'000;

TEST(Messages, StayAsLongAsTheyTakeToRead) {
    Messages messages;
    messages.show("A");
    EXPECT_EQ(messages.lines(0, 50, 5), Lines{"A"});
    EXPECT_EQ(messages.lines(2'400'000, 50, 5), Lines{"A"});
    EXPECT_EQ(messages.lines(2'500'000, 50, 5), Lines{});
    const std::string hundred(100, 'b');
    messages.show(hundred);
    EXPECT_EQ(messages.lines(3 * kSecond_us, 200, 5), Lines{hundred});
    EXPECT_EQ(messages.lines(8'900'000, 200, 5), Lines{hundred});
    EXPECT_EQ(messages.lines(9'000'000, 200, 5), Lines{});
    std::string accented;
    for (int i = 0; i < 50; ++i) accented += "é";
    messages.show(accented);
    EXPECT_EQ(messages.lines(10 * kSecond_us, 200, 5), Lines{accented});
    EXPECT_EQ(messages.lines(12'999'999, 200, 5), Lines{accented});
    EXPECT_EQ(messages.lines(13 * kSecond_us, 200, 5), Lines{}) << "by letters";
}

TEST(Messages, TheNewestAloneIsUp) {
    Messages messages;
    messages.show("one");
    messages.show("two");
    EXPECT_EQ(messages.lines(0, 50, 5), Lines{"two"});
    messages.show("three four");
    EXPECT_EQ(messages.lines(1, 5, 1), Lines{"three"});
    messages.show("five");  // in place of what was still to come, too
    EXPECT_EQ(messages.lines(2, 5, 1), Lines{"five"});
    EXPECT_EQ(messages.lines(2'500'001, 5, 1), Lines{"five"}) << "its time began with it";
    EXPECT_EQ(messages.lines(2'500'002, 5, 1), Lines{});
}

TEST(Messages, WhatHasNoRoomLosesNoTime) {
    Messages messages;
    messages.show("one");
    EXPECT_EQ(messages.lines(0, 50, 1), Lines{"one"});
    EXPECT_EQ(messages.lines(2'400'000, 50, 0), Lines{});  // no room now: a panel, say
    EXPECT_EQ(messages.lines(90 * kSecond_us, 50, 1), Lines{"one"});
    EXPECT_EQ(messages.lines(90 * kSecond_us + 100'000, 50, 1), Lines{});
}

TEST(Messages, AllThatWasToldIsKeptOnceTheNewestFirst) {
    Messages messages;
    for (const char* text : {"one", "two", "one", "three"}) messages.show(text);
    EXPECT_EQ(messages.all(), (Lines{"three", "one", "two"}));
    messages.lines(0, 50, 1);
    messages.lines(90 * kSecond_us, 50, 1);
    EXPECT_EQ(messages.all().size(), 3u) << "also what is no longer up";
    for (int i = 0; i < 1000; ++i) messages.show(std::to_string(i));
    EXPECT_LT(messages.all().size(), 100u);
    EXPECT_EQ(messages.all().front(), "999");
}

TEST(Messages, ALongOneIsShownInParts) {
    Messages messages;
    messages.show("one two three four five six");
    EXPECT_EQ(messages.lines(0, 9, 2), (Lines{"one two", "three ..."}));
    EXPECT_EQ(messages.lines(2'500'000, 9, 2), (Lines{"four five", "six"}));
    EXPECT_EQ(messages.lines(5'000'000, 9, 2), Lines{});
    messages.show("one two three four five six");
    EXPECT_EQ(messages.lines(0, 7, 2), (Lines{"one two", "..."})) << "its last word would leave no room";
    EXPECT_EQ(messages.lines(2'500'000, 7, 2), (Lines{"three", "..."}));
}

// However long it is, and whatever the room: each word of the newest message is up for a part's reading time.
TEST(Messages, NoPartIsLost) {
    std::mt19937 random(3);
    for (int run = 0; run < 50; ++run) {
        Messages messages;
        std::map<std::string, int> up_ms;  // by the words, each of which is another
        const std::int32_t columns = 8 + static_cast<std::int32_t>(random() % 40);
        const std::size_t most_lines = 1 + random() % 4, words = 1 + random() % 60;
        std::string text;
        for (std::size_t i = 0; i < words; ++i) text += (i == 0 ? "w" : " w") + std::to_string(i);
        messages.show(text);
        for (int ms = 0; !messages.is_empty() && ms < 1'000'000; ms += 100)
            for (const std::string& line : messages.lines(static_cast<std::uint64_t>(ms) * 1000, columns, most_lines)) {
                ASSERT_LE(line.size(), static_cast<std::size_t>(columns));
                std::istringstream in(line);
                for (std::string word; in >> word;)
                    if (word != "...") up_ms[word] += 100;
            }
        EXPECT_EQ(up_ms.size(), words);
        for (const auto& [word, time_ms] : up_ms) EXPECT_GE(time_ms, 2400) << word;
    }
}

}  // namespace
}  // namespace oblong
