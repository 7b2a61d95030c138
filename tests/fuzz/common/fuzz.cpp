#include "tests/fuzz/common/fuzz.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "engine/base/input_error.h"
#include "engine/files/files.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t size, std::size_t most);

namespace oblong::fuzz {
namespace {

// How many inputs were read, and how many in all: said at the end.
struct Tally {
    std::int64_t read = 0, inputs = 0;
    ~Tally() { std::fprintf(stderr, "stat::inputs_read: %lld of %lld\n", 0LL + read, 0LL + inputs); }
};

}  // namespace

__attribute__((weak)) void mutate(Bytes& input, std::minstd_rand&) {
    mutate_bytes(input);
}

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
    switch (below(4, random)) {
        case 0:
            return static_cast<std::int64_t>(below(9, random)) - 4;
        case 1:
            return power - 1 + static_cast<std::int64_t>(below(3, random));
        case 2:
            return 1 - power - static_cast<std::int64_t>(below(3, random));
        default:
            return static_cast<std::int64_t>(random()) * 2 + static_cast<std::int64_t>(random() & 1);
    }
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
    } catch (const FileError& error) {
        fuzz::expect(std::string(error.what()).find(": ") != std::string::npos, "an error with a place");
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed) {
    std::minstd_rand random(seed);
    oblong::fuzz::Bytes input(bytes, bytes + size);
    oblong::fuzz::mutate(input, random);
    const std::size_t kept = std::min(input.size(), most);
    std::copy_n(input.begin(), kept, bytes);
    return kept;
}
