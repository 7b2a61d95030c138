#include <gtest/gtest.h>

#include "engine/fixed/root.h"
#include "tests/exhaustive/first_failure.h"

namespace oblong {
namespace {

TEST(HardCaseA6, RootOfEvery32BitNumberIsItsFloor) {
    expect_all(0, kAll32, [](std::uint64_t value) {
        const std::uint64_t r = integer_root(value);
        return r * r <= value && value < (r + 1) * (r + 1);
    });
}

/// Where the floor changes, at r^2: for the 2^28 largest roots of 32 bits.
TEST(HardCaseA6, RootChangesAtEverySquareOf64Bits) {
    expect_all(1, kAll32 / 16, [](std::uint64_t input) {
        const std::uint64_t r = kAll32 - input;
        return integer_root(r * r) == r && integer_root(r * r - 1) == r - 1;
    });
}

}  // namespace
}  // namespace oblong
