#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace oblong {

/// An exclusive lock on a byte position of a file, among all programs; it is released when its holder ends, in any way.
/// The file's bytes are not used. On a file system without locks, all locks are granted.
class FileLock {
  public:
    /// Waits for at most `longest_wait_ms`; null if the lock is still held. Creates the file. Throws FileError if it
    /// cannot be opened.
    static std::unique_ptr<FileLock> take(const std::string& file, std::int64_t place, int longest_wait_ms);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}

    const int descriptor_;
};

}  // namespace oblong
