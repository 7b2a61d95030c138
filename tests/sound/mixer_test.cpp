#include "engine/sound/mixer.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "engine/io/files.h"
#include "engine/platform/sdl/sdl.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kSineRate_hz = 22'050;

std::vector<std::int16_t> sine(double hz, double seconds) {
    std::vector<std::int16_t> wave;
    for (int i = 0; i < seconds * kSineRate_hz; ++i)
        wave.push_back(static_cast<std::int16_t>(16'000 * std::sin(2 * M_PI * hz * i / kSineRate_hz)));
    return wave;
}

/// What SDL's driver "disk" writes instead of playing it: 16-bit samples, left and right by turns.
class DiskAudio {
  public:
    DiskAudio() {
        setenv("SDL_AUDIODRIVER", "disk", 1);
        setenv("SDL_DISKAUDIOFILE", file_.c_str(), 1);
        setenv("SDL_DISKAUDIODELAY", "1", 1);
    }

    /// Until a tenth of a second has been written, five minutes at most.
    void wait_for_sound() const {
        const std::uintmax_t least_bytes = kSineRate_hz / 10 * 2 * sizeof(std::int16_t);
        for (int i = 0; i < 300'000 && (!fs::exists(file_) || fs::file_size(file_) < least_bytes); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

    struct Sides {
        double left = 0, right = 0;
    };
    /// The root mean squares of both sides, without the silence before and after, whose length is chance.
    Sides loudness() const {
        const std::vector<std::uint8_t> bytes = read_file(file_);
        double sums[2] = {};
        std::size_t first = bytes.size(), end = 0;
        for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
            const double sample = static_cast<std::int16_t>(bytes[i] | bytes[i + 1] << 8);
            sums[i / 2 % 2] += sample * sample;
            if (sample == 0) continue;
            first = std::min(first, i);
            end = i + 2;
        }
        const double count = end > first ? static_cast<double>(end - first) / 4 : 1;
        return {std::sqrt(sums[0] / count), std::sqrt(sums[1] / count)};
    }

  private:
    const test::TemporaryFolder folder_;
    const std::string file_ = folder_.path("played");
};

void wait_until_silent(const SoundOutput& output, SoundOutput::VoiceNumber voice) {
    for (int i = 0; i < 300'000 && output.is_playing(voice); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(output.is_playing(voice));
}

DiskAudio::Sides played(double hz, const VoiceLevels& levels) {
    DiskAudio disk;
    {
        const auto output = open_mixer();
        const auto sound = output->add_sound(sine(hz, 0.4), kSineRate_hz);
        wait_until_silent(*output, output->start(sound, false, levels));
    }
    return disk.loudness();
}

TEST(Mixer, PlaysEachSideAsLoudAsItIsTold) {
    const DiskAudio::Sides left = played(440, {256, 0, false}), right = played(440, {64, 256, false});
    EXPECT_GT(left.left, 3'000);
    EXPECT_EQ(left.right, 0);
    EXPECT_NEAR(right.right / right.left, 4, 0.1);
}

TEST(Mixer, MufflesHighToneMoreThanLowOnes) {
    const double low = played(200, {256, 256, true}).left / played(200, {256, 256, false}).left;
    const double high = played(4'000, {256, 256, true}).left / played(4'000, {256, 256, false}).left;
    EXPECT_GT(low, 0.7);
    EXPECT_LT(high, 0.06);
}

TEST(Mixer, PlaysTheTitlesMusic) {
    DiskAudio disk;
    {
        const auto output = open_mixer();
        output->play_music(read_file(test::source_folder() + "/assets/music/title.mod"), 256);
        std::this_thread::sleep_for(std::chrono::milliseconds(150));
        disk.wait_for_sound();
    }
    const DiskAudio::Sides sides = disk.loudness();
    EXPECT_GT(sides.left, 200);
    EXPECT_GT(sides.right, 200);
}

TEST(Mixer, IsSilentOnceTheMusicIsStopped) {
    Mixer mixer;
    std::vector<std::int16_t> samples(8'820);
    const auto loudest = [&] {
        mixer.mix(samples);
        return *std::max_element(samples.begin(), samples.end());
    };
    mixer.play_music(read_file(test::source_folder() + "/assets/music/title.mod"), 256);
    EXPECT_GT(loudest(), 200);
    mixer.stop_music();
    EXPECT_EQ(loudest(), 0);
}

TEST(Mixer, SaysWhereThereIsNoDevice) {
    setenv("SDL_AUDIODRIVER", "nonsense", 1);
    EXPECT_TRUE(test::refusal<std::runtime_error>(open_mixer).starts_with("no sound: "));
}

TEST(VoiceFilter, GoesToItsLevelsWithoutAStep) {
    VoiceFilter filter;
    filter.begin({0, 0, false}, false);
    filter.set({256, 0, false});
    std::vector<std::int16_t> samples(2 * 2'000, 10'000);
    filter.apply(samples);
    EXPECT_LT(samples[0], 20);
    for (std::size_t i = 2; i < samples.size(); i += 2) EXPECT_LE(std::abs(samples[i] - samples[i - 2]), 12);
    EXPECT_EQ(samples[samples.size() - 2], 10'000);
    EXPECT_EQ(samples.back(), 0);
}

TEST(VoiceFilter, ChangesBothSidesAlike) {
    VoiceFilter filter;
    filter.begin({256, 256, false}, false);
    filter.set({256, 256, true});
    std::vector<std::int16_t> samples(2 * 2'000);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<std::int16_t>(i / 2 % 7 * 5'000);
    filter.apply(samples);
    for (std::size_t i = 0; i < samples.size(); i += 2) ASSERT_EQ(samples[i], samples[i + 1]) << i;
    EXPECT_NE(samples[0], samples[2]);
}

TEST(VoiceFilter, LeavesFullLevelsAsTheyAre) {
    VoiceFilter filter;
    filter.begin({256, 256, false}, false);
    std::vector<std::int16_t> samples{1, -2, 32'767, -32'768, 300, -300}, copy = samples;
    filter.apply(samples);
    EXPECT_EQ(samples, copy);
}

}  // namespace
}  // namespace oblong
