#include "engine/io/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "engine/base/table.h"
#include "engine/io/system.h"

namespace oblong {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reason() {
    return std::strerror(errno);
}

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as in Linux
constexpr const char* kNoRegularFile = "is no regular file, expected one";

// errno's message if a call failed, else empty.
std::string reason_unless(bool is_done) {
    return is_done ? "" : reason();
}

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string write_all(int file, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const std::int64_t count = write_some(file, bytes);
        if (count < 0) return reason();
        bytes = bytes.subspan(as_size(count));
    }
    return {};
}

// Takes ownership of an open file, or -1.
std::string write_and_close(int file, std::span<const std::uint8_t> bytes, bool is_synced) {
    if (file < 0) return reason();
    std::string failure = write_all(file, bytes);
    if (failure.empty() && is_synced) failure = reason_unless(sync_file(file));
    const std::string of_closing = reason_unless(close_file(file));
    return failure.empty() ? of_closing : failure;
}

// Creates a new file beside another; `name` becomes its name. -1 on failure.
int open_unfinished(const std::string& path, std::string& name) {
    for (int number = 0;; ++number) {
        name = path + "." + std::to_string(process_number()) + "-" + std::to_string(number) + kUnfinishedExtension;
        const int file = open_file(name, OpenMode::New);
        if (file >= 0 || errno != EEXIST) return file;
    }
}

// Writes such a file, then calls finish(its name), which returns an error or "". On an error, the file is removed.
template <class Finish>
std::string write_beside(const std::string& path, std::span<const std::uint8_t> bytes, bool is_synced, Finish finish) {
    std::string name;
    const int file = open_unfinished(path, name);
    if (file < 0) return reason();
    std::string failure = write_and_close(file, bytes, is_synced);
    if (failure.empty()) failure = finish(name);
    if (!failure.empty()) std::remove(name.c_str());
    return failure;
}

std::string rename_file(const std::string& from, const std::string& to) {
    return reason_unless(std::rename(from.c_str(), to.c_str()) == 0);
}

[[noreturn]] void refuse_writing(const std::string& path, const std::string& failure, std::size_t size) {
    throw FileError(path, "write", failure + ", expected a place for a file of " + std::to_string(size) + " bytes");
}

// Open files of a process, by number: they may have another name or none.
bool is_open_file(const std::string& path) {
    const std::string folder = folder_of(path);
    return folder.starts_with("/proc/") || folder == "/dev/fd";
}

bool is_written_in_place(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_regular_file(status)) return is_open_file(end_of_links(path));
    return fs::exists(status) && !fs::is_directory(status);
}

// A regular file; nothing else is opened, as that may wait, or do something.
File open_regular(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) throw FileError(path, "open", "is a folder, expected a file");
    if (fs::exists(status) && !fs::is_regular_file(status)) throw FileError(path, "open", kNoRegularFile);
    const int number = open_file(path, OpenMode::Read);  // a pipe may have come meanwhile
    File file(number < 0 ? nullptr : stream_of(number));
    if (!file) throw FileError(path, "open", reason() + ", expected a readable file");
    return file;
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::string& path, std::size_t most_bytes) {
    const File file = open_regular(path);
    constexpr std::size_t kChunk = std::size_t{1} << 16;
    const std::unique_ptr<std::uint8_t[]> chunk(new std::uint8_t[kChunk]);
    std::vector<std::uint8_t> bytes;
    std::error_code ignored;
    const std::uintmax_t size = fs::file_size(path, ignored);
    if (size <= most_bytes) bytes.reserve(static_cast<std::size_t>(size));  // growing would take twice the memory
    while (const std::size_t count = std::fread(chunk.get(), 1, kChunk, file.get())) {
        if (count > most_bytes - bytes.size())
            throw FileError(path, "size",
                            "more than " + std::to_string(most_bytes) + " bytes, expected a smaller file");
        bytes.insert(bytes.end(), chunk.get(), chunk.get() + count);
    }
    if (std::ferror(file.get())) throw FileError(path, "read", reason() + ", expected a readable file");
    return bytes;
}

std::vector<std::uint8_t> read_file_part(const std::string& path, std::uint64_t offset, std::size_t length) {
    const File file = open_regular(path);
    std::error_code ignored;
    const std::uint64_t size = std::filesystem::file_size(path, ignored);
    if (offset > size || length > size - offset)
        throw FileError(
            path, "offset " + std::to_string(offset),
            "the file has " + std::to_string(size) + " bytes, expected " + std::to_string(length) + " from here on");
    std::vector<std::uint8_t> bytes(length);
    if (!seek(file.get(), offset) || std::fread(bytes.data(), 1, length, file.get()) != length)
        throw FileError(path, "read", "expected a readable file");
    return bytes;
}

