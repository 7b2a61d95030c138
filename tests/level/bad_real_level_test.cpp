#include <gtest/gtest.h>

#include <random>

#include "tests/support/bsp_fault.h"
#include "tests/support/shared_levels.h"

namespace oblong {
namespace {

using test::Bytes, test::fault_of, test::lump_label, test::names_a_lump;

class BadRealLevel : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        OBLONG_NEEDS_SHARED_LEVELS();
        file_ = test::read_shared_file(std::string(GetParam()) + ".bsp");
    }
    Bytes file_;
};

TEST_P(BadRealLevel, CutAtALumpsBorderItNamesALump) {
    std::vector<std::size_t> borders;
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const std::size_t start = test::number_at(file_, 4 + lump * 8, 4),
                          size = test::number_at(file_, 8 + lump * 8, 4);
        for (const std::size_t cut : {start, start + size / 2, start + size - 1}) borders.push_back(cut);
    }
    for (const std::size_t cut : borders) {
        const std::string where = fault_of(Bytes(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(cut)));
        EXPECT_TRUE(names_a_lump(where)) << "cut at " << cut << ": '" << where << "'";
    }
}

TEST_P(BadRealLevel, LumpOutsideTheFileIsNamed) {
    const auto size = static_cast<std::int64_t>(file_.size());
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        for (const std::int64_t value :
             {std::int64_t{-1}, std::int64_t{-2147483648}, std::int64_t{2147483647}, size + 1}) {
            for (const std::size_t field : {4 + lump * 8, 8 + lump * 8}) {
                Bytes bad = file_;
                test::put_number(bad, field, 4, value);
                EXPECT_TRUE(fault_of(bad).starts_with(lump_label(lump))) << kLumpNames[lump] << ' ' << value;
            }
        }
        Bytes in_header = file_;
        test::put_number(in_header, 4 + lump * 8, 4, kBspHeaderSize - 1);
        EXPECT_TRUE(fault_of(in_header).starts_with(lump_label(lump))) << kLumpNames[lump];
    }
}

// A lump moved by a record, or emptied, may by chance hold a valid level: then it is read.
TEST_P(BadRealLevel, LumpMovedOrResizedIsReadOrNamesALump) {
    for (std::size_t lump = 0; lump < kLumpCount; ++lump) {
        const auto offset = test::number_at(file_, 4 + lump * 8, 4), size = test::number_at(file_, 8 + lump * 8, 4);
        const std::int64_t record = kBspFormats[0].record_sizes[lump];
        for (const std::int64_t change : {-record, std::int64_t{-1}, std::int64_t{1}, record}) {
            Bytes moved = file_, resized = file_, emptied = file_;
            test::put_number(moved, 4 + lump * 8, 4, offset + change);
            test::put_number(resized, 8 + lump * 8, 4, size + change);
            test::put_number(emptied, 8 + lump * 8, 4, 0);
            for (const Bytes& bad : {moved, resized, emptied}) {
                const std::string where = fault_of(bad);
                EXPECT_TRUE(where.empty() || names_a_lump(where)) << where;
            }
        }
    }
}

TEST_P(BadRealLevel, RandomDamageNeverCrashes) {
    std::mt19937 random(20);
    const Bytes whole = file_;
    for (int round = 0; round < 400; ++round) {
        Bytes bad = whole;
        for (int flips = 1 + round % 8; flips > 0; --flips)
            bad[4 + random() % (bad.size() - 4)] = static_cast<std::uint8_t>(random());
        const std::string where = fault_of(bad);
        EXPECT_TRUE(where.empty() || names_a_lump(where)) << where;
    }
}

INSTANTIATE_TEST_SUITE_P(Shared, BadRealLevel, testing::ValuesIn(test::kRealLevels));

}  // namespace
}  // namespace oblong
