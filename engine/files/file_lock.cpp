#include "engine/files/file_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "engine/files/files.h"

namespace oblong {
namespace {

// Open file description locks: two locks in one program exclude each other too.
bool is_held_by_another(int descriptor, std::int64_t place) {
    struct flock lock = {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = place;
    lock.l_len = 1;
    return fcntl(descriptor, F_OFD_SETLK, &lock) != 0 && (errno == EAGAIN || errno == EACCES || errno == EINTR);
}

}  // namespace

std::unique_ptr<FileLock> FileLock::take(const std::string& file, std::int64_t place, int longest_wait_ms) {
    constexpr int kPause_ms = 5;
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
    if (descriptor < 0)
        throw FileError(file, "open", std::strerror(errno) + std::string(", expected a place for a lock"));
    std::unique_ptr<FileLock> lock(new FileLock(descriptor));
    for (int waited_ms = 0; is_held_by_another(descriptor, place); waited_ms += kPause_ms) {
        if (waited_ms >= longest_wait_ms) return nullptr;
        std::this_thread::sleep_for(std::chrono::milliseconds(kPause_ms));
    }
    return lock;
}

FileLock::~FileLock() {
    close(descriptor_);
}

}  // namespace oblong