std::string read_text(const std::string& path) {
    const std::vector<std::uint8_t> bytes = read_file(path);
    return {bytes.begin(), bytes.end()};
}

std::string end_of_links(const std::string& path) {
    std::string at = path;
    std::error_code error;
    for (int links = 0; links <= kMostLinks; ++links) {
        if (fs::symlink_status(at, error).type() != fs::file_type::symlink || is_open_file(at)) return at;
        at = (fs::path(at).parent_path() / fs::read_symlink(at, error)).string();
    }
    throw FileError(path, "open", "its symbolic links form a loop, expected a path that ends at a file");
}

void write_file(const std::string& path, std::span<const std::uint8_t> bytes, FileUse use) {
    std::string failure;
    if (is_written_in_place(path)) {
        if (use == FileUse::Kept) throw FileError(path, "write", kNoRegularFile);
        failure = write_and_close(open_file(path, OpenMode::Replace), bytes, false);
    } else {
        const std::string end = end_of_links(path);
        std::error_code ignored;
        const bool is_synced = use == FileUse::Kept || fs::exists(end, ignored);
        failure = write_beside(end, bytes, is_synced, [&](const std::string& name) { return rename_file(name, end); });
        if (failure.empty() && use == FileUse::Kept) failure = reason_unless(sync_folder(folder_of(end)));
    }
    if (!failure.empty()) refuse_writing(path, failure, bytes.size());
}

void replace_file(const std::string& path, const std::string& former_path, std::span<const std::uint8_t> bytes) {
    std::string failure = write_beside(path, bytes, true, [&](const std::string& name) {
        const std::string of_former = rename_file(path, former_path);
        return of_former.empty() ? rename_file(name, path) : of_former;
    });
    if (failure.empty()) failure = reason_unless(sync_folder(folder_of(path)));
    if (!failure.empty()) refuse_writing(path, failure, bytes.size());
}

void check_writable(const std::string& path) {
    std::error_code ignored;
    const std::string folder = folder_of(path);
    if (fs::is_directory(path, ignored)) throw FileError(path, "write", "is a folder, expected a file");
    if (!fs::is_directory(folder, ignored))
        throw FileError(path, "write", folder + " is no folder, expected a folder for the file");
}

void remove_files(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
        std::string failure = reason_unless(std::remove(path.c_str()) == 0 || errno == ENOENT);
        if (failure.empty()) failure = reason_unless(sync_folder(folder_of(path)));
        if (!failure.empty()) throw FileError(path, "remove", failure + ", expected a file that may be removed");
    }
}

void write_file(const std::string& path, const std::string& text, FileUse use) {
    write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), use);
}

void flush_standard_output() {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    const std::string why = errno == 0 ? "failed" : reason();
    throw FileError("standard output", "write", why + ", expected it to be writable");
}

bool stays_below(const std::string& path) {
    const fs::path each = path;
    return !each.empty() && each.is_relative() && std::find(each.begin(), each.end(), "..") == each.end();
}

bool leads_out(const std::string& folder, const std::string& name) {
    if (!stays_below(name)) return true;
    std::error_code error;
    const fs::path top = fs::canonical(folder.empty() ? "." : folder, error), end = fs::canonical(top / name, error);
    return !error && !stays_below(end.lexically_relative(top).string());
}

std::string find_below(const std::vector<std::string>& folders, const std::string& name) {
    std::error_code ignored;
    for (const std::string& folder : folders)
        if (const fs::path file = fs::path(folder) / name;
            !leads_out(folder, name) && fs::is_regular_file(file, ignored))
            return file.lexically_normal().string();
    return {};
}

void make_folder(const std::string& path) {
    std::error_code error, ignored;
    std::vector<std::string> made;
    for (std::string each = path; !fs::is_directory(each, ignored) && folder_of(each) != each; each = folder_of(each))
        made.push_back(each);
    fs::create_directories(path, error);
    std::string failure = error ? error.message() : "";
    for (const std::string& each : made)
        if (failure.empty()) failure = reason_unless(sync_folder(folder_of(each)));
    if (!failure.empty()) throw FileError(path, "make folder", failure + ", expected a place for a folder");
}

}  // namespace oblong
