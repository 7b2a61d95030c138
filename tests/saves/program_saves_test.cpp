#include <vector>

#include "engine/base/fnv.h"
#include "game/tick_input_source.h"
#include "tests/support/folders.h"
#include "tests/walk/walked_level.h"

// Saves made and loaded by keys in the whole program, held against the game stepped by itself.
namespace oblong::test {
namespace {

class ProgramSaves : public WalkedLevel {
  protected:
    static Controls walk_controls(std::int64_t poll) {
        Controls controls;
        controls.forward = true;
        controls.turn_left = poll % 30 < 4;
        controls.jump = poll % 50 == 20;
        return controls;
    }

    // What is in the slot, which must be this level's.
    GameState saved(SaveSlot slot) const {
        const SlotContent content = SaveSlots(folder_.path("saves")).load(slot);
        EXPECT_EQ(content.refusal, "");
        if (!content.game) {
            ADD_FAILURE() << name_of(slot) << " is empty";
            return {};
        }
        EXPECT_NO_THROW(
            check_level(*content.game, fnv1a_of(read_file(test::build_folder() + "/assets/demo.bsp")), level_));
        return content.game->state;
    }

    // A walk from the title, with one command at a poll each, that ends with the last poll.
    void play(std::int64_t polls, const std::vector<std::pair<std::int64_t, Command>>& commands) {
        Options options;
        options.shows_title = true;
        options.folders.data = folder_.path("saves");
        ScriptedPlatform platform(polls, [&](std::int64_t poll) {
            if (poll == kAccept) return accept();
            if (poll < kAccept) return Controls{};
            if (poll == kAccept + 1) start_ = saved(SaveSlot::LevelStart);
            Controls controls = walk_controls(poll);
            live_.gather(controls);
            inputs_.push_back(live_.next());
            for (const auto& [at, command] : commands)
                if (at == poll) controls.commands.push_back(command);
            return controls;
        });
        PreferencesStore store;
        Program(options, load_program_files(options, assets_), store, platform, nullptr).run();
    }

    // The state so many ticks after another, the input of which begins with the `first`.
    GameState stepped(GameState state, std::size_t first, std::int64_t ticks) const {
        for (std::int64_t i = 0; i < ticks; ++i) step(level_, state, inputs_.at(first + static_cast<std::size_t>(i)));
        return state;
    }

    static constexpr std::int64_t kAccept = 3;
    LiveInput live_;
    std::vector<TickInput> inputs_;  // of the polls after kAccept
    GameState start_;                // as it was saved when the walk began
};

TEST_F(ProgramSaves, AWalkGoesOnFromTheStateThatWasSavedAndIsSavedOnLeaving) {
    constexpr std::int64_t kSave = 120, kLoad = 200, kEnd = 290;
    live_.use(Preferences{});
    play(kEnd, {{kSave, Command::QuickSave}, {kLoad, Command::QuickLoad}});
    EXPECT_EQ(start_, start_of(level_));

    const GameState quick = saved(SaveSlot::Quick), left = saved(SaveSlot::Automatic);
    EXPECT_EQ(quick.tick, kSave - kAccept - 1);
    EXPECT_EQ(hash_of(quick), hash_of(stepped(start_of(level_), 0, quick.tick)));
    EXPECT_NE(quick.player.position, level_.player_start);
    // The poll after kLoad has the first tick from there on.
    const std::int64_t ticks = kEnd - kLoad - 1;
    EXPECT_EQ(left.tick, quick.tick + ticks);
    EXPECT_EQ(hash_of(left), hash_of(stepped(quick, static_cast<std::size_t>(kLoad - kAccept), ticks)));
}

}  // namespace
}  // namespace oblong::test
