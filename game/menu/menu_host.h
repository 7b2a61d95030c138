#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/input/bindings.h"
#include "game/input/key_names.h"
#include "game/menu/menu_page.h"
#include "game/options/preferences.h"
#include "game/simulation/goal.h"

namespace oblong {

/// A place for a saved game, as the menu shows it.
struct SaveEntry {
    std::string name;     ///< "Slot 1"
    std::string content;  ///< "demo 3:12, 5 of 12 lenses"; "empty"
    std::string help;     ///< a line, for KeyNames::in(); of a save that can't be loaded load() says more
    bool is_saved_to_by_player = false;  ///< and not by keys or the game alone
    bool is_empty = true, has_game = false;
    bool is_of_this_walk = false;  ///< of the walk that is on, which goes back to it by loading it
    std::optional<MenuPicture> picture;
};

/// A level that can be walked.
struct LevelEntry {
    std::string name;   ///< "e1m1"
    std::string file;   ///< what play_level() takes
    std::string title;  ///< what its maker calls it; may be empty
};

/// How a walk ended.
struct EndFigures {
    std::string message;     ///< what the level says; may be empty
    std::string time;        ///< "3:12"
    std::string lenses;      ///< "Lenses found: 5 of 12"; empty where the level has none
    std::string next_level;  ///< "e1m2"; empty where there is none
    std::string fault;       ///< why the level that follows cannot be played, which it names; may be empty
};

/// What the menu's pages know of the program, and have it do.
class MenuHost {
  public:
    virtual ~MenuHost() = default;

    virtual Preferences& preferences() = 0;
    virtual KeyNames key_names() const = 0;
    virtual std::string local_name_of(Input input) const = 0;
    virtual std::vector<KeyHelp> key_help() const = 0;  ///< of what is up behind the menu
    virtual std::string game_title() const = 0;         ///< in capitals
    virtual Goal goal() const = 0;                      ///< of the walk
    virtual std::vector<std::string> told() const = 0;  ///< the messages of a walk, the newest first
    virtual std::string figures() const = 0;            ///< of the gallery's row that is up

    virtual std::vector<LevelEntry> levels() const = 0;
    virtual std::vector<SaveEntry> saves() const = 0;
    virtual EndFigures end_figures() const = 0;
    virtual std::string credits() const = 0;

    virtual bool can_save() const = 0;  ///< a walk is on, and there is a place for saves
    /// The walk that was saved last; nothing if there is none.
    virtual std::optional<SaveEntry> last_walk() const = 0;
    /// Whether something of a walk that is on is not saved.
    virtual bool has_unsaved_progress() const = 0;
    /// Whether leaving a walk saves it.
    virtual bool saves_on_leaving() const = 0;

    virtual void walk() = 0;  ///< the demo level, from its start
    virtual void continue_walk() = 0;
    virtual void restart() = 0;
    virtual void play_level(const std::string& file) = 0;
    virtual void play_next() = 0;                            ///< EndFigures::next_level
    virtual void save(std::size_t entry) = 0;                ///< of saves()
    virtual void load(std::size_t entry) = 0;                ///< says why where there is none to load
    virtual std::string remove_save(std::size_t entry) = 0;  ///< the message if that failed, else ""
    virtual void show_title() = 0;
    virtual void show_gallery() = 0;
    virtual void leave() = 0;
};

}  // namespace oblong
