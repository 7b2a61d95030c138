#pragma once

#include "tests/support/levels.h"

namespace oblong::test {

/// Tests of each level and of the file that it is read from.
class LevelFile : public OfLevel {
  protected:
    void SetUp() override {
        OfLevel::SetUp();
        if (IsSkipped()) return;
        file_ = bytes_of_level(GetParam());
        level_ = read_bsp(file_);
    }
    std::size_t lump_offset(std::size_t lump) const { return number_at(file_, 4 + lump * 8, 4); }
    std::size_t lump_size(std::size_t lump) const { return number_at(file_, 8 + lump * 8, 4); }

    Bytes file_;
    Level level_;
};

}  // namespace oblong::test
