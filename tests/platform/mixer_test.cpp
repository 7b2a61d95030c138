#include "engine/sound/mixer.h"

#include <gtest/gtest.h>

#include <vector>

namespace oblong {
namespace {

std::vector<std::int16_t> mixed(Mixer& mixer, std::size_t frames) {
    std::vector<std::int16_t> samples(2 * frames);
    mixer.mix(samples);
    return samples;
}

const std::vector<std::int16_t> kFlat(100, 10'000);

TEST(Mixing, IsSilentWithoutVoices) {
    Mixer mixer;
    EXPECT_EQ(mixed(mixer, 1'000), std::vector<std::int16_t>(2'000));
}

// Half of the device's rate: every other sample is half-way between two.
TEST(Mixing, GoesStraightBetweenSamples) {
    Mixer mixer;
    const auto sound = mixer.add_sound(std::vector<std::int16_t>{100, 200, -300, 0}, 22'050);
    const auto voice = mixer.start(sound, false, {256, 128, false});
    const std::vector<std::int16_t> left{100, 150, 200, -50, -300, -150, 0, 0, 0, 0};
    const std::vector<std::int16_t> samples = mixed(mixer, left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        EXPECT_EQ(samples[2 * i], left[i]);
        EXPECT_EQ(samples[2 * i + 1], left[i] / 2);
    }
    EXPECT_FALSE(mixer.is_playing(voice));
}

TEST(Mixing, AddsVoicesUpToTheLimitsOfSamples) {
    Mixer mixer;
    const auto sound = mixer.add_sound(kFlat, 44'100);
    for (const int sum : {10'000, 20'000, 30'000, 32'767}) {
        const auto voice = mixer.start(sound, false, {256, 256, false});
        ASSERT_NE(voice, Mixer::kNoVoice);
        EXPECT_EQ(mixed(mixer, 1).front(), sum);
    }
}

// A voice that is stopped has no step of more than a 50th of a second's fading, and is free after it.
TEST(Mixing, StopsByFading) {
    Mixer mixer;
    const auto voice = mixer.start(mixer.add_sound(kFlat, 44'100), true, {256, 256, false});
    std::int16_t before = mixed(mixer, 2'000).back();
    EXPECT_EQ(before, 10'000);
    mixer.stop(voice);
    EXPECT_TRUE(mixer.is_playing(voice));
    for (const std::int16_t sample : mixed(mixer, 1'000)) {
        EXPECT_LE(before - sample, 12);
        before = sample;
    }
    EXPECT_EQ(before, 0);
    EXPECT_FALSE(mixer.is_playing(voice));
    EXPECT_NE(mixer.start(0, true, {0, 0, false}), voice);
    mixer.adjust(voice, {256, 256, false});
    EXPECT_EQ(mixed(mixer, 1'000).back(), 0) << "what has ended cannot be adjusted";
}

TEST(Mixing, HeldVoicesGoOnWhereTheyWere) {
    Mixer mixer;
    std::vector<std::int16_t> rising(1'000);
    for (std::size_t i = 0; i < rising.size(); ++i) rising[i] = static_cast<std::int16_t>(i);
    const auto sound = mixer.add_sound(rising, 44'100);
    const auto voice = mixer.start(sound, false, {256, 256, false});
    mixed(mixer, 300);
    mixer.hold_voices(true);
    EXPECT_EQ(mixed(mixer, 5'000), std::vector<std::int16_t>(10'000));
    EXPECT_TRUE(mixer.is_playing(voice));
    EXPECT_NE(mixer.start(sound, false, {256, 256, false}), Mixer::kNoVoice);
    EXPECT_EQ(mixed(mixer, 11).back(), 10);  // one that begins later is heard
    mixer.hold_voices(false);
    EXPECT_EQ(mixed(mixer, 1).front(), 300 + 11);
}

TEST(Mixing, ThirtyTwoVoicesAtOnce) {
    Mixer mixer;
    const auto sound = mixer.add_sound(kFlat, 8'000);
    for (int i = 0; i < Mixer::kVoices; ++i) EXPECT_NE(mixer.start(sound, true, {1, 1, false}), Mixer::kNoVoice);
    EXPECT_EQ(mixer.start(sound, true, {1, 1, false}), Mixer::kNoVoice);
}

}  // namespace
}  // namespace oblong
