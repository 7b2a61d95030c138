#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/level/level.h"
#include "engine/surface/colormap.h"
#include "engine/surface/palette.h"

namespace oblong {

/// A file that can't be read or written, or is not what it should be: "FILE: WHERE: what is wrong, what was expected".
class FileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// All bytes of a file. Throws FileError.
std::vector<std::uint8_t> read_file(const std::string& file);
void write_file(const std::string& file, std::span<const std::uint8_t> bytes);

/// What a game is played with.
struct GameData {
    std::string level_file;
    Level level;
    Palette palette;
    Colormap colormap;
};

/// Reads the level and its palette; empty names: the demo level of `assets_folder`, and the palette.lmp beside the
/// level, in gfx/ beside it, or in `assets_folder`. Throws FileError.
GameData load_game(const std::string& level_file, const std::string& palette_file, const std::string& assets_folder);

}  // namespace oblong
