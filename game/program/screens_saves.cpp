// Saving and continuing walks.
#include <filesystem>

#include "engine/io/files.h"
#include "game/program/screens.h"
#include "game/saves/saved_game.h"

namespace oblong {
namespace {

std::string content_of(const SaveHead& game, const std::string& lenses) {
    std::string text = std::filesystem::path(game.level.name).stem().string() + " " + time_text(game.tick);
    if (game.lenses.all > 0)
        text += ", " + std::to_string(game.lenses.taken) + " of " + std::to_string(game.lenses.all) + " " + lenses;
    return text;
}

MenuPicture picture_of(const Thumbnail& thumbnail) {
    return {Thumbnail::kWidth_px, Thumbnail::kHeight_px,
            std::make_shared<std::vector<Rgb8>>(thumbnail.pixels.begin(), thumbnail.pixels.end())};
}

SaveEntry entry_of(const ListedSlot& content, const std::string& lenses) {
    SaveEntry entry;
    entry.name = name_of(content.slot);
    entry.is_saved_to_by_player = content.slot.kind == SaveKind::Numbered;
    entry.is_empty = !content.game && content.refusal.empty();
    entry.has_game = content.game.has_value();
    if (!content.refusal.empty()) {
        const bool is_old = content.refusal.find(kOtherVersion) != std::string::npos;
        entry.content = is_old ? "of another version" : "damaged";
    }
    if (entry.is_empty) entry.content = "empty";
    if (!content.game) return entry;
    entry.content = content_of(*content.game, lenses);
    entry.help = content.is_former ? "The save before the last: the last is missing or damaged" : "";
    entry.picture = picture_of(content.game->picture);
    return entry;
}

}  // namespace

std::vector<SaveEntry> Screens::saves() {
    std::vector<SaveEntry> entries;
    if (!saves_.is_kept()) return entries;
    listed_ = saves_.slots().list();
    for (const ListedSlot& content : listed_) {
        entries.push_back(entry_of(content, own_words(game_.definition(), kLenses)));
        entries.back().is_of_this_walk = saves_.is_own(content.slot);
    }
    return entries;
}

std::optional<SaveEntry> Screens::last_walk() const {
    if (!last_walk_) return {};
    return entry_of(*last_walk_, own_words(game_.definition(), kLenses));
}

void Screens::quick_save() {
    if (walk_->kind() != SessionKind::Walk) return walk_->show("Not saved: a walk that began as a replay never is");
    if (!can_save()) return walk_->show("This game cannot be saved.");
    try_with_files("Save", [&] {
        saves_.save(saves_.own_slot(SaveKind::Quick));
        walk_->show("Saved");
    });
}

void Screens::quick_load() {
    if (walk_->kind() != SessionKind::Walk) return walk_->show("Nothing is loaded into a replay: the menu loads walks");
    if (!saves_.holds_number()) return walk_->show("Nothing was saved in this walk: the menu loads others");
    load_from(saves_.own_slot(SaveKind::Quick));
}

// Another program may have saved to the slot since it was listed.
std::string Screens::save(std::size_t entry) {
    const ListedSlot& listed = listed_.at(entry);
    try {
        if (saves_.slots().head_of(listed.slot).game != listed.game)
            return "Another program has saved to " + name_of(listed.slot) +
                   " meanwhile. Nothing was saved: choose again.";
        saves_.save(listed.slot);
        walk_->show("Saved: " + name_of(listed.slot));
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

std::string Screens::remove_save(std::size_t entry) {
    try {
        saves_.slots().remove(listed_.at(entry).slot);
    } catch (const FileError& error) {
        return error.what();
    }
    if (!walk_) last_walk_ = saves_.slots().last_walk();
    return "";
}

// A walk held by another program, one in a folder that cannot be written to, a quick save of another walk, and a save
// in a numbered slot continue as new walks.
void Screens::load_from(SaveSlot slot) {
    try_with_files("Load", [&] {
        saves_.finish_autosave();
        auto held = std::make_shared<std::optional<HeldWalk>>();
        std::string why_new = "another running Oblong uses this walk's saves.";
        try {
            if (slot.kind == SaveKind::Walk && !saves_.is_own(slot)) *held = saves_.slots().hold(slot.number);
        } catch (const FileError& error) {
            why_new = error.what();
        }
        const SlotContent content = saves_.slots().load(slot);
        if (!content.game) {
            const std::string nothing = name_of(slot) + ": nothing is saved there";
            if (content.refusal.empty() && walk_) return walk_->show(nothing);
            return pages_.open_message("Load", content.refusal.empty() ? nothing : content.refusal);
        }
        if (saves_.is_own(slot)) return go_on_with(content, {}, why_new);
        leave_walk([this, content, held, why_new] {
            try_with_files("Load", [&] { go_on_with(content, std::move(*held), why_new); });
        });
    });
}

void Screens::go_on_with(const SlotContent& content, std::optional<HeldWalk> held, const std::string& why_new) {
    const SavedGame& game = *content.game;
    const bool is_here = saved_level_of(level_below()) == game.level;
    auto loaded = is_here ? screens_.front()->shared_level()
                          : std::make_shared<const LoadedLevel>(files_of(game.level, game_.files()));
    naming_file(game.level.name, [&] { check_level(game, loaded->data.level_hash, loaded->level); });
    const std::string gone = what_is_gone(game.level, saved_level_of(*loaded));
    if (saves_.is_own(content.slot)) held = saves_.release();
    start_walk(loaded);
    walk_->restore(game.state);
    const bool is_elsewhere = content.slot.kind == SaveKind::Walk && !held;
    saves_.begin(walk_, std::move(held));
    walk_->show("Loaded: " + name_of(content.slot));
    if (is_elsewhere) pages_.open_message("Load", "The game goes on as a new walk: " + why_new);
    if (!gone.empty()) pages_.open_message("Load", gone);
    if (content.is_former) pages_.open_message("Load", "The save before the last was loaded. " + content.refusal);
}

void Screens::leave_walk(const std::function<void()>& go) {
    const std::string fault = saves_.save_on_leaving();
    if (fault.empty()) return go();
    pages_.open_not_saved(fault, go);
}

}  // namespace oblong
