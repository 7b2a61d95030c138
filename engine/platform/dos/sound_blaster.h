#pragma once

#include "engine/sound/sound.h"

namespace oblong::dos {

/// Sound through a Sound Blaster; empty if there is none. When it is opened again, sounds may be added without samples,
/// in the same order.
OpenSound sound_of_card();

}  // namespace oblong::dos
