// Music (tracker modules), as the game loads it, and two seconds of it played.
#include <vector>

#include "engine/sound/module_player.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {

void mutate(Bytes& input, std::minstd_rand& random) {
    constexpr std::string_view kSignature = "M.K.";
    constexpr std::ptrdiff_t kAt = 1080;
    mutate_bytes(input);
    if (std::ssize(input) < kAt + 4 || below(8, random) == 0) return;
    std::copy(kSignature.begin(), kSignature.end(), input.begin() + kAt);
}

void run(Input input) {
    ModulePlayer player(parse_module(input));
    std::vector<std::int32_t> sums(2 * ModulePlayer::kRate_hz / 10);
    for (int i = 0; i < 20; ++i) player.add(sums, 256);
}

}  // namespace oblong::fuzz
