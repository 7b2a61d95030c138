#include <gtest/gtest.h>

#include <thread>

#include "engine/base/input_error.h"
#include "engine/platform/worker_threads.h"
#include "tests/map/map_source.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

// Rooms in a row, each with a door to the next that is off the others' line: portals, styles and shadows.
std::string row_of_rooms(int count) {
    std::string brushes = box({-16, 0, -16}, {256 * count, 256, 0}) + box({-16, 0, 128}, {256 * count, 256, 144}) +
                          box({-16, -16, -16}, {256 * count, 0, 144}) + box({-16, 256, -16}, {256 * count, 272, 144}) +
                          box({-16, 0, 0}, {0, 256, 128});
    std::string entities = entity_at("info_player_start", {64, 64, 28});
    for (int i = 0; i < count; ++i) {
        const int x = 256 * (i + 1) - 16, gap = 32 + 37 * i % 160;
        brushes += i + 1 == count ? box({x, 0, 0}, {x + 16, 256, 128})
                                  : box({x, 0, 0}, {x + 16, gap, 128}) + box({x, gap + 48, 0}, {x + 16, 256, 128});
        brushes += prism({256 * i + 120, 128, 0}, 24, 128, 5 + i % 3);
        entities += entity_at("light", {256 * i + 60, 60, 100}, {{"style", std::to_string(i % 4)}});
    }
    return level(brushes, entities);
}

TEST(Threads, AnyNumberOfThemMakesTheSameLevel) {
    const std::string source = row_of_rooms(9);
    const std::string alone = map::to_bytes(compile(source));
    for (const int count : {1, 2, 3, 7}) {
        WorkerThreads workers(count);
        map::PortalFile portals;
        const map::CompileOptions options{.workers = &workers, .portals = &portals};
        EXPECT_EQ(map::to_bytes(compile(source, options)), alone) << count;
        EXPECT_GT(portals.count, 40u) << "as many that several batches of portals are followed";
    }
}

TEST(Threads, EachItemIsDoneOnceAndTold) {
    struct Told : map::Progress {
        void begin(const char*, std::size_t steps) override { all += steps; }
        void step(std::size_t steps) override { done += steps; }
        std::size_t all = 0, done = 0;
    } told;
    WorkerThreads workers(3);
    const map::WorkSharing sharing(&workers, &told);
    std::vector<int> times(1000, 0);
    sharing.begin("counting", times.size());
    sharing.for_each(times.size(), [&](std::size_t i) { ++times[i]; });
    EXPECT_EQ(times, std::vector<int>(1000, 1));
    EXPECT_EQ(told.done, told.all);
}

TEST(Threads, AnErrorOfAnItemIsThrownAfterAllOthers) {
    WorkerThreads workers(2);
    std::vector<int> times(100, 0);
    const auto work = [&](std::size_t i) {
        ++times[i];
        if (i == 7) throw InputError("line 7", "no");
    };
    EXPECT_THROW(map::WorkSharing(&workers, nullptr).for_each(times.size(), work), InputError);
    EXPECT_EQ(times, std::vector<int>(100, 1));
}

TEST(Threads, TheFirstItemsErrorIsThrownWhicheverComesFirst) {
    for (int times = 0; times < 50; ++times) {
        WorkerThreads workers(3);
        const auto work = [](std::size_t i) {
            if (i == 3) std::this_thread::yield();
            if (i >= 3) throw InputError("item", std::to_string(i));
        };
        ASSERT_EQ(refusal([&] { map::WorkSharing(&workers, nullptr).for_each(20, work); }), "item: 3");
    }
}

// Planes that nothing refers to are too many for version 29: BSP2 has the same level with wider numbers.
TEST(Threads, ALevelTooLargeForVersion29IsBsp2) {
    map::BspFile bsp = compile(row_of_rooms(3));
    EXPECT_EQ(map::to_bytes(bsp).substr(0, 4), std::string("\x1d\0\0\0", 4));
    const Level small = engine_level(bsp);
    bsp.planes.resize(32768, bsp.planes.front());
    EXPECT_TRUE(map::needs_bsp2(bsp));
    EXPECT_EQ(map::to_bytes(bsp).substr(0, 4), "BSP2");
    const Level large = engine_level(bsp);
    EXPECT_TRUE(large.nodes == small.nodes && large.leaves == small.leaves && large.clip_nodes == small.clip_nodes);
    EXPECT_TRUE(large.faces == small.faces && large.mark_faces == small.mark_faces);
    EXPECT_EQ(large.lighting, small.lighting);
}

}  // namespace
}  // namespace oblong::test
