#include "game/saves/save_slots.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <utility>
#include <vector>

#include "engine/io/files.h"
#include "game/saves/saved_game.h"
#include "tests/saves/saved_walk.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

class SlotFiles : public testing::Test {
  protected:
    // The game after so many ticks.
    static SavedGame after(int ticks) { return SavedWalk(ticks).saved(); }

    std::string file(const std::string& name) const { return folder_.path("made/" + name); }

    static constexpr SaveSlot kQuick{SaveKind::Quick, 1}, kThird{SaveKind::Numbered, 3};
    const TemporaryFolder folder_;
    const SaveSlots slots_{folder_.path("made")};
    const SavedGame first_ = after(10), second_ = after(20), third_ = after(30);
};

TEST_F(SlotFiles, AreEmptyWithoutAFolderAndMakeNone) {
    const std::vector<ListedSlot> all = slots_.list();
    ASSERT_EQ(all.size(), 8u);
    for (const ListedSlot& content : all) {
        EXPECT_FALSE(content.game);
        EXPECT_EQ(content.refusal, "");
    }
    EXPECT_FALSE(slots_.last_walk());
    EXPECT_FALSE(fs::exists(folder_.path("made")));
    EXPECT_EQ(name_of(all[0].slot) + name_of(all[7].slot) + name_of(kQuick) + name_of({SaveKind::Walk, 12}),
              "Slot 1Slot 8Quick save 1Walk 12");
}

TEST_F(SlotFiles, EachKeepsItsOwnGame) {
    const std::vector<SaveSlot> kept{
        kQuick, {SaveKind::Walk, 1}, {SaveKind::Walk, 2}, {SaveKind::Numbered, 1}, {SaveKind::Numbered, 8}};
    for (int i = 0; i < 5; ++i) slots_.save(kept[static_cast<std::size_t>(i)], after(i));
    for (int i = 0; i < 5; ++i) {
        const SlotContent content = slots_.load(kept[static_cast<std::size_t>(i)]);
        ASSERT_TRUE(content.game) << i;
        EXPECT_EQ(*content.game, after(i)) << i;
        EXPECT_FALSE(content.is_former) << i;
    }
    EXPECT_EQ(slots_.list().size(), 3u + 8u);
}

TEST_F(SlotFiles, AreListedAsTheyAreLoaded) {
    slots_.save(kThird, third_);
    const ListedSlot listed = slots_.list().at(2);
    ASSERT_TRUE(listed.game);
    EXPECT_EQ(listed.slot, kThird);
    EXPECT_EQ(listed.game->level, third_.level);
    EXPECT_EQ(listed.game->lenses, third_.lenses);
    EXPECT_EQ(listed.game->tick, 30);
    EXPECT_EQ(listed.game->picture, third_.picture);
    SavedGame other = third_;
    other.state.player.pitch += 1;
    slots_.save(kThird, other);
    EXPECT_NE(slots_.head_of(kThird).game, listed.game) << "though they differ in their states alone";
}

TEST_F(SlotFiles, TheWalkThatWasSavedLastIsFirst) {
    for (const int number : {3, 1, 2}) {
        const SaveSlot slot{SaveKind::Walk, number};
        slots_.save(slot, first_);
        fs::last_write_time(file("auto" + std::to_string(number) + ".save"),
                            fs::file_time_type{std::chrono::hours(number == 1 ? 9 : number)});
    }
    const std::vector<ListedSlot> all = slots_.list();
    EXPECT_EQ(all[0].slot.number, 1);
    EXPECT_EQ(all[1].slot.number, 3);
    EXPECT_EQ(slots_.last_walk()->slot.number, 1);
    // Damaged it is still the last one: it does not give way to another in silence.
    folder_.write("made/auto1.save", "damaged");
    fs::last_write_time(file("auto1.save"), fs::file_time_type{std::chrono::hours(9)});
    EXPECT_EQ(slots_.last_walk()->slot.number, 1);
    EXPECT_FALSE(slots_.last_walk()->game);
}

