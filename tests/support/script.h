#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

/// Tests as sentences: tables of a name and a text, whose lines say what is done, then what must hold.
namespace oblong::test {

struct Script {
    const char* name;
    const char* text;
};

inline void PrintTo(const Script& script, std::ostream* out) {
    *out << script.name;
}

using Words = std::vector<std::string>;

/// "do this; do that: this = 1, that = 2   # a note"
struct ScriptLine {
    std::string text;
    std::vector<Words> actions, checks;
};

/// A text's lines, without empty ones and notes. What stands in quotes is not parted; words are without them.
std::vector<ScriptLine> script_lines(const std::string& text);

/// The words of a line.
Words words_of(const std::string& text);

/// Words from the one at `first` on, with spaces between them.
std::string joined(const Words& words, std::size_t first = 0);

}  // namespace oblong::test

/// Makes a test of each row of a table of scripts, in which `run(script)` fails at each line that does not hold.
#define OBLONG_SCRIPTS(Suite, rows, run)                                  \
    class Suite : public testing::TestWithParam<oblong::test::Script> {}; \
    TEST_P(Suite, Goes) {                                                 \
        run(GetParam());                                                  \
    }                                                                     \
    INSTANTIATE_TEST_SUITE_P(As, Suite, testing::ValuesIn(rows),          \
                             [](const auto& row) { return std::string(row.param.name); })
