#pragma once

#include <cstdint>

// Files are bytes in memory: those of the archive behind the program, which can't be changed, and those that the game
// makes. A folder is there if a file is in it, or if the game has made it.

namespace oblong::dos {

/// As Linux numbers them (asm/errno.h).
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
    char name[kNameSize];  // without a slash in front; empty: none
    const std::uint8_t* bytes;
    std::uint32_t size, room;  // no room: of the archive
    bool is_folder;
};

/// A name as files have it: "/a/./b//c/" is "a/b/c".
struct Path {
    char name[kNameSize];
    bool is_too_long = false;
    explicit Path(const char* text);
};

File& file_of(int number);
/// -1: there is none.
int find_file(const Path& path);
bool is_folder(const Path& path);
bool has_files(const Path& folder);
/// What of a file's name comes after the folder's; null where it is not in there.
const char* name_in(const char* folder, const char* name);
/// Numbers of new files; an Error where that can't be.
int make_file(const Path& path, bool is_folder);
void remove_file(int number);
void rename_file(int number, const Path& path);
/// Whether a file outlives the game (dos_files.cpp).
bool is_kept(const File& file);
/// Whether a file's bytes can be so many.
bool make_room(File& file, std::uint32_t size);

}  // namespace oblong::dos
