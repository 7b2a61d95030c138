#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/input_error.h"
#include "engine/sound/module_player.h"
#include "tests/platform/module_file.h"
#include "tests/support/refusal.h"

namespace oblong {
namespace {

using test::heard;
using test::kRowFrames;
using test::kTickFrames;
using test::ModuleFile;
using test::rises;
using test::square;

// 3,546,895 samples a second through the period, and 2 to the power of so many 96ths for the finetune.
TEST(Module, PitchFollowsPeriodAndFinetune) {
    for (const int period : {113, 214, 428, 856}) {
        for (const int finetune : {-8, 0, 7}) {
            const ModuleFile file = ModuleFile().sample(square(32), finetune, 0, 32).note(0, 0, 0, 1, period);
            ModulePlayer player(parse_module(file.bytes()));
            const double hz = 3'546'895.0 / period / 32 * std::pow(2, finetune / 96.0);
            EXPECT_NEAR(rises(heard(player, 5 * kRowFrames)), hz * 0.6, 1) << period << ' ' << finetune;
        }
    }
}

TEST(Module, ArpeggioTakesTurnsByTicks) {
    const ModuleFile file =
        ModuleFile().sample(square(8), 0, 0, 8).note(0, 0, 1, 0, 0, 0xf20).note(0, 0, 0, 1, 214, 0x047);
    ModulePlayer player(parse_module(file.bytes()));
    const int frames = 44'100 * 5 / 2 / 32;  // of a tick at 32 beats a minute
    const double hz = 3'546'895.0 / 214 / 8;
    for (const int semitones : {0, 4, 7, 0, 4, 7})
        EXPECT_NEAR(rises(heard(player, frames)), hz * std::pow(2, semitones / 12.0) * frames / 44'100, 2) << semitones;
}

TEST(Module, SlidesOfVolumeAndPeriodAreByTicks) {
    const std::vector<int> flat(64, 64);
    ModuleFile file = ModuleFile().sample(flat, 0, 0, 64).note(0, 0, 0, 1, 428, 0xa04).note(0, 1, 0, 0, 0, 0xa30);
    file.note(0, 2, 0, 0, 0, 0xc20).note(0, 3, 0, 0, 0, 0xeb1).note(0, 4, 0, 0, 0, 0xec2);
    ModulePlayer player(parse_module(file.bytes()));
    // 64 of 128, half for each of two channels on a side, three quarters of which are left.
    const auto level = [](int volume_64) { return 64 * 256 * (128 * volume_64 / 64 - 128 * volume_64 / 64 / 4) / 256; };
    for (const auto& row :
         {std::array{64, 60, 56, 52, 48, 44}, std::array{44, 47, 50, 53, 56, 59}, std::array{32, 32, 32, 32, 32, 32},
          std::array{31, 31, 31, 31, 31, 31}, std::array{31, 31, 0, 0, 0, 0}})
        for (const int volume_64 : row) {
            const auto tick = heard(player, kTickFrames);
            EXPECT_EQ(tick.front(), level(volume_64));
            EXPECT_EQ(tick.back(), level(volume_64));
        }
}

TEST(Module, SlideToANoteStopsAtIt) {
    ModuleFile file = ModuleFile().sample(square(8), 0, 0, 8).note(0, 0, 0, 1, 428);
    file.note(0, 1, 0, 0, 214, 0x3ff).note(0, 2, 0, 0, 0, 0x101);
    ModulePlayer player(parse_module(file.bytes()));
    const auto rate = [](double period) { return 3'546'895 / period / 8; };
    EXPECT_NEAR(rises(heard(player, kRowFrames)), rate(428) * 0.12, 1);
    heard(player, kTickFrames);  // the slide begins with the second tick: one step is enough
    EXPECT_NEAR(rises(heard(player, 5 * kTickFrames)), rate(214) * 0.1, 2);
    heard(player, 5 * kTickFrames);
    EXPECT_NEAR(rises(heard(player, kTickFrames)), rate(209) * 0.02, 1);  // five ticks by 1
}

// A sample without a loop ends; one with a loop never does, nor is what is after the loop heard.
TEST(Module, LoopsAreWithinTheirPoints) {
    std::vector<int> values(200, 20);
    std::fill(values.begin() + 100, values.begin() + 150, 40);
    std::fill(values.begin() + 150, values.end(), 60);
    const double frames = 44'100 / (3'546'895.0 / 428);  // a sample
    for (const bool is_loop : {false, true}) {
        ModulePlayer player(parse_module(
            ModuleFile().sample(values, 0, is_loop ? 100 : 0, is_loop ? 50 : 2).note(0, 0, 0, 1, 428).bytes()));
        const auto wave = heard(player, 2 * kRowFrames);
        const auto at = [&](double sample) { return wave[static_cast<std::size_t>(sample * frames)] * 4 / 3 / 128; };
        EXPECT_EQ(at(50), 20);
        EXPECT_EQ(at(120), 40);
        EXPECT_EQ(at(170), is_loop ? 40 : 60);
        EXPECT_EQ(at(202), is_loop ? 40 : 0);
        EXPECT_EQ(at(1'500), is_loop ? 40 : 0);
    }
}

std::vector<std::pair<std::size_t, std::size_t>> places(const ModuleFile& file, int rows) {
    ModulePlayer player(parse_module(file.bytes()));
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (int i = 0; i < rows; ++i) {
        found.emplace_back(player.place().order, player.place().row);
        heard(player, kRowFrames);
    }
    return found;
}

TEST(Module, RowsFollowBreaksJumpsAndLoops) {
    using Places = std::vector<std::pair<std::size_t, std::size_t>>;
    ModuleFile file({0, 1, 0}, 2);
    file.note(0, 1, 0, 0, 0, 0xd16).note(1, 17, 2, 0, 0, 0xb02);  // to row 16, written in decimals; to order 2
    EXPECT_EQ(places(file, 9), (Places{{0, 0}, {0, 1}, {1, 16}, {1, 17}, {2, 0}, {2, 1}, {0, 16}, {0, 17}, {0, 18}}));
    ModuleFile loop;
    loop.note(0, 1, 0, 0, 0, 0xe60).note(0, 2, 0, 0, 0, 0xe62).note(0, 4, 0, 0, 0, 0xee1);
    EXPECT_EQ(places(loop, 11),
              (Places{{0, 0}, {0, 1}, {0, 2}, {0, 1}, {0, 2}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 4}, {0, 5}}));
}

// At 144 beats a minute 24 rows take 2.5 s, although no tick is a whole number of samples.
TEST(Module, BeatsKeepTime) {
    ModulePlayer player(parse_module(ModuleFile().note(0, 0, 0, 0, 0, 0xf90).bytes()));
    heard(player, 44'100 * 5 / 2 - 1);
    EXPECT_EQ(player.place().row, 23u);
    heard(player, 1);
    EXPECT_EQ(player.place().row, 24u);
}

TEST(Module, PannedBetweenTheSides) {
    const std::vector<int> flat(64, 64);
    ModuleFile file({0}, 1, 6);
    file.sample(flat, 0, 0, 64)
        .note(0, 0, 5, 1, 428, 0x840)
        .note(0, 1, 5, 0, 0, 0x880);  // 80 is right, where none is more
    ModulePlayer player(parse_module(file.bytes()));
    const auto row = heard(player, kRowFrames);
    const auto next = heard(player, kRowFrames, 1);
    EXPECT_EQ(row.front(), 64 * 256 / 4);
    EXPECT_EQ(next.front(), 64 * 256 * (128 * 255 / 256) / 256);
}

TEST(Module, ChannelsAreLeftRightRightLeftAndSoOn) {
    for (std::size_t channel = 0; channel < 8; ++channel) {
        ModuleFile file({0}, 1, 8);
        file.sample(std::vector<int>(64, 64), 0, 0, 64).note(0, 0, channel, 1, 428);
        ModulePlayer left(parse_module(file.bytes())), right(parse_module(file.bytes()));
        const bool is_right = channel % 4 == 1 || channel % 4 == 2;
        EXPECT_EQ(heard(left, 9).front() < heard(right, 9, 1).front(), is_right) << channel;
    }
}

TEST(Module, BeginsAgainWhereItSaysIfThatIsAmongItsOrders) {
    for (const auto& [said, begins] : {std::pair{0, 0u}, {1, 1u}, {2, 2u}, {3, 0u}, {127, 0u}}) {
        ModuleFile file({0, 0, 0});
        for (std::size_t channel = 0; channel < 2; ++channel) file.note(0, 0, channel, 0, 0, 0xd00);
        std::vector<std::uint8_t> bytes = file.bytes();
        bytes[951] = static_cast<std::uint8_t>(said);
        ModulePlayer player(parse_module(bytes));
        heard(player, 3 * kRowFrames);
        EXPECT_EQ(player.place().order, begins) << said;
    }
}

// Whatever the size of the pieces that are asked for.
TEST(Module, SaysTheSameInPieces) {
    const ModuleFile file =
        ModuleFile().sample(square(30), 3, 4, 20).note(0, 0, 0, 1, 300, 0x48f).note(0, 3, 2, 1, 200);
    ModulePlayer whole(parse_module(file.bytes())), pieces(parse_module(file.bytes()));
    std::vector<std::int32_t> expected(2 * 30'000), joined;
    whole.add(expected, 200);
    for (std::size_t frames = 1; joined.size() < expected.size(); frames = frames * 3 % 1'009) {
        std::vector<std::int32_t> piece(std::min(2 * frames, expected.size() - joined.size()));
        pieces.add(piece, 200);
        joined.insert(joined.end(), piece.begin(), piece.end());
    }
    EXPECT_EQ(joined, expected);
}

/// The first note of each channel in the first row, by its period, and the first sample's values.
struct ModuleStart {
    std::vector<int> periods;
    std::vector<std::int8_t> values;
    bool operator==(const ModuleStart&) const = default;
};

ModuleStart start_of(const std::vector<std::uint8_t>& bytes) {
    const TrackerModule module = parse_module(bytes);
    ModuleStart start{{}, module.samples[0].samples};
    for (const ModuleNote& note : module.row(module.orders.back(), 0)) start.periods.push_back(note.period);
    return start;
}

std::vector<std::uint8_t> marked(std::vector<std::uint8_t> bytes, const std::string& mark) {
    std::copy(mark.begin(), mark.end(), bytes.begin() + 1080);
    return bytes;
}

TEST(Module, MarksOfOtherTrackersAreKnown) {
    ModuleFile eight({0, 1}, 2, 8), four({0, 1}, 2), paired({0, 2}, 4);
    std::vector<int> periods;
    for (std::size_t i = 0; i < 8; ++i) {
        const int period = 200 + static_cast<int>(i);
        periods.push_back(period);
        eight.note(1, 0, i, 1, period);
        if (i < 4) four.note(1, 0, i, 1, period);
        paired.note(2 + i / 4, 0, i % 4, 1, period);
    }
    for (ModuleFile* const file : {&eight, &four, &paired}) file->sample({1, 2, 3, 4});
    const ModuleStart of_eight{periods, {1, 2, 3, 4}}, of_four{{200, 201, 202, 203}, {1, 2, 3, 4}};
    for (const std::string mark : {"8CHN", "08CH", "OCTA", "OKTA", "CD81"})
        EXPECT_EQ(start_of(marked(eight.bytes(), mark)), of_eight) << mark;
    EXPECT_EQ(start_of(marked(eight.bytes(), "M.K.")), of_eight) << "Mod's Grave: only the size says so";
    EXPECT_EQ(start_of(marked(paired.bytes(), "FLT8")), of_eight);
    for (const std::string mark : {"M.K.", "M!K!", "M&K!", "N.T.", "FLT4", "4CHN"})
        EXPECT_EQ(start_of(marked(four.bytes(), mark)), of_four) << mark;
}

TEST(Module, JunkBehindTheOrdersIsNoPattern) {
    for (const int junk : {3, 100, 200, 255}) {
        ModuleFile file({0, 1}, 2);
        std::vector<std::uint8_t> bytes = file.note(1, 0, 0, 1, 428).sample({1, 2, 3, 4}).bytes();
        bytes[1000] = static_cast<std::uint8_t>(junk);
        EXPECT_EQ(start_of(bytes), (ModuleStart{{428, 0, 0, 0}, {1, 2, 3, 4}})) << junk;
    }
    ModuleFile hidden({0}, 3);
    EXPECT_EQ(start_of(hidden.note(0, 0, 0, 1, 428).sample({1, 2, 3, 4}).bytes()),
              (ModuleStart{{428, 0, 0, 0}, {1, 2, 3, 4}}));
}

TEST(Module, ANumberOfNoSampleIsNone) {
    for (const int sample : {32, 97, 255}) {
        ModuleFile file;
        const TrackerModule module = parse_module(file.sample(square(32)).note(0, 0, 0, sample, 428).bytes());
        EXPECT_EQ(module.notes[0].sample, 0);
        EXPECT_EQ(module.notes[0].period, 428);
    }
    ModuleFile packed;
    for (std::size_t i = 0; i < 256; ++i) packed.note(0, i / 4, i % 4, i % 3 == 0 ? 200 : 1, 428);
    EXPECT_NE(test::refusal([&] { parse_module(packed.bytes()); }).find("86 of 256 notes name samples above 31"),
              std::string::npos);
}

// By OpenMPT's description of ModPlug's packing: each half of a byte, the lower first, adds one of 16 differences.
TEST(Module, PackedSamplesAreUnpacked) {
    ModuleFile file;
    std::vector<std::uint8_t> bytes = file.sample({0, 0, 0, 0, 0, 0}).bytes();
    bytes.resize(bytes.size() - 6);
    for (const char letter : std::string("ADPCM")) bytes.push_back(static_cast<std::uint8_t>(letter));
    for (int i = 0; i < 16; ++i) bytes.push_back(static_cast<std::uint8_t>(i < 8 ? i * i : -i));
    bytes.insert(bytes.end(), {0x21, 0x7f, 0x07});
    EXPECT_EQ(start_of(bytes).values, (std::vector<std::int8_t>{1, 5, -10, 39, 88, 88}));
}

TEST(Module, SaysWhatIsWrongAndWhere) {
    const std::vector<std::uint8_t> good = ModuleFile().sample(square(32)).bytes();
    const auto place_of_error = [](const std::vector<std::uint8_t>& bytes) {
        return test::place_of_refusal([&] { parse_module(bytes); });
    };
    for (std::size_t size = 0; size < 1084 + 1024; ++size)
        EXPECT_EQ(place_of_error({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}),
                  "offset " + std::to_string(size));
    EXPECT_EQ(place_of_error({good.begin(), good.end() - 20}), "");  // a sample that is cut off is as long as it is
    const auto changed = [&](std::size_t at, std::uint8_t to) {
        auto bytes = good;
        bytes[at] = to;
        return place_of_error(bytes);
    };
    EXPECT_EQ(changed(1081, 'X'), "offset 1080");
    EXPECT_EQ(changed(950, 0), "offset 950");
    EXPECT_EQ(changed(950, 129), "offset 950");
    EXPECT_EQ(changed(1084 + 40, 0xf0), "") << "a note of no sample";
    EXPECT_EQ(changed(952, 1), "offset " + std::to_string(good.size()));
}

}  // namespace
}  // namespace oblong
