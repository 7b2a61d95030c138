#include "engine/surface/palette.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

TEST(Palette, TakesTriplesInOrder) {
    std::vector<std::uint8_t> bytes(768);
    bytes[0] = 1, bytes[1] = 2, bytes[2] = 3, bytes[767] = 4;
    const Palette palette = read_palette(bytes);
    EXPECT_EQ(palette.colours[0], (Rgb8{1, 2, 3}));
    EXPECT_EQ(palette.colours[255], (Rgb8{0, 0, 4}));
}

TEST(Palette, OtherSizesAreRefused) {
    for (const std::size_t size : {0u, 767u, 769u, 1024u})
        EXPECT_THROW(read_palette(std::vector<std::uint8_t>(size)), InputError) << size;
}

}  // namespace
}  // namespace oblong
