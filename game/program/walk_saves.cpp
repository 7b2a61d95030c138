#include "game/program/walk_saves.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>
#include <thread>

#include "engine/io/files.h"
#include "game/saves/saved_game.h"
#include "game/simulation/items.h"

namespace oblong {
namespace {

constexpr std::int64_t kNothing_ticks = 2 * kTicksPerSecond;  // less progress than this needs no save
constexpr std::int64_t kAutosave_ticks = 60 * kTicksPerSecond;

std::int64_t taken_items(const GameState& state) {
    return std::count(state.items.begin(), state.items.end(), ItemState::Taken);
}

// False in a web page. std::async() also fails there, but libc++ then waits for ever for the thread of its state.
bool has_threads() {
    try {
        std::thread([] {}).join();
        return true;
    } catch (const std::system_error&) {
        return false;
    }
}

}  // namespace

void WalkSaves::begin(Session* walk, std::optional<HeldWalk> held) {
    walk_ = walk;
    held_ = std::move(held);
    saved_tick_ = walk_saved_tick_ = autosave_tick_ = walk ? walk->state().tick : 0;
    autosave_items_ = walk ? taken_items(walk->state()) : 0;
}

bool WalkSaves::has_unsaved_progress() const {
    return walk_ && !walk_->state().has_ended && walk_->state().tick > saved_tick_ + kNothing_ticks;
}

SaveSlot WalkSaves::own_slot(SaveKind kind) {
    if (!held_) finish_autosave();  // which may take a number
    if (!held_) held_ = slots_.hold_new();
    return {kind, held_->number};
}

bool WalkSaves::is_own(SaveSlot slot) const {
    return held_ && slot.kind != SaveKind::Numbered && slot.number == held_->number;
}

SavedGame WalkSaves::saved_now() {
    const LoadedLevel& loaded = walk_->loaded();
    const GameState& state = walk_->state();
    return {saved_level_of(loaded), count_items(loaded.level, state, ItemClass::Lens), state, walk_->thumbnail()};
}

// To another slot than the walk's own it is saved there, too: that is the one with which the title continues, also
// after a crash.
void WalkSaves::save(SaveSlot slot) {
    const SavedGame game = saved_now();
    slots_.save(slot, game);
    saved_tick_ = walk_->state().tick;
    if (slot.kind != SaveKind::Walk) slots_.save(own_slot(SaveKind::Walk), game);
    walk_saved_tick_ = saved_tick_;
}

void WalkSaves::autosave_when_due(bool may_begin) {
    using namespace std::chrono_literals;
    if (autosave_.valid() && autosave_.wait_for(0s) != std::future_status::timeout) finish_autosave();
    if (autosave_.valid() || !may_begin || !can_save()) return;
    const GameState& state = walk_->state();
    if (taken_items(state) == autosave_items_ && state.tick < autosave_tick_ + kAutosave_ticks) return;
    autosave_tick_ = state.tick;
    autosave_items_ = taken_items(state);
    try {
        const auto own_number = held_ ? std::optional(held_->number) : std::nullopt;
        // Without threads the next call writes it.
        const auto beside = has_threads() ? std::launch::async : std::launch::deferred;
        autosave_ = std::async(beside, [slots = slots_, own_number, game = saved_now()] {
            Autosave done;
            try {
                if (!own_number) done.taken = slots.hold_new();
                slots.save({SaveKind::Walk, done.taken ? done.taken->number : *own_number}, game);
            } catch (const FileError& error) {
                done.fault = error.what();
            }
            return done;
        });
    } catch (const std::exception& error) {
        walk_->show(std::string("Not saved: ") + error.what());
    }
}

void WalkSaves::finish_autosave() {
    if (!autosave_.valid()) return;
    Autosave done = autosave_.get();
    if (done.taken) held_ = std::move(done.taken);
    if (!done.fault.empty()) return walk_->show("Not saved: " + done.fault);
    saved_tick_ = std::max(saved_tick_, autosave_tick_);
    walk_saved_tick_ = std::max(walk_saved_tick_, autosave_tick_);
}

// A walk that has hardly begun gets no number.
std::string WalkSaves::save_on_leaving() {
    finish_autosave();
    if (!can_save() || walk_->state().tick <= walk_saved_tick_ + (held_ ? 0 : kNothing_ticks)) return "";
    try {
        save(own_slot(SaveKind::Walk));
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

}  // namespace oblong
