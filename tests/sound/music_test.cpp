#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/files/files.h"
#include "tests/support/folders.h"

namespace oblong {
namespace {

/// assets/music/title.mod, read by the format's description.
struct TitleModule {
    std::size_t word(std::size_t at) const { return bytes[at] * std::size_t{256} + bytes[at + 1]; }
    std::size_t sample(std::size_t i) const { return 20 + 30 * i; }
    std::size_t patterns() const { return 1 + *std::max_element(bytes.begin() + 952, bytes.begin() + 952 + 128); }
    std::string text(std::size_t at, std::size_t size) const {
        return {bytes.begin() + static_cast<std::ptrdiff_t>(at),
                bytes.begin() + static_cast<std::ptrdiff_t>(at + size)};
    }

    const std::vector<std::uint8_t> bytes = read_file(test::source_folder() + "/assets/music/title.mod");
};

constexpr std::size_t kHeader = 1084, kPattern = 64 * 8 * 4;

TEST(TitleMusic, HasAllPartsOfItsFile) {
    const TitleModule module;
    EXPECT_EQ(module.text(1080, 4), "8CHN");
    EXPECT_EQ(module.text(0, 18), "after closing time");
    std::size_t samples = 0;
    for (std::size_t i = 0; i < 31; ++i) samples += 2 * module.word(module.sample(i) + 22);
    EXPECT_EQ(module.bytes.size(), kHeader + module.patterns() * kPattern + samples);
}

TEST(TitleMusic, LastsAMinuteAndAQuarter) {
    const TitleModule module;
    const double row_s = 6 * 2.5 / 125;  // six ticks, at the 125 beats a minute that a module begins with
    const double length_s = module.bytes[950] * 64 * row_s;
    EXPECT_GT(length_s, 60);
    EXPECT_LT(length_s, 90);
}

TEST(TitleMusic, PlaysNotesThatItHasSamplesFor) {
    const TitleModule module;
    int notes = 0;
    for (std::size_t at = kHeader; at < kHeader + module.patterns() * kPattern; at += 4) {
        const auto* cell = &module.bytes[at];
        const std::size_t period = (cell[0] & 15u) * 256 + cell[1], sample = (cell[0] & 0xf0u) + (cell[2] >> 4);
        const int effect = cell[2] & 15;
        EXPECT_EQ(period == 0, sample == 0);
        EXPECT_TRUE(effect == 0 || effect == 8 || effect == 12) << effect;
        EXPECT_LE(effect == 12 ? cell[3] : 0, 64);
        if (period == 0) continue;
        ++notes;
        EXPECT_GE(period, 113u);
        EXPECT_LE(period, 856u);
        EXPECT_GT(module.word(module.sample(sample - 1) + 22), 0u);
    }
    EXPECT_GT(notes, 300);
}

TEST(TitleMusic, LoopsOfSamplesAreInThem) {
    const TitleModule module;
    int loops = 0;
    for (std::size_t i = 0; i < 31; ++i) {
        const std::size_t at = module.sample(i), length = module.word(at + 22);
        EXPECT_LE(module.bytes[at + 25], 64);
        if (module.word(at + 28) <= 1) continue;
        ++loops;
        EXPECT_LE(module.word(at + 26) + module.word(at + 28), length);
    }
    EXPECT_EQ(loops, 1);
}

}  // namespace
}  // namespace oblong
