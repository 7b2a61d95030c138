// How the program saves walks and goes on with them.
#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <utility>

#include "engine/files/files.h"
#include "game/program/program.h"
#include "game/saves/saved_level.h"
#include "game/simulation/items.h"

namespace oblong {
namespace {

constexpr std::int64_t kNothing_ticks = 2 * kTicksPerSecond;  // is lost in so short a time
constexpr std::int64_t kAutosave_ticks = 60 * kTicksPerSecond;

std::int64_t taken_items(const GameState& state) {
    return std::count(state.items.begin(), state.items.end(), ItemState::Taken);
}

std::string content_of(const SavedGame& game) {
    std::string text = std::filesystem::path(game.level.name).stem().string() + " " + time_text(game.state.tick);
    if (game.lenses.all > 0)
        text += ", " + std::to_string(game.lenses.taken) + " of " + std::to_string(game.lenses.all) + " lenses";
    return text;
}

MenuPicture picture_of(const Thumbnail& thumbnail) {
    return {Thumbnail::kWidth_px, Thumbnail::kHeight_px, {thumbnail.pixels.begin(), thumbnail.pixels.end()}};
}

SaveEntry entry_of(const SlotContent& content) {
    SaveEntry entry;
    entry.name = name_of(content.slot);
    entry.is_saved_to_by_player = content.slot.kind == SaveKind::Numbered;
    entry.is_empty = !content.game && content.refusal.empty();
    entry.has_game = content.game.has_value();
    if (!content.refusal.empty()) {
        const bool is_old = content.refusal.find(kOtherVersion) != std::string::npos;
        entry.content = is_old ? "of another version" : "damaged";
        entry.help = "{accept} says why it can't be loaded";
    }
    if (entry.is_empty) entry.content = "empty";
    if (!content.game) return entry;
    entry.content = content_of(*content.game);
    entry.help = content.is_former ? "The one saved before it: the last one is missing or damaged" : "";
    entry.picture = picture_of(content.game->picture);
    return entry;
}

}  // namespace

std::vector<SaveEntry> Program::saves() const {
    std::vector<SaveEntry> entries;
    if (!has_saves()) return entries;
    listed_ = slots_.list();
    for (const SlotContent& content : listed_) {
        entries.push_back(entry_of(content));
        entries.back().is_of_this_walk = is_own(content.slot);
    }
    return entries;
}

std::optional<SaveEntry> Program::last_walk() const {
    if (!last_walk_) return {};
    return entry_of(*last_walk_);
}

bool Program::can_save() const {
    return has_saves() && stage_ == Stage::Walk && session_ && !session_->state().has_ended;
}

bool Program::has_unsaved_progress() const {
    return stage_ == Stage::Walk && session_ && !session_->state().has_ended &&
           session_->state().tick > saved_tick_ + kNothing_ticks;
}

SavedGame Program::saved_now() {
    const LoadedLevel& loaded = session_->loaded();
    const GameState& state = session_->state();
    return {saved_level_of(loaded), count_items(loaded.level, state, ItemClass::Lens), state, session_->thumbnail()};
}

SaveSlot Program::own_slot(SaveKind kind) {
    if (!held_) held_ = slots_.hold_new();
    return {kind, held_->number};
}

bool Program::is_own(SaveSlot slot) const {
    return held_ && slot.kind != SaveKind::Numbered && slot.number == held_->number;
}

void Program::quick_save() {
    if (!can_save()) return session_->show("This game cannot be saved.");
    try_with_files("Save", [&] {
        slots_.save(own_slot(SaveKind::Quick), saved_now());
        saved_tick_ = session_->state().tick;
        session_->show("Saved");
    });
}

void Program::quick_load() {
    if (!held_) return session_->show("Nothing was saved in this walk: the menu loads others");
    load_from(own_slot(SaveKind::Quick));
}

// What was listed may be another by now: another program may have saved there.
void Program::save(std::size_t entry) {
    const SlotContent& listed = listed_.at(entry);
    try_with_files("Save", [&] {
        if (slots_.load(listed.slot).game != listed.game)
            return pages_.open_message("Save", "Another program has saved to " + name_of(listed.slot) +
                                                   " meanwhile. Nothing was saved: choose again.");
        slots_.save(listed.slot, saved_now());
        saved_tick_ = session_->state().tick;
        session_->show("Saved: " + name_of(listed.slot));
    });
}

std::string Program::remove_save(std::size_t entry) {
    try {
        slots_.remove(listed_.at(entry).slot);
    } catch (const FileError& error) {
        return error.what();
    }
    if (stage_ == Stage::Title) last_walk_ = slots_.last_walk();
    return "";
}

void Program::continue_walk() {
    load_from(last_walk_->slot);
}

// A walk that another program is in, and a save of the player's, go on as new walks.
void Program::load_from(SaveSlot slot) {
    try_with_files("Load", [&] {
        finish_autosave();
        auto held = std::make_shared<std::optional<HeldWalk>>();
        if (slot.kind == SaveKind::Walk && !is_own(slot)) *held = slots_.hold(slot.number);
        const SlotContent content = slots_.load(slot);
        if (!content.game) {
            if (content.refusal.empty()) return session_->show(name_of(slot) + ": nothing is saved there");
            return pages_.open_message("Load", content.refusal);
        }
        if (is_own(slot)) return go_on_with(content, {});
        leave_walk([this, content, held] { try_with_files("Load", [&] { go_on_with(content, std::move(*held)); }); });
    });
}

void Program::go_on_with(const SlotContent& content, std::optional<HeldWalk> held) {
    const SavedGame& game = *content.game;
    const bool is_here = saved_level_of(session_->loaded()) == game.level;
    auto loaded =
        is_here ? session_->shared_level() : std::make_shared<const LoadedLevel>(files_of(game.level, level_files_));
    naming_file(game.level.name, [&] { check_level(game, loaded->data.level_hash, loaded->level); });
    const std::string gone = what_is_gone(game.level, saved_level_of(*loaded));
    if (is_own(content.slot)) held = std::exchange(held_, std::nullopt);
    start(loaded, TickInputSource(start_of(loaded->level), std::nullopt, false), Stage::Walk);
    session_->restore(game.state);
    saved_tick_ = autosave_tick_ = game.state.tick;
    autosave_items_ = taken_items(game.state);
    const bool is_elsewhere = content.slot.kind == SaveKind::Walk && !held;
    held_ = std::move(held);
    session_->show("Loaded: " + name_of(content.slot));
    if (is_elsewhere) pages_.open_message("Load", "Another program is in this walk: from here on this is a new one.");
    if (!gone.empty()) pages_.open_message("Load", gone);
    if (content.is_former) pages_.open_message("Load", "The one saved before it was loaded. " + content.refusal);
}

bool Program::is_autosave_due() const {
    if (!can_save() || gallery_ || menu_.is_open()) return false;
    const GameState& state = session_->state();
    return taken_items(state) != autosave_items_ || state.tick >= autosave_tick_ + kAutosave_ticks;
}

void Program::autosave_when_due() {
    using namespace std::chrono_literals;
    if (autosave_.valid() && autosave_.wait_for(0s) == std::future_status::ready) finish_autosave();
    if (autosave_.valid() || !is_autosave_due()) return;
    autosave_tick_ = session_->state().tick;
    autosave_items_ = taken_items(session_->state());
    try {
        autosave_ =
            std::async(std::launch::async, [slots = slots_, slot = own_slot(SaveKind::Walk), game = saved_now()] {
                try {
                    slots.save(slot, game);
                    return std::string();
                } catch (const FileError& error) {
                    return std::string(error.what());
                }
            });
    } catch (const std::exception& error) {
        session_->show(std::string("Not saved: ") + error.what());
    }
}

void Program::finish_autosave() {
    if (!autosave_.valid()) return;
    const std::string fault = autosave_.get();
    if (fault.empty())
        saved_tick_ = std::max(saved_tick_, autosave_tick_);
    else
        session_->show("Not saved: " + fault);
}

// A walk that has hardly begun is not worth a place of its own.
std::string Program::save_on_leaving() {
    finish_autosave();
    if (!can_save() || session_->state().tick <= saved_tick_ || !(held_ || has_unsaved_progress())) return "";
    try {
        slots_.save(own_slot(SaveKind::Walk), saved_now());
        saved_tick_ = session_->state().tick;
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

void Program::leave_walk(const std::function<void()>& go) {
    const std::string fault = save_on_leaving();
    if (fault.empty()) return go();
    pages_.open_not_saved(fault, go);
}

}  // namespace oblong
