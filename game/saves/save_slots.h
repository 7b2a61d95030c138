#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/files/file_lock.h"
#include "game/saves/saved_game.h"

namespace oblong {

enum class SaveKind : std::uint8_t {
    Walk,     ///< the game saves a walk by itself, each under its own number, from 1
    Quick,    ///< by a key in the walk of that number
    Numbered  ///< by the player's choice, from 1 to kNumberedSlotCount
};
inline constexpr int kNumberedSlotCount = 8;

/// A place for one saved game. Number 0 of walks and quick saves is what versions before walks had numbers wrote.
struct SaveSlot {
    SaveKind kind = SaveKind::Walk;
    int number = 0;

    auto operator<=>(const SaveSlot&) const = default;
};

/// "Walk 3", "Quick save 3", "Slot 1" and so on.
std::string name_of(SaveSlot slot);

/// What can be loaded from a slot, or shown of it.
template <class Saved>
struct SlotOf {
    SaveSlot slot;
    std::optional<Saved> game;  ///< nothing: the slot is empty, or nothing in it can be loaded
    bool is_former = false;     ///< it is the one before the last, which is missing or refused
    std::string refusal;        ///< why the last one is refused, `FILE: WHERE: what, expected what`; else empty
};
using SlotContent = SlotOf<SavedGame>;
using ListedSlot = SlotOf<SaveHead>;

/// A walk's number, under which one program at a time may save: the one that has this, until it ends, however it ends.
struct HeldWalk {
    int number = 0;
    std::unique_ptr<FileLock> lock;
};

/// A folder of saved games, made when the first is saved. Each slot keeps the game that was saved there before, too. Of
/// several programs one saves at a time.
class SaveSlots {
  public:
    explicit SaveSlots(std::string folder) : folder_(std::move(folder)) {}

    /// Saves into a slot. Whatever fails, and whenever the program or the power ends: the slot's last game or the one
    /// before it can be loaded; once this has returned, the last one. Throws FileError.
    void save(SaveSlot slot, const SavedGame& game) const;

    /// The last game of a slot, or the one before it where the last can't be loaded.
    SlotContent load(SaveSlot slot) const;
    ListedSlot head_of(SaveSlot slot) const;

    /// Removes both. Throws FileError; also where it is of a walk that is held.
    void remove(SaveSlot slot) const;

    /// Walks and quick saves, the one that was written last first; then all numbered slots.
    std::vector<ListedSlot> list() const;

    /// The walk that was saved last; nothing where there is none.
    std::optional<ListedSlot> last_walk() const;

    /// A walk that nobody holds; nothing if somebody does. Throws FileError.
    std::optional<HeldWalk> hold(int number) const;
    /// A new walk: its number has no saves, and nobody else gets it. Throws FileError.
    HeldWalk hold_new() const;

  private:
    std::string link_of(SaveSlot slot) const;  ///< the file, or a link to it
    std::string file_of(SaveSlot slot) const;
    /// The last one written first.
    std::vector<SaveSlot> walks_and_quick_saves() const;
    std::unique_ptr<FileLock> lock(std::int64_t place, int longest_wait_ms) const;
    std::unique_ptr<FileLock> lock_folder() const;

    std::string folder_;
};

}  // namespace oblong
