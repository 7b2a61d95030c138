#include "game/messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace oblong {
namespace {

using Lines = std::vector<std::string>;
constexpr std::uint64_t kSecond_us = 1'000'000;

TEST(Messages, StayAsLongAsTheyTakeToRead) {
    Messages messages;
    messages.show("A", MessageKind::Level);
    EXPECT_EQ(messages.lines(0, 50, 5), Lines{"A"});
    EXPECT_EQ(messages.lines(2'400'000, 50, 5), Lines{"A"});
    EXPECT_EQ(messages.lines(2'500'000, 50, 5), Lines{});
    const std::string hundred(100, 'b');
    messages.show(hundred, MessageKind::Level);
    EXPECT_EQ(messages.lines(3 * kSecond_us, 200, 5), Lines{hundred});
    EXPECT_EQ(messages.lines(8'900'000, 200, 5), Lines{hundred});
    EXPECT_EQ(messages.lines(9'000'000, 200, 5), Lines{});
}

TEST(Messages, TwoThatComeTogetherAreBothShown) {
    Messages messages;
    messages.show("one", MessageKind::Level);
    messages.show("two", MessageKind::Level);
    EXPECT_EQ(messages.lines(0, 50, 5), (Lines{"one", "two"}));
}

TEST(Messages, WhatHasNoRoomWaitsAndLosesNoTime) {
    Messages messages;
    messages.show("one", MessageKind::Level);
    messages.show("two", MessageKind::Level);
    EXPECT_EQ(messages.lines(0, 50, 1), Lines{"one"});
    EXPECT_EQ(messages.lines(2'500'000, 50, 1), Lines{"two"});
    EXPECT_EQ(messages.lines(4'900'000, 50, 1), Lines{"two"});
    EXPECT_EQ(messages.lines(4'950'000, 50, 0), Lines{});  // no room now: a panel, say
    EXPECT_EQ(messages.lines(90 * kSecond_us, 50, 1), Lines{"two"});
}

TEST(Messages, AnAnswerTakesThePlaceOfTheLastOne) {
    Messages messages;
    messages.show("level", MessageKind::Level);
    messages.show("1994", MessageKind::Answer);
    messages.lines(0, 50, 5);
    messages.show("1996", MessageKind::Answer);
    EXPECT_EQ(messages.lines(1, 50, 5), (Lines{"level", "1996"}));
    messages.show("level", MessageKind::Level);  // the same again: it stays longer, once
    EXPECT_EQ(messages.lines(2, 50, 5), (Lines{"level", "1996"}));
}

TEST(Messages, ALongOneIsShownInParts) {
    Messages messages;
    messages.show("one two three four five", MessageKind::Level);
    EXPECT_EQ(messages.lines(0, 7, 2), (Lines{"one two", "three"}));
    EXPECT_EQ(messages.lines(2'500'000, 7, 2), (Lines{"four", "five"}));
    EXPECT_EQ(messages.lines(5'000'000, 7, 2), Lines{});
}

// Whatever comes when, and whatever the room: each word of a level's messages is up for its reading time at least.
TEST(Messages, NoneIsLost) {
    std::mt19937 random(3);
    for (int run = 0; run < 50; ++run) {
        Messages messages;
        std::map<std::string, int> up_ms;  // by the words, each of which is another
        std::vector<std::string> words;
        const std::int32_t columns = 8 + static_cast<std::int32_t>(random() % 40);
        const std::size_t most_lines = 1 + random() % 4;
        for (int ms = 0; ms < 200'000; ms += 100) {
            if (ms < 20'000 && random() % 40 == 0) {
                std::string text;
                for (unsigned i = random() % 12 + 1; i > 0; --i) {
                    words.push_back("w" + std::to_string(words.size()));
                    text += (text.empty() ? "" : " ") + words.back();
                }
                messages.show(text, MessageKind::Level);
            }
            const Lines lines = messages.lines(static_cast<std::uint64_t>(ms) * 1000, columns, most_lines);
            ASSERT_LE(lines.size(), most_lines);
            for (const std::string& line : lines) {
                ASSERT_LE(line.size(), static_cast<std::size_t>(columns));
                for (std::size_t at = 0; at < line.size();
                     at = line.find(' ', at) == line.npos ? line.size() : line.find(' ', at) + 1)
                    up_ms[line.substr(at, line.find(' ', at) - at)] += 100;
            }
        }
        EXPECT_TRUE(messages.is_empty());
        for (const std::string& word : words) EXPECT_GE(up_ms[word], 2400) << word;
    }
}

}  // namespace
}  // namespace oblong
