#include "engine/scene/light_styles.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/levels.h"

namespace oblong::test {
namespace {

using Patterns = std::array<std::string, kLightStyleCount>;

/// The patterns of a level whose floor has this style.
LightPatterns patterns_of_style(std::uint8_t style, const Patterns& own = {}) {
    Level level = tiny_level();
    level.faces[FaceIndex(0)].styles[0] = style;
    return make_light_patterns(level, own);
}

int brightness_at(const LightPatterns& patterns, std::uint8_t style, std::int64_t time_ms) {
    return light_styles_at(patterns, time_ms, Flashes::Full)[style];
}

/// Times at which a counter of 32 bits would have wrapped, and far later.
constexpr std::int64_t kLateTimes[] = {0, std::int64_t{1} << 32, std::int64_t{1} << 53,
                                       std::numeric_limits<std::int64_t>::max() - 300'000};

std::string random_pattern(std::mt19937& random) {
    std::string letters;
    const std::size_t length = 1 + random() % 60;
    while (letters.size() < length) letters += static_cast<char>('a' + random() % 26);
    return letters;
}

TEST(LightStyles, ALetterIsATwelfthOfTheStoredBrightness) {
    for (char letter = 'a'; letter <= 'z'; ++letter)
        EXPECT_EQ(brightness_of(letter), std::lround((letter - 'a') * 256 / 12.0)) << letter;
    EXPECT_EQ(brightness_of('m'), 256) << "plain light";
}

/// Three of Quake's patterns, and a kilobyte of a level's own.
TEST(LightStyles, ShowALetterForATenthOfASecond) {
    std::mt19937 random(3);
    Patterns own;
    for (int i = 0; i < 1024; ++i) own[40] += static_cast<char>('a' + random() % 26);
    for (const auto& [style, letters] : {std::pair<std::uint8_t, std::string>{4, "ma"},
                                         {2, "abcdefghijklmnopqrstuvwxyzyxwvutsrqponmlkjihgfedcba"},
                                         {9, "aaaaaaaazzzzzzzz"},
                                         {40, own[40]}}) {
        const LightPatterns patterns = patterns_of_style(style, own);
        const std::int64_t count = std::ssize(letters);
        for (const std::int64_t start : kLateTimes)
            for (std::int64_t time = start; time < start + count * 200; time += 33)
                ASSERT_EQ(brightness_at(patterns, style, time), brightness_of(letters[as_size(time / 100 % count)]))
                    << int{style} << " at " << time;
    }
}

TEST(LightStyles, OtherStylesOfThatTimeArePlain) {
    LightStyles styles = light_styles_at(patterns_of_style(4), 100, Flashes::Full);
    styles[4] = kStoredBrightness;
    EXPECT_EQ(styles, plain_light_styles());
}

TEST(LightStyles, OnlyStylesThatALitFaceHasAreCalledFor) {
    EXPECT_TRUE(patterns_of_style(0).entries.empty());
    EXPECT_TRUE(patterns_of_style(12).entries.empty()) << "Quake has no such pattern";
    EXPECT_TRUE(patterns_of_style(32).entries.empty()) << "switchable, and on";
    EXPECT_TRUE(patterns_of_style(255).entries.empty()) << "no style";
    ASSERT_EQ(patterns_of_style(11).entries.size(), 1u);
    EXPECT_TRUE(patterns_of_style(11).has(11));

    Level level = tiny_level();
    Face& face = level.faces[FaceIndex(0)];
    face.styles = {0, 3, 255, 4};
    const LightPatterns patterns = make_light_patterns(level, {});
    EXPECT_TRUE(patterns.has(3));
    EXPECT_FALSE(patterns.has(4)) << "behind the last style";
    EXPECT_TRUE(patterns.is_called_for_by(face));
    face.styles = {0, 255, 3, 255};
    EXPECT_FALSE(patterns.is_called_for_by(face));
    face.styles = {3, 255, 255, 255};
    face.light_offset = -1;
    EXPECT_FALSE(patterns.is_called_for_by(face));
    EXPECT_TRUE(make_light_patterns(level, {}).entries.empty());
}

TEST(LightStyles, ALevelsOwnPatternGoesBeforeQuakes) {
    Patterns own;
    own[32] = "za";
    own[33] = "mmm";
    EXPECT_EQ(brightness_at(patterns_of_style(32, own), 32, 0), 533);
    EXPECT_EQ(brightness_at(patterns_of_style(32, own), 32, 100), 0);
    EXPECT_TRUE(patterns_of_style(33, own).entries.empty()) << "plain light needs no pattern";
}

TEST(LightStyles, PatternsAreSmallLettersUpToALimit) {
    EXPECT_TRUE(is_light_pattern("az"));
    EXPECT_TRUE(is_light_pattern(std::string(1024, 'q')));
    EXPECT_TRUE(is_light_pattern(std::string(65'536, 'q')));
    for (const std::string& pattern : {std::string(65'537, 'q'), std::string(), std::string("A"), std::string("a b"),
                                       std::string("a{"), std::string("\xff")})
        EXPECT_FALSE(is_light_pattern(pattern)) << pattern.substr(0, 5);
}

TEST(LightStyles, WithoutFlashesAStyleHasItsMeanBrightness) {
    std::mt19937 random(4);
    for (int round = 0; round < 50; ++round) {
        Patterns own;
        own[32] = random_pattern(random) + "a";
        double sum = 0;
        for (const char letter : own[32]) sum += brightness_of(letter);
        const LightPatterns patterns = patterns_of_style(32, own);
        for (const std::int64_t time : {std::int64_t{0}, std::int64_t{123'456}, std::int64_t{1} << 40})
            EXPECT_NEAR(light_styles_at(patterns, time, Flashes::Off)[32], sum / static_cast<double>(own[32].size()),
                        0.5001);
    }
}

/// The largest change of a reduced style within a third of a second, over two of its periods.
int most_reduced_change(const StyleSteps& steps) {
    int most = 0;
    const std::int64_t period_ms = std::ssize(steps.full) * 100;
    for (std::int64_t time = 0; time < period_ms; time += 50)
        for (std::int64_t later = time; later <= time + 333; later += 9)
            most = std::max(most, std::abs(steps.at(later, Flashes::Reduced) - steps.at(time, Flashes::Reduced)));
    return most;
}

TEST(LightStyles, ReducedFlashesNeverChangeByMoreThanTheLimit) {
    std::mt19937 random(5);
    for (int style = 1; style < 12; ++style)
        EXPECT_LE(most_reduced_change(make_style_steps(quake_light_pattern(style))), kReducedChange) << style;
    for (int round = 0; round < 200; ++round) {
        const std::string pattern = random_pattern(random);
        EXPECT_LE(most_reduced_change(make_style_steps(pattern)), kReducedChange) << pattern;
    }
    EXPECT_LE(most_reduced_change(make_style_steps(std::string(40, 'a') + std::string(40, 'z'))), kReducedChange);
}

TEST(LightStyles, ReducedFlashesKeepTheMeanAndSlowChanges) {
    const StyleSteps pulse = make_style_steps(quake_light_pattern(2)), strobe = make_style_steps("ma");
    std::set<int> seen;
    double sum = 0;
    for (std::int64_t step = 0; step < 51; ++step) {
        seen.insert(pulse.at(step * 100, Flashes::Reduced));
        sum += pulse.at(step * 100, Flashes::Reduced);
    }
    EXPECT_GT(seen.size(), 20u) << "it still pulses";
    EXPECT_NEAR(sum / 51, pulse.mean, 1);
    for (const std::int64_t time : {0, 100, 200, 300}) EXPECT_EQ(strobe.at(time, Flashes::Reduced), 128);
}

}  // namespace
}  // namespace oblong::test
