#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/map/source/map_file.h"

namespace oblong::map {

/// A map source included by another one.
struct ExternalSource {
    std::string path;  ///< unique for each file
    std::string text;
};

/// Reads the file named `name` in the source at `path`; throws InputError at `line` of that source if it is missing.
using ReadExternalSource = std::function<ExternalSource(const std::string& name, const std::string& path, int line)>;

/// Puts the brushes of other sources into the entities misc_external_map of the source at `path`: all brushes of those
/// sources, of any entity, scaled, then rotated, then moved to the entity's origin, with their textures. Each becomes
/// an entity of the class in its key "_external_map_classname", with the brushes at its line. Throws FileError and
/// InputError, also if a source includes itself, or more than kMostExternal sources are included. `warnings`: of those
/// sources.
void include_external_maps(std::vector<MapEntity>& entities, const std::string& path, const ReadExternalSource& read,
                           Warnings& warnings);

inline constexpr int kMostExternal = 4096;

}  // namespace oblong::map
