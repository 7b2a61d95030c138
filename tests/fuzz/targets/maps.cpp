// Map sources, as they are or made of seeds: compiled, read back, played and drawn.

#include "engine/base/checksum.h"
#include "engine/level/bsp_read.h"
#include "tests/fuzz/common/entity_mutator.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/map/map_source.h"
#include "tools/map/source/checks.h"
#include "tools/map/source/external_maps.h"

namespace oblong::fuzz {
namespace {

// The sources that a map may name: itself among them.
map::BspFile compile(const std::string& text, const map::CompileOptions& options) {
    const auto read = [&](const std::string& name, const std::string&, int line) -> map::ExternalSource {
        if (name == "self") return {name, text};
        if (name == "room") return {name, test::level(test::plain_room())};
        throw InputError("line " + std::to_string(line), "no such map");
    };
    std::vector<map::MapEntity> entities = map::parse_map(text);
    map::include_external_maps(entities, "self", read, *options.warnings);
    map::find_warnings(entities, *options.warnings);
    return test::compile(std::move(entities), options);
}

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
    play_and_draw(read_back(map::to_bytes(compile(text, options))), hash);
}

}  // namespace oblong::fuzz
