#pragma once

#include <string>
#include <vector>

#include "tools/map/source/map_file.h"
#include "tools/map/source/textures.h"

namespace oblong::map {

/// The sources of a level's textures.
struct TextureSources {
    std::vector<std::string> wads;     ///< WAD2 files, and folders of pictures; none: those of worldspawn's "wad"
    std::vector<std::string> glowing;  ///< textures of folders that may use glowing colours
    std::string palette;               ///< of folders' pictures; empty: palette.lmp in the folder, or the game's
    std::string game_palette;          ///< empty: Oblong's
    std::string dither = "none";       ///< of folders' pictures
};

/// The path of the given palette, or the game's, or Oblong's.
std::string palette_file(const TextureSources& sources, const char* called_as);

/// Reads the textures. The worldspawn's key "wad" has names of files and folders, separated by ';'. Each is searched
/// for from the map's folder, then by its last component in that folder, then in Oblong's own (`called_as`: argv[0]).
/// One that is nowhere is a warning. Throws FileError, and UsageError if `glowing` has a name of no texture. `files`:
/// receives the names of the sources and pictures before they are read.
std::vector<Wad> read_texture_sources(const TextureSources& sources, const MapEntity& world,
                                      const std::string& map_path, const char* called_as,
                                      std::vector<std::string>& files, Warnings& warnings);

}  // namespace oblong::map
