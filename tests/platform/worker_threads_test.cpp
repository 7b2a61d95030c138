#include "engine/platform/worker_threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <vector>

namespace oblong::test {
namespace {

/// Notes who did each item, and reads what was written for it before it was added.
class Notes final : public SharedWork {
  public:
    explicit Notes(std::size_t items) : inputs(items), done(items), sums(items) {}

    void do_item(std::uint32_t item, int worker) override {
        if (busy[static_cast<std::size_t>(worker)].exchange(true)) ++clashes;
        ++done[item];
        sums[item] = inputs[item] * 3;
        busy[static_cast<std::size_t>(worker)] = false;
    }

    std::vector<int> inputs;
    std::vector<std::atomic<int>> done;
    std::vector<int> sums;
    std::array<std::atomic<bool>, 16> busy{};
    std::atomic<int> clashes{0};
};

TEST(WorkerThreads, DoEachItemOnce) {
    for (const int count : {1, 2, 3, 8}) {
        WorkerThreads workers(count);
        EXPECT_EQ(workers.count(), count);
        for (int round = 0; round < 50; ++round) {  // items' numbers wrap after 256
            Notes notes(40);
            workers.begin(notes);
            for (int item = 0; item < 40; ++item) {
                notes.inputs[static_cast<std::size_t>(item)] = round + item;
                workers.add_item();
                if (item % 16 == 15) workers.finish_items();
            }
            workers.finish_items();
            workers.end();
            EXPECT_EQ(notes.clashes, 0);
            for (std::size_t item = 0; item < 40; ++item) {
                EXPECT_EQ(notes.done[item], 1) << count << " workers, item " << item;
                EXPECT_EQ(notes.sums[item], (round + static_cast<int>(item)) * 3);
            }
        }
    }
}

TEST(WorkerThreads, HaveFinishedWhenItemsAre) {
    WorkerThreads workers(3);
    Notes notes(2000);
    workers.begin(notes);
    for (std::size_t item = 0; item < 2000; ++item) {
        workers.add_item();
        if (item % 100 != 99) continue;
        workers.finish_items();
        EXPECT_EQ(std::accumulate(notes.done.begin(), notes.done.end(), 0), static_cast<int>(item) + 1);
    }
    workers.end();
}

TEST(WorkerThreads, MayRestAndGoWithoutWork) {
    for (int i = 0; i < 100; ++i) {
        WorkerThreads workers(2);
        Notes notes(1);
        if (i % 3 == 0) continue;
        workers.begin(notes);
        if (i % 3 == 1) workers.add_item();
        workers.finish_items();
        workers.end();
        EXPECT_EQ(notes.done[0], i % 3 == 1);
    }
}

/// A worker that sleeps is woken.
TEST(WorkerThreads, ShareInWorkThatComesLate) {
    class Meeting final : public SharedWork {
      public:
        void do_item(std::uint32_t, int) override {
            ++here;
            while (here < 2) std::this_thread::yield();  // waits for another one
        }
        std::atomic<int> here{0};
    };
    WorkerThreads workers(2);
    for (const int wait_ms : {0, 20, 0}) {
        std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
        Meeting meeting;
        workers.begin(meeting);
        workers.add_item();
        workers.add_item();
        workers.finish_items();
        workers.end();
        EXPECT_EQ(meeting.here, 2);
    }
}

}  // namespace
}  // namespace oblong::test
