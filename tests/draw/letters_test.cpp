// Letters of a text in UTF-8, against their encoding.

#include <gtest/gtest.h>

#include "engine/base/input_error.h"
#include "engine/base/text.h"

namespace oblong::test::letters_test {
namespace {

bool is_surrogate(char32_t code) {
    return code >= 0xd800 && code < 0xe000;
}

std::string encoded(char32_t code) {
    const auto part = [&](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3f)); };
    if (code < 0x80) return {static_cast<char>(code)};
    if (code < 0x800) return {static_cast<char>(0xc0 | code >> 6), part(0)};
    if (code < 0x10000) return {static_cast<char>(0xe0 | code >> 12), part(6), part(0)};
    return {static_cast<char>(0xf0 | code >> 18), part(12), part(6), part(0)};
}

TEST(Letters, OfAllCodesAreTaken) {
    for (char32_t code = 0; code < kNoLetter; ++code) {
        if (is_surrogate(code)) continue;
        const std::string text = encoded(code) + "\xbf";
        std::string_view rest = text;
        ASSERT_EQ(take_letter(rest), code);
        ASSERT_EQ(rest, "\xbf") << static_cast<int>(code);
    }
}

TEST(Letters, EachByteOfNoneCounts) {
    const std::pair<std::string_view, std::size_t> kTexts[] = {
        // overlong
        {"\xc0\xaf", 2},
        {"\xc1\xbf", 2},
        {"\xe0\x9f\xbf", 3},
        {"\xf0\x8f\xbf\xbf", 4},
        // surrogates, and too large
        {"\xed\xa0\x80", 3},
        {"\xed\xbf\xbf", 3},
        {"\xf4\x90\x80\x80", 4},
        {"\xf8\x90\x80\x80", 4},
        // cut off, or without a beginning
        {"\xc3", 1},
        {"\xe2\x82", 2},
        {"\xf0\x9f\x8e", 3},
        {"\xc3(", 2},
        {"\xe2\x82\xe2\x82\xac", 3},
        {"a\xbfz", 3},
        {"\x84\x80", 2},
    };
    for (const auto& [text, count] : kTexts) EXPECT_EQ(letters_in(text), count) << text;
}

// Whatever the first two bytes: a letter is what its own encoding begins with, anything else a byte.
TEST(Letters, OfAnyBytesAreThoseThatEncodeThem) {
    for (unsigned first = 0; first < 0x10000; ++first)
        for (const char third : {'\x20', '\x7f', '\x80', '\xbf', '\xc0'}) {
            const std::string text{static_cast<char>(first >> 8), static_cast<char>(first), third, '\x81'};
            std::string_view rest = text;
            const char32_t code = take_letter(rest);
            const std::size_t taken = text.size() - rest.size();
            if (code == kNoLetter) {
                ASSERT_EQ(taken, 1u);
                ASSERT_GE(first, 0x8000u);
            } else {
                ASSERT_EQ(encoded(code), text.substr(0, taken));
                ASSERT_FALSE(is_surrogate(code));
            }
        }
}

TEST(Letters, StartOfATextHoldsWholeOnes) {
    EXPECT_EQ(first_letters("Größe", 0), "");
    EXPECT_EQ(first_letters("Größe", 3), "Grö");
    EXPECT_EQ(first_letters("Größe", 9), "Größe");
    EXPECT_EQ(first_letters("\xf6\xc3", 1), "\xf6");
}

TEST(Letters, AShortenedTextEndsWithAWholeOne) {
    EXPECT_EQ(shortened("Größe", 7), "Größe");
    EXPECT_EQ(shortened("Größe", 6), "Größ...");
    EXPECT_EQ(shortened("Größe", 5), "Grö...");
    EXPECT_EQ(shortened("Größe", 4), "Grö...");
    EXPECT_EQ(shortened("Größe", 3), "Gr...");
    EXPECT_EQ(shortened("\xbf\xbf\xbf", 2), "...");
    EXPECT_EQ(printable(std::string(399, 'a') + "ö"), std::string(399, 'a') + "...");
    EXPECT_EQ(printable("Höhle\n"), "Höhle?");
}

TEST(Letters, HaveCapitals) {
    EXPECT_EQ(in_capitals("Höhle – L'été, żółć 12"), "HÖHLE – L'ÉTÉ, ŻÓŁĆ 12");
    EXPECT_EQ(in_capitals("œufs œufs", 1), "Œufs œufs");
    EXPECT_EQ(in_capitals("", 1), "");
    const std::string small = "azàþāķĺľłňŋŷźž", capital = "AZÀÞĀĶĹĽŁŇŊŶŹŽ", neither = "`{¿ß÷ÿıŀĸŉſ€\xe0\xc3";
    EXPECT_EQ(in_capitals(small), capital);
    EXPECT_EQ(in_capitals(capital), capital);
    EXPECT_EQ(in_capitals(neither), neither);
}

TEST(Letters, OfQuakesLevelsAreWhite) {
    EXPECT_EQ(level_text("Die Höhle"), "Die Höhle");
    EXPECT_EQ(level_text("The \xcc\xef\xf3\xf4 cave"), "The Lost cave");
    EXPECT_EQ(level_text("\xd4\xc8\xc5\xa0\xc5\xce\xc4"), "THE END") << "although C5 A0 is a letter of UTF-8";
}

}  // namespace
}  // namespace oblong::test::letters_test
