#pragma once

#include <cstdint>

#include "engine/platform/controls.h"

namespace oblong {

/// What hands do on a short walk that shows any level: ahead, a look around, a jump, on and on.
Controls short_walk(std::int64_t tick);

}  // namespace oblong
