#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/sound/sound_file.h"
#include "game/sound/sound_table.h"
#include "tests/support/folders.h"

namespace oblong::test::waves_test {
namespace {

constexpr double kRate_hz = 22'050;

using Wave = std::vector<std::int16_t>;

/// The committed sounds, by their files' names.
const std::map<std::string, Wave>& waves() {
    static const std::map<std::string, Wave> read = [] {
        std::map<std::string, Wave> by_name;
        for (const auto& file : std::filesystem::directory_iterator(test::source_folder() + "/assets/sounds")) {
            const SoundSamples sound = read_parsed(file.path().string(), decode_flac);
            EXPECT_EQ(sound.rate_hz, kRate_hz) << file.path();
            by_name[file.path().stem().string()] = sound.samples;
        }
        return by_name;
    }();
    return read;
}

int step_at(const Wave& wave, std::size_t i) {
    return std::abs(wave[i] - wave[(i + wave.size() - 1) % wave.size()]);
}

std::vector<std::string> files_of(Sound sound) {
    std::vector<std::string> names;
    for (int variant = 0; variant < row_of(sound).variants; ++variant)
        names.push_back(std::filesystem::path(file_of(sound, variant)).stem().string());
    return names;
}

TEST(Waves, AreThoseThatTheGameAsksForAndNoOthers) {
    std::set<std::string> wanted, there;
    for (std::size_t i = 0; i < kSoundCount; ++i)
        for (const std::string& name : files_of(static_cast<Sound>(i))) wanted.insert(name);
    for (const Entity& entity : read_bsp(read_file(test::source_folder() + "/assets/demo.bsp")).entities)
        if (const std::string own = entity.value("noise"); !own.empty())
            wanted.insert(std::filesystem::path(own).stem().string());
    for (const auto& [name, wave] : waves()) there.insert(name);
    EXPECT_EQ(there, wanted);
}

TEST(Waves, LastAsLongAsTheTableSays) {
    for (std::size_t i = 0; i < kSoundCount; ++i) {
        const SoundRow& row = row_of(static_cast<Sound>(i));
        if (row.variants == 0) continue;
        double longest = 0;
        for (const std::string& name : files_of(static_cast<Sound>(i)))
            longest = std::max(longest, static_cast<double>(waves().at(name).size()) / kRate_hz);
        if (row.is_loop()) {
            EXPECT_GE(longest, 2) << row.file;
        } else {
            EXPECT_LE(longest, row.length_ticks / 35.0) << row.file;
            EXPECT_GT(longest, (row.length_ticks - 2) / 35.0) << row.file;
        }
    }
}

TEST(Waves, AreNeitherClippedNorFaintNorOffTheMiddle) {
    for (const auto& [name, wave] : waves()) {
        int peak = 0;
        double sum = 0;
        for (const std::int16_t sample : wave) peak = std::max(peak, std::abs(sample)), sum += sample;
        EXPECT_LT(peak, 0.86 * 32'767) << name;
        EXPECT_GT(peak, 0.39 * 32'767) << name;
        EXPECT_LT(std::abs(sum / static_cast<double>(wave.size())), 0.001 * 32'767) << name;
    }
}

TEST(Waves, OfOneShotsBeginAndEndInSilence) {
    for (std::size_t i = 0; i < kSoundCount; ++i) {
        if (row_of(static_cast<Sound>(i)).is_loop()) continue;
        for (const std::string& name : files_of(static_cast<Sound>(i))) {
            const Wave& wave = waves().at(name);
            EXPECT_EQ(wave.front(), 0) << name;
            for (std::size_t n = 1; n <= 8; ++n) EXPECT_LE(std::abs(wave[wave.size() - n]), 100) << name;
        }
    }
}

// A seam that clicks is a step larger than any other for a while around it.
TEST(Waves, OfLoopsHaveNoSeam) {
    int loops = 0;
    for (std::size_t i = 0; i < kSoundCount; ++i) {
        if (!row_of(static_cast<Sound>(i)).is_loop()) continue;
        ++loops;
        const Wave& wave = waves().at(files_of(static_cast<Sound>(i)).front());
        int usual = 0;
        for (std::size_t n = 1; n < 400; ++n)
            usual = std::max({usual, step_at(wave, n), step_at(wave, wave.size() - n)});
        EXPECT_LE(step_at(wave, 0), usual + 40) << row_of(static_cast<Sound>(i)).file;
    }
    EXPECT_EQ(loops, 16);
}

}  // namespace
}  // namespace oblong::test::waves_test
