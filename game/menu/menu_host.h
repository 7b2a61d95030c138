#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/input/bindings.h"
#include "game/input/key_names.h"
#include "game/menu/menu_layout.h"
#include "game/options/preferences.h"
#include "game/simulation/items.h"

namespace oblong {

/// A save slot, as the menu shows it.
struct SaveEntry {
    std::string name;                    ///< "Slot 1"
    std::string content;                 ///< "demo 3:12, 5 of 12 lenses"; "empty"
    std::string help;                    ///< a line, for KeyNames::in(); if a save cannot be loaded, load() says more
    bool is_saved_to_by_player = false;  ///< not only by keys or by the game itself
    bool is_empty = true, has_game = false;
    bool is_of_this_walk = false;  ///< of the current walk: loading it goes back to an earlier state
    std::optional<MenuPicture> picture;
};

/// A level that can be played.
struct LevelEntry {
    std::string name;   ///< "e1m1"
    std::string file;   ///< argument of play_level()
    std::string title;  ///< the author's title; may be empty
};

/// The figures of a walk that ended.
struct EndFigures {
    std::string message;     ///< the level's message; may be empty
    std::string time;        ///< "3:12"
    std::string lenses;      ///< "Lenses found: 5 of 12"; empty if the level has none
    std::string next_level;  ///< "e1m2"; empty if there is none
    std::string fault;       ///< why the next level, which it names, cannot be played; may be empty
};

/// The interface of the program for the menu's pages.
class MenuHost {
  public:
    virtual ~MenuHost() = default;

    virtual Preferences& preferences() = 0;
    virtual KeyNames key_names() const = 0;
    virtual std::string local_name_of(Input input) const = 0;
    virtual std::vector<KeyHelp> key_help() const = 0;  ///< of the screen behind the menu
    virtual std::string game_title() const = 0;         ///< in capitals
    virtual Goal goal() const = 0;                      ///< of the walk
    virtual std::vector<std::string> told() const = 0;  ///< the messages of a walk, the newest first
    virtual std::string figures() const = 0;            ///< of the gallery's current row

    virtual std::vector<LevelEntry> levels() const = 0;
    virtual std::vector<SaveEntry> saves() const = 0;
    virtual EndFigures end_figures() const = 0;
    virtual std::string credits() const = 0;

    virtual bool can_save() const = 0;  ///< there is a walk, and a folder for saves
    /// The walk that was saved last; nothing if there is none.
    virtual std::optional<SaveEntry> last_walk() const = 0;
    /// Whether the current walk has unsaved progress.
    virtual bool has_unsaved_progress() const = 0;
    /// Whether leaving a walk saves it.
    virtual bool saves_on_leaving() const = 0;

    virtual void walk() = 0;  ///< the demo level, from its start
    virtual void continue_walk() = 0;
    virtual void restart() = 0;
    virtual void play_level(const std::string& file) = 0;
    virtual void play_next() = 0;                            ///< EndFigures::next_level
    virtual void save(std::size_t entry) = 0;                ///< of saves()
    virtual void load(std::size_t entry) = 0;                ///< shows the reason if it cannot be loaded
    virtual std::string remove_save(std::size_t entry) = 0;  ///< the error, or ""
    virtual void show_title() = 0;
    virtual void show_gallery() = 0;
    virtual void leave() = 0;
};

}  // namespace oblong
