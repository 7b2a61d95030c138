#include "game/saves/saved_game.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "game/simulation/game_level.h"
#include "tests/saves/saved_walk.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

std::string refusal_of(const Bytes& bytes) {
    return refusal([&] { decode_save(bytes); });
}

TEST(SavedGame, TheWalkHasSomethingInEveryList) {
    const SavedWalk walk;
    const GameState& state = walk.game.state;
    EXPECT_EQ(state.movers.size(), 2u);
    EXPECT_FALSE(state.active_movers.empty());
    const auto was_open = [](const TriggerState& trigger) { return trigger.open_until > 0; };
    EXPECT_EQ(std::count_if(state.triggers.begin(), state.triggers.end(), was_open), 1);
    EXPECT_EQ(state.items, (std::vector{ItemState::Taken, ItemState::Taken}));
    EXPECT_EQ(state.progress.keys, kSilverKey);
    EXPECT_NE(state.message.shown, -1);
    EXPECT_NE(state.player.position, walk.game.level.start.position);
}

TEST(SavedGame, WhatIsReadIsWhatWasSaved) {
    for (const int ticks : {0, 1, 20, 150, 500}) {
        const SavedWalk walk(ticks);
        const SavedGame saved = walk.saved();
        const SavedGame loaded = decode_save(encode_save(saved));
        EXPECT_EQ(loaded, saved) << ticks;
        EXPECT_EQ(hash_of(loaded.state), hash_of(walk.game.state)) << ticks;
        EXPECT_EQ(refusal([&] { check_level(loaded, kToyLevelHash, walk.game.level); }), "") << ticks;
    }
}

TEST(SavedGame, LoadedItGoesOnAsIfItHadNotBeenSaved) {
    SavedWalk walk(0);
    GameState loaded;
    for (int tick = 0; tick < 600; ++tick) {
        if (tick % 50 == 0) loaded = decode_save(encode_save(walk.saved())).state;
        step(walk.game.level, walk.game.state, walk_input(tick));
        step(walk.game.level, loaded, walk_input(tick));
        ASSERT_EQ(hash_of(loaded), hash_of(walk.game.state)) << tick;
    }
}

TEST(SavedGame, TheFileIsAsItsDescriptionSays) {
    const SavedGame saved = SavedWalk().saved();
    const Bytes bytes = encode_save(saved);
    const auto number = [&](std::size_t offset, std::size_t size) {
        std::uint64_t value = 0;
        for (std::size_t i = size; i > 0; --i) value = value << 8 | bytes.at(offset + i - 1);
        return value;
    };
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 8), "OBLGSAVE");
    EXPECT_EQ(number(8, 4), 2u);
    EXPECT_EQ(number(12, 4), bytes.size());
    std::size_t at = 24;
    const auto name = [&] {
        const std::size_t length = number(at, 2), first = at + 2;
        at = first + length;
        return std::string(bytes.begin() + static_cast<std::ptrdiff_t>(first),
                           bytes.begin() + static_cast<std::ptrdiff_t>(at));
    };
    EXPECT_EQ(name(), "/levels/toy.bsp");
    EXPECT_EQ(name(), "/levels/its.lmp");
    EXPECT_EQ(name(), "/models");
    EXPECT_EQ(number(at, 2), 2u);
    at += 2;
    EXPECT_EQ(name(), "/game");
    EXPECT_EQ(name(), "/game/id1");
    EXPECT_EQ(number(at, 8), kToyLevelHash);
    EXPECT_EQ(number(at + 16, 8), 0xfedcba9876543210u);
    EXPECT_EQ(number(at + 24, 4), 77u);
    EXPECT_EQ(number(at + 28, 4), 3u);
    EXPECT_EQ(number(at + 32, 4), 12u);
    const std::size_t picture_at = at + 36, state_hash_at = picture_at + 80 * 50 * 3;
    EXPECT_EQ(number(picture_at + 3 * 9, 3), 63u | 27u << 8 | 45u << 16);
    EXPECT_EQ(number(state_hash_at, 8), hash_of(saved.state));
    EXPECT_EQ(number(state_hash_at + 8, 8), 150u) << "the tick";
    EXPECT_EQ(number(state_hash_at + 16, 4), static_cast<std::uint32_t>(saved.state.player.position.x.raw));
    EXPECT_EQ(number(bytes.size() - 8, 8), checksum_of(std::span(bytes).first(bytes.size() - 8)));
}

