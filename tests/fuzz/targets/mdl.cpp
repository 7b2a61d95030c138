// Quake's models: read and drawn.

#include "engine/base/fnv.h"
#include "engine/mesh/mesh.h"
#include "tests/fuzz/common/played_level.h"

namespace oblong::fuzz {

void run(Input input) {
    draw_in_stage(read_mdl(input), fnv1a_of(input));
}

}  // namespace oblong::fuzz
