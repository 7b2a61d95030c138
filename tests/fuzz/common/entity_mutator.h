#pragma once

#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {

/// Alters the text of entities, or of a map's if `has_brushes`: pairs and whole entities of the engine's table of
/// classes (engine/level/entity_classes.h), other numbers, boxes of the compiler's textures; and any bytes.
void mutate_entities(std::string& text, bool has_brushes, std::minstd_rand& random);

/// The source of a small room with what each four bytes decide: a brush in it, or an entity.
std::string made_map(Input seeds);

}  // namespace oblong::fuzz
