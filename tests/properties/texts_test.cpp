// Lines of texts of random bytes.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/draw/drawing.h"

namespace oblong::test::texts_test {
namespace {

std::string any_text() {
    const auto parts = rc::gen::oneOf(
        rc::gen::element<std::string>(" ", "\n", "a", "ö", "—", "\xf0\x9f\x8e\xae"),
        rc::gen::map(rc::gen::inRange(0, 0x100), [](int byte) { return std::string(1, static_cast<char>(byte)); }),
        rc::gen::map(rc::gen::inRange(0x80, 0x100), [](int byte) { return std::string(1, static_cast<char>(byte)); }));
    std::string text;
    for (const std::string& part : *rc::gen::container<std::vector<std::string>>(parts)) text += part;
    return text;
}

// Between two lines there is one space or line feed, or nothing.
RC_GTEST_PROP(Texts, LinesFitAndHoldWholeLetters, ()) {
    const std::string text = any_text();
    const auto columns = *rc::gen::inRange(1, 12);
    std::size_t letters = 0;
    const char* end = text.data();
    for (const std::string_view line : lines_of(text, columns * kGlyphAdvance_px)) {
        RC_ASSERT(text_width_px(line) <= columns * kGlyphAdvance_px);
        RC_ASSERT(line.data() - end <= 1);
        letters += letters_in(line) + static_cast<std::size_t>(line.data() - end);
        end = line.data() + line.size();
    }
    letters += static_cast<std::size_t>(text.data() + text.size() - end);
    RC_ASSERT(letters == letters_in(text));
}

// What is behind its end changes nothing: it is not read.
RC_GTEST_PROP(Texts, EndWhereTheyEnd, ()) {
    const std::string text = any_text();
    const auto letters_before = [&](char behind) {
        const std::string longer = text + std::string(4, behind);
        std::vector<char32_t> letters;
        for (std::string_view rest(longer.data(), text.size()); !rest.empty();) letters.push_back(take_letter(rest));
        return letters;
    };
    const std::vector<char32_t> letters = letters_before(' ');
    RC_ASSERT(letters == letters_before('\xbf'));
    RC_ASSERT(letters.size() == letters_in(text));
    RC_ASSERT(first_letters(text, letters.size()) == text);
    RC_ASSERT(text_width_px(text) == static_cast<std::int32_t>(letters.size()) * kGlyphAdvance_px);
}

}  // namespace
}  // namespace oblong::test::texts_test
