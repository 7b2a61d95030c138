#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>

#include "engine/platform/files.h"
#include "game/saves/save_slots.h"
#include "tests/saves/saved_walk.h"
#include "tests/support/temporary_folder.h"

// Saves by a process of their own that is stopped on the way.
namespace oblong::test {
namespace {

namespace fs = std::filesystem;

constexpr SaveSlot kSlot = SaveSlot::Quick;
constexpr int kSaved = 0, kRefused = 3, kNotTraced = 4;  // exit codes of such a process

// Runs `work` in a copy of this process; the copy's exit code says whether it threw a FileError.
pid_t start(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child != 0) return child;
    try {
        work();
        _exit(kSaved);
    } catch (const FileError&) {
        _exit(kRefused);
    } catch (...) {
        _exit(1);
    }
}

int status_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

// Lets a process that is traced make `calls` system calls, each counted where it begins and where it ends, and kills it
// there. True if it was killed, false if it ended before; then `exit_code` is its own.
bool kill_after(pid_t child, int calls, int& exit_code) {
    int status = status_of(child);
    for (int i = 0; i < calls && WIFSTOPPED(status); ++i) {
        ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
        status = status_of(child);
    }
    if (WIFEXITED(status)) {
        exit_code = WEXITSTATUS(status);
        return false;
    }
    kill(child, SIGKILL);
    status_of(child);
    return true;
}

class InterruptedSave : public testing::Test {
  protected:
    InterruptedSave() {
        slots_.save(kSlot, first_);
        slots_.save(kSlot, second_);
    }

    // Either game is there, as it was saved, and the slot can be saved to again.
    void expect_nothing_lost(const std::string& when) {
        const SlotContent content = slots_.load(kSlot);
        ASSERT_TRUE(content.game) << when;
        EXPECT_EQ(content.refusal, "") << when;
        EXPECT_TRUE(*content.game == second_ || *content.game == third_) << when;
        slots_.save(kSlot, second_);
        EXPECT_EQ(slots_.load(kSlot).game, second_) << when;
    }

    const TemporaryFolder folder_;
    const SaveSlots slots_{folder_.path()};
    const SavedGame first_ = SavedWalk(10).saved(), second_ = SavedWalk(20).saved(), third_ = SavedWalk(30).saved();
};

TEST_F(InterruptedSave, KilledAtAnySystemCallLosesNothing) {
    int exit_code = -1, calls = 0;
    while (exit_code == -1) {
        const pid_t child = start([&] {
            if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(kNotTraced);
            raise(SIGSTOP);
            slots_.save(kSlot, third_);
        });
        ++calls;
        kill_after(child, calls, exit_code);
        ASSERT_NO_FATAL_FAILURE(expect_nothing_lost("after half a call more than " + std::to_string(calls)));
        ASSERT_LT(calls, 2000);
    }
    if (exit_code == kNotTraced) GTEST_SKIP() << "processes can't be traced here";
    EXPECT_EQ(exit_code, kSaved);
    // Opening, writing, closing, twice renaming, each with a beginning and an end, are the fewest that it takes.
    EXPECT_GT(calls, 10);
}

TEST_F(InterruptedSave, ADiskThatIsFullAtAnyByteLosesNothing) {
    const rlim_t size = encode_save(third_).size();
    for (rlim_t room = 0; room <= size; room += room + 97 < size ? 97 : 1) {
        const pid_t child = start([&] {
            signal(SIGXFSZ, SIG_IGN);
            const rlimit limit{room, room};
            if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(1);
            slots_.save(kSlot, third_);
        });
        const int status = status_of(child);
        ASSERT_TRUE(WIFEXITED(status)) << room;
        ASSERT_EQ(WEXITSTATUS(status), room < size ? kRefused : kSaved) << room;
        if (room == size) break;
        EXPECT_EQ(slots_.load(kSlot).game, second_) << room;
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 2) << room << ": something was left";
    }
    EXPECT_EQ(slots_.load(kSlot).game, third_);
}

TEST_F(InterruptedSave, ADeviceThatIsFullIsNamed) {
    fs::create_symlink("/dev/full", folder_.path("quick.save.new.part"));
    try {
        slots_.save(kSlot, third_);
        FAIL() << "saved";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos) << error.what();
    }
    EXPECT_EQ(slots_.load(kSlot).game, second_);
}

}  // namespace
}  // namespace oblong::test
