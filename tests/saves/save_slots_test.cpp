#include "game/saves/save_slots.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/platform/files.h"
#include "tests/saves/saved_walk.h"
#include "tests/support/temporary_folder.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

class SlotFiles : public testing::Test {
  protected:
    // The game after so many ticks.
    static SavedGame after(int ticks) { return SavedWalk(ticks).saved(); }

    std::string file(const std::string& name) const { return folder_.path("made/" + name); }

    const TemporaryFolder folder_;
    const SaveSlots slots_{folder_.path("made")};
    const SavedGame first_ = after(10), second_ = after(20), third_ = after(30);
};

TEST_F(SlotFiles, AreEmptyWithoutAFolderAndMakeNone) {
    const std::vector<SlotContent> all = slots_.list();
    ASSERT_EQ(all.size(), 11u);
    for (const SlotContent& content : all) {
        EXPECT_FALSE(content.game);
        EXPECT_EQ(content.refusal, "");
    }
    EXPECT_FALSE(fs::exists(folder_.path("made")));
    EXPECT_EQ(name_of(all[0].slot) + name_of(all[1].slot) + name_of(all[2].slot) + name_of(all[3].slot) +
                  name_of(all[10].slot),
              "Quick saveAutosaveLevel startSlot 1Slot 8");
}

TEST_F(SlotFiles, EachKeepsItsOwnGame) {
    for (int i = 0; i < kSaveSlotCount; ++i) slots_.save(static_cast<SaveSlot>(i), after(i));
    const std::vector<SlotContent> all = slots_.list();
    for (int i = 0; i < kSaveSlotCount; ++i) {
        const SlotContent& content = all[static_cast<std::size_t>(i)];
        EXPECT_EQ(content.slot, static_cast<SaveSlot>(i));
        ASSERT_TRUE(content.game) << i;
        EXPECT_EQ(*content.game, after(i)) << i;
        EXPECT_FALSE(content.is_former) << i;
    }
    EXPECT_EQ(slots_.load(numbered_slot(1)).game, after(3));
    EXPECT_EQ(slots_.load(numbered_slot(8)).game, after(10));
}

TEST_F(SlotFiles, ADamagedGameIsNamedAndTheOneBeforeItIsOffered) {
    slots_.save(SaveSlot::Quick, first_);
    slots_.save(SaveSlot::Quick, second_);
    EXPECT_EQ(slots_.load(SaveSlot::Quick).game, second_);
    Bytes bytes = read_file(file("quick.save"));
    bytes[3000] ^= 4;
    write_file(file("quick.save"), bytes);
    const SlotContent content = slots_.load(SaveSlot::Quick);
    EXPECT_EQ(content.game, first_);
    EXPECT_TRUE(content.is_former);
    EXPECT_EQ(content.refusal, file("quick.save") + ": offset " + std::to_string(bytes.size() - 8) +
                                   ": the checksum is another, expected an unaltered file");

    // Saving again does not put the damaged one in the place of the one that can be loaded.
    slots_.save(SaveSlot::Quick, third_);
    EXPECT_EQ(slots_.load(SaveSlot::Quick).game, third_);
    fs::remove(file("quick.save"));
    EXPECT_EQ(slots_.load(SaveSlot::Quick).game, first_);
}

TEST_F(SlotFiles, AMissingGameLeavesTheOneBeforeIt) {
    slots_.save(numbered_slot(3), first_);
    slots_.save(numbered_slot(3), second_);
    fs::remove(file("slot3.save"));
    const SlotContent content = slots_.load(numbered_slot(3));
    EXPECT_EQ(content.game, first_);
    EXPECT_TRUE(content.is_former);
    EXPECT_EQ(content.refusal, "");
}

TEST_F(SlotFiles, WhatIsNoFileIsRefused) {
    fs::create_directories(file("auto.save"));
    const SlotContent content = slots_.load(SaveSlot::Automatic);
    EXPECT_FALSE(content.game);
    EXPECT_EQ(content.refusal, file("auto.save") + ": open: is a folder, expected a file");
    EXPECT_THROW(slots_.save(SaveSlot::Automatic, first_), FileError);

    fs::create_symlink("/dev/zero", file("quick.save"));
    EXPECT_EQ(slots_.load(SaveSlot::Quick).refusal,
              file("quick.save") + ": size: more than 16777216 bytes, expected a smaller file");
}

TEST_F(SlotFiles, AFolderThatCannotBeMadeIsAnError) {
    folder_.write("made", "a file");
    EXPECT_THROW(slots_.save(SaveSlot::Quick, first_), FileError);
    EXPECT_FALSE(slots_.load(SaveSlot::Quick).game);
}

TEST_F(SlotFiles, OfAThousandDamagedOnesTheFormerIsAlwaysThere) {
    slots_.save(SaveSlot::Quick, first_);
    slots_.save(SaveSlot::Quick, second_);
    const Bytes whole = read_file(file("quick.save"));
    std::mt19937 random(14);
    for (int i = 0; i < 1000; ++i) {
        folder_.write("made/quick.save", damaged(whole, random));
        const SlotContent content = slots_.load(SaveSlot::Quick);
        ASSERT_TRUE(content.game) << i;
        ASSERT_EQ(content.is_former, !content.refusal.empty()) << i;
        ASSERT_EQ(content.game->state, (content.is_former ? first_ : second_).state) << i;
    }
}

}  // namespace
}  // namespace oblong::test
