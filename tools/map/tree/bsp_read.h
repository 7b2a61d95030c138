#pragma once

#include <span>

#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// The level in the bytes of a file of version 29 or BSP2 that to_bytes() made: that gives the same bytes again. Throws
/// InputError for any other.
BspFile from_bytes(const std::string& bytes);

}  // namespace oblong::map
