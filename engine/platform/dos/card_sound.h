#pragma once

#include <functional>

#include "engine/platform/sound.h"

namespace oblong::dos {

/// Sound by a Sound Blaster; empty where there is none. `when_loaded` is called once, when the first sound begins: from
/// then on each sound may be given without samples, in the same order.
OpenSound sound_of_card(std::function<void()> when_loaded);

}  // namespace oblong::dos
