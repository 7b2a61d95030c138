// Music (tracker modules), as the game loads it: SDL_mixer and libmodplug read and mix it.

#include <stdlib.h>

#include "engine/base/input_error.h"
#include "engine/platform/sdl/sdl.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {
namespace {

// By which letters modules of each kind are known.
struct Signature {
    std::size_t at;
    std::string_view letters;
};
constexpr Signature kSignatures[] = {
    {1080, "M.K."},  {1080, "FLT8"}, {1080, "16CH"},   {0, "Extended Module: "},
    {0, "IMPM"},     {44, "SCRM"},   {20, "!Scream!"}, {0, "MTM"},
    {0, "OKTASONG"}, {0, "MMD1"},    {0, "if"},        {0, "FAR\xfe"},
};

// SDL's driver without a device: it takes what is mixed as fast as a device would.
std::unique_ptr<SoundOutput> open_without_device() {
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    return open_mixer();
}

}  // namespace

void mutate(Bytes& input, std::minstd_rand& random) {
    mutate_bytes(input);
    const Signature& signature = one_of(kSignatures, random);
    if (input.size() < signature.at + signature.letters.size() || below(8, random) != 0) return;
    std::copy(signature.letters.begin(), signature.letters.end(),
              input.begin() + static_cast<std::ptrdiff_t>(signature.at));
}

void run(Input input) {
    static const std::unique_ptr<SoundOutput> output = open_without_device();
    output->play_music(input, 128);
    output->stop_music();
}

}  // namespace oblong::fuzz
