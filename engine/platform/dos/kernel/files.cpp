#include "engine/platform/dos/kernel/file_table.h"
#include "engine/platform/dos/kernel/kernel.h"

// Linux's system calls for files.

namespace oblong::dos {
namespace {

constexpr int kMostOpen = 32, kStandardFiles = 3;

struct Open {
    int file = -1;  // number of a file; -1: closed
    std::uint32_t at = 0;
};
Open opened[kMostOpen];

std::int32_t open(const char* name, std::uint32_t flags) {
    constexpr std::uint32_t kWrites = 3, kCreates = 0100, kMustBeNew = 0200, kTruncates = 01000;
    const Path path(name);
    int file = find_file(path);
    const bool writes = (flags & kWrites) != 0;
    if (file >= 0 && (flags & kMustBeNew) != 0) return kExists;
    if (file >= 0 && writes && file_of(file).room == 0) return kReadOnly;
    if (file < 0 && is_folder(path)) {
        if (writes) return kIsFolder;
        file = make_file(path, true);
    }
    if (file < 0 && (flags & kCreates) == 0) return kNoEntry;
    if (file < 0 && !is_in_kept_folder(path.name)) return kReadOnly;
    if (file < 0) file = make_file(path, false);
    if (file < 0) return file;
    if ((flags & kTruncates) != 0) file_of(file).size = 0;
    for (int i = kStandardFiles; i < kMostOpen; ++i) {
        if (opened[i].file >= 0) continue;
        opened[i] = {file, 0};
        return i;
    }
    return kTooManyOpen;
}

Open* open_file(std::uint32_t descriptor) {
    const bool is_open = descriptor >= kStandardFiles && descriptor < kMostOpen && opened[descriptor].file >= 0;
    return is_open ? &opened[descriptor] : nullptr;
}

std::int32_t read(std::uint32_t descriptor, void* to, std::uint32_t size) {
    Open* const open = open_file(descriptor);
    if (open == nullptr) return descriptor == 0 ? 0 : kBadDescriptor;
    const File& file = file_of(open->file);
    if (file.is_folder) return kIsFolder;
    const std::uint32_t left = open->at < file.size ? file.size - open->at : 0;
    if (size > left) size = left;
    memcpy(to, file.bytes + open->at, size);
    open->at += size;
    return static_cast<std::int32_t>(size);
}

std::int32_t write(std::uint32_t descriptor, const char* from, std::uint32_t size) {
    if (descriptor == 1 || descriptor == 2) {
        for (std::uint32_t i = 0; i < size; ++i) put(from[i]);
        return static_cast<std::int32_t>(size);
    }
    Open* const open = open_file(descriptor);
    if (open == nullptr) return kBadDescriptor;
    File& file = file_of(open->file);
    if (!make_room(file, open->at + size)) return kNoMemory;
    memcpy(const_cast<std::uint8_t*>(file.bytes) + open->at, from, size);
    open->at += size;
    if (open->at > file.size) file.size = open->at;
    return static_cast<std::int32_t>(size);
}

std::int32_t close(std::uint32_t descriptor) {
    Open* const open = open_file(descriptor);
    if (open == nullptr) return 0;
    File& file = file_of(open->file);
    if (file.is_read_once && open->at == file.size) free_archived(file);
    open->file = -1;
    return 0;
}

struct Piece {
    char* bytes;
    std::uint32_t size;
};
template <class Do>
std::int32_t each_piece(const Registers& registers, Do do_one) {
    const auto* const pieces = reinterpret_cast<const Piece*>(registers.ecx);
    std::int32_t all = 0;
    for (std::uint32_t i = 0; i < registers.edx; ++i) {
        const std::int32_t done = do_one(registers.ebx, pieces[i].bytes, pieces[i].size);
        if (done < 0) return done;
        all += done;
    }
    return all;
}

// Linux's _llseek: a 64-bit position, also written to the address in esi.
std::int32_t seek(const Registers& registers) {
    Open* const open = open_file(registers.ebx);
    if (open == nullptr) return registers.ebx < kStandardFiles ? -29 : kBadDescriptor;
    std::uint32_t at = registers.edx;
    if (registers.edi == 1) at += open->at;
    if (registers.edi == 2) at += file_of(open->file).size;
    open->at = at;
    auto* const place = reinterpret_cast<std::uint32_t*>(registers.esi);
    place[0] = at;
    place[1] = 0;
    return 0;
}

// Fills the result of statx() (linux/stat.h): kind and size are enough.
std::int32_t describe(const Registers& registers) {
    constexpr std::uint16_t kFile = 0100644, kFolder = 0040755, kDevice = 0020620;
    const auto* const name = reinterpret_cast<const char*>(registers.ecx);
    auto* const to = reinterpret_cast<std::uint8_t*>(registers.edi);
    std::uint16_t mode = kDevice;
    std::uint32_t size = 0;
    int file = -1;
    if (name != nullptr && *name != 0) {
        const Path path(name);
        file = find_file(path);
        if (file < 0 && !is_folder(path)) return kNoEntry;
        if (file < 0) mode = kFolder;
    } else if (const Open* const open = open_file(registers.ebx)) {
        file = open->file;
    }
    if (file >= 0) {
        mode = file_of(file).is_folder ? kFolder : kFile;
        size = file_of(file).size;
    }
    memset(to, 0, 256);
    constexpr std::uint32_t kBasic = 0x7ff;
    *reinterpret_cast<std::uint32_t*>(to) = kBasic;
    *reinterpret_cast<std::uint32_t*>(to + 4) = 512;
    *reinterpret_cast<std::uint32_t*>(to + 16) = 1;
    *reinterpret_cast<std::uint16_t*>(to + 28) = mode;
    *reinterpret_cast<std::uint32_t*>(to + 32) = static_cast<std::uint32_t>(file + 2);  // the inode's number
    *reinterpret_cast<std::uint32_t*>(to + 40) = size;
    return 0;
}

std::int32_t rename(const char* from, const char* to) {
    const Path source(from), target(to);
    const int file = find_file(source);
    if (file < 0) return kNoEntry;
    if (file_of(file).room == 0) return kReadOnly;
    const int former = find_file(target);
    if (former == file) return 0;
    // Hides the old file; it is removed when DOS has the new one.
    char none = 0;
    char& former_start = former < 0 ? none : file_of(former).name[0];
    const char letter = former_start;
    former_start = 0;
    rename_file(file, target);
    const std::int32_t error = is_kept(file_of(file)) ? keep_files() : 0;
    former_start = letter;
    if (error != 0)
        rename_file(file, source);
    else if (former >= 0)
        remove_file(former);
    return error;
}

std::int32_t unlink(const char* name, bool is_of_folder) {
    const Path path(name);
    const int file = find_file(path);
    if (file < 0) return kNoEntry;
    if (file_of(file).is_folder != is_of_folder) return is_of_folder ? kNoFolder : kIsFolder;
    if (file_of(file).room == 0) return kReadOnly;
    if (is_of_folder && has_files(path)) return kNotEmpty;
    const bool was_kept = is_kept(file_of(file));
    remove_file(file);
    return was_kept ? keep_files() : 0;
}

std::int32_t make_folder(const char* name) {
    const Path path(name);
    if (find_file(path) >= 0 || is_folder(path)) return kExists;
    const int made = make_file(path, true);
    return made < 0 ? made : 0;
}

// getdents64: a folder's files, and its folders that the game has made.
std::int32_t list(const Registers& registers) {
    struct Entry {
        std::uint64_t inode, next;
        std::uint16_t size;
        std::uint8_t kind;
        char name[1];
    };
    constexpr std::uint8_t kFolder = 4, kFile = 8;
    constexpr std::uint32_t kHead = 19;
    Open* const open = open_file(registers.ebx);
    if (open == nullptr) return kBadDescriptor;
    if (!file_of(open->file).is_folder) return kNoFolder;
    std::uint32_t size = 0;
    for (; open->at < kMostFiles; ++open->at) {
        const File& file = file_of(open->at);
        const char* const name = file.name[0] == 0 ? nullptr : name_in(file_of(open->file).name, file.name);
        if (name == nullptr) continue;
        std::uint32_t length = 0;
        while (name[length] != 0 && name[length] != '/') ++length;
        if (name[length] == '/') continue;
        const std::uint32_t entry_size = (kHead + length + 1 + 7) & ~7u;
        if (size + entry_size > registers.edx) break;
        auto* const entry = reinterpret_cast<Entry*>(registers.ecx + size);
        entry->inode = open->at + 2;
        entry->next = open->at + 1;
        entry->size = static_cast<std::uint16_t>(entry_size);
        entry->kind = file.is_folder ? kFolder : kFile;
        memcpy(entry->name, name, length);
        entry->name[length] = 0;
        size += entry_size;
    }
    return static_cast<std::int32_t>(size);
}

}  // namespace

std::int32_t system_call_of_files(const Registers& registers, bool& is_known) {
    const auto text = [](std::uint32_t address) { return reinterpret_cast<const char*>(address); };
    const std::uint32_t b = registers.ebx, c = registers.ecx, d = registers.edx;
    switch (registers.eax) {
        case 3:
            return read(b, reinterpret_cast<void*>(c), d);
        case 4:
            return write(b, text(c), d);
        case 5:
            return open(text(b), c);
        case 295:
            return open(text(c), d);  // openat
        case 6:
            return close(b);
        case 10:
            return unlink(text(b), false);
        case 301:
            return unlink(text(c), (d & 0x200) != 0);  // unlinkat
        case 40:
            return unlink(text(b), true);  // rmdir
        case 33:
            return find_file(Path(text(b))) >= 0 || is_folder(Path(text(b))) ? 0 : kNoEntry;  // access
        case 38:
            return rename(text(b), text(c));
        case 302:
        case 353:
            return rename(text(c), text(registers.esi));  // renameat
        case 39:
            return make_folder(text(b));
        case 296:
            return make_folder(text(c));
        case 140:
            return seek(registers);
        case 145:
            return each_piece(registers, [](auto fd, char* at, auto size) { return read(fd, at, size); });
        case 146:
            return each_piece(registers, [](auto fd, char* at, auto size) { return write(fd, at, size); });
        case 183:
            *reinterpret_cast<char*>(b) = '/', reinterpret_cast<char*>(b)[1] = 0;
            return 2;  // getcwd
        case 220:
            return list(registers);
        case 383:
            return describe(registers);  // statx
        default:
            is_known = false;
            return 0;
    }
}

}  // namespace oblong::dos
