// Map sources: compiled, read back, played and drawn.

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

void mutate(Bytes& input, std::minstd_rand& random) {
    std::string text = text_of(input);
    mutate_entities(text, true, random);
    set_text(input, text);
}

void run(Input input) {
    map::Warnings warnings;
    map::CompileOptions options;
    options.is_fast = fnv1a_of(input) % 4 != 0;
    options.warnings = &warnings;
    play_and_draw(read_back(map::to_bytes(test::compile(text_of(input), options))), fnv1a_of(input));
}

}  // namespace oblong::fuzz
