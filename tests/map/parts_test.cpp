#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

#include "engine/io/files.h"
#include "engine/level/entity_classes.h"
#include "engine/platform/headless.h"
#include "game/level/load.h"
#include "game/program/map_watch.h"
#include "game/program/program.h"
#include "tests/map/map_source.h"
#include "tests/saves/traced_process.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"
#include "tests/support/scripted_input.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong::test::parts_test {
namespace {

namespace fs = std::filesystem;

std::string two_rooms(const std::string& entities) {
    return level(room({0, 0, 0}, {512, 256, 128}) + box({240, 0, 0}, {256, 96, 128}) +
                     box({240, 160, 0}, {256, 256, 128}) + box({240, 96, 96}, {256, 160, 128}),
                 entities_of("info_player_start 64 64 28 + func_wall 300 64 0 340 100 40") + entities);
}

const std::string kLamp = entity_at("light", {64, 200, 100}), kOtherLamp = entity_at("light", {400, 128, 64}),
                  kLens = entity_at("item_lens", {400, 60, 40}), kOtherLens = entity_at("item_lens", {420, 60, 40});

TEST(Parts, AFileThatIsReadGivesTheSameBytes) {
    map::BspFile bsp = compile(two_rooms(kLamp + kLens));
    const std::string bytes = map::to_bytes(bsp);
    EXPECT_EQ(map::to_bytes(map::from_bytes(bytes)), bytes);
    bsp.planes.resize(32768, bsp.planes.front());
    const std::string wide = map::to_bytes(bsp);
    ASSERT_TRUE(wide.starts_with("BSP2"));
    EXPECT_EQ(map::to_bytes(map::from_bytes(wide)), wide);
    EXPECT_THROW(map::from_bytes(bytes + "more"), InputError) << "not written like this";
    EXPECT_THROW(map::from_bytes(bytes.substr(0, 200)), InputError);
}

std::string bytes_of_part(map::CompilePart part, const std::string& source, const map::BspFile& former) {
    return map::to_bytes(compile(source, {.part = part, .former = former}));
}

// Each part alone makes of the former level what all together make of the source.
TEST(Parts, MadeAnewAloneGiveTheWholeLevel) {
    const auto whole = [](const std::string& source) { return map::to_bytes(compile(source)); };
    const std::string before = two_rooms(kLamp + kLens), moved = two_rooms(kLamp + kOtherLens),
                      lit = two_rooms(kOtherLamp + kOtherLens);
    const map::BspFile former = compile(before);
    EXPECT_TRUE(bytes_of_part(map::CompilePart::Entities, moved, former) == whole(moved));
    EXPECT_TRUE(bytes_of_part(map::CompilePart::Light, lit, former) == whole(lit));
    EXPECT_NE(bytes_of(lit), whole(moved));
    map::BspFile dim = former;
    for (char& sample : dim.lighting) sample = 1;
    for (map::FileLeaf& leaf : dim.leaves) leaf.visibility_offset = -1;
    map::BspFile expected = former;
    expected.lighting = dim.lighting;
    EXPECT_TRUE(bytes_of_part(map::CompilePart::Visibility, before, dim) == map::to_bytes(expected));
}

TEST(Parts, OfOtherBrushesAreRefused) {
    const map::BspFile former = compile(two_rooms(kLamp));
    const std::string more = two_rooms(kLamp + entities_of("func_wall 400 64 0 440 100 40"));
    for (const std::string& source : {more, replaced(two_rooms(kLamp), "( 240 ", "( 232 ")})
        for (const auto part : {map::CompilePart::Entities, map::CompilePart::Light, map::CompilePart::Visibility})
            EXPECT_THROW(compile(source, {.part = part, .former = former}), InputError);
}

TEST(Parts, ChangesSayWhatHasToBeMadeAnew) {
    using enum map::CompilePart;
    const std::string before = two_rooms(kLamp + kLens), door = replaced(before, "func_wall", "func_door");
    const auto part = [&](const std::string& from, const std::string& to) {
        return map::changed_part(map::parse_map(from), map::parse_map(to));
    };
    const auto with_key = [&](const std::string& of, const std::string& pair) {
        return replaced(before, "\"" + of + "\"", "\"" + of + "\"\n" + pair);
    };
    EXPECT_EQ(part(before, "// a comment\n" + before), Entities);
    EXPECT_EQ(part(before, two_rooms(kLamp + kOtherLens)), Entities);
    for (const std::string end : {"\n", "\r\n", "\r"})
        EXPECT_EQ(
            part(replaced("// a comment\n" + before, "\n", end), replaced(two_rooms(kOtherLamp + kLens), "\n", end)),
            Light);
    EXPECT_EQ(part(before, two_rooms(kLens)), Light);
    EXPECT_EQ(part(before, with_key("worldspawn", "\"_sunlight2\" \"40\"")), Light);
    EXPECT_EQ(part(before, with_key("func_wall", "\"targetname\" \"lit\"")), Light);
    EXPECT_EQ(part(before, with_key("func_wall", "\"wait\" \"2\"")), Entities);
    EXPECT_EQ(part(before, replaced(before, "( 300 64 0 )", "( 308 64 0 )")), All);
    EXPECT_EQ(part(before, replaced(before, " wall ", " brick ")), All);
    EXPECT_EQ(part(before, door), All);
    EXPECT_EQ(part(before, with_key("func_wall", "\"_phong\" \"1\"")), All);
    EXPECT_EQ(part(before, with_key("worldspawn", "\"wad\" \"t.wad\"")), All);
    EXPECT_EQ(part(before, with_key("item_lens", "\"_external_map\" \"t.map\"")), All);
    const std::string layer = "\"classname\" \"func_group\"\n\"_tb_type\" \"_tb_layer\"\n\"_tb_id\" \"1\"\n";
    const std::string layered = with_key("func_wall", "\"_tb_layer\" \"1\"") + "{\n" + layer;
    EXPECT_EQ(part(layered + "}\n", layered + "\"_tb_layer_omit_from_export\" \"1\"\n}\n"), All);
}

// Each key of the world and of its brushes, with a value that does something: what is made in part is what is made
// whole.
TEST(Parts, MadeOfWhatHasChangedAreTheWholeLevel) {
    const std::string before = two_rooms(kLamp + entities_of("func_group 360 64 0 400 100 40"));
    const map::BspFile former = compile(before);
    int in_part = 0;
    for (const std::string its_class : {"worldspawn", "func_wall", "func_group"})
        for (const std::span<const EntityKey> keys : find_entity_class(its_class)->keys)
            for (const EntityKey& key : keys) {
                const std::string value = key.values.empty() ? "90" : std::string(key.values.back().value);
                const std::string pair =
                    "\"" + std::string(key.name) + "\" \"" + value + (key.least == 3 ? " 90 90" : "") + "\"";
                const std::string now = replaced(before, "\"" + its_class + "\"", "\"" + its_class + "\"\n" + pair);
                const map::CompilePart part = map::changed_part(map::parse_map(before), map::parse_map(now));
                if (part == map::CompilePart::All || refusal([&] { compile(now); }) != "") continue;
                ++in_part;
                std::string made;  // refused, all is compiled
                const std::string refused = refusal([&] { made = bytes_of_part(part, now, former); });
                EXPECT_TRUE(refused != "" || made == map::to_bytes(compile(now))) << its_class << ": " << pair;
            }
    EXPECT_GT(in_part, 40);
}

std::string with_wad(const std::string& source) {
    return replaced(source, "\"worldspawn\"", "\"worldspawn\"\n\"wad\" \"t.wad\"");
}
// The rooms with these entities, and the texture of a WAD.
std::string textured(const std::string& entities) {
    return with_wad(two_rooms(entities));
}

// A folder with a source that is watched.
class MapWatchTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }

    std::string level_bytes() const { return read_text(watch.level_file()); }

    void save(const std::string& source) const { write_file(path("my.map"), source); }
    // Saves a source with its WAD and compiles it; returns the level, and what is said on standard error.
    std::array<std::string, 2> begin(const std::string& source) {
        write_file(path("t.wad"), wad_bytes({"wall"}));
        save(source);
        testing::internal::CaptureStderr();
        watch.compile_first(false);
        const std::string said = testing::internal::GetCapturedStderr();
        return {level_bytes(), said};
    }

    MapWatch::Result result_after(const std::string& name, const std::string& text) {
        write_file(path(name), text);
        fs::last_write_time(path(name), fs::file_time_type::clock::now() + std::chrono::seconds(++saves_));
        for (int tries = 0; tries < 3000; ++tries) {
            if (auto result = watch.poll(now_us_ += 300'000)) return *result;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return {};
    }

  private:
    const TemporaryFolder folder_;
    std::uint64_t now_us_ = 0;
    int saves_ = 0;

  protected:
    const std::shared_ptr<MapWatch> shared_watch_ =
        std::make_shared<MapWatch>(path("my.map"), build_folder() + "/bin/oblong-map");
    MapWatch& watch = *shared_watch_;
};

TEST_F(MapWatchTest, APipeOrAFolderInItsPlaceIsAFaultAndNotWaitedFor) {
    for (const bool is_pipe : {true, false}) {
        fs::remove(path("my.map"));
        EXPECT_EQ((is_pipe ? mkfifo : mkdir)(path("my.map").c_str(), 0700), 0);
        const std::string said = refusal<FileError>([&] { watch.poll(is_pipe ? 300'000 : 600'000); });
        EXPECT_TRUE(said.starts_with(path("my.map") + ": open: is ")) << said;
    }
}

// Else, a window would close when the compiler has ended.
TEST_F(MapWatchTest, ItsEndIsThatOfTheCompiler) {
    write_file(path("slow"), std::string("#!/bin/sh\necho $$ >") + path("number") + "\nexec sleep 3000\n");
    fs::permissions(path("slow"), fs::perms::owner_all);
    write_file(path("my.map"), two_rooms(kLamp));
    {
        MapWatch slow(path("my.map"), path("slow"));
        EXPECT_FALSE(slow.poll(300'000));
        while (!fs::exists(path("number")) || read_text(path("number")).empty()) std::this_thread::yield();
    }
    EXPECT_EQ(kill(std::stoi(read_text(path("number"))), 0), -1);
    EXPECT_EQ(errno, ESRCH);
}

// One system call in turn fails, as where a disk is broken or there are too many processes; the next time it does not.
TEST_F(MapWatchTest, WhatFailsOnceIsAFaultAndTriedAgain) {
    if (!TracedProcess::kCanFailCalls) GTEST_SKIP() << "calls can't be made to fail on this processor";
    const std::set<std::uint64_t> failing{SYS_openat, SYS_read,   SYS_write, SYS_newfstatat, SYS_close, SYS_statx,
                                          SYS_unlink, SYS_clone3, SYS_vfork, SYS_clone,      SYS_wait4, SYS_stat};
    const std::string whole = begin(textured(kLamp))[0];
    const auto follow = [&] {
        MapWatch follower(path("my.map"), build_folder() + "/bin/oblong-map");
        int faults = 0;
        for (std::uint64_t now_us = 0; now_us < 2'000'000'000; now_us += 300'000) {
            try {
                if (const auto result = follower.poll(now_us); result && result->has_level) _exit(10 + (faults > 0));
            } catch (const FileError&) {
                ++faults;
            }
            usleep(2000);
        }
        _exit(faults > 0 ? kRefused : kDone);  // there never was a level
    };
    int calls = 0, faults = 0;
    for (int call = -1; call < calls; ++call) {  // at first none fails
        fs::remove(watch.level_file());
        TracedProcess process(follow);
        int made = 0;
        while (const auto begun = process.next())
            if (process.is_beginning() && failing.contains(begun->number) && made++ == call) process.fail_call(EIO);
        if (process.exit_code() == kNotTraced) GTEST_SKIP() << "processes can't be traced here";
        ASSERT_GE(process.exit_code(), 10) << "call " << call << ": no level";
        EXPECT_EQ(level_bytes(), whole) << "call " << call;
        faults += process.exit_code() == 11;
        if (call < 0) calls = std::min(made, 200);
    }
    EXPECT_GT(calls, 10);
    EXPECT_GT(faults, 3) << "reading the source, writing the log, starting the compiler, waiting for it";
}

TEST_F(MapWatchTest, TellsAFaultFromALevelWhereEndsOfProcessesAreIgnored) {
    signal(SIGCHLD, SIG_IGN);
    MapWatch follower(path("my.map"), build_folder() + "/bin/oblong-map");
    write_file(path("my.map"), std::string("no level"));
    EXPECT_THROW(follower.compile_first(false), FileError);
}

// A walk in such a level, with a quick save before the level changes.
class WatchedWalk : public MapWatchTest {
  protected:
    static constexpr std::int64_t kSaved = 10, kChanged = 20, kEnd = 400;

    // The first walk as it was saved at the end. `script`: other inputs of the player. Until the level has changed,
    // each poll waits up to `patience_ms`.
    SlotContent played(const std::map<std::int64_t, Controls>& script, int patience_ms) {
        patience_ms_ = patience_ms;
        first_ = begin(textured(kLamp))[0];
        Options options;
        options.level = watch.level_file();
        options.folders.data = path("data");
        HeadlessPlatform platform(
            kEnd, 35, [&](std::int64_t poll) { return input_at(poll, script); }, [](Framebuffer, const Palette&) {});
        PreferencesStore store;
        ProgramFiles files = load_program_files(options, build_folder() + "/assets");
        files.watch = shared_watch_;
        oblong::Program(options, std::move(files), store, platform, {}).run();
        return SaveSlots(path("data")).load({SaveKind::Walk, 1});
    }

  private:
    PlatformInput input_at(std::int64_t poll, const std::map<std::int64_t, Controls>& script) {
        Controls controls;
        if (script.contains(poll)) controls = script.at(poll);
        if (poll == kSaved) controls.commands.push_back(Action::QuickSave);
        if (poll == kChanged) save(textured(kLamp + kLens));
        for (int ms = 0; poll > kChanged + 10 && ms < patience_ms_ && level_bytes() == first_; ms += 10)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));  // the compiler is at work
        return scripted_input(controls);
    }

    std::string first_;
    int patience_ms_ = 0;
};

TEST_F(WatchedWalk, KeepsItsNumberInTheChangedLevel) {
    const SlotContent walk = played({}, 100);
    ASSERT_TRUE(walk.game);
    EXPECT_EQ(walk.game->lenses.all, 1);
    EXPECT_LT(walk.game->state.tick, kEnd - kChanged);
}

TEST_F(WatchedWalk, IsNotGoneOnWithWhileTheGalleryIsOverIt) {
    Controls menu, gallery;
    menu.commands = {Action::Menu};
    gallery.menu = {MenuAction::Up, MenuAction::Up, MenuAction::Up, MenuAction::Accept};
    const SlotContent walk = played({{14, menu}, {15, gallery}}, 10);
    ASSERT_TRUE(walk.game);
    EXPECT_LT(walk.game->state.tick, kChanged);
    EXPECT_EQ(walk.game->lenses.all, 0);
}

// As a mapper saves: a lamp moves, a wall goes, and comes back.
TEST_F(MapWatchTest, FollowsTheSource) {
    const std::string first = begin(textured(kLamp))[0];
    EXPECT_TRUE(result_after("my.map", textured(kOtherLamp)).has_level);
    EXPECT_FALSE(level_bytes() == first);
    const auto broken = result_after("my.map", textured(kOtherLamp) + "{");
    EXPECT_FALSE(broken.has_level);
    EXPECT_TRUE(broken.fault.starts_with("line ")) << broken.fault;
    EXPECT_TRUE(result_after("my.map", textured(kOtherLamp)).has_level) << "as it was: the fault is gone";
    const std::string leaking = level(box({0, 0, 0}, {64, 64, 64}), entity_at("light", {0, 0, 99}));
    EXPECT_TRUE(result_after("my.map", with_wad(leaking)).has_level);
    EXPECT_GE(LoadedLevel({path("my-draft.bsp"), "", build_folder() + "/assets", ""}).leak_path.size(), 2u);
    EXPECT_TRUE(result_after("my.map", textured(kLamp)).has_level);
    EXPECT_TRUE(level_bytes() == first);
}

TEST_F(MapWatchTest, WaitsUntilTheFirstLevelCompiles) {
    write_file(path("t.wad"), wad_bytes({"wall"}));
    save(textured(kLamp) + "{");
    EXPECT_NE(refusal<FileError>([&] { watch.compile_first(false); }).find("line "), std::string::npos);
    fs::remove(path("my-draft.log"));
    testing::internal::CaptureStderr();
    std::thread mapper([&] {
        while (!fs::exists(path("my-draft.log")) || read_text(path("my-draft.log")).empty()) std::this_thread::yield();
        save(textured(kLamp));
    });
    watch.compile_first(true);
    mapper.join();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("; tried again after a change"), std::string::npos);
    EXPECT_TRUE(result_after("my.map", textured(kOtherLamp)).has_level);
}

TEST_F(MapWatchTest, NamesAPlaceWhereNothingCanBeWritten) {
    save(textured(kLamp));
    fs::create_directory(path("my-draft.log"));
    const std::string said = refusal<FileError>([&] { watch.compile_first(false); });
    EXPECT_TRUE(said.starts_with(path("my-draft.log") + ": write: ")) << said;
}

// The mapper sees them where the game was started.
TEST_F(MapWatchTest, PassesOnTheWarningsOfLevelsThatCompile) {
    const std::string said = begin(textured(kLamp + entity_at("lihgt", {32, 32, 32})))[1];
    EXPECT_NE(said.find("the class 'lihgt' is unknown, perhaps 'light' is meant"), std::string::npos) << said;
}

// Of a game with a class of its own, in whose meaning nothing is wrong.
TEST_F(MapWatchTest, HandsTheGameOn) {
    fs::create_directories(path("game"));
    write_file(path("game/game.json"),
               R"({"title": "T", "levels": ["one"], "classes": {"func_my_gate": {"is": "func_door"}}})");
    write_file(path("t.wad"), wad_bytes({"wall"}));
    save(textured(kLamp + entities_of("func_my_gate 160 128 0 176 144 16")));
    for (const std::string& game : {path("game"), std::string()}) {
        MapWatch watched(path("my.map"), build_folder() + "/bin/oblong-map", game);
        testing::internal::CaptureStderr();
        watched.compile_first(false);
        const std::string said = testing::internal::GetCapturedStderr();
        EXPECT_EQ(said.find("the class 'func_my_gate' is unknown") == said.npos, !game.empty()) << said;
    }
}

// The limit of five looks at files a second does not delay it.
TEST_F(MapWatchTest, ReturnsALevelAsSoonAsItIsCompiled) {
    begin(textured(kLamp));
    save(textured(kLamp + kLens));
    const std::uint64_t saved_us = 1'000'000;
    std::optional<MapWatch::Result> result = watch.poll(saved_us);
    for (int tries = 0; tries < 3000 && !result; ++tries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        result = watch.poll(saved_us + 1);
    }
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->has_level);
}

