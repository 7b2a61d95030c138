#pragma once

#include <vector>

#include "tools/map/source/map_file.h"

namespace oblong::map {

/// The parts to compile; the rest is taken from an earlier level.
enum class CompilePart { All, Entities, Light, Visibility };

/// The part to compile after a source has changed, by what parse_map() returned before and returns now: All if brushes,
/// their entities or files may have, Light if what emits light or is lit otherwise may have, else Entities.
CompilePart changed_part(const std::vector<MapEntity>& before, const std::vector<MapEntity>& now);

}  // namespace oblong::map
