#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/io/files.h"

namespace oblong::test {

/// Exit codes of a copy of this process that does some work: it was done, or threw a FileError.
inline constexpr int kDone = 0, kRefused = 3, kNotTraced = 4;

inline pid_t start_process(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child != 0) return child;
    try {
        work();
        _exit(kDone);
    } catch (const FileError&) {
        _exit(kRefused);
    } catch (...) {
        _exit(1);
    }
}

inline int status_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

/// A system call of a process, with what its first arguments point to where that is a name.
struct SystemCall {
    std::uint64_t number = 0, arguments[6] = {};
    std::int64_t result = 0;
    std::string path, second_path;
    std::vector<std::uint8_t> data;  ///< of a write
};

/// A copy of this process that stops before and after each system call that its work makes.
class TracedProcess {
  public:
    explicit TracedProcess(const std::function<void()>& work) {
        child_ = start_process([&] {
            if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(kNotTraced);
            raise(SIGSTOP);
            work();
        });
        status_ = status_of(child_);
        if (is_stopped()) ptrace(PTRACE_SETOPTIONS, child_, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    }
    ~TracedProcess() { end(); }
    TracedProcess(const TracedProcess&) = delete;
    TracedProcess& operator=(const TracedProcess&) = delete;

    bool is_stopped() const { return WIFSTOPPED(status_); }
    /// Of one that has ended.
    int exit_code() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

    /// To the next stop; then the call that begins there, or ended there (with its result), or nothing after the end.
    std::optional<SystemCall> next() {
        ptrace(PTRACE_SYSCALL, child_, nullptr, nullptr);
        status_ = status_of(child_);
        if (!is_stopped()) return {};
        __ptrace_syscall_info info = {};
        ptrace(static_cast<__ptrace_request>(PTRACE_GET_SYSCALL_INFO), child_, sizeof info, &info);
        is_beginning_ = info.op == PTRACE_SYSCALL_INFO_ENTRY;
        if (is_beginning_) {
            call_ = {};
            call_.number = info.entry.nr;
            for (int i = 0; i < 6; ++i) call_.arguments[i] = info.entry.args[i];
            read_arguments();
        } else {
            call_.result = info.exit.rval;
        }
        return call_;
    }
    bool is_beginning() const { return is_beginning_; }

#ifdef __x86_64__
    static constexpr bool kCanFailCalls = true;
    /// The call that begins here is not made, and fails so.
    void fail_call(int error) {
        set_register(offsetof(user_regs_struct, orig_rax), ~std::uint64_t{0});
        next();
        set_register(offsetof(user_regs_struct, rax), static_cast<std::uint64_t>(-std::int64_t{error}));
    }
#else
    static constexpr bool kCanFailCalls = false;
    void fail_call(int) {}
#endif

    void end() {
        if (!is_stopped()) return;
        kill(child_, SIGKILL);
        status_ = status_of(child_);
    }

  private:
    void set_register(std::size_t offset, std::uint64_t value) {
        ptrace(PTRACE_POKEUSER, child_, offset, reinterpret_cast<void*>(value));
    }
    std::vector<std::uint8_t> memory(std::uint64_t address, std::size_t size) const {
        std::vector<std::uint8_t> bytes(size);
        iovec here{bytes.data(), size}, there{reinterpret_cast<void*>(address), size};
        const ssize_t count = process_vm_readv(child_, &here, 1, &there, 1, 0);
        bytes.resize(static_cast<std::size_t>(count < 0 ? 0 : count));
        return bytes;
    }
    std::string text(std::uint64_t address) const {
        std::string read;
        for (;; ++address) {
            const std::vector<std::uint8_t> letter = memory(address, 1);
            if (letter.empty() || letter[0] == 0) return read;
            read += static_cast<char>(letter[0]);
        }
    }
    void read_arguments() {
        // Which arguments of a call are names.
        static const std::map<std::uint64_t, std::vector<std::size_t>> kNames{
            {SYS_openat, {1}},      {SYS_mkdirat, {1}},      {SYS_unlinkat, {1}},
            {SYS_renameat, {1, 3}}, {SYS_renameat2, {1, 3}},
#ifdef SYS_rename
            {SYS_mkdir, {0}},       {SYS_unlink, {0}},       {SYS_rename, {0, 1}},
#endif
        };
        if (call_.number == SYS_write) call_.data = memory(call_.arguments[1], call_.arguments[2]);
        const auto found = kNames.find(call_.number);
        if (found == kNames.end()) return;
        call_.path = text(call_.arguments[found->second[0]]);
        if (found->second.size() > 1) call_.second_path = text(call_.arguments[found->second[1]]);
    }

    pid_t child_ = 0;
    int status_ = 0;
    bool is_beginning_ = false;
    SystemCall call_;
};

}  // namespace oblong::test
