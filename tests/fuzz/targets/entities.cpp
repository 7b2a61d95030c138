// The text of a level's entities, played and drawn in a small level.

#include "engine/level/entities.h"

#include "engine/base/checksum.h"
#include "tests/fuzz/common/entity_mutator.h"
#include "tests/fuzz/common/played_level.h"

namespace oblong::fuzz {

void mutate(Bytes& input, std::minstd_rand& random) {
    std::string text = text_of(input);
    mutate_entities(text, false, random);
    set_text(input, text);
}

void run(Input input) {
    static Level level = stage_level();
    level.entities = parse_entities(text_of(input), "entities");
    play_and_draw(level, fnv1a_of(input));
}

}  // namespace oblong::fuzz
