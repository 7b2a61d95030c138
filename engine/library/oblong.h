#pragma once

#include "engine/view/screen.h"

// The first header of a program that uses Oblong as a library.

namespace oblong {

/// Of the library, as "0.1.0".
const char* version();

}  // namespace oblong
