#include "tools/cli/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

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
    // A device or a pipe is written to; only a file is replaced by a finished one.
    std::error_code ignored;
    const auto target = std::filesystem::status(path, ignored);
    const bool is_replaced = !std::filesystem::exists(target) || std::filesystem::is_regular_file(target);
    const std::string unfinished = is_replaced ? path + ".part" : path;
    std::FILE* const file = std::fopen(unfinished.c_str(), "wb");
    if (!file) throw FileError(path, "open for writing", reason());
    const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
    const std::string why = reason();
    const bool is_closed = std::fclose(file) == 0;
    if (is_written && is_closed && (!is_replaced || std::rename(unfinished.c_str(), path.c_str()) == 0)) return;
    const std::string failure = is_written ? reason() : why;
    if (is_replaced) std::remove(unfinished.c_str());
    throw FileError(path, "write", failure);
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
