#include "engine/level/entities.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

TEST(Entities, PairsComeInTheirOrder) {
    const auto entities = parse_entities("{ \"a\" \"1\"\n\"b\" \"2 3\" }\r\n{}\t{\"c\"\"\"} // the end", "text");
    ASSERT_EQ(entities.size(), 3u);
    ASSERT_EQ(entities[0].pairs.size(), 2u);
    EXPECT_EQ(entities[0].pairs[1].first, "b");
    EXPECT_EQ(entities[0].pairs[1].second, "2 3");
    EXPECT_TRUE(entities[1].pairs.empty());
    EXPECT_EQ(entities[2].value("c", "other"), "");
}

TEST(Entities, FirstOfEqualKeysCounts) {
    const auto entities = parse_entities("{ \"a\" \"1\" \"a\" \"2\" }", "text");
    EXPECT_EQ(entities[0].value("a"), "1");
    EXPECT_EQ(entities[0].value("b", "otherwise"), "otherwise");
}

TEST(Entities, TextEndsAtAZero) {
    using namespace std::string_view_literals;
    EXPECT_EQ(parse_entities("{}\0{"sv, "text").size(), 1u);
    EXPECT_TRUE(parse_entities("", "text").empty());
}

TEST(Entities, CommentInAQuoteIsText) {
    EXPECT_EQ(parse_entities("{ \"music\" \"a//b\" }", "text")[0].value("music"), "a//b");
}

TEST(Entities, QuotesBehindBackslashesAreText) {
    const auto entities = parse_entities("{\"say\" \"a \\\"b\\\" c\"\n\"path\" \"C:\\\"\n}{\"a\" \"b\\\\\"}", "text");
    ASSERT_EQ(entities.size(), 2u);
    EXPECT_EQ(entities[0].value("say"), R"(a \"b\" c)");
    EXPECT_EQ(entities[0].value("path"), R"(C:\)") << "the last quote of a line ends the text";
    EXPECT_EQ(entities[1].value("a"), R"(b\\)");
}

struct Fault {
    const char* text;
    const char* where;
};

TEST(Entities, FaultsTellTheirOffset) {
    for (const Fault& fault :
         {Fault{"x", "maps, offset 100"}, Fault{"{ \"key\" }", "maps, offset 108"},
          Fault{"{ \"key\" \"val", "maps, offset 108"}, Fault{"{ \"a\" \"b\"", "maps, offset 109"}}) {
        try {
            parse_entities(fault.text, "maps", 100);
            FAIL() << "read: " << fault.text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where, fault.where) << error.what();
        }
    }
}

TEST(Decimal, RoundsToNearest) {
    EXPECT_EQ(parse_decimal("12.5", 12), 12 * 4096 + 2048);
    EXPECT_EQ(parse_decimal("-12.5", 12), -12 * 4096 - 2048);
    EXPECT_EQ(parse_decimal("+.25", 12), 1024);
    EXPECT_EQ(parse_decimal("7.", 0), 7);
    EXPECT_EQ(parse_decimal("0.5", 0), 1);
    EXPECT_EQ(parse_decimal("0.00012", 12), 0);   // 0.49 of a step
    EXPECT_EQ(parse_decimal("0.000123", 12), 1);  // 0.504
    EXPECT_EQ(parse_decimal("-0.000123", 12), -1);
    EXPECT_EQ(parse_decimal("2147483647.999999999", 16), std::int64_t{2147483648} * 65536);
    // 10^-9 is 4.29 steps of 2^-32
    EXPECT_EQ(parse_decimal("-2147483647.999999999", 32), -(std::numeric_limits<std::int64_t>::max() - 3));
}

TEST(Decimal, RefusesWhatIsNoNumber) {
    for (const char* text :
         {"", "-", ".", "+.", "1e3", "nan", "1 ", " 1", "1.2.3", "--1", "2147483648", "99999999999999999999"})
        EXPECT_FALSE(parse_decimal(text, 12).has_value()) << text;
}

TEST(WorldVector, TakesThreeNumbersThatFit) {
    const auto origin = parse_world_vector("  -16 0.5\t524287.9 ");
    ASSERT_TRUE(origin.has_value());
    EXPECT_EQ(origin->x, World::from_int(-16));
    EXPECT_EQ(origin->y.raw, 2048);
    EXPECT_EQ(origin->z.raw, 524287 * 4096 + 3686);  // 0.9 * 4,096 = 3,686.4
    for (const char* text : {"", "1 2", "1 2 3 4", "1 2 x", "1 2 524288", "-524289 0 0"})
        EXPECT_FALSE(parse_world_vector(text).has_value()) << text;
    EXPECT_TRUE(parse_world_vector("-524288 0 0").has_value());
}

}  // namespace
}  // namespace oblong
