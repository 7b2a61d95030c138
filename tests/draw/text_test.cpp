#include <gtest/gtest.h>

#include <set>
#include <string>

#include "engine/draw/drawing.h"

namespace oblong::test {
namespace {

using Lines = std::vector<std::string_view>;

Lines lines_of_columns(std::string_view text, int columns) {
    return lines_of(text, columns * kGlyphAdvance_px);
}

TEST(Lines, BreakAtLineFeedsAndTheLastSpaceThatFitsOrCutAWord) {
    for (const auto& [text, columns, lines] : {std::tuple{"", 5, Lines{""}},
                                               {"a b c", 5, {"a b c"}},
                                               {"one two three", 7, {"one two", "three"}},
                                               {"one two three", 8, {"one two", "three"}},
                                               {"one two three", 6, {"one", "two", "three"}},
                                               {"one\n\ntwo three", 5, {"one", "", "two", "three"}},
                                               {"abcdefgh ij", 3, {"abc", "def", "gh", "ij"}},
                                               {"Höhle Größe", 5, {"Höhle", "Größe"}},
                                               {"ÄÖÜßé ¿Dónde?", 3, {"ÄÖÜ", "ßé", "¿Dó", "nde", "?"}},
                                               // No UTF-8: a letter each.
                                               {"\xff\xc3\xff…", 2, {"\xff\xc3", "\xff…"}}})
        EXPECT_EQ(lines_of_columns(text, columns), lines) << text << ", " << columns;
    EXPECT_EQ(lines_of("a b", 3 * kGlyphAdvance_px - 1), (Lines{"a", "b"}));
    EXPECT_EQ(lines_of("ab", -20), (Lines{"a", "b"}));
    EXPECT_EQ(text_width_px("Höhle – 5 €"), 11 * kGlyphAdvance_px);
}

// Whatever the width: every line fits, and nothing but spaces and line feeds is lost.
TEST(Lines, HoldAllWordsAndFit) {
    const std::string text = "This is so in Deathmatch,  exiting the map\nwill go to the start map. ";
    std::string letters;
    for (const char letter : text)
        if (letter != ' ' && letter != '\n') letters += letter;
    for (int columns = 1; columns < 90; ++columns) {
        std::string kept;
        for (const std::string_view line : lines_of_columns(text, columns)) {
            EXPECT_LE(text_width_px(line), columns * kGlyphAdvance_px);
            for (const char letter : line)
                if (letter != ' ') kept += letter;
        }
        EXPECT_EQ(kept, letters) << columns;
    }
}

constexpr std::u32string_view kAlike = U"\u00a0¦ª\u00ad²³µ¹º×÷ĐȘșȚț‐‑–—−‘’‚“”„•‹›",
                              kDrawn = U" |a-23u1ox/ÐŞşŢţ-----'\',\"\"\"*<>", kFurther = U"…€",
                              kLacking = U"¤¬®¶¼½¾ĦħĲĳĸĿŀŉŊŋſ";

bool is_one_of(std::u32string_view letters, char32_t letter) {
    return letters.find(letter) != letters.npos;
}

bool is_known(char32_t letter) {
    return (letter >= 0x20 && letter < 0x7f) || (letter >= 0xa0 && letter < 0x180 && !is_one_of(kLacking, letter)) ||
           is_one_of(kFurther, letter) || is_one_of(kAlike, letter);
}

TEST(Font, EveryLetterHasAPictureOfItsOwn) {
    std::set<Glyph> glyphs;
    for (char32_t letter = 0; letter < kNoLetter; ++letter) {
        if (!is_known(letter) || is_one_of(kAlike, letter)) continue;
        EXPECT_TRUE(glyphs.insert(glyph_of(letter)).second) << static_cast<int>(letter);
    }
    EXPECT_EQ(glyph_of(U' '), Glyph{});
}

TEST(Font, SomeLettersAreDrawnAsOthers) {
    ASSERT_EQ(kAlike.size(), kDrawn.size());
    for (std::size_t i = 0; i < kAlike.size(); ++i) EXPECT_EQ(glyph_of(kAlike[i]), glyph_of(kDrawn[i])) << i;
}

TEST(Font, AnyOtherLetterIsAQuestionMark) {
    const Glyph question_mark = glyph_of(U'?');
    for (char32_t letter = 0; letter <= kNoLetter; ++letter) {
        if (is_known(letter)) continue;
        ASSERT_EQ(glyph_of(letter), question_mark) << static_cast<int>(letter);
    }
    EXPECT_EQ(glyph_of(~char32_t{0}), question_mark);
}

// Of rows -2 to 7.
std::vector<std::string> picture_of(std::string_view line) {
    std::vector<std::string> rows(kAccentRows_px + kGlyphHeight_px,
                                  std::string(letters_in(line) * kGlyphAdvance_px, ' '));
    for_each_dot(line, [&](int column, int row) {
        rows.at(static_cast<std::size_t>(row + kAccentRows_px)).at(static_cast<std::size_t>(column)) = '#';
    });
    return rows;
}

TEST(Font, AccentsAreOverSmallLettersAndOverShorterCapitalsAndBelow) {
    // clang-format off
    const std::vector<std::string> expected{
        "         #          #                  #  ",
        "   #    #     #    # #                #   ",
        "  #          # #    #                     ",
        "      #####   #    ###               ##   ",
        " ###  #      ###  #   #  ####  ##     #   ",
        "#   # #         # #   # #       #     #   ",
        "##### ####   #### ##### #       #     #   ",
        "#     #     #   # #   # #       #     #   ",
        " ###  #####  #### #   #  ####  ###   ###  ",
        "                          #               ",
    };
    // clang-format on
    EXPECT_EQ(picture_of("éÉåÅçıĺ"), expected);
}

TEST(Font, OfAsciiNothingIsAbove) {
    for (char32_t letter = U' '; letter < 0x7f; ++letter)
        EXPECT_EQ(glyph_of(letter)[0] | glyph_of(letter)[1], 0) << static_cast<int>(letter);
}

TEST(Text, IsDrawnWithItsAccentsAbove) {
    std::vector<std::uint8_t> pixels(20 * 16);
    const std::vector<std::string> rows = picture_of("ÉÅ");
    for (const std::size_t y : {0u, 1u, 4u}) {
        std::fill(pixels.begin(), pixels.end(), std::uint8_t{0});
        draw_text({pixels.data(), 20, 16, 20}, 1, static_cast<int>(y), "ÉÅ", {9, 0, 1});
        std::vector<std::uint8_t> expected(20 * 16);
        for (std::size_t row = 0; row < rows.size(); ++row)
            for (std::size_t column = 0; column < rows[row].size(); ++column)
                if (rows[row][column] == '#' && row + y >= kAccentRows_px)
                    expected[(row + y - kAccentRows_px) * 20 + column + 1] = 9;
        EXPECT_EQ(pixels, expected) << y;
    }
}

// The letter L: a stroke down the left edge and along the baseline.
TEST(Font, RowsRunDownAndColumnsFromTheLeft) {
    const Glyph glyph = glyph_of(U'L');
    for (int row = 0; row < kGlyphHeight_px; ++row)
        for (int column = 0; column < kGlyphWidth_px; ++column)
            EXPECT_EQ(is_drawn(glyph, row, column), row < 7 && (column == 0 || row == 6)) << row << ' ' << column;
}

}  // namespace
}  // namespace oblong::test
