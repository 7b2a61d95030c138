#pragma once

#include "engine/platform/sound.h"

namespace oblong::dos {

/// Sound by a Sound Blaster; empty where there is none.
OpenSound sound_of_card();

}  // namespace oblong::dos
