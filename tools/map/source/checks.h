#pragma once

#include "tools/map/source/map_file.h"

namespace oblong::map {

/// Something in a map source that the compiler may read differently from what its author means.
struct Warning {
    int line = 0;
    std::string what;
};

/// Unknown classes and keys, what has no effect here, and a missing start, in the order of their first lines; each
/// once, with the number of repetitions.
std::vector<Warning> find_warnings(const std::vector<MapEntity>& entities);

}  // namespace oblong::map
