#pragma once

#include <optional>

#include "game/menu/menu.h"
#include "game/menu/menu_host.h"
#include "game/options/preference_table.h"

namespace oblong {

/// The bindings before their last change; nothing if there was none.
using KeyUndo = std::optional<Bindings>;

/// Opens the page of all actions and their keys; each row opens a page that changes it. All arguments outlive the
/// pages.
void open_key_pages(Menu& menu, MenuHost& host, KeyUndo& undo);

/// The inputs of an action as the player's keyboard names them: "W, Up"; "none".
std::string inputs_text(MenuHost& host, Action action);

/// Added to a question if leaving a walk loses progress.
inline constexpr const char* kLost = " What is not saved is lost.";

/// A row with an action; its help begins with a capital.
MenuRow menu_row(std::string label, std::function<void()> accept, std::string help = "");

/// Opens the pages of the menu.
class MenuPages {
  public:
    /// Both outlive it.
    MenuPages(Menu& menu, MenuHost& host) : menu_(menu), host_(host) {}

    void open_title();
    void open_game();     ///< over a walk
    void open_keys();     ///< help on keys, over a walk or a gallery
    void open_figures();  ///< over a gallery
    void open_gallery();  ///< over a gallery with nothing behind it
    void open_end();      ///< after a walk
    void open_light();    ///< a test picture, to set the light of the game that is played
    void open_restart();  ///< asks first, if there is unsaved progress
    /// A text with one row, "OK".
    void open_message(std::string title, std::string text);
    /// Shows why a walk could not be saved, and asks whether to leave it anyway; if so, calls `go`.
    void open_not_saved(const std::string& fault, std::function<void()> go);

  private:
    void open_options();
    void open_preferences(int page);
    void open_levels();
    void open_load();
    void open_delete();
    void open_save();
    void open_credits();
    void open_told();
    void open_text(std::string title, std::string text, std::optional<Action> closed_by);

    MenuPage title_page();
    MenuPage game_page();
    MenuPage end_page(const EndFigures& figures);
    MenuPage options_page();
    MenuPage preferences_page(int page);
    std::string help_of(const Preference& preference);
    MenuRow save_row(const SaveEntry& save, std::function<void()> accept) const;
    MenuRow back_row();

    void ask(std::string title, std::string text, std::string yes, std::function<void()> action);
    /// Closes all pages, then runs the action.
    std::function<void()> closing(std::function<void()> action);
    void ask_to_leave();
    /// Asks before `action` if the walk has progress that leaving it does not save.
    void leave_walk(const std::string& question, std::function<void()> action);

    Menu& menu_;
    MenuHost& host_;
    KeyUndo key_undo_;
};

}  // namespace oblong
