#include "engine/files/arguments.h"

#include <gtest/gtest.h>

namespace oblong::test {
namespace {

/// What a parser says against its argument; empty if it takes it.
template <class Parse>
std::string complaint_of(Parse parse) {
    try {
        parse();
        return "";
    } catch (const UsageError& error) {
        return error.what();
    }
}

TEST(Arguments, NumbersAreRoundedToTheNearestStep) {
    EXPECT_EQ(parse_number("--time", "-12.375", 3), -99);
    EXPECT_EQ(parse_number("--time", "0.3", 1), 1);
    EXPECT_EQ(parse_number("--time", "16777215", 32), std::int64_t{16777215} << 32);
    for (const std::string text : {"", "nan", "1e3", "16777216", "-16777216", "1,5"})
        EXPECT_TRUE(
            complaint_of([&] { parse_number("--time", text, 8); }).starts_with("--time: '" + text + "', expected"))
            << text;
}

TEST(Arguments, FieldOfViewIsFromOneTo179Degrees) {
    EXPECT_EQ(parse_field_of_view("72.5"), Degrees::from_raw(std::int64_t{145} << 47));
    EXPECT_EQ(complaint_of([] { parse_field_of_view("1"); }), "");
    EXPECT_EQ(complaint_of([] { parse_field_of_view("179"); }), "");
    for (const std::string text : {"0.99", "179.01", "", "wide"})
        EXPECT_TRUE(complaint_of([&] { parse_field_of_view(text); }).starts_with("--fov: '" + text + "', expected"))
            << text;
}

TEST(Arguments, BrightnessIsFromAQuarterToEight) {
    EXPECT_EQ(parse_brightness("1"), 100);
    EXPECT_EQ(parse_brightness("1.29"), 129);
    EXPECT_EQ(parse_brightness("0.25"), 25);
    EXPECT_EQ(parse_brightness("8"), 800);
    for (const std::string text : {"0.24", "8.01", "-1", "", "bright"})
        EXPECT_TRUE(complaint_of([&] { parse_brightness(text); }).starts_with("--brightness: '" + text + "', expected"))
            << text;
}

TEST(Arguments, PresetsAreKnownByName) {
    EXPECT_EQ(parse_preset("1991"), Preset::Year1991);
    EXPECT_EQ(parse_preset("exact"), Preset::Exact);
    EXPECT_TRUE(complaint_of([] { parse_preset("2001"); }).starts_with("--accuracy: '2001', expected 1991"));
}

TEST(Arguments, DisplaysAreShapesInLowestTerms) {
    EXPECT_EQ(parse_display("8:6").numerator, 4);
    for (const std::string text : {"4", "4:0", "101:1", "4:3:2"})
        EXPECT_TRUE(complaint_of([&] { parse_display(text); }).starts_with("--display: '" + text + "', expected"))
            << text;
}

}  // namespace
}  // namespace oblong::test
