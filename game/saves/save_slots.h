#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/saves/saved_game.h"

namespace oblong {

/// An exclusive lock on a byte of a file, among all programs; it is released when its holder ends, in any way.
/// The file's bytes are not used. On a file system without locks, all locks are granted.
class FileLock {
  public:
    /// Waits for at most `longest_wait_ms`; null if the lock is still held. Creates the file. Throws FileError if it
    /// cannot be opened.
    static std::unique_ptr<FileLock> take(const std::string& file, std::int64_t byte, int longest_wait_ms);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    explicit FileLock(int number) : number_(number) {}

    const int number_;  ///< of its open file
};

enum class SaveKind : std::uint8_t {
    Walk,     ///< saved by the game itself, each walk under its own number, from 1
    Quick,    ///< saved by a key in the walk of that number
    Numbered  ///< chosen by the player, 1 to kNumberedSlotCount
};
inline constexpr int kNumberedSlotCount = 8;

/// A place for one saved game. Walks and quick saves of versions without numbers have number 0.
struct SaveSlot {
    SaveKind kind = SaveKind::Walk;
    int number = 0;

    auto operator<=>(const SaveSlot&) const = default;
};

/// "Walk 3", "Quick save 3", "Slot 1" and so on.
std::string name_of(SaveSlot slot);

/// The contents of a slot, to be loaded or listed.
template <class Saved>
struct SlotOf {
    SaveSlot slot;
    std::optional<Saved> game;  ///< nothing: the slot is empty, or its saves cannot be loaded
    bool is_former = false;     ///< `game` is the save before the last, which is missing or refused
    std::string refusal;        ///< why the last save is refused, `FILE: WHERE: what, expected what`; else empty
};
using SlotContent = SlotOf<SavedGame>;
using ListedSlot = SlotOf<SaveHead>;

/// A walk's number with its lock: only the program that holds the lock may save under it. The lock ends with the
/// program.
struct HeldWalk {
    int number = 0;
    std::unique_ptr<FileLock> lock;
};

/// A folder of saved games, made at the first save. Each slot also keeps its previous save. Only one program saves at a
/// time.
class SaveSlots {
  public:
    explicit SaveSlots(std::string folder) : folder_(std::move(folder)) {}

    /// Saves into a slot. If anything fails, or the program or the power ends at any moment, the slot's last save or
    /// the one before it can be loaded; after this has returned, the last one. Throws FileError.
    void save(SaveSlot slot, const SavedGame& game) const;

    /// The last game of a slot, or the one before it if the last cannot be loaded.
    SlotContent load(SaveSlot slot) const;
    ListedSlot head_of(SaveSlot slot) const;

    /// Removes both saves of a slot. Throws FileError; also if the slot's walk is held.
    void remove(SaveSlot slot) const;

    /// Walks and quick saves, the most recent first; then all numbered slots.
    std::vector<ListedSlot> list() const;

    /// The walk that was saved last; nothing if there is none.
    std::optional<ListedSlot> last_walk() const;

    /// Holds a walk; nothing if another program holds it. Throws FileError.
    std::optional<HeldWalk> hold(int number) const;
    /// Holds a new walk, whose number has no saves. Throws FileError.
    HeldWalk hold_new() const;

  private:
    std::string link_of(SaveSlot slot) const;  ///< the file, or a link to it
    std::string file_of(SaveSlot slot) const;
    void make_latest(SaveSlot slot) const;
    /// The most recent first.
    std::vector<SaveSlot> walks_and_quick_saves() const;
    std::unique_ptr<FileLock> lock(std::int64_t byte, int longest_wait_ms) const;
    std::unique_ptr<FileLock> lock_folder() const;

    std::string folder_;
};

}  // namespace oblong
