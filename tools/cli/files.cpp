#include "tools/cli/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "engine/platform/replace_file.h"

namespace oblong {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reason() {
    return std::strerror(errno);
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::string& path, std::size_t most_bytes) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw FileError(path, "open", "is a folder, expected a file");
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) throw FileError(path, "open", reason() + ", expected a readable file");
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint8_t> chunk(std::size_t{1} << 16);
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
        bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
        if (bytes.size() > most_bytes)
            throw FileError(path, "size",
                            "more than " + std::to_string(most_bytes) + " bytes, expected a smaller file");
    }
    if (std::ferror(file.get())) throw FileError(path, "read", reason());
    return bytes;
}

void write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    try {
        replace_file(path, bytes);
    } catch (const InputError& error) {
        throw FileError(path, "write", error.what());
    }
}

void write_file(const std::string& path, const std::string& text) {
    write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw FileError(path, "make folder", error.message());
}

}  // namespace oblong
