#pragma once

#include <cstdint>

// Files are bytes in memory: read-only ones in the archive behind the program, and those that the game makes. A folder
// exists if it contains a file, or if the game has made it.

namespace oblong::dos {

/// Linux's numbers (asm/errno.h).
enum Error : std::int32_t {
    kNoEntry = -2,
    kBadDescriptor = -9,
    kNoMemory = -12,
    kExists = -17,
    kNoFolder = -20,
    kIsFolder = -21,
    kInvalid = -22,
    kTooManyFiles = -23,
    kTooManyOpen = -24,
    kNoTerminal = -25,
    kNoSpace = -28,
    kReadOnly = -30,
    kNotEmpty = -39
};

inline constexpr std::uint32_t kNameSize = 56;
inline constexpr int kMostFiles = 256;

struct File {
    char name[kNameSize];  // without a leading slash; empty: unused
    const std::uint8_t* bytes;
    std::uint32_t size, room;  // room 0: in the archive, read-only
    bool is_folder;
    bool is_read_once;  // its memory is freed when it has been read
};

/// A normalised name: "/a/./b//c/" is "a/b/c".
struct Path {
    char name[kNameSize];
    bool is_too_long = false;
    explicit Path(const char* text);
};

File& file_of(int number);
/// The number of a file; -1: none.
int find_file(const Path& path);
bool is_folder(const Path& path);
bool has_files(const Path& folder);
/// A file's name relative to a folder; null if the file is not in it.
const char* name_in(const char* folder, const char* name);
/// The number of a new file, or an Error.
int make_file(const Path& path, bool is_folder);
void remove_file(int number);
/// Empties a file of the archive, and frees its memory but for pages that it shares with other files.
void free_archived(File& file);
void rename_file(int number, const Path& path);
/// Whether a name is in the only folder in which files can be made.
bool is_in_kept_folder(const char* name);
/// Whether a file is stored in DOS (dos_files.cpp).
bool is_kept(const File& file);
/// Gives a file room for `size` bytes; false if memory is full.
bool make_room(File& file, std::uint32_t size);

}  // namespace oblong::dos
