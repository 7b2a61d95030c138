#pragma once

#include <gtest/gtest.h>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "game/program/program.h"
#include "game/simulation/items.h"
#include "game/simulation/step.h"
#include "tests/support/folders.h"
#include "tests/walk/scripted_platform.h"

namespace oblong::test {

/// The demo level, and what is recorded of a walk in it by the whole program.
class WalkedLevel : public testing::Test {
  protected:
    /// The program from its title on; the demo that it records of the first walk.
    Demo record(Options options, Platform& platform) const {
        options.shows_title = true;
        options.record = folder_.path("recorded.demo");
        PreferencesStore store;
        Program(options, load_program_files(options, assets_), store, platform, nullptr).run();
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
