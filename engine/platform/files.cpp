#include "engine/platform/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
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

/// The system's message if writing failed; else empty.
std::string write_bytes(const std::string& path, std::span<const std::uint8_t> bytes) {
    File file(std::fopen(path.c_str(), "wb"));
    if (!file) return reason();
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) return reason();
    return std::fclose(file.release()) == 0 ? "" : reason();
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::string& path, std::size_t most_bytes) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw FileError(path, "open", "is a folder, expected a file");
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) throw FileError(path, "open", reason() + ", expected a readable file");
    std::vector<std::uint8_t> bytes, chunk(std::size_t{1} << 16);
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
        if (count > most_bytes - bytes.size())
            throw FileError(path, "size",
                            "more than " + std::to_string(most_bytes) + " bytes, expected a smaller file");
        bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
    }
    if (std::ferror(file.get())) throw FileError(path, "read", reason() + ", expected a readable file");
    return bytes;
}

std::vector<std::uint8_t> read_file_part(const std::string& path, std::uint64_t offset, std::size_t length) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path, "open", "expected a readable file");
    std::error_code ignored;
    const std::uint64_t size = std::filesystem::file_size(path, ignored);
    if (offset > size || length > size - offset)
        throw FileError(
            path, "offset " + std::to_string(offset),
            "the file has " + std::to_string(size) + " bytes, expected " + std::to_string(length) + " from here on");
    std::vector<std::uint8_t> bytes(length);
    file.seekg(static_cast<std::streamoff>(offset));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(length));
    if (!file) throw FileError(path, "read", "expected a readable file");
    return bytes;
}

std::string read_text(const std::string& path) {
    const std::vector<std::uint8_t> bytes = read_file(path);
    return {bytes.begin(), bytes.end()};
}

void write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    std::error_code ignored;
    const auto kind = std::filesystem::symlink_status(path, ignored).type();
    const bool is_in_place =
        kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found;
    const std::string written = is_in_place ? path : path + ".part";
    std::string failure = write_bytes(written, bytes);
    if (failure.empty() && !is_in_place && std::rename(written.c_str(), path.c_str()) != 0) failure = reason();
    if (failure.empty()) return;
    if (!is_in_place) std::remove(written.c_str());
    throw FileError(path, "write",
                    failure + ", expected a place for a file of " + std::to_string(bytes.size()) + " bytes");
}

void replace_file(const std::string& path, const std::string& former_path, std::span<const std::uint8_t> bytes) {
    const std::string written = path + ".new";
    write_file(written, bytes);
    const auto rename = [&](const std::string& from, const std::string& to) {
        if (std::rename(from.c_str(), to.c_str()) == 0) return;
        const std::string failure = reason();
        std::remove(written.c_str());
        throw FileError(to, "write", failure + ", expected to put " + from + " in its place");
    };
    rename(path, former_path);
    rename(written, path);
}

void write_file(const std::string& path, const std::string& text) {
    write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void flush_standard_output() {
    errno = 0;
    std::cout.flush();
    if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    const std::string why = errno == 0 ? "failed" : reason();
    throw FileError("standard output", "write", why + ", expected it to be writable");
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw FileError(path, "make folder", error.message() + ", expected a place for a folder");
}

}  // namespace oblong
