#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <functional>
#include <set>

#include "game/saves/save_slots.h"
#include "tests/saves/forgetful_disk.h"
#include "tests/saves/saved_walk.h"
#include "tests/saves/traced_process.h"
#include "tests/support/folders.h"

// Saves by a process of their own that is stopped on the way.
namespace oblong::test {
namespace {

namespace fs = std::filesystem;

constexpr SaveSlot kSlot{SaveKind::Walk, 1};

class InterruptedSave : public testing::Test {
  protected:
    InterruptedSave() {
        slots_.save(kSlot, first_);
        slots_.save(kSlot, second_);
    }
    void save_third() const { slots_.save(kSlot, third_); }

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
    const SaveSlots slots_{folder_.path("saves")};
    const SavedGame first_ = SavedWalk(10).saved(), second_ = SavedWalk(20).saved(), third_ = SavedWalk(30).saved();
};

// What a full disk says, or one whose quota is used up, to each system call in turn.
TEST_F(InterruptedSave, ARefusedSystemCallLosesNothing) {
    if (!TracedProcess::kCanFailCalls) GTEST_SKIP() << "calls can't be made to fail on this processor";
    const std::set<std::uint64_t> of_files{SYS_openat, SYS_read,   SYS_write,  SYS_newfstatat, SYS_fsync,
                                           SYS_close,  SYS_rename, SYS_unlink, SYS_fcntl,      SYS_getdents64};
    int refused = 0, calls = 0;
    for (int call = -1; call < calls; ++call) {  // at first none fails
        TracedProcess process([&] { save_third(); });
        int made = 0;
        while (const auto begun = process.next())
            if (process.is_beginning() && of_files.contains(begun->number) && made++ == call)
                process.fail_call(call % 2 == 0 ? ENOSPC : EDQUOT);
        if (process.exit_code() == kNotTraced) GTEST_SKIP() << "processes can't be traced here";
        ASSERT_TRUE(process.exit_code() == kDone || process.exit_code() == kRefused) << "call " << call;
        if (call < 0) calls = made;
        refused += process.exit_code() == kRefused;
        if (process.exit_code() == kDone) {
            EXPECT_EQ(slots_.load(kSlot).game, third_) << "call " << call;
        }
        ASSERT_NO_FATAL_FAILURE(expect_nothing_lost("call " + std::to_string(call)));
    }
    EXPECT_GT(refused, 6) << "making, writing, syncing, closing the file, renaming twice, syncing the folder";
}

TEST_F(InterruptedSave, ADiskThatIsFullAtAnyByteLosesNothing) {
    const rlim_t size = encode_save(third_).size();
    for (rlim_t room = 0; room <= size; room += room + 97 < size ? 97 : 1) {
        const int status = status_of(start_process([&] {
            signal(SIGXFSZ, SIG_IGN);
            const rlimit limit{room, room};
            if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(1);
            save_third();
        }));
        ASSERT_TRUE(WIFEXITED(status)) << room;
        ASSERT_EQ(WEXITSTATUS(status), room < size ? kRefused : kDone) << room;
        if (room == size) break;
        EXPECT_EQ(slots_.load(kSlot).game, second_) << room;
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path("saves")), {}), 3)
            << room << ": something was left";
    }
    EXPECT_EQ(slots_.load(kSlot).game, third_);
}

// The power fails after each system call: what the disk may hold then is put into a folder and loaded.
class PowerCut : public InterruptedSave {
  protected:
    // Saves into a folder, which need not be there; returns how many states were tried.
    int try_all(const std::string& saves, const std::function<bool(const SlotContent&)>& is_right_before) {
        const SaveSlots slots(saves);
        ForgetfulDisk disk(folder_.path());
        TracedProcess process([&] { slots.save(kSlot, third_); });
        int states = 0;
        const auto try_losses = [&](const std::string& when, const std::function<bool(const SlotContent&)>& is_right) {
            disk.for_each_loss([&](const ForgetfulDisk::Files& files) {
                const SlotContent content = loaded(files, saves);
                EXPECT_TRUE(is_right(content)) << when << ": " << content.refusal;
                ++states;
            });
        };
        int calls = 0;
        while (const auto call = process.next())
            if (!process.is_beginning() && disk.note(*call) && !HasFailure())
                try_losses("call " + std::to_string(++calls), is_right_before);
        EXPECT_EQ(process.exit_code(), kDone);
        try_losses("at the end", [&](const SlotContent& content) { return content.game == third_; });
        return states;
    }

  private:
    SlotContent loaded(const ForgetfulDisk::Files& files, const std::string& saves) const {
        const TemporaryFolder after;
        for (const auto& [name, bytes] : files)
            if (fs::path(name).parent_path() == saves) after.write(fs::path(name).filename().string(), bytes);
        return SaveSlots(after.path()).load(kSlot);
    }
};

TEST_F(PowerCut, LosesNothingOfASlotThatHasSaves) {
    const int states = try_all(folder_.path("saves"), [&](const SlotContent& content) {
        return content.game == second_ || content.game == third_;
    });
    EXPECT_GT(states, 50);
}

TEST_F(PowerCut, LeavesAFirstSaveWholeOrNone) {
    const int states = try_all(folder_.path("made/with/saves"), [&](const SlotContent& content) {
        return content.game == third_ || (!content.game && content.refusal.empty());
    });
    EXPECT_GT(states, 50);
}

// Each saves a walk of its own, and all to one slot.
TEST_F(InterruptedSave, SeveralProgramsAtOnceAllSave) {
    constexpr int kPrograms = 4, kTimes = 25;
    constexpr SaveSlot kShared{SaveKind::Numbered, 1};
    std::vector<pid_t> programs;
    for (int program = 0; program < kPrograms; ++program)
        programs.push_back(start_process([&] {
            const HeldWalk walk = slots_.hold_new();
            const SavedGame mine = SavedWalk(walk.number).saved();
            for (int i = 0; i < kTimes; ++i) {
                slots_.save({SaveKind::Walk, walk.number}, mine);
                slots_.save(kShared, mine);
                if (slots_.load({SaveKind::Walk, walk.number}).game != mine || !slots_.load(kShared).game) _exit(1);
            }
        }));
    for (const pid_t program : programs) EXPECT_EQ(status_of(program), kDone);
    int walks = 0;
    for (const ListedSlot& content : slots_.list()) {
        if (content.slot.kind != SaveKind::Walk || content.slot == kSlot) continue;
        ++walks;
        EXPECT_EQ(slots_.load(content.slot).game, SavedWalk(content.slot.number).saved());
    }
    EXPECT_EQ(walks, kPrograms);
}

}  // namespace
}  // namespace oblong::test
