#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace oblong {

/// A place of a file that is held by one at a time, of all programs, until it lets go or ends, however it ends. The
/// file's bytes are not used. On a file system without locks everyone holds all places.
class FileLock {
  public:
    /// Waits so long for it; null where another still holds it then. Makes the file. Throws FileError where it can't be
    /// opened.
    static std::unique_ptr<FileLock> take(const std::string& file, std::int64_t place, int longest_wait_ms);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}

    const int descriptor_;
};

}  // namespace oblong
