#include <functional>
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

    SaveSlots slots() const { return SaveSlots(folder_.path("saves")); }

    // What is in the slot, which must be this level's.
    GameState saved(SaveSlot slot) const {
        const SlotContent content = slots().load(slot);
        EXPECT_EQ(content.refusal, "");
        if (!content.game) {
            ADD_FAILURE() << name_of(slot) << " is empty";
            return {};
        }
        EXPECT_NO_THROW(
            check_level(*content.game, fnv1a_of(read_file(test::build_folder() + "/assets/demo.bsp")), level_));
        return content.game->state;
    }

    using Commands = std::vector<std::pair<std::int64_t, Command>>;

    // A walk from the title, with one command at a poll each, that ends with the last poll.
    void play(std::int64_t polls, const Commands& commands) {
        play(polls, commands, 0, [](std::int64_t) {});
    }
    void play(std::int64_t polls, const Commands& commands, std::size_t title_row,
              const std::function<void(std::int64_t)>& at_poll) {
        Options options;
        options.shows_title = true;
        options.folders.data = folder_.path("saves");
        ScriptedPlatform platform(polls, [&](std::int64_t poll) {
            at_poll(poll);
            if (poll == kAccept) return chosen(title_row);
            if (poll < kAccept) return Controls{};
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
    static Controls chosen(std::size_t row) {
        Controls controls;
        controls.menu.assign(row, MenuAction::Down);
        controls.menu.push_back(MenuAction::Accept);
        return controls;
    }

    // The state so many ticks after another, the input of which begins with the `first`.
    GameState stepped(GameState state, std::size_t first, std::int64_t ticks) const {
        for (std::int64_t i = 0; i < ticks; ++i) step(level_, state, inputs_.at(first + static_cast<std::size_t>(i)));
        return state;
    }

    static constexpr std::int64_t kAccept = 3;
    static constexpr SaveSlot kFirst{SaveKind::Walk, 1}, kSecond{SaveKind::Walk, 2};
    LiveInput live_;
    std::vector<TickInput> inputs_;  // of the polls after kAccept
};

TEST_F(ProgramSaves, AWalkGoesOnFromTheStateThatWasSavedAndIsSavedOnLeaving) {
    constexpr std::int64_t kSave = 120, kLoad = 200, kEnd = 290;
    live_.use(Preferences{});
    play(kEnd, {{kSave, Command::QuickSave}, {kLoad, Command::QuickLoad}});
    const GameState quick = saved({SaveKind::Quick, 1}), left = saved(kFirst);
    EXPECT_EQ(quick.tick, kSave - kAccept - 1);
    EXPECT_EQ(hash_of(quick), hash_of(stepped(start_of(level_), 0, quick.tick)));
    EXPECT_NE(quick.player.position, level_.player_start);
    // The poll after kLoad has the first tick from there on.
    const std::int64_t ticks = kEnd - kLoad - 1;
    EXPECT_EQ(left.tick, quick.tick + ticks);
    EXPECT_EQ(hash_of(left), hash_of(stepped(quick, static_cast<std::size_t>(kLoad - kAccept), ticks)));
}

// "Walk" and another program's walk have places of their own; "Continue" goes on with the last one.
TEST_F(ProgramSaves, AWalkNeverOverwritesAnother) {
    play(200, {});
    const GameState first = saved(kFirst);
    EXPECT_EQ(first.tick, 196);
    play(150, {}, 1, [](std::int64_t) {});  // below "Continue"
    EXPECT_EQ(saved(kFirst), first);
    EXPECT_EQ(saved(kSecond).tick, 146);
    play(100, {});  // "Continue"
    EXPECT_EQ(saved(kFirst), first);
    EXPECT_EQ(saved(kSecond).tick, 146 + 96);
}

TEST_F(ProgramSaves, AWalkThatIsOnElsewhereGoesOnAsAnother) {
    play(200, {});
    const std::optional<HeldWalk> elsewhere = slots().hold(1);
    play(300, {{kAccept + 1, Command::Menu}});  // the message
    EXPECT_EQ(saved(kFirst).tick, 196);
    EXPECT_GT(saved(kSecond).tick, 400);
}

TEST_F(ProgramSaves, AWalkIsSavedEachMinuteAndAtEachItem) {
    constexpr std::int64_t kMinute = 60 * kTicksPerSecond;
    const SaveSlots all = slots();
    std::vector<std::int64_t> saved_ticks{0};
    play(2 * kMinute + 200, {}, 0, [&](std::int64_t) {
        if (const SlotContent content = all.load(kFirst);
            content.game && content.game->state.tick != saved_ticks.back())
            saved_ticks.push_back(content.game->state.tick);
    });
    ASSERT_GE(saved_ticks.size(), 3u);
    for (std::size_t i = 1; i < saved_ticks.size(); ++i)
        EXPECT_LE(saved_ticks[i], saved_ticks[i - 1] + kMinute) << "the last minute at most is lost";
}

// Not to begin anew by mistake: the title says so, and "Continue" says why.
TEST_F(ProgramSaves, AWalkDamagedInBothCopiesStaysOnTheTitle) {
    play(200, {});
    folder_.write("saves/auto1.save", "damaged");
    folder_.write("saves/auto1.save.old", "damaged");
    std::int64_t polls = 0;
    play(120, {}, 0, [&](std::int64_t poll) { polls = poll; });
    EXPECT_EQ(polls, 119);
    EXPECT_FALSE(slots().load(kSecond).game) << "no new walk has begun";
}

}  // namespace
}  // namespace oblong::test
