#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/input/bindings.h"
#include "game/menu/menu.h"
#include "game/menu/menu_layout.h"
#include "game/options/preference_table.h"
#include "game/options/preferences.h"
#include "game/simulation/items.h"

namespace oblong {

/// A save slot, as the menu shows it.
struct SaveEntry {
    std::string name;                    ///< "Slot 1"
    std::string content;                 ///< "demo 3:12, 5 of 12 lenses"; "empty"
    std::string help;                    ///< a line; may be empty
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
    std::string message;     ///< the level's, or the game's
    std::string time;        ///< "3:12"
    std::string lenses;      ///< "Lenses found: 5 of 12"; empty if the level has none
    std::string secrets;     ///< "Secrets found: 1 of 4"; empty if the level has none
    std::string missed;      ///< "Missed: an egg among spheres"; may be empty
    std::string picture;     ///< time and error of the last picture; may be empty
    std::string next_level;  ///< "e1m2"; empty if there is none
    std::string fault;       ///< why the next level, which it names, cannot be played; may be empty
    bool is_lost = false;    ///< the player died
};

/// The interface of the program for the menu's pages.
class MenuHost {
  public:
    virtual ~MenuHost() = default;

    virtual Preferences& preferences() = 0;
    virtual KeyNames key_names() const = 0;
    virtual std::string local_name_of(Input input) const = 0;
    virtual std::vector<KeyHelp> key_help() const = 0;      ///< of the screen behind the menu
    virtual std::string game_title() const = 0;             ///< in capitals
    virtual Goal goal() const = 0;                          ///< of the walk
    virtual std::vector<std::string> messages() const = 0;  ///< the messages of a walk, the newest first
    virtual std::string figures() const = 0;                ///< of the gallery's current row

    virtual std::vector<LevelEntry> levels() const = 0;
    virtual std::vector<SaveEntry> saves() = 0;  ///< save(), load() and remove_save() take an index of the last ones
    virtual EndFigures end_figures() const = 0;
    virtual std::string credits() const = 0;

    /// Whether there is a walk and a folder for saves: leaving the walk saves it.
    virtual bool can_save() const = 0;
    /// The walk that was saved last; nothing if there is none.
    virtual std::optional<SaveEntry> last_walk() const = 0;
    /// Whether the current walk has unsaved progress.
    virtual bool has_unsaved_progress() const = 0;

    virtual void act(Action action) = 0;  ///< what its key does, once no page is open
    virtual void walk() = 0;              ///< a new walk from the game's first level
    virtual bool has_visit() const = 0;   ///< whether visit() differs from walk()
    virtual void visit() = 0;             ///< the same, with all doors open
    virtual void continue_walk() = 0;
    virtual void restart() = 0;
    virtual void play_level(const std::string& file) = 0;
    virtual void play_next() = 0;  ///< EndFigures::next_level
    /// Saves the picture behind the menu with a text under it; what to tell the player.
    virtual std::string save_picture(const std::string& text) = 0;
    virtual std::string save(std::size_t entry) = 0;         ///< of saves(); the error, or ""
    virtual void load(std::size_t entry) = 0;                ///< shows the reason if it cannot be loaded
    virtual std::string remove_save(std::size_t entry) = 0;  ///< the error, or ""
    virtual void show_title() = 0;
    virtual bool has_gallery() const { return true; }
    virtual void show_gallery() = 0;
    virtual void leave() = 0;
};

/// The bindings before their last change; nothing if there was none.
using KeyUndo = std::optional<Bindings>;

/// Opens the page of all actions and their keys; each row opens a page that changes it. All arguments outlive the
/// pages.
void open_key_pages(Menu& menu, MenuHost& host, KeyUndo& undo);

/// The inputs of an action as the player's keyboard names them: "W, Up"; "none".
std::string inputs_text(MenuHost& host, Action action);

/// Added to a question if leaving a walk loses progress.
inline constexpr const char* kLost = " What is not saved is lost.";

/// Opens the pages of the menu.
class MenuPages {
  public:
    /// Both outlive it.
    MenuPages(Menu& menu, MenuHost& host) : menu_(menu), host_(host) {}

    void open_title();
    void open_game();  ///< over a walk
    void open_keys();  ///< what each key does, and does it if it is chosen; over a walk or a gallery
    void open_figures() { open_text("All figures", host_.figures(), Action::FrameCost); }  ///< over a gallery
    void open_gallery();  ///< over a gallery with nothing behind it
    void open_end();      ///< after a walk
    void open_light();    ///< a test picture, to set the light of the game that is played
    void open_restart();  ///< asks first, if there is unsaved progress
    /// A text whose pages the player turns: a heading, and pages that each begin with kNewPage.
    void open_pages(const std::string& text);
    /// A text with one row, "OK".
    void open_message(std::string title, std::string text);
    /// Shows why a walk could not be saved, and asks whether to leave it anyway; if so, calls `go`.
    void open_not_saved(const std::string& fault, std::function<void()> go);

  private:
    void open_options();
    void open_levels();
    void open_load();
    void open_delete();
    void open_save();
    void open_messages();
    void open_page_of(const std::vector<std::string>& pages, std::size_t number);
    void open_text(std::string title, std::string text, std::optional<Action> closed_by);

    MenuPage title_page();
    MenuPage game_page();
    MenuPage end_page(const EndFigures& figures);
    MenuPage options_page();
    MenuPage preferences_page(PreferencePage page);
    MenuRow preference_row(const Preference& preference);
    MenuRow save_row(const SaveEntry& save, std::function<void()> accept) const;
    void add_keys(MenuPage& page);
    void add_back(MenuPage& page);

    void ask(std::string title, std::string text, std::string yes, std::function<void()> action);
    /// Closes all pages, then does what the only one of the actions does.
    std::function<void()> acting(const std::vector<Action>& actions);
    /// Closes all pages, then runs the action.
    std::function<void()> closing(std::function<void()> action);
    /// Asks before `action` if the walk has progress that leaving it does not save.
    void leave_walk(const std::string& question, std::function<void()> action);

    Menu& menu_;
    MenuHost& host_;
    KeyUndo key_undo_;
};

}  // namespace oblong
