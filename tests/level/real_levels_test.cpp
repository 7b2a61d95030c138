#include <gtest/gtest.h>

#include "engine/level/bsp_read.h"
#include "tests/support/shared_levels.h"

namespace oblong {
namespace {

/// A number of the file, read without the engine.
std::int64_t number_at(const std::vector<std::uint8_t>& file, std::size_t offset, int bytes) {
    std::int64_t value = 0;
    for (int i = bytes; i-- > 0;) value = value * 256 + file[offset + static_cast<std::size_t>(i)];
    return value;
}

class RealLevel : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        OBLONG_NEEDS_SHARED_LEVELS();
        file_ = test::read_shared_file(std::string(GetParam()) + ".bsp");
        level_ = read_bsp(file_);
    }

    std::size_t lump_offset(std::size_t lump) const {
        return static_cast<std::size_t>(number_at(file_, 4 + lump * 8, 4));
    }
    std::size_t lump_size(std::size_t lump) const {
        return static_cast<std::size_t>(number_at(file_, 8 + lump * 8, 4));
    }

    std::vector<std::uint8_t> file_;
    Level level_;
};

// Lump numbers and record sizes as the format's description has them, not as the engine does.
TEST_P(RealLevel, HoldsEveryRecordOfTheFile) {
    EXPECT_EQ(level_.planes.size() * 20, lump_size(1));
    EXPECT_EQ(level_.vertices.size() * 12, lump_size(3));
    EXPECT_EQ(level_.visibility.size(), lump_size(4));
    EXPECT_EQ(level_.nodes.size() * 24, lump_size(5));
    EXPECT_EQ(level_.texinfos.size() * 40, lump_size(6));
    EXPECT_EQ(level_.faces.size() * 20, lump_size(7));
    EXPECT_EQ(level_.lighting.size(), lump_size(8));
    EXPECT_EQ(level_.clip_nodes.size() * 8, lump_size(9));
    EXPECT_EQ(level_.leaves.size() * 28, lump_size(10));
    EXPECT_EQ(level_.mark_faces.size() * 2, lump_size(11));
    EXPECT_EQ(level_.edges.size() * 4, lump_size(12));
    EXPECT_EQ(level_.surf_edges.size() * 4, lump_size(13));
    EXPECT_EQ(level_.models.size() * 64, lump_size(14));
    EXPECT_EQ(level_.textures.size(), static_cast<std::size_t>(number_at(file_, lump_offset(2), 4)));
}

TEST_P(RealLevel, BeginsWithTheWorldspawn) {
    ASSERT_FALSE(level_.entities.empty());
    EXPECT_EQ(level_.entities[0].value("classname"), "worldspawn");
}

INSTANTIATE_TEST_SUITE_P(Shared, RealLevel, testing::ValuesIn(test::kRealLevels));

}  // namespace
}  // namespace oblong
