#include "engine/platform/replace_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "engine/base/input_error.h"

namespace oblong {

namespace {

/// What went wrong while writing; empty: nothing.
std::string write_bytes(const std::string& path, std::span<const std::uint8_t> bytes) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (!file) return std::strerror(errno);
    const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
    const std::string why = std::strerror(errno);
    const bool is_closed = std::fclose(file) == 0;
    if (!is_written) return why;
    return is_closed ? "" : std::strerror(errno);
}

}  // namespace

void replace_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    std::error_code ignored;
    const bool is_in_place = std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
    const std::string written = is_in_place ? path : path + ".part";
    std::string failure = write_bytes(written, bytes);
    if (failure.empty() && !is_in_place && std::rename(written.c_str(), path.c_str()) != 0)
        failure = std::strerror(errno);
    if (failure.empty()) return;
    if (!is_in_place) std::remove(written.c_str());
    throw InputError(path, "can't be written: " + failure + ", expected a folder with room for it");
}

}  // namespace oblong
