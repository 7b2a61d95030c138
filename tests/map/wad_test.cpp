#include <gtest/gtest.h>

#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

TEST(Wad, UnknownTexturesAreNamed) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}, 16, "nothing")), "line 4: texture 'nothing' is in none");
}

TEST(Wad, BrokenOnesAreRefused) {
    EXPECT_THROW(map::Wad("WAD3"), InputError);
    EXPECT_THROW(map::Wad("WAD2"), InputError);
    const std::string whole = wad_bytes({"wall"});
    EXPECT_NE(map::Wad(whole).find("wall"), nullptr);
    EXPECT_THROW(map::Wad(whole.substr(0, whole.size() - 1)), InputError);
    std::string far = whole;
    far.replace(whole.size() - 32, 4, "\xff\xff\xff\x7f");
    EXPECT_THROW(map::Wad{far}, InputError);
}

}  // namespace
}  // namespace oblong::test
