#pragma once

#include <functional>

#include "engine/platform/sound.h"

namespace oblong::dos {

/// Sound through a Sound Blaster; empty if there is none. `when_loaded` is called once, when the first sound begins;
/// after that, sounds may be added without samples, in the same order.
OpenSound sound_of_card(std::function<void()> when_loaded);

}  // namespace oblong::dos
