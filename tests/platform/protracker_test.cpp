#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/sound/module_player.h"
#include "tests/platform/module_file.h"

// What ProTracker's own player does beyond the plain meaning of notes and effects, by its source (PT2.3D's replayer)
// and by recordings of it in OpenMPT's public test modules; libxmp and OpenMPT do the same.
namespace oblong {
namespace {

using test::heard;
using test::kRowFrames;
using test::kTickFrames;
using test::ModuleFile;
using test::rises;

/// The value of the first channel's sample that is heard at the end of so many frames from now.
int value_after(ModulePlayer& player, std::int32_t frames) {
    return heard(player, frames).back() * 4 / 3 / 128;
}

double rate_hz(double period, int length = 8) {
    return 3'546'895 / period / length;
}

/// Which rows are begun, one after the other.
std::vector<std::size_t> rows_of(const ModuleFile& file, int ticks) {
    ModulePlayer player(parse_module(file.bytes()));
    std::vector<std::size_t> rows;
    for (int i = 0; i < ticks; ++i) {
        if (rows.empty() || rows.back() != player.place().row) rows.push_back(player.place().row);
        heard(player, kTickFrames);
    }
    return rows;
}

// The rest of a row's times is played where it leads, and what is there is not heard.
TEST(ProTracker, ARowThatIsHeldAndLeftIsHeldWhereItLeads) {
    const std::vector<int> low(64, 20), high(64, 40);
    ModuleFile file({0, 1}, 2);
    file.sample(low, 0, 0, 64).sample(high, 0, 0, 64).note(0, 0, 0, 1, 428, 0xee1).note(0, 0, 1, 0, 0, 0xd05);
    file.note(1, 5, 0, 2, 428);
    ModulePlayer player(parse_module(file.bytes()));
    for (const std::size_t row : {0u, 5u, 6u}) {
        EXPECT_EQ(player.place().row, row);
        EXPECT_EQ(value_after(player, kRowFrames), 20) << row;
    }
    ModuleFile at_once;
    at_once.note(0, 0, 0, 0, 0, 0xee1).note(0, 0, 2, 0, 0, 0xb00).note(0, 1, 0, 0, 0, 0xd00);
    EXPECT_EQ(rows_of(at_once, 6 * 7), (std::vector<std::size_t>{0, 1, 0, 1, 0}));
}

// Fine slides, cuts and repeated notes come with each time of a row that is held.
TEST(ProTracker, FineSlidesCountEachTimeThatARowIsHeld) {
    ModuleFile file;
    file.sample(std::vector<int>(64, 64), 0, 0, 64).note(0, 0, 0, 1, 428, 0xc20).note(0, 1, 0, 0, 0, 0xeb4);
    file.note(0, 1, 1, 0, 0, 0xee2);
    ModulePlayer player(parse_module(file.bytes()));
    for (const int volume_64 : {32, 28, 24, 20, 20}) EXPECT_EQ(value_after(player, kRowFrames), volume_64);
}

TEST(ProTracker, ASampleWithoutANoteIsPlayedFromTheEndOfTheLoop) {
    const std::vector<int> low(400, 20), high(64, 40);
    for (const bool has_slide : {false, true}) {
        ModuleFile file;
        file.sample(low, 0, 0, 400).sample(high, 0, 0, 64).sample(high).note(0, 0, 0, 1, 856);
        file.note(0, 1, 0, 2, has_slide ? 856 : 0, has_slide ? 0x300 : 0).note(0, 2, 0, 3, 0);
        ModulePlayer player(parse_module(file.bytes()));
        const auto loop_frames =
            static_cast<std::int32_t>(400 * 44'100 * (856 / 3'546'895.0));  // 4,257 of a row's 5,292
        EXPECT_EQ(value_after(player, kRowFrames), 20);
        EXPECT_EQ(value_after(player, 2 * loop_frames - kRowFrames - 50), 20);
        EXPECT_EQ(value_after(player, 100), 40);
        EXPECT_EQ(value_after(player, 2 * kRowFrames), 0);  // the third has no loop
    }
}

TEST(ProTracker, ASampleWithoutANoteBeginsWhereNothingIsPlayed) {
    ModuleFile file;
    file.sample(std::vector<int>(64, 20)).sample(std::vector<int>(64, 40), 0, 0, 64).note(0, 0, 0, 1, 428);
    file.note(0, 1, 0, 2, 0);
    ModulePlayer player(parse_module(file.bytes()));
    EXPECT_EQ(value_after(player, kRowFrames), 0);
    EXPECT_EQ(value_after(player, kRowFrames), 40);
}

TEST(ProTracker, ALoopFromTheBeginningIsPlayedAfterAllOfTheSample) {
    std::vector<int> values(400, 20);
    std::fill(values.begin() + 64, values.end(), 40);
    for (const std::uint8_t restart : std::to_array<std::uint8_t>({0, 127})) {  // 127: other trackers'
        std::vector<std::uint8_t> bytes = ModuleFile().sample(values, 0, 0, 64).note(0, 0, 0, 1, 428).bytes();
        bytes[951] = restart;
        ModulePlayer player(parse_module(bytes));
        EXPECT_EQ(value_after(player, 1'000), restart == 0 ? 40 : 20);
        EXPECT_EQ(value_after(player, 2'000), 20);
    }
}

// For notes that follow without a sample.
TEST(ProTracker, AnOffsetCountsOnceMoreForTheNotesThatFollow) {
    std::vector<int> values(1'024, 20);
    std::fill(values.begin() + 256, values.begin() + 512, 40);
    std::fill(values.begin() + 512, values.begin() + 768, 60);
    for (const bool is_protrackers : {true, false}) {
        ModuleFile file;
        file.sample(values).note(0, 0, 0, 1, 856, 0x901).note(0, 1, 0, 0, 856).note(0, 2, 0, 1, 856);
        if (!is_protrackers) file.note(0, 63, 3, 0, 1'712);
        ModulePlayer player(parse_module(file.bytes()));
        EXPECT_EQ(value_after(player, 1'000), 40);
        heard(player, kRowFrames - 1'000);
        EXPECT_EQ(value_after(player, 1'000), is_protrackers ? 60 : 40);
        heard(player, kRowFrames - 1'000);
        EXPECT_EQ(value_after(player, 1'000), 20);
    }
}

TEST(ProTracker, SlidesEndAtItsNotesButWhereOthersAreUsed) {
    for (const auto& [effect, own, others] : {std::tuple{0x1ff, 113, 14}, {0x2ff, 856, 3'424}}) {
        for (const bool is_protrackers : {true, false}) {
            ModuleFile file;
            file.sample(test::square(8), 0, 0, 8);
            for (std::size_t row = 0; row < 4; ++row)
                file.note(0, row, 0, row == 0 ? 1 : 0, row == 0 ? 428 : 0, effect);
            if (!is_protrackers) file.note(0, 63, 3, 0, 1'712);
            ModulePlayer player(parse_module(file.bytes()));
            heard(player, 4 * kRowFrames);
            const double hz = rate_hz(is_protrackers ? own : others);
            if (hz < 44'100 / 4) {
                EXPECT_NEAR(rises(heard(player, 5 * kRowFrames)), hz * 0.6, 2) << effect << ' ' << is_protrackers;
            }
        }
    }
}

// ProTracker's table has 36 notes, a 0, which the sound chip takes for 65,536, and then the next finetune's.
TEST(ProTracker, ArpeggiosBeyondTheHighestNoteBeginAgainAtTheLowest) {
    for (const auto& [semitones, hz] :
         {std::pair{1, rate_hz(65'536)}, {2, rate_hz(850)}, {3, rate_hz(802)}, {15, rate_hz(401)}}) {
        ModuleFile file;
        file.sample(test::square(8), 0, 0, 8).note(0, 0, 0, 1, 113, semitones << 4).note(0, 0, 1, 0, 0, 0xf20);
        ModulePlayer player(parse_module(file.bytes()));
        const int frames = 44'100 * 5 / 2 / 32;  // of a tick at 32 beats a minute
        heard(player, frames);
        EXPECT_NEAR(rises(heard(player, frames)), hz * frames / 44'100, 1.5) << semitones;
    }
}

// E31: a slide to a note is heard in semitones.
TEST(ProTracker, SlidesToNotesAreHeardInSemitonesIfAsked) {
    ModuleFile file;
    file.sample(test::square(8), 0, 0, 8).note(0, 0, 0, 1, 428, 0xe31).note(0, 1, 0, 0, 214, 0x302);
    ModulePlayer player(parse_module(file.bytes()));
    heard(player, kRowFrames + kTickFrames);
    for (const int period : {404, 404, 404, 404, 404})  // 426, 424, ..., 418: all above C#-2's 404
        EXPECT_NEAR(rises(heard(player, kTickFrames)), rate_hz(period) * 0.02, 1);
}

// A note's finetune is that of its beginning: E5 and a sample's number alone do not change what is heard.
TEST(ProTracker, AFinetuneIsOfTheNotesThatFollow) {
    ModuleFile file;
    file.sample(test::square(8), 0, 0, 8).note(0, 0, 0, 1, 428).note(0, 1, 0, 0, 0, 0xe57).note(0, 2, 0, 0, 428);
    ModulePlayer player(parse_module(file.bytes()));
    for (const double period : {428.0, 428.0, 407.0})
        EXPECT_NEAR(rises(heard(player, kRowFrames)), rate_hz(period) * 0.12, 1) << period;
}

// It never begins, but the next row without a note takes its pitch.
TEST(ProTracker, ADelayBeyondItsRowIsHeardAsAPitch) {
    ModuleFile file;
    file.sample(test::square(8), 0, 0, 8).note(0, 0, 0, 1, 428).note(0, 1, 0, 1, 214, 0xedf);
    ModulePlayer player(parse_module(file.bytes()));
    for (const double period : {428.0, 428.0, 214.0})
        EXPECT_NEAR(rises(heard(player, kRowFrames)), rate_hz(period) * 0.12, 1) << period;
}

// The second waveform of a vibrato: the period rises in a ramp, and falls back at once.
TEST(ProTracker, ARampOfAVibratoIsOneOfPeriods) {
    ModuleFile file;
    file.sample(test::square(8), 0, 0, 8).note(0, 0, 0, 1, 428, 0xe41).note(0, 1, 0, 0, 0, 0x48f);
    ModulePlayer player(parse_module(file.bytes()));
    heard(player, kRowFrames + kTickFrames);
    // Phases 0, 8, 16, 24, 32 of 64: (0, 64, 128, 192, -255) * 15 / 128.
    for (const int more : {0, 7, 15, 22, -29})
        EXPECT_NEAR(rises(heard(player, kTickFrames)), rate_hz(428 + more) * 0.02, 1) << more;
}

}  // namespace
}  // namespace oblong
