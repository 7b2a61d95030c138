#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/saves/saved_game.h"

namespace oblong {

/// A place for one saved game: the quick one, the walk that was left last, the start of the level, and
/// kNumberedSlotCount that the player chooses.
enum class SaveSlot : std::uint8_t { Quick, Automatic, LevelStart, FirstNumbered };
inline constexpr int kNumberedSlotCount = 8, kSaveSlotCount = 3 + kNumberedSlotCount;

/// The slot of a number from 1 to kNumberedSlotCount.
constexpr SaveSlot numbered_slot(int number) {
    return static_cast<SaveSlot>(static_cast<int>(SaveSlot::FirstNumbered) + number - 1);
}

/// "Quick save", "Autosave", "Level start", "Slot 1" and so on.
std::string name_of(SaveSlot slot);

/// What can be loaded from a slot.
struct SlotContent {
    SaveSlot slot = SaveSlot::Quick;
    std::optional<SavedGame> game;  ///< nothing: the slot is empty, or nothing in it can be loaded
    bool is_former = false;         ///< it is the one before the last, which is missing or refused
    std::string refusal;            ///< why the last one is refused, `FILE: WHERE: what, expected what`; else empty
};

/// A folder of saved games, made when the first is saved. Each slot keeps the game that was saved there before, too.
class SaveSlots {
  public:
    explicit SaveSlots(std::string folder) : folder_(std::move(folder)) {}

    /// Saves into a slot. Whatever fails, and whenever the program ends: the slot's last game or the one before it can
    /// be loaded. Throws FileError.
    void save(SaveSlot slot, const SavedGame& game) const;

    /// The last game of a slot, or the one before it where the last can't be loaded.
    SlotContent load(SaveSlot slot) const;

    /// All slots, in their order.
    std::vector<SlotContent> list() const;

  private:
    std::string file_of(SaveSlot slot) const;

    std::string folder_;
};

}  // namespace oblong
