#pragma once

#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <utility>

#include "game/program/session.h"
#include "game/saves/save_slots.h"

namespace oblong {

/// Saves the walk that is on: where the player asks for it, beside the game every minute and after each find, and when
/// it is left.
class WalkSaves {
  public:
    /// In a folder of the player's; an empty name: nothing is saved.
    explicit WalkSaves(const std::string& folder) : slots_(folder), is_kept_(!folder.empty()) {}

    /// Another walk is on, which outlives this or the next call; null: none that can be saved. `held`: its own place
    /// where it has one already. What of it is saved: all up to now if it was loaded, nothing if it begins.
    void begin(Session* walk, std::optional<HeldWalk> held = {});

    const SaveSlots& slots() const { return slots_; }
    bool is_kept() const { return is_kept_; }
    bool can_save() const { return is_kept_ && walk_ && !walk_->state().has_ended; }
    bool has_place() const { return held_.has_value(); }
    /// Whether more is not saved than one plays again in a moment.
    bool has_unsaved_progress() const;

    /// The walk's own place for saves of a kind: its number is taken when it is saved first. Throws FileError.
    SaveSlot own_slot(SaveKind kind);
    bool is_own(SaveSlot slot) const;
    /// Gives the walk's own place away, to go on from a save in it.
    std::optional<HeldWalk> release() { return std::exchange(held_, std::nullopt); }

    /// Throws FileError.
    void save(SaveSlot slot);
    /// Saves the walk beside the game where that is due and may begin: a frame takes its picture, another thread
    /// writes.
    void autosave_when_due(bool may_begin);
    /// Waits for that: from then on the walk has a place, where it was saved first.
    void finish_autosave();
    /// The message if that failed, else "".
    std::string save_on_leaving();

  private:
    struct Autosave {
        std::string fault;              // or ""
        std::optional<HeldWalk> taken;  // the walk's place, if it had none before
    };

    SavedGame saved_now();

    SaveSlots slots_;
    bool is_kept_;
    Session* walk_ = nullptr;
    std::optional<HeldWalk> held_;                         // the walk's place, once it has saves
    std::future<Autosave> autosave_;                       // that is being written
    std::int64_t autosave_tick_ = 0, autosave_items_ = 0;  // when the last one began
    std::int64_t saved_tick_ = 0;                          // of the walk, up to which it is saved
};

}  // namespace oblong
