// Lines to oblong-probe: each has one line as its answer, the same when it is asked again.

#include "tools/probe/probe.h"

#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {
namespace {

constexpr const char* kQueries[] = {"project", "view", "coverage", "mesh", "texspan", "texspanq", "modes",
                                    "clip",    "sin",  "cos",      "sqrt", "recip",   "leaf"};

// Another number in the place of one, or a query of its own.
void alter(std::string& text, std::minstd_rand& random) {
    if (below(3, random) != 0) return replace_number(text, random);
    text += std::string("\n") + one_of(kQueries, random);
    for (std::size_t numbers = 1 + below(20, random); numbers > 0; --numbers) text += " " + number_text(random);
}

}  // namespace

void mutate(Bytes& input, std::minstd_rand& random) {
    if (below(3, random) == 0) return mutate_bytes(input);
    std::string text = text_of(input);
    alter(text, random);
    set_text(input, text);
}

void run(Input input) {
    Probe probe;
    const std::string text = text_of(input);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin), answer = probe.answer(line);
        expect(!answer.empty() && answer.find('\n') == std::string::npos, "an answer of one line");
        expect(probe.answer(line) == answer, "the same answer again");
        begin = end + 1;
    }
}

}  // namespace oblong::fuzz
