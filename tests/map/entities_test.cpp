#include <gtest/gtest.h>

#include "engine/level/bsp_read.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

TEST(Entities, MalformedNumbersAreRefused) {
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity("light", {{"origin", "1 2"}})),
                     "\"origin\" is \"1 2\", expected 3 numbers");
    expect_complaint(level(room({0, 0, 0}, {64, 64, 64}), entity_at("light", {32, 32, 32}, {{"light", "bright"}})),
                     "\"light\" is \"bright\", expected 1 number");
}

TEST(Entities, DetailsToPassStopNobody) {
    const auto bsp = compile(level(plain_room(), lights_of_plain_room() + entity("func_detail_illusionary", {},
                                                                                 box({160, 160, 0}, {192, 192, 64}))),
                             {true});
    const Point inside{176, 176, 32};
    for (const int hull : {0, 1, 2}) EXPECT_EQ(contents_at(bsp, 0, hull, {176, 176, 40}), contents::kEmpty) << hull;
    EXPECT_EQ(contents_at(bsp, 1, 0, inside), contents::kSolid) << "of a model";
    EXPECT_EQ(bsp.models.at(1).face_count, 6) << "and drawn";
    EXPECT_NE(bsp.entities.find("\"classname\" \"func_illusionary\"\n\"model\" \"*1\""), std::string::npos)
        << bsp.entities;
}

TEST(Entities, QuotesBehindBackslashesArePartOfAValue) {
    const std::string sign = entity("trigger_multiple", {{"message", R"(say \"hi\" now)"}, {"wad", R"(C:\gfx\)"}},
                                    box({160, 160, 0}, {192, 192, 64}, "trigger"));
    const std::string bytes = bytes_of(level(plain_room(), lights_of_plain_room() + sign));
    const Level read = read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    EXPECT_EQ(read.entities.back().value("message"), R"(say \"hi\" now)");
    EXPECT_EQ(read.entities.back().value("wad"), R"(C:\gfx\)");
}

TEST(Entities, GroupsAloneAreAWorld) {
    const std::string bytes = bytes_of(level(plain_room(), lights_of_plain_room()));
    EXPECT_EQ(
        bytes_of(level("", entity("func_group", {{"_tb_type", "_tb_group"}}, plain_room()) + lights_of_plain_room())),
        bytes);
}

}  // namespace
}  // namespace oblong::test
