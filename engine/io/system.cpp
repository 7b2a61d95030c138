#include "engine/io/system.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>

namespace oblong {

int open_file(const std::string& path, OpenMode mode) {
    constexpr int kFlags[] = {O_RDONLY | O_NONBLOCK, O_WRONLY | O_CREAT | O_TRUNC, O_WRONLY | O_CREAT | O_EXCL,
                              O_RDWR | O_CREAT | O_NONBLOCK};
    return open(path.c_str(), kFlags[static_cast<int>(mode)] | O_CLOEXEC, 0666);
}

bool close_file(int file) {
    return close(file) == 0;
}

std::FILE* stream_of(int file) {
    return fdopen(file, "rb");
}

bool seek(std::FILE* stream, std::uint64_t offset) {
    return fseeko(stream, static_cast<off_t>(offset), SEEK_SET) == 0;
}

std::int64_t write_some(int file, std::span<const std::uint8_t> bytes) {
    while (true) {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        if (count >= 0 || errno != EINTR) return count;
    }
}

bool sync_file(int file) {
    return fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP;
}

bool sync_folder(const std::string& folder) {
    const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return errno == EACCES;
    const bool is_synced = sync_file(file);
    const int why = errno;
    close(file);
    errno = why;
    return is_synced;
}

// An open file description's: two locks in one program exclude each other, too.
bool lock_byte(int file, std::int64_t byte) {
    struct flock lock = {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = static_cast<off_t>(byte);
    lock.l_len = 1;
    return fcntl(file, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES && errno != EINTR);
}

std::string program_file() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

int process_number() {
    return getpid();
}

namespace {

std::vector<char*> arguments_of(std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return arguments;
}

}  // namespace

void replace_program(std::vector<std::string> words) {
    execv(words.front().c_str(), arguments_of(words).data());
}

std::optional<int> start_program(std::vector<std::string> words, const std::string& error_file) {
    std::signal(SIGCHLD, SIG_DFL);  // a shell may have left it ignored: then no exit code would be kept
    const std::vector<char*> arguments = arguments_of(words);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, error_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    pid_t program = 0;
    const int error = posix_spawn(&program, arguments.front(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) return std::nullopt;
    return program;
}

ProgramState state_of_program(int program) {
    int status = 0;
    const pid_t ended = waitpid(program, &status, WNOHANG);
    if (ended == 0) return ProgramState::Runs;
    if (ended < 0) return ProgramState::Unknown;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? ProgramState::Succeeded : ProgramState::Failed;
}

void stop_program(int program) {
    kill(program, SIGKILL);
    waitpid(program, nullptr, 0);
}

bool is_shown_on_terminal() {
    return isatty(STDERR_FILENO) != 0;
}

void end_with_terminal() {
    if (std::signal(SIGHUP, [](int) { std::raise(SIGTERM); }) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace oblong
