#include "engine/programs/arguments.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

/// That each text is no value of an option, for a reason that the parser says.
void expect_refused(const std::string& option, std::initializer_list<const char*> texts, auto parse) {
    for (const std::string text : texts)
        EXPECT_TRUE(refusal<UsageError>([&] { parse(text); }).starts_with(option + ": '" + text + "', expected"))
            << text;
}

TEST(Arguments, NumbersAreRoundedToTheNearestStep) {
    EXPECT_EQ(parse_number("--time", "-12.375", 3), -99);
    EXPECT_EQ(parse_number("--time", "0.3", 1), 1);
    EXPECT_EQ(parse_number("--time", "16777215", 32), std::int64_t{16777215} << 32);
    expect_refused("--time", {"", "nan", "1e3", "16777216", "-16777216", "1,5"},
                   [](const std::string& text) { parse_number("--time", text, 8); });
}

TEST(Arguments, FieldOfViewIsFromOneTo179Degrees) {
    EXPECT_EQ(parse_field_of_view("72.5"), Degrees::from_raw(std::int64_t{145} << 47));
    EXPECT_NO_THROW(parse_field_of_view("1"));
    EXPECT_NO_THROW(parse_field_of_view("179"));
    expect_refused("--fov", {"0.99", "179.01", "", "wide"}, parse_field_of_view);
}

TEST(Arguments, BrightnessIsFromAQuarterToEight) {
    EXPECT_EQ(parse_brightness("1"), 100);
    EXPECT_EQ(parse_brightness("1.29"), 129);
    EXPECT_EQ(parse_brightness("0.25"), 25);
    EXPECT_EQ(parse_brightness("8"), 800);
    expect_refused("--brightness", {"0.24", "8.01", "-1", "", "bright"}, parse_brightness);
}

TEST(Arguments, PresetsAreKnownByName) {
    EXPECT_EQ(parse_preset("1991"), Preset::Year1991);
    EXPECT_EQ(parse_preset("exact"), Preset::Exact);
    EXPECT_TRUE(refusal<UsageError>([] { parse_preset("2001"); }).starts_with("--accuracy: '2001', expected 1991"));
}

TEST(Arguments, DisplaysAreShapesInLowestTerms) {
    struct Shape {
        const char* text;
        std::int64_t width, height;
    };
    for (const auto& [text, width, height] : {Shape{"8:6", 4, 3},
                                              {"1.85:1", 37, 20},
                                              {"37:20", 37, 20},
                                              {"2.39:1", 239, 100},
                                              {"1:0.75", 4, 3},
                                              {"1.50:1.0", 3, 2},
                                              {"16.5:9.75", 22, 13},
                                              {"0.01:1", 1, 100},
                                              {"20000:15000", 4, 3}}) {
        EXPECT_EQ(parse_display(text).numerator, width) << text;
        EXPECT_EQ(parse_display(text).denominator, height) << text;
    }
    expect_refused("--display",
                   {"",        ":",    "4",     "1.85",  "4:0",       "0:3",      "0.0:1",        "101:1",  "1:100.5",
                    "4:3:2",   "-4:3", "-4:-3", "1.:1",  ".5:1",      ".:1",      "1.8.5:1",      "1,85:1", "1.-5:1",
                    "1.85:1 ", " 4:3", "1e0:1", "nan:1", "1.33333:1", "1.3333:1", "99999999999:1"},
                   parse_display);
}

}  // namespace
}  // namespace oblong::test
