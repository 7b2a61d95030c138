#include <gtest/gtest.h>

#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

TEST(Entities, MalformedNumbersAreRefused) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity("light", {{"origin", "1 2"}})),
                     "\"origin\" is \"1 2\", expected 3 numbers");
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity_at("light", {32, 32, 32}, {{"light", "bright"}})),
                     "\"light\" is \"bright\", expected 1 number");
}

TEST(Entities, GroupsAloneAreAWorld) {
    const std::string bytes = bytes_of(level(plain_room(), lights_of_plain_room()));
    EXPECT_EQ(
        bytes_of(level("", entity("func_group", {{"_tb_type", "_tb_group"}}, plain_room()) + lights_of_plain_room())),
        bytes);
}

}  // namespace
}  // namespace oblong::test
