#include "tests/fuzz/common/fuzz.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "engine/base/input_error.h"
#include "engine/io/files.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t size, std::size_t most);

namespace oblong::fuzz {
namespace {

// How many inputs were read, and how many in all: said at the end.
struct Tally {
    std::int64_t read = 0, inputs = 0;
    ~Tally() { std::fprintf(stderr, "stat::inputs_read: %lld of %lld\n", 0LL + read, 0LL + inputs); }
};

bool is_read(const Bytes& input) {
    try {
        read(input);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

// Beside the counters of instrumented code, libFuzzer looks at what is in this section.
__attribute__((section("__libfuzzer_extra_counters"))) std::uint8_t places_reached[1024];

}  // namespace

void note_reached(std::string_view where) {
    std::uint32_t hash = 0;
    bool is_quoted = false;
    for (const char letter : where) {
        if (letter == '\'') is_quoted = !is_quoted;
        if (!is_quoted && (letter < '0' || letter > '9')) hash = hash * 31 + static_cast<std::uint8_t>(letter);
    }
    places_reached[(hash ^ hash >> 16) % std::size(places_reached)] = 1;
}

__attribute__((weak)) void mutate(Bytes& input, std::minstd_rand&) {
    mutate_bytes(input);
}

__attribute__((weak)) void read(Input) {}

void mutate_bytes(Bytes& bytes, std::size_t growth) {
    const std::size_t size = bytes.size();
    bytes.resize(size + growth);
    bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

void expect(bool holds, const std::string& what) {
    if (holds) return;
    std::fprintf(stderr, "expected: %s\n", what.c_str());
    std::abort();
}

std::size_t below(std::size_t limit, std::minstd_rand& random) {
    return limit == 0 ? 0 : random() % limit;
}

std::int64_t odd_number(std::minstd_rand& random) {
    const std::int64_t power = std::int64_t{1} << below(33, random);
    const std::size_t kind = below(4, random);
    if (kind == 0) return static_cast<std::int64_t>(below(9, random)) - 4;
    if (kind == 1) return power - 1 + static_cast<std::int64_t>(below(3, random));
    if (kind == 2) return 1 - power - static_cast<std::int64_t>(below(3, random));
    return static_cast<std::int64_t>(random()) * 2 + static_cast<std::int64_t>(random() & 1);
}

std::string number_text(std::minstd_rand& random) {
    std::string text = std::to_string(odd_number(random) >> below(32, random));
    if (below(3, random) == 0) text += "." + std::to_string(below(100'000, random));
    return text;
}

void replace_number(std::string& text, std::minstd_rand& random) {
    const std::size_t begin = text.find_first_of("-0123456789", below(text.size(), random));
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_not_of("-.0123456789", begin), text.size());
    text.replace(begin, end - begin, number_text(random));
}

std::string text_of(Input input) {
    return {input.begin(), input.end()};
}

void set_text(Bytes& bytes, const std::string& text) {
    bytes.assign(text.begin(), text.end());
}

}  // namespace oblong::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace oblong;
    static fuzz::Tally tally;
    ++tally.inputs;
    try {
        fuzz::run({bytes, size});
        ++tally.read;
    } catch (const InputError& error) {
        fuzz::expect(!error.where.empty() && *error.what() != 0, "an error with a place and a reason");
        fuzz::note_reached(error.what());
    } catch (const FileError& error) {
        fuzz::expect(std::string(error.what()).find(": ") != std::string::npos, "an error with a place");
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed) {
    std::minstd_rand random(seed);
    const oblong::fuzz::Bytes before(bytes, bytes + size);
    oblong::fuzz::Bytes input = before;
    oblong::fuzz::mutate(input, random);
    const int tries = oblong::fuzz::below(8, random) == 0 ? 1 : 8;
    for (int i = 1; i < tries && !oblong::fuzz::is_read(input); ++i) {
        input = before;
        oblong::fuzz::mutate(input, random);
    }
    const std::size_t kept = std::min(input.size(), most);
    std::copy_n(input.begin(), kept, bytes);
    return kept;
}
