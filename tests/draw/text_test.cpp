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

TEST(Lines, ShortTextIsOneLine) {
    EXPECT_EQ(lines_of_columns("", 5), Lines{""});
    EXPECT_EQ(lines_of_columns("a b c", 5), Lines{"a b c"});
    EXPECT_EQ(lines_of("a b", 3 * kGlyphAdvance_px - 1), (Lines{"a", "b"}));
}

TEST(Lines, BreakAtTheLastSpaceThatFits) {
    EXPECT_EQ(lines_of_columns("one two three", 7), (Lines{"one two", "three"}));
    EXPECT_EQ(lines_of_columns("one two three", 8), (Lines{"one two", "three"}));
    EXPECT_EQ(lines_of_columns("one two three", 6), (Lines{"one", "two", "three"}));
}

TEST(Lines, BreakAtLineFeeds) {
    EXPECT_EQ(lines_of_columns("one\n\ntwo three", 5), (Lines{"one", "", "two", "three"}));
}

TEST(Lines, LongWordsAreCut) {
    EXPECT_EQ(lines_of_columns("abcdefgh ij", 3), (Lines{"abc", "def", "gh", "ij"}));
    EXPECT_EQ(lines_of("ab", -20), (Lines{"a", "b"}));
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

TEST(Font, EveryPrintableCharacterHasAPictureOfItsOwn) {
    std::set<Glyph> glyphs;
    for (char character = kFirstGlyph; character <= '~'; ++character) glyphs.insert(glyph_of(character));
    EXPECT_EQ(glyphs.size(), std::size_t{kGlyphCount});
    EXPECT_EQ(glyph_of(' '), Glyph{});
}

TEST(Font, AnyOtherCharacterIsAQuestionMark) {
    for (const char character : {'\0', '\n', '\x7f', '\xe4', '\xff'}) EXPECT_EQ(glyph_of(character), glyph_of('?'));
}

// The letter L: a stroke down the left edge and along the baseline.
TEST(Font, RowsRunDownAndColumnsFromTheLeft) {
    const Glyph& glyph = glyph_of('L');
    for (int row = 0; row < kGlyphHeight_px; ++row)
        for (int column = 0; column < kGlyphWidth_px; ++column)
            EXPECT_EQ(is_drawn(glyph, row, column), row < 7 && (column == 0 || row == 6)) << row << ' ' << column;
}

}  // namespace
}  // namespace oblong::test
