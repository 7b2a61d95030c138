// Map sources, as they are or made of seeds: compiled, read back, played and drawn.

#include "engine/base/fnv.h"
#include "engine/level/bsp_read.h"
#include "tests/fuzz/common/entity_mutator.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/map/map_source.h"
#include "tools/map/source/checks.h"

namespace oblong::fuzz {
namespace {

Level read_back(const std::string& bytes) {
    try {
        return read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    } catch (const InputError& error) {
        expect(false, "a compiled level that is read, not " + error.where + ": " + error.what());
        throw;
    }
}

}  // namespace

// A text, or seeds of a small one behind a byte that no text begins with.
constexpr std::uint8_t kSeeds = 0xff;

void mutate(Bytes& input, std::minstd_rand& random) {
    if (input.empty() || input[0] == kSeeds || below(8, random) == 0) {
        mutate_bytes(input, 16);
        if (!input.empty()) input[0] = kSeeds;
        return;
    }
    std::string text = text_of(input);
    mutate_entities(text, true, random);
    set_text(input, text);
}

void run(Input input) {
    const std::uint64_t hash = fnv1a_of(input);
    const bool is_made = !input.empty() && input[0] == kSeeds;
    map::Warnings warnings;
    map::CompileOptions options;
    options.is_fast = hash % 4 != 0;
    options.warnings = &warnings;
    const std::string text = is_made ? made_map(input.subspan(1)) : text_of(input);
    play_and_draw(read_back(map::to_bytes(test::compile(text, options))), hash);
}

}  // namespace oblong::fuzz
