#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/platform/platform.h"
#include "game/program/program.h"
#include "game/simulation/items.h"
#include "game/simulation/step.h"
#include "game/simulation/tick.h"
#include "tests/support/folders.h"
#include "tests/support/scripted_input.h"

namespace oblong::test {

/// A platform without a screen that is open for so many polls. Its clock advances a tick of the game a poll; what is
/// presented is not kept.
class ScriptedPlatform : public Platform {
  public:
    using Script = std::function<PlatformInput(std::int64_t poll)>;

    ScriptedPlatform(std::int64_t polls, Script script) : most_polls_(polls), script_(std::move(script)) {}

    bool is_open() const override { return polls_ < most_polls_; }
    PlatformInput poll() override { return script_(polls_++); }
    // A tick is 28,571.4 us: whenever the game begins, each poll is one, until what is rounded up makes another.
    std::uint64_t now_us() override { return static_cast<std::uint64_t>(polls_) * 28'572; }
    WindowSize window_size() const override { return {640, 400}; }
    void set_title(const char*) override {}
    void present(Framebuffer, const Palette&, const PresentRect&) override {}

  private:
    const std::int64_t most_polls_;
    std::int64_t polls_ = 0;
    Script script_;
};

/// A press of Enter, or of a gamepad's A, in a menu.
inline PlatformInput accept() {
    Controls controls;
    controls.menu.push_back(MenuAction::Accept);
    return scripted_input(controls);
}

/// The demo level, and what is recorded of a walk in it by the whole program.
class WalkedLevel : public testing::Test {
  protected:
    /// The program from its title on; the demo that it records of the first walk.
    Demo record(Options options, Platform& platform) const {
        options.shows_title = true;
        options.record = folder_.path("recorded.demo");
        PreferencesStore store;
        Program(options, load_program_files(options, assets_), store, platform, {}).run();
        return decode_demo(read_file(options.record));
    }

    /// The state after the ticks of a demo, each of which must be the one recorded.
    GameState replayed(const Demo& demo) const {
        GameState state = start_of(level_);
        EXPECT_EQ(hash_of(state), demo.start_hash);
        for (const DemoTick& tick : demo.ticks) {
            step(level_, state, tick.input);
            EXPECT_EQ(hash_of(state), tick.state_hash) << "tick " << state.tick;
            if (HasFailure()) break;
        }
        return state;
    }

    void expect_all_found(const GameState& state) const {
        EXPECT_TRUE(state.has_ended);
        const ItemCount lenses = count_items(level_, state, ItemClass::Lens);
        EXPECT_GT(lenses.all, 0);
        EXPECT_EQ(lenses.taken, lenses.all);
    }

    const std::string assets_ = test::build_folder() + "/assets";
    const TemporaryFolder folder_;
    const Level bsp_ = read_bsp(read_file(test::build_folder() + "/assets/demo.bsp"));
    const GameLevel level_ = make_game_level(bsp_);
};

}  // namespace oblong::test
