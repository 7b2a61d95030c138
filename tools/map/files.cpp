#include "tools/map/files.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "engine/base/input_error.h"

namespace oblong::map {

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file.is_open() || file.bad() || std::filesystem::is_directory(path))
        throw InputError("file", "cannot be read, expected a readable file");
    return bytes;
}

void write_file(const std::string& path, const std::string& bytes) {
    const std::string unfinished = path + ".unfinished";
    std::error_code error;
    std::ofstream file(unfinished, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    bool is_written = !file.fail();
    if (is_written) {
        std::filesystem::rename(unfinished, path, error);
        is_written = !error;
    }
    if (is_written) return;
    std::filesystem::remove(unfinished, error);
    throw InputError(
        "file", "cannot be written, expected a writable folder with " + std::to_string(bytes.size()) + " bytes free");
}

}  // namespace oblong::map
