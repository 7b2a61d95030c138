#include <algorithm>
#include <vector>

#include "tests/support/folders.h"
#include "tests/walk/walked_level.h"

namespace oblong::test {
namespace {

using TitleToEnd = WalkedLevel;

// Enter on the title's "Walk" starts the demo that is to be replayed; what the program records of it is that demo, to
// the end of the level.
TEST_F(TitleToEnd, TheRecordedWalkGoesThroughTheWholeProgram) {
    Options options;
    options.replay = test::build_folder() + "/assets/walk.demo";
    options.preferences.game_speed_100 = 800;
    const Demo walk = decode_demo(read_file(options.replay));
    constexpr std::int64_t kTitlePolls = 20, kEndPolls = 20;
    const auto polls = kTitlePolls + static_cast<std::int64_t>(walk.ticks.size()) / 8 + kEndPolls;
    ScriptedPlatform platform(polls,
                              [&](std::int64_t poll) { return poll == kTitlePolls ? accept() : PlatformInput{}; });

    Demo recorded = record(options, platform);
    // The last frame of the walk may hold some ticks more than the demo.
    ASSERT_GE(recorded.ticks.size(), walk.ticks.size());
    EXPECT_LT(recorded.ticks.size(), walk.ticks.size() + 8) << "the end's page does not stop the game";
    expect_all_found(replayed(recorded));
    recorded.ticks.resize(walk.ticks.size());
    EXPECT_EQ(recorded, walk);
}

// Keeps what is presented, as a number, and the brightest that black became.
class WatchedPlatform final : public ScriptedPlatform {
  public:
    explicit WatchedPlatform(std::int64_t polls)
        : ScriptedPlatform(polls, [](std::int64_t) { return PlatformInput{}; }) {}

    void present(Framebuffer canvas, const Palette& palette, const PresentRect&) override {
        std::uint64_t hash = 0;
        for (std::int32_t y = 0; y < canvas.height_px; ++y)
            for (std::int32_t x = 0; x < canvas.width_px; ++x) hash = hash * 1'099'511'628'211u + canvas.row(y)[x];
        pictures.push_back(hash);
        brightest_black = std::max(brightest_black, palette.colours[0].red);
    }

    std::vector<std::uint64_t> pictures;
    std::uint8_t brightest_black = 0;
};

TEST_F(TitleToEnd, TheTitleShowsTheWalkUntilTheLastLensAndNoFlash) {
    Options options;
    options.shows_title = true;
    constexpr std::int64_t kTicksPerPoll = 4;
    options.preferences.game_speed_100 = 100 * kTicksPerPoll;
    const Demo walk = decode_demo(read_file(test::build_folder() + "/assets/walk.demo"));
    std::int64_t found_all_at = 0;
    GameState state = start_of(level_);
    for (const DemoTick& tick : walk.ticks) {
        step(level_, state, tick.input);
        const ItemCount lenses = count_items(level_, state, ItemClass::Lens);
        if (lenses.taken < lenses.all) found_all_at = state.tick;
    }
    ASSERT_LT(found_all_at, state.tick - 20 * kTicksPerSecond) << "the tower is the rest of the walk";

    WatchedPlatform platform(state.tick / kTicksPerPoll);
    PreferencesStore store;
    Program(options, load_program_files(options, assets_), store, platform, nullptr).run();
    ASSERT_EQ(platform.pictures.size(), static_cast<std::size_t>(state.tick / kTicksPerPoll));
    const auto again = std::find(platform.pictures.begin() + 100, platform.pictures.end(), platform.pictures[20]);
    ASSERT_NE(again, platform.pictures.end()) << "it does not begin again";
    EXPECT_NEAR(static_cast<double>(again - platform.pictures.begin() - 20) * kTicksPerPoll,
                static_cast<double>(found_all_at), 4 * kTicksPerPoll);
    EXPECT_LT(platform.brightest_black, 40) << "a flash";
}

}  // namespace
}  // namespace oblong::test
