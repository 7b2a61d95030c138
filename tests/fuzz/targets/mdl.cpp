// Quake's models: read and drawn.

#include "engine/base/checksum.h"
#include "engine/mesh/mesh.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/support/bsp_writer.h"

namespace oblong::fuzz {

// Numbers as it has them, or any bytes.
void mutate(Bytes& input, std::minstd_rand& random) {
    constexpr std::size_t kNumber = 4;
    if (input.size() < kNumber || below(2, random) == 0) return mutate_bytes(input);
    test::put_number(input, below(input.size() / kNumber, random) * kNumber, kNumber, odd_number(random));
}

void read(Input input) {
    read_mdl(input);
}

void run(Input input) {
    draw_in_stage(read_mdl(input), fnv1a_of(input));
}

}  // namespace oblong::fuzz
