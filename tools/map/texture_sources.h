#pragma once

#include <string>
#include <vector>

#include "tools/map/source/map_file.h"
#include "tools/map/source/textures.h"

namespace oblong::map {

/// Where a level's textures come from.
struct TextureSources {
    std::vector<std::string> wads;     ///< WAD2 files, and folders of pictures; none: those that the worldspawn names
    std::vector<std::string> glowing;  ///< textures of folders that may take colours which glow
    std::string palette;               ///< of folders' pictures; empty: palette.lmp in the folder, or Oblong's
    std::string dither = "none";       ///< of folders' pictures
};

/// The palette that is named, or Oblong's.
std::string palette_file(const TextureSources& sources, const char* called_as);

/// Reads them. The worldspawn's key "wad" names files and folders, a ';' between two; each is looked for from the map's
/// folder, and if it is not there by its name alone in that folder and in Oblong's own (`called_as`: argv[0]). Throws
/// FileError, InputError where there is none, and UsageError where `glowing` names no texture. `files`: receives their
/// names, and those of the pictures, before they are read.
std::vector<Wad> read_texture_sources(const TextureSources& sources, const MapEntity& world,
                                      const std::string& map_path, const char* called_as,
                                      std::vector<std::string>& files);

}  // namespace oblong::map
