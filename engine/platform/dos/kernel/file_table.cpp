#include "engine/platform/dos/kernel/file_table.h"

#include "engine/platform/dos/kernel/kernel.h"

namespace oblong::dos {
namespace {

/// An entry of the archive.
struct ArchivedFile {
    char name[kNameSize];
    std::uint32_t offset, size;  ///< from the archive's beginning
};

File files[kMostFiles];

bool are_equal(const char* a, const char* b) {
    for (; *a != 0 && *a == *b; ++a, ++b) {
    }
    return *a == *b;
}

void copy_name(const char* from, char* to) {
    std::uint32_t i = 0;
    for (; i + 1 < kNameSize && from[i] != 0; ++i) to[i] = from[i];
    while (i > 0 && to[i - 1] == '/') --i;
    to[i] = 0;
}

}  // namespace

Path::Path(const char* text) {
    std::uint32_t size = 0;
    while (*text != 0) {
        if (*text == '/' ||
            (*text == '.' && (text[1] == '/' || text[1] == 0) && (size == 0 || name[size - 1] == '/'))) {
            if (*text == '/' && size > 0 && name[size - 1] != '/') name[size++] = '/';
            ++text;
            continue;
        }
        if (size + 2 >= kNameSize) {
            is_too_long = true;
            break;
        }
        name[size++] = *text++;
    }
    while (size > 0 && name[size - 1] == '/') --size;
    name[size] = 0;
}

File& file_of(int number) {
    return files[number];
}

int find_file(const Path& path) {
    for (int i = 0; i < kMostFiles; ++i)
        if (files[i].name[0] != 0 && are_equal(files[i].name, path.name)) return i;
    return -1;
}

const char* name_in(const char* folder, const char* name) {
    if (*folder == 0) return *name == 0 ? nullptr : name;
    for (; *folder != 0; ++folder, ++name)
        if (*folder != *name) return nullptr;
    return *name == '/' ? name + 1 : nullptr;
}

bool has_files(const Path& folder) {
    for (const File& each : files)
        if (each.name[0] != 0 && name_in(folder.name, each.name) != nullptr) return true;
    return false;
}

bool is_folder(const Path& path) {
    if (path.name[0] == 0) return true;
    const int file = find_file(path);
    return file >= 0 ? files[file].is_folder : has_files(path);
}

int make_file(const Path& path, bool is_folder) {
    if (path.is_too_long) return kInvalid;
    for (int i = 0; i < kMostFiles; ++i) {
        if (files[i].name[0] != 0) continue;
        files[i] = {};
        copy_name(path.name, files[i].name);
        files[i].is_folder = is_folder;
        files[i].room = 1;  // marks it as writable
        return i;
    }
    return kTooManyFiles;
}

void remove_file(int number) {
    File& file = files[number];
    if (file.room > 1) free_pages(file.bytes, file.room);
    file.name[0] = 0;
}

void free_archived(File& file) {
    if (file.size == 0) return;
    const auto address = [](const File& of) { return reinterpret_cast<std::uint32_t>(of.bytes); };
    const std::uint32_t end = address(file) + file.size;
    std::uint32_t first_page = address(file) & ~(kPage - 1), end_page = whole_pages(end);
    file.size = 0;
    for (const File& other : files) {
        if (other.name[0] == 0 || other.room != 0 || other.size == 0) continue;
        const std::uint32_t other_end = address(other) + other.size;
        if (other_end < end && other_end > first_page) first_page = whole_pages(other_end);
        if (address(other) >= end && address(other) < end_page) end_page = address(other) & ~(kPage - 1);
    }
    if (first_page < end_page) free_pages(reinterpret_cast<void*>(first_page), end_page - first_page);
}

void rename_file(int number, const Path& path) {
    copy_name(path.name, files[number].name);
}

bool make_room(File& file, std::uint32_t size) {
    if (size <= file.room) return true;
    const std::uint32_t room = whole_pages(size + size / 2);
    auto* const bytes = static_cast<std::uint8_t*>(take_pages(room));
    if (bytes == nullptr) return false;
    memcpy(bytes, file.bytes, file.size);
    if (file.room > 1) free_pages(file.bytes, file.room);
    file.bytes = bytes;
    file.room = room;
    return true;
}

void start_files(const std::uint8_t* archive) {
    const auto* const head = reinterpret_cast<const std::uint32_t*>(archive);
    const std::uint32_t count = head[0], read_once = head[2];
    const auto* const archived = reinterpret_cast<const ArchivedFile*>(archive + 64);
    for (std::uint32_t i = 0; i < count && i < kMostFiles; ++i) {
        copy_name(archived[i].name, files[i].name);
        files[i].bytes = archive + archived[i].offset;
        files[i].size = archived[i].size;
        files[i].is_read_once = i < read_once;
    }
}

}  // namespace oblong::dos
