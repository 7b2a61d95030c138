#include "engine/draw/font.h"

#include <gtest/gtest.h>

#include <set>

namespace oblong::test {
namespace {

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
