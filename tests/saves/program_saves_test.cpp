#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>
#include <vector>

#include "engine/base/checksum.h"
#include "engine/effects/palette_effects.h"
#include "game/input/tick_input_source.h"
#include "game/saves/saved_game.h"
#include "tests/support/folders.h"
#include "tests/walk/walked_level.h"

// Saves made and loaded by keys in the whole program, held against the game stepped by itself.
namespace oblong::test {
namespace {

class ProgramSaves : public WalkedLevel {
  protected:
    static Controls walk_controls(std::int64_t poll) {
        Controls controls;
        controls.moves.set(Action::Forward);
        controls.moves.set(Action::TurnLeft, poll % 30 < 4);
        controls.moves.set(Action::Jump, poll % 50 == 20);
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

    using Commands = std::vector<std::pair<std::int64_t, Action>>;

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
            if (poll == kAccept) return scripted_input(chosen(title_row));
            if (poll < kAccept) return PlatformInput{};
            Controls controls = walk_controls(poll);
            live_.gather(controls);
            inputs_.push_back(live_.next());
            for (const auto& [at, command] : commands)
                if (at == poll) controls.commands.push_back(command);
            return scripted_input(controls);
        });
        PreferencesStore store;
        Program(options, load_program_files(options, assets_), store, platform, {}).run();
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
    play(kEnd, {{kSave, Action::QuickSave}, {kLoad, Action::QuickLoad}});
    const GameState quick = saved({SaveKind::Quick, 1}), left = saved(kFirst);
    EXPECT_EQ(quick.tick, kSave - kAccept) << "what the frame shows in which the key is pressed";
    EXPECT_EQ(hash_of(quick), hash_of(stepped(start_of(level_), 0, quick.tick)));
    EXPECT_NE(quick.player.position, level_.start.position);
    // The poll after kLoad has the first tick from there on.
    const std::int64_t ticks = kEnd - kLoad - 1;
    EXPECT_EQ(left.tick, quick.tick + ticks);
    EXPECT_EQ(hash_of(left), hash_of(stepped(quick, static_cast<std::size_t>(kLoad - kAccept), ticks)));
}

// Before the first autosave: "Continue" goes on from any save, if the program then ends without saving.
TEST_F(ProgramSaves, ACrashAfterAQuickSaveLosesNothingThatWasSaved) {
    constexpr std::int64_t kSave = 120;
    std::optional<ListedSlot> continued;
    play(kSave + 10, {{kSave, Action::QuickSave}}, 0, [&](std::int64_t poll) {
        if (poll == kSave + 1) continued = slots().last_walk();
    });
    ASSERT_TRUE(continued && continued->game);
    EXPECT_EQ(continued->game->tick, kSave - kAccept);
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
    play(300, {{kAccept + 1, Action::Menu}});  // the message
    EXPECT_EQ(saved(kFirst).tick, 196);
    EXPECT_GT(saved(kSecond).tick, 400);
}

// As in a folder that is read-only: its lock cannot be opened.
TEST_F(ProgramSaves, AWalkThatCannotBeHeldGoesOnAsAnother) {
    play(200, {});
    const std::string lock = folder_.path("saves/lock");
    std::filesystem::remove(lock);
    std::filesystem::create_directory(lock);
    play(300, {{kAccept + 1, Action::Menu}}, 0, [&](std::int64_t poll) {  // the message
        if (poll == kAccept + 2) std::filesystem::remove(lock);
    });
    EXPECT_EQ(saved(kFirst).tick, 196);
    EXPECT_GT(saved(kSecond).tick, 400);
}

TEST_F(ProgramSaves, AWalkIsSavedEachMinute) {
    constexpr std::int64_t kMinute = 60 * kTicksPerSecond;
    const SaveSlots all = slots();
    std::vector<std::int64_t> saved_ticks{0};
    const auto note_saved = [&] {
        const SlotContent content = all.load(kFirst);
        if (content.game && content.game->state.tick != saved_ticks.back())
            saved_ticks.push_back(content.game->state.tick);
    };
    play(2 * kMinute + 200, {}, 0, [&](std::int64_t poll) {
        note_saved();
        // It is written beside the game, which is hundreds of times as fast here.
        for (int ms = 0; poll % kMinute == 150 && as_size(poll / kMinute) >= saved_ticks.size() && ms < 30'000; ++ms) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            note_saved();
        }
    });
    ASSERT_GE(saved_ticks.size(), 3u);
    for (std::size_t i = 1; i < saved_ticks.size(); ++i)
        EXPECT_LE(saved_ticks[i], saved_ticks[i - 1] + kMinute) << "the last minute at most is lost";
}

// It is continued where the next tick takes an item.
TEST_F(ProgramSaves, AnItemThatIsTakenIsSavedAtOnce) {
    const Demo demo = decode_demo(read_file(assets_ + "/walk.demo"));
    SavedGame game;
    game.state = start_of(level_);
    const auto taken = [&] { return std::find(game.state.items.begin(), game.state.items.end(), ItemState::Taken); };
    for (const DemoTick& tick : demo.ticks)
        if (taken() == game.state.items.end()) step(level_, game.state, tick.input);
    ASSERT_NE(taken(), game.state.items.end());
    *taken() = ItemState::There;
    game.state.progress.taken.clear();
    game.level.name = assets_ + "/demo.bsp";
    game.level.file_hash = fnv1a_of(read_file(game.level.name));
    game.level.start_hash = hash_of(start_of(level_));
    slots().save(kFirst, game);
    std::int64_t saved_tick = 0;
    constexpr std::int64_t kPolls = 400;  // time enough for what is written beside the game
    play(kPolls, {{kAccept + 1, Action::Menu}}, 0, [&](std::int64_t poll) {
        if (poll == kPolls - 1) saved_tick = saved(kFirst).tick;
    });
    EXPECT_GT(saved_tick, game.state.tick);
    EXPECT_LT(saved_tick, game.state.tick + 5);
}

// A level under another name and in other colours, walked from one folder and gone on with from another program.
class ProgramSavesOfALevel : public ProgramSaves {
  protected:
    class Shown final : public ScriptedPlatform {
      public:
        using ScriptedPlatform::ScriptedPlatform;
        void present(Framebuffer, const Palette& palette, const PresentRect&) override { last = palette; }
        Palette last;
    };
    ProgramSavesOfALevel() {
        std::filesystem::copy_file(assets_ + "/demo.bsp", level_file_);
        std::vector<std::uint8_t> bytes;
        for (int i = 0; i < 256; ++i)
            bytes.insert(bytes.end(), {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), 7});
        palette_file_ = folder_.write("its.lmp", bytes);
    }
    // The colours of the last picture, as far as no effect changes them.
    std::vector<Rgb8> colours_of(Options options, std::int64_t polls) const {
        options.folders.data = folder_.path("saves");
        Shown platform(polls, [](std::int64_t poll) { return poll == kAccept ? accept() : PlatformInput{}; });
        PreferencesStore store;
        Program(options, load_program_files(options, assets_), store, platform, {}).run();
        return {platform.last.colours.begin() + 1, platform.last.colours.begin() + 200};
    }
    std::vector<Rgb8> colours_from_the_title() const {
        Options options;
        options.shows_title = true;
        return colours_of(options, 60);
    }
    const std::string level_file_ = folder_.path("mine.bsp");
    std::string palette_file_;
};

TEST_F(ProgramSavesOfALevel, TheColoursAreThoseItWasStartedWith) {
    const std::vector<Rgb8> of_the_museum = colours_from_the_title();
    Options options;
    options.level = level_file_;
    options.palette = std::filesystem::relative(palette_file_).string();
    const std::vector<Rgb8> its = colours_of(options, 150);
    const GammaTable tube = make_tube_table();  // as a level that is not the museum starts
    EXPECT_EQ(its[0], (Rgb8{tube[1], tube[254], tube[7]}));
    ASSERT_TRUE(slots().last_walk()->game);
    EXPECT_EQ(slots().last_walk()->game->level.palette, palette_file_);
    EXPECT_EQ(colours_from_the_title(), its);

    std::filesystem::remove(palette_file_);
    EXPECT_EQ(colours_from_the_title(), of_the_museum) << "the palette is gone";
    SavedLevel now = slots().last_walk()->game->level;
    now.palette_hash ^= 1;
    EXPECT_NE(what_is_gone(slots().last_walk()->game->level, now).find(palette_file_), std::string::npos);
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
