#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "engine/io/files.h"
#include "engine/library/oblong.h"
#include "engine/library/ogg.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

std::string tone_file() {
    return source_folder() + "/tests/library/tone.ogg";
}

// 441 Hz at 22,050 Hz for a fifth of a second, 12,000 on the left and nothing on the right.
TEST(LibraryOgg, ChannelsBecomeTheirMean) {
    const SoundSamples sound = decode_ogg(read_file(tone_file()));
    EXPECT_EQ(sound.rate_hz, 22'050);
    ASSERT_NEAR(double(sound.samples.size()), 4410, 64);
    double sine = 0, cosine = 0, energy = 0;
    for (std::size_t i = 1000; i < 4000; ++i) {
        const double turn = double(i) * 2 * 3.14159265358979 / 50;
        sine += sound.samples[i] * std::sin(turn) / 1500;
        cosine += sound.samples[i] * std::cos(turn) / 1500;
        energy += sound.samples[i] * double(sound.samples[i]) / 3000;
    }
    EXPECT_NEAR(std::hypot(sine, cosine), 6000, 300);
    EXPECT_NEAR(std::sqrt(energy * 2), 6000, 300) << "and nothing else";
}

TEST(LibraryOgg, DamagedFilesAreRefused) {
    const std::vector<std::uint8_t> file = read_file(tone_file());
    EXPECT_THROW(decode_ogg(std::span(file).first(200)), InputError);
    EXPECT_FALSE(is_ogg(std::span(file).subspan(1)));
    const TemporaryFolder folder;
    EXPECT_THROW(Speaker().load(folder.write("short.ogg", std::vector(file.begin(), file.begin() + 60))),
                 std::runtime_error);
}

// SDL's driver for tests plays to nobody, at the usual speed.
TEST(LibrarySpeaker, WhatPlaysInALoopPlaysUntilItIsStopped) {
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    Speaker opened, speaker = std::move(opened);
    ASSERT_EQ(speaker.problem(), "");
    const std::int32_t tone = speaker.load(tone_file());
    const std::int64_t once = speaker.play(tone), loop = speaker.play(tone, 256, 0, true);
    const auto plays_for_ms = [&](std::int64_t playing, int most_ms) {
        int waited_ms = 0;
        for (; waited_ms < most_ms && speaker.is_playing(playing); waited_ms += 10)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return waited_ms;
    };
    EXPECT_LT(plays_for_ms(once, 5000), 5000);
    EXPECT_EQ(plays_for_ms(loop, 300), 300);
    speaker.set_volume(loop, 20, 256);
    speaker.set_music_volume(3);
    speaker.stop(loop);
    EXPECT_LT(plays_for_ms(loop, 5000), 5000);
    EXPECT_FALSE(speaker.is_playing(-1));
    unsetenv("SDL_AUDIODRIVER");
}

}  // namespace
}  // namespace oblong::test
