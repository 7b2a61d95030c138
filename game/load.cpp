#include "game/load.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/base/input_error.h"
#include "engine/level/bsp_read.h"
#include "engine/platform/replace_file.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

std::string find_palette(const fs::path& level_folder, const fs::path& assets) {
    for (const fs::path& file : {level_folder / "palette.lmp", level_folder / "gfx" / "palette.lmp"})
        if (fs::exists(file)) return file.string();
    return (assets / "palette.lmp").string();
}

// read(bytes of the file), with the file's name on what is wrong with them.
template <class Read>
auto read_as(const std::string& file, Read read) {
    const std::vector<std::uint8_t> bytes = read_file(file);
    try {
        return read(std::span<const std::uint8_t>(bytes));
    } catch (const InputError& error) {
        throw FileError(file + ": " + error.where + ": " + error.what());
    }
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in || fs::is_directory(file)) throw FileError(file + ": file: can't be read, expected a file");
    return bytes;
}

void write_file(const std::string& file, std::span<const std::uint8_t> bytes) {
    try {
        replace_file(file, bytes);
    } catch (const InputError& error) {
        throw FileError(error.where + ": file: " + error.what());
    }
}

GameData load_game(const std::string& level_file, const std::string& palette_file, const std::string& assets_folder) {
    GameData data;
    data.level_file = level_file.empty() ? (fs::path(assets_folder) / "demo.bsp").string() : level_file;
    data.level = read_as(data.level_file, read_bsp);
    const std::string palette =
        palette_file.empty() ? find_palette(fs::path(data.level_file).parent_path(), assets_folder) : palette_file;
    data.palette = read_as(palette, read_palette);
    data.colormap = make_colormap(data.palette);
    return data;
}

}  // namespace oblong