// A map within the map, its place, and textures: none of them is in the source's own brushes.
TEST_F(MapWatchTest, FollowsWhatTheSourceNames) {
    const auto source = [](const Whole& at) {
        return textured(kLamp + entity_at("misc_external_map", at, {{"_external_map", "part.map"}}));
    };
    const std::string brick = level(box({0, 0, 0}, {32, 32, 16})), taller = level(box({0, 0, 0}, {32, 32, 48}));
    write_file(path("part.map"), brick);
    const std::string first = begin(source({160, 128, 0}))[0];
    EXPECT_TRUE(result_after("part.map", taller).has_level);
    EXPECT_FALSE(level_bytes() == first);
    EXPECT_FALSE(result_after("part.map", brick + "{").has_level);
    EXPECT_TRUE(result_after("part.map", brick).has_level);
    EXPECT_TRUE(level_bytes() == first);
    EXPECT_TRUE(result_after("t.wad", wad_bytes(std::vector<std::string>{"other", "wall"})).has_level)
        << "'wall' has the second colour now";
    EXPECT_FALSE(level_bytes() == first);
    EXPECT_TRUE(result_after("t.wad", wad_bytes({"wall"})).has_level);
    EXPECT_TRUE(result_after("my.map", source({160, 64, 0})).has_level);
    EXPECT_FALSE(level_bytes() == first) << "it was moved";
    fs::remove(path("t.wad"));
    EXPECT_TRUE(result_after("part.map", taller).has_level) << "with a checkerboard";
    EXPECT_TRUE(result_after("t.wad", wad_bytes({"wall"})).has_level) << "it is there again";
    EXPECT_TRUE(result_after("part.map", brick).has_level);
    EXPECT_TRUE(result_after("my.map", source({160, 128, 0})).has_level);
    EXPECT_TRUE(level_bytes() == first);
}

}  // namespace
}  // namespace oblong::test::parts_test