TEST(SavedGame, OfAnotherLevelOrVersionIsRefused) {
    const SavedWalk walk;
    const SavedGame saved = walk.saved();
    EXPECT_EQ(refusal([&] { check_level(saved, kToyLevelHash + 1, walk.game.level); }),
              "level: saved in another level, another version of it or by other rules, expected this one");
    ToyGame other(ToyLevel().add_model(floor_and({})));
    EXPECT_EQ(refusal([&] { check_level(saved, kToyLevelHash, other.level); }),
              "state: of another start of this level, expected one saved by this version of the game");
    SavedGame impossible = saved;
    impossible.state.player.ground = 99;
    EXPECT_EQ(refusal([&] { check_level(impossible, kToyLevelHash, walk.game.level); }),
              "state: player: stands on model 99, which the level does not have; expected one saved by this version of "
              "the game");

    Bytes later = encode_save(saved);
    later[8] = 1;
    forge(later);
    EXPECT_EQ(refusal_of(later), "offset 8: saved by another version of the game (1), expected 2");
    Bytes other_fields = encode_save(saved);
    other_fields[16] ^= 1;
    forge(other_fields);
    EXPECT_EQ(refusal_of(other_fields),
              "offset 16: saved by another version of the game, expected a state of this one's fields");
}

TEST(SavedGame, NoPartOfAFileIsOne) {
    const Bytes whole = encode_save(SavedWalk().saved());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        ASSERT_NE(refusal_of(part), "") << size;
        Bytes forged = part;
        if (size >= 24) forge(forged);
        ASSERT_NE(refusal_of(forged), "") << size;
    }
    const Bytes half(whole.begin(), whole.begin() + 1000);
    EXPECT_EQ(refusal_of(half),
              "offset 12: the file has 1000 bytes, expected the " + std::to_string(whole.size()) + " that were saved");
    EXPECT_EQ(refusal_of({}), "offset 0: the file has 0 bytes, expected a saved game");
    EXPECT_EQ(refusal_of(Bytes(100)), "offset 0: no saved game: expected 'OBLGSAVE'");
}

TEST(SavedGame, AnyOtherValueOfAnyByteOfTheHeaderAndABitOfAnyOtherIsRefused) {
    Bytes bytes = encode_save(SavedWalk().saved());
    constexpr std::size_t kHeader = 64;
    for (std::size_t at = 0; at < bytes.size(); ++at)
        for (int flip = 1; flip < 256; flip += at < kHeader ? 1 : 256) {
            bytes[at] ^= static_cast<std::uint8_t>(flip);
            ASSERT_NE(refusal_of(bytes), "") << "byte " << at << " with " << flip;
            bytes[at] ^= static_cast<std::uint8_t>(flip);
        }
    EXPECT_EQ(refusal_of(bytes), "");
}

// The program was started for another game than the one that a save is of.
TEST(SavedGame, IsLoadedFromItsOwnFilesUnlessTheyAreGoneOrTheDemoLevels) {
    const TemporaryFolder folder;
    const std::string there = folder.write("there", "any"), gone = folder.path("gone"),
                      demo = folder.write("demo.bsp", "any"), moved_demo = gone + "/demo.bsp";
    const std::vector<std::string> its_game{"/its"}, own_game{"/own"};
    const LevelFiles own{"own.bsp", "own.lmp", folder.path(), "own models", own_game};
    struct Case {
        std::string level, palette, models;                 // that were saved
        std::string from_level, from_palette, from_models;  // that are loaded
        std::vector<std::string> from_game;
    };
    for (const Case& each : {Case{there, there, there, there, there, there, its_game},
                             {gone, there, gone, gone, there, "own models", its_game},
                             {there, gone, there, there, "own.lmp", there, its_game},
                             {there, "", "", there, "", "", its_game},
                             {demo, "", there, "own.bsp", "", there, own_game},
                             {moved_demo, there, "", "own.bsp", there, "", own_game}}) {
        SavedLevel saved;
        saved.name = each.level, saved.palette = each.palette, saved.models = each.models;
        saved.game_folders = its_game;
        const LevelFiles files = files_of(saved, own);
        EXPECT_EQ(files.level, each.from_level);
        EXPECT_EQ(files.palette, each.from_palette) << each.level;
        EXPECT_EQ(files.models, each.from_models) << each.level;
        EXPECT_EQ(files.game_folders, each.from_game) << each.level;
        EXPECT_EQ(files.assets, own.assets);
    }
}

}  // namespace
}  // namespace oblong::test