TEST_F(SlotFiles, TheWalkThatWasSavedLastIsFirstAlsoAfterTheClockWasSetBack) {
    for (const int number : {1, 2, 1}) {
        const SaveSlot slot{SaveKind::Walk, number};
        slots_.save(slot, first_);
        EXPECT_EQ(slots_.last_walk()->slot.number, number);
        fs::last_write_time(file("auto" + std::to_string(number) + ".save"),
                            fs::file_time_type::clock::now() + std::chrono::hours(10'000 * number));
    }
}

TEST_F(SlotFiles, WhatEarlierVersionsSavedIsListedAndSaysSo) {
    Bytes bytes = encode_save(first_);
    bytes[8] = 1;
    forge(bytes);
    fs::create_directory(folder_.path("made"));
    for (const char* name : {"auto.save", "quick.save", "slot2.save"}) write_file(file(name), bytes);
    int refused = 0;
    for (const ListedSlot& content : slots_.list())
        refused += content.refusal.find("another version of the game (1)") != std::string::npos;
    EXPECT_EQ(refused, 3);
    EXPECT_EQ(slots_.hold_new().number, 1) << "and is not saved over";
}

TEST_F(SlotFiles, OtherFilesAreNoSlots) {
    fs::create_directory(folder_.path("made"));
    for (const char* name : {"auto01.save", "auto-1.save", "auto1.save.part", "auto.saved", "auto99999999999999.save",
                             "auto2147483647.save", "walk1.save", "oblong.cfg", "auto 1.save"})
        folder_.write(std::string("made/") + name, "something");
    EXPECT_EQ(slots_.list().size(), 8u);
    EXPECT_EQ(slots_.hold_new().number, 1);
}

TEST_F(SlotFiles, AfterTheGreatestNumberComesTheFirstThatIsFree) {
    slots_.save({SaveKind::Walk, 1}, first_);
    slots_.save({SaveKind::Walk, 1'000'000}, first_);
    const HeldWalk walk = slots_.hold_new();
    EXPECT_EQ(walk.number, 2);
    slots_.save({SaveKind::Walk, walk.number}, first_);
    EXPECT_EQ(slots_.list().size(), 11u) << "a save that is not listed";
}

TEST_F(SlotFiles, AWalkIsHeldByOneAtATime) {
    const SaveSlots of_another(folder_.path("made"));
    std::optional<HeldWalk> mine = slots_.hold_new();
    EXPECT_EQ(mine->number, 1);
    EXPECT_FALSE(of_another.hold(1));
    EXPECT_EQ(of_another.hold_new().number, 2) << "though nothing is saved yet";
    slots_.save({SaveKind::Walk, 1}, first_);
    EXPECT_THROW(of_another.remove({SaveKind::Walk, 1}), FileError);
    EXPECT_NO_THROW(of_another.remove({SaveKind::Numbered, 1})) << "it is of no walk";
    EXPECT_TRUE(of_another.load({SaveKind::Walk, 1}).game) << "to be gone on with as another walk";
    mine.reset();
    EXPECT_EQ(of_another.hold(1)->number, 1);
    EXPECT_EQ(of_another.hold_new().number, 2);
    of_another.remove({SaveKind::Walk, 1});
    EXPECT_FALSE(slots_.last_walk());
}

TEST_F(SlotFiles, BothCopiesDamagedAreNamed) {
    fs::create_directory(folder_.path("made"));
    folder_.write("made/quick1.save", "short");
    folder_.write("made/quick1.save.old", Bytes(100));
    EXPECT_EQ(slots_.load(kQuick).refusal, file("quick1.save") +
                                               ": offset 0: the file has 5 bytes, expected a saved game" +
                                               "\n\nThe save before it: " + file("quick1.save.old") +
                                               ": offset 0: no saved game: expected 'OBLGSAVE'");
    EXPECT_EQ(slots_.list().size(), 9u);
    slots_.remove(kQuick);
    EXPECT_EQ(slots_.list().size(), 8u);
}

// A link leads to where the save is kept, also the one before it.
TEST_F(SlotFiles, ALinkIsFollowedToItsEnd) {
    fs::create_directory(folder_.path("made"));
    fs::create_directory(folder_.path("elsewhere"));
    fs::create_symlink("../elsewhere/link", file("quick1.save"));
    fs::create_symlink("mine", folder_.path("elsewhere/link"));
    slots_.save(kQuick, first_);
    slots_.save(kQuick, second_);
    EXPECT_TRUE(fs::is_symlink(file("quick1.save")));
    EXPECT_TRUE(fs::is_symlink(folder_.path("elsewhere/link")));
    EXPECT_EQ(decode_save(read_file(folder_.path("elsewhere/mine"))), second_);
    EXPECT_EQ(slots_.load(kQuick).game, second_);
    fs::remove(folder_.path("elsewhere/mine"));
    EXPECT_EQ(slots_.load(kQuick).game, first_);

    fs::create_symlink("slot1.save", file("slot1.save"));
    EXPECT_NE(slots_.load({SaveKind::Numbered, 1}).refusal, "");
    EXPECT_THROW(slots_.save({SaveKind::Numbered, 1}, first_), FileError);
}

// A pipe that nobody writes to would be waited for for ever.
TEST_F(SlotFiles, PipesAndDevicesAreRefused) {
    fs::create_directory(folder_.path("made"));
    ASSERT_EQ(mkfifo(file("quick1.save").c_str(), 0600), 0);
    const std::string null = device_for_writing(folder_.path(), "null");
    fs::create_symlink(null, file("slot1.save"));
    fs::create_symlink(device_for_writing(folder_.path(), "zero"), file("slot2.save"));
    for (const SaveSlot slot : {kQuick, SaveSlot{SaveKind::Numbered, 1}, SaveSlot{SaveKind::Numbered, 2}}) {
        const SlotContent content = slots_.load(slot);
        EXPECT_NE(content.refusal.find("is no regular file, expected one"), std::string::npos) << content.refusal;
        EXPECT_THROW(slots_.save(slot, first_), FileError);
    }
    EXPECT_TRUE(fs::is_fifo(file("quick1.save")));
    EXPECT_TRUE(fs::is_character_file(null));
}

TEST_F(SlotFiles, WhatAnEndedProgramHasLeftGoes) {
    slots_.save(kQuick, first_);
    folder_.write("made/quick1.save.1-0.part", "a part");
    slots_.save(kQuick, second_);
    EXPECT_FALSE(fs::exists(file("quick1.save.1-0.part")));
}

TEST_F(SlotFiles, ADamagedGameIsNamedAndTheOneBeforeItIsOffered) {
    slots_.save(kQuick, first_);
    slots_.save(kQuick, second_);
    EXPECT_EQ(slots_.load(kQuick).game, second_);
    Bytes bytes = read_file(file("quick1.save"));
    bytes[3000] ^= 4;
    write_file(file("quick1.save"), bytes);
    const SlotContent content = slots_.load(kQuick);
    EXPECT_EQ(content.game, first_);
    EXPECT_TRUE(content.is_former);
    EXPECT_EQ(content.refusal, file("quick1.save") + ": offset " + std::to_string(bytes.size() - 8) +
                                   ": the checksum differs, expected a file that was not changed");

    // Saving again does not put the damaged one in the place of the one that can be loaded.
    slots_.save(kQuick, third_);
    EXPECT_EQ(slots_.load(kQuick).game, third_);
    fs::remove(file("quick1.save"));
    const SlotContent without = slots_.load(kQuick);
    EXPECT_EQ(without.game, first_);
    EXPECT_TRUE(without.is_former);
    EXPECT_EQ(without.refusal, "");
}

TEST_F(SlotFiles, AFolderIsNoSave) {
    fs::create_directories(file("quick1.save"));
    const SlotContent content = slots_.load(kQuick);
    EXPECT_FALSE(content.game);
    EXPECT_EQ(content.refusal, file("quick1.save") + ": open: is a folder, expected a file");
    EXPECT_THROW(slots_.save(kQuick, first_), FileError);
}

TEST_F(SlotFiles, AFolderThatCannotBeMadeIsAnError) {
    folder_.write("made", "a file");
    EXPECT_THROW(slots_.save(kQuick, first_), FileError);
    EXPECT_FALSE(slots_.load(kQuick).game);
}

struct Canvas {
    Canvas(std::int32_t width_px, std::int32_t height_px, std::uint8_t colour = 0)
        : pixels(pixel_count(width_px, height_px), colour), picture{pixels.data(), width_px, height_px, width_px} {}
    std::vector<std::uint8_t> pixels;
    Framebuffer picture;
};

std::uint8_t pixel(const Thumbnail& thumbnail, std::size_t x, std::size_t y) {
    return thumbnail.pixels[y * 80 + x].green;
}

TEST(Thumbnail, HasTheMeanOfWhatEachPixelCovers) {
    Canvas canvas(320, 200);
    for (std::int32_t y = 0; y < 200; ++y)
        for (std::int32_t x = 0; x < 320; ++x)
            canvas.picture.row(y)[x] = static_cast<std::uint8_t>(x / 4 + 2 * (y / 4) + (x % 2 == 0 ? 20 : 0));
    const Thumbnail thumbnail = make_thumbnail(canvas.picture, grey_palette());
    for (std::size_t y = 0; y < 50; ++y)
        for (std::size_t x = 0; x < 80; ++x) ASSERT_EQ(pixel(thumbnail, x, y), x + 2 * y + 10);
}

TEST(Thumbnail, IsOfTheWholePictureInAnyMode) {
    for (const auto& [width, height] : {std::pair{8, 8}, {320, 200}, {333, 217}, {79, 51}, {640, 480}}) {
        Canvas canvas(width, height, 7);
        canvas.picture.row(height - 1)[width - 1] = 255;
        canvas.picture.row(0)[0] = 254;
        const Thumbnail thumbnail = make_thumbnail(canvas.picture, grey_palette());
        EXPECT_GT(pixel(thumbnail, 0, 0), 7) << width;
        EXPECT_GT(pixel(thumbnail, 79, 49), 7) << width;
        EXPECT_EQ(pixel(thumbnail, 40, 25), 7) << width;
    }
}

TEST(Thumbnail, IsOfTheColoursNotTheirNumbers) {
    Canvas canvas(160, 100, 9);
    Palette palette;
    palette.colours[9] = {10, 20, 30};
    EXPECT_EQ(make_thumbnail(canvas.picture, palette).pixels.front(), (Rgb8{10, 20, 30}));
}

}  // namespace
}  // namespace oblong::test
