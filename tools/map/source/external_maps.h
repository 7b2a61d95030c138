#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/map/source/map_file.h"

namespace oblong::map {

/// A map source that another one names.
struct ExternalSource {
    std::string path;  ///< one for each file, whoever names it
    std::string text;
};

/// Reads what `name` means in the source at `path`; throws InputError at `line` of that if it is not there.
using ReadExternalSource = std::function<ExternalSource(const std::string& name, const std::string& path, int line)>;

/// Puts the brushes of other sources into the entities misc_external_map of the source at `path`, all that there are in
/// those, whatever their entities: scaled, then turned, then moved to the entity's origin, with their textures. Each
/// becomes an entity of the class that its key "_external_map_classname" says, and the brushes are at its line.
/// Throws FileError and InputError; also where a source includes itself, or kMostExternal sources are included.
void include_external_maps(std::vector<MapEntity>& entities, const std::string& path, const ReadExternalSource& read);

inline constexpr int kMostExternal = 4096;

}  // namespace oblong::map
