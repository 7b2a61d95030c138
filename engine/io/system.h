#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace oblong {

// All that the project asks of its operating system beyond C++, SDL and a Platform. A call that fails sets errno.

enum class OpenMode {
    Read,     ///< does not wait for the other end of a pipe
    Replace,  ///< to write; what was in it goes
    New,      ///< to write; fails with EEXIST if there is one
    Lock      ///< for lock_byte(); is made if there is none
};

/// A number for the file, -1 on failure. Programs that are started do not get it.
int open_file(const std::string& path, OpenMode mode);
bool close_file(int file);
/// The same file for reading by the standard library, which closes it; null on failure.
std::FILE* stream_of(int file);
bool seek(std::FILE* stream, std::uint64_t offset);
/// Writes at least one byte; how many. -1 on failure.
std::int64_t write_some(int file, std::span<const std::uint8_t> bytes);
/// Returns once the file is on the disk; true for file systems that cannot do that.
bool sync_file(int file);
/// The same for a folder's names; true if it may not be read.
bool sync_folder(const std::string& folder);
/// Holds a byte of a file, which need not be there, until the file is closed or the program ends. False if another
/// holder has it, in this program or another. On a file system without locks, all are granted.
bool lock_byte(int file, std::int64_t byte);

/// The running program's file; empty if the system does not tell.
std::string program_file();
int process_number();

/// Starts a program without waiting for it. words[0] is its file; its standard error is written to a file, its standard
/// output is dropped. A number for it, or nothing.
std::optional<int> start_program(std::vector<std::string> words, const std::string& error_file);
/// Runs another program in place of this one; returns if it cannot. words[0] is its file.
void replace_program(std::vector<std::string> words);
enum class ProgramState { Runs, Succeeded, Failed, Unknown };
/// Once it has ended, its number is forgotten.
ProgramState state_of_program(int program);
void stop_program(int program);

/// Whether standard error is a terminal.
bool is_shown_on_terminal();
/// A closed terminal ends the program as SIGTERM does, unless it is to outlive it; writing to what nobody reads fails.
void end_with_terminal();

}  // namespace oblong
