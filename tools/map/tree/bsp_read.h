#pragma once

#include <span>

#include "tools/map/tree/bsp_file.h"

namespace oblong::map {

/// Reads a file of version 29 or BSP2 from to_bytes(), which would give the same bytes again. Throws InputError for any
/// other file.
BspFile from_bytes(const std::string& bytes);

}  // namespace oblong::map
