#pragma once

#include <string>
#include <string_view>

namespace oblong::map {

struct MapToken {
    std::string text;
    bool is_quoted = false;
    bool is_end = false;
    int line = 1;

    bool is(std::string_view symbol) const { return !is_quoted && !is_end && text == symbol; }
};

/// Cuts the text of a map source into words, brackets and quoted strings; comments run from // to the line's end.
class MapTokens {
  public:
    explicit MapTokens(std::string_view text) : text_(text) { advance(); }

    const MapToken& peek() const { return next_; }
    MapToken take();
    /// Takes `symbol`, or throws InputError saying that it was expected `where`.
    void expect(std::string_view symbol, std::string_view where);
    double take_number(std::string_view what);
    [[noreturn]] void fail(const MapToken& at, std::string_view expected) const;

  private:
    void advance();
    void skip_blanks();
    void read_quoted();
    void read_word();

    std::string_view text_;
    std::size_t position_ = 0;
    int line_ = 1;
    MapToken next_;
};

}  // namespace oblong::map
