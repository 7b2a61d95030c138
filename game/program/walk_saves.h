#pragma once

#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <utility>

#include "game/program/session.h"
#include "game/saves/save_slots.h"

namespace oblong {

/// Saves the current walk: on request, automatically every minute and after each find, and when it is left.
class WalkSaves {
  public:
    /// `folder`: of the player's saves; empty: nothing is saved.
    explicit WalkSaves(const std::string& folder) : slots_(folder), is_kept_(!folder.empty()) {}

    /// Sets the current walk, which outlives this or the next call; null: none that can be saved. `held`: its number,
    /// if it has one. Its progress up to now counts as saved.
    void begin(Session* walk, std::optional<HeldWalk> held = {});

    const SaveSlots& slots() const { return slots_; }
    bool is_kept() const { return is_kept_; }
    bool can_save() const { return is_kept_ && walk_ && !walk_->state().has_ended; }
    bool holds_number() const { return held_.has_value(); }
    /// Whether there is more unsaved progress than two seconds.
    bool has_unsaved_progress() const;

    /// The walk's own slot of a kind. Its number is taken at the first save. Throws FileError.
    SaveSlot own_slot(SaveKind kind);
    bool is_own(SaveSlot slot) const;
    /// Releases the walk's number, to continue from a save under it.
    std::optional<HeldWalk> release() { return std::exchange(held_, std::nullopt); }

    /// Throws FileError.
    void save(SaveSlot slot);
    /// Autosaves the walk if that is due and `may_begin`: takes the picture now, and writes in another thread.
    void autosave_when_due(bool may_begin);
    /// Waits for the autosave. From then on the walk has a number.
    void finish_autosave();
    /// Returns the error, or "".
    std::string save_on_leaving();

  private:
    struct Autosave {
        std::string fault;              // or ""
        std::optional<HeldWalk> taken;  // the walk's new number, if it had none
    };

    SavedGame saved_now();

    SaveSlots slots_;
    bool is_kept_;
    Session* walk_ = nullptr;
    std::optional<HeldWalk> held_;                         // the walk's number, once it has saves
    std::future<Autosave> autosave_;                       // in progress
    std::int64_t autosave_tick_ = 0, autosave_items_ = 0;  // at the start of the last one
    std::int64_t saved_tick_ = 0, walk_saved_tick_ = 0;    // up to which the walk is saved: in any slot, as a walk
};

}  // namespace oblong
