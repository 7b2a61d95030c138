#include "engine/platform/worker_threads.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <vector>

namespace oblong::test {
namespace {

/// Notes who did each item, and reads what was written for it before it was added.
class Notes final : public SharedWork {
  public:
    explicit Notes(std::size_t items) : inputs(items), done(items), sums(items) {}

    void add(int input) {
        inputs[added.load(std::memory_order_relaxed)] = input;
        added.fetch_add(1, std::memory_order_release);
    }

    bool do_part(int worker) override {
        std::size_t next = taken.load(std::memory_order_relaxed);
        do {
            if (next >= added.load(std::memory_order_acquire)) return false;
        } while (!taken.compare_exchange_weak(next, next + 1, std::memory_order_relaxed));
        if (busy[static_cast<std::size_t>(worker)].exchange(true)) ++clashes;
        ++done[next];
        sums[next] = inputs[next] * 3;
        busy[static_cast<std::size_t>(worker)] = false;
        return true;
    }

    std::vector<int> inputs;
    std::vector<std::atomic<int>> done;
    std::vector<int> sums;
    std::array<std::atomic<bool>, 16> busy{};
    std::atomic<std::size_t> added{0}, taken{0};
    std::atomic<int> clashes{0};
};

TEST(WorkerThreads, DoEachItemOnce) {
    for (const int count : {1, 2, 3, 8}) {
        WorkerThreads workers(count);
        EXPECT_EQ(workers.count(), count);
        for (int round = 0; round < 300; ++round) {  // another work begins while threads leave the one before
            Notes notes(40);
            workers.begin(notes);
            for (int item = 0; item < 40; ++item) notes.add(round + item);
            workers.end();
            EXPECT_EQ(notes.clashes, 0);
            for (std::size_t item = 0; item < 40; ++item) {
                EXPECT_EQ(notes.done[item], 1) << count << " workers, item " << item;
                EXPECT_EQ(notes.sums[item], (round + static_cast<int>(item)) * 3);
            }
        }
    }
}

TEST(WorkerThreads, MayRestAndGoWithoutWork) {
    for (int i = 0; i < 100; ++i) {
        WorkerThreads workers(2);
        Notes notes(1);
        if (i % 3 == 0) continue;
        workers.begin(notes);
        if (i % 3 == 1) notes.add(1);
        workers.end();
        EXPECT_EQ(notes.done[0], i % 3 == 1);
    }
}

/// One thread holds the whole work while the others look: what it finds meanwhile is done, too.
TEST(WorkerThreads, LeaveNothingThatAThreadHeld) {
    class Held final : public SharedWork {
      public:
        bool do_part(int) override {
            if (left == 0 || is_held.exchange(true)) return false;
            if (left == 1000) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            --left;
            is_held = false;
            return true;
        }
        std::atomic<bool> is_held{false};
        std::atomic<int> left{1000};
    };
    WorkerThreads workers(3);
    for (int round = 0; round < 20; ++round) {
        Held held;
        workers.begin(held);
        while (round % 2 == 1 && held.left == 1000) std::this_thread::yield();  // another thread begins
        workers.end();
        EXPECT_EQ(held.left, 0) << "round " << round;
    }
}

/// A worker that sleeps is woken.
TEST(WorkerThreads, ShareInWorkThatComesLate) {
    class Meeting final : public SharedWork {
      public:
        bool do_part(int) override {
            if (here >= 2) return false;
            ++here;
            while (here < 2) std::this_thread::yield();  // waits for another one
            return true;
        }
        std::atomic<int> here{0};
    };
    WorkerThreads workers(2);
    for (const int wait_ms : {0, 20, 0}) {
        std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
        Meeting meeting;
        workers.begin(meeting);
        workers.end();
        EXPECT_EQ(meeting.here, 2);
    }
}

}  // namespace
}  // namespace oblong::test
