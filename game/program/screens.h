#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "game/menu/menu_pages.h"
#include "game/options/preferences_store.h"
#include "game/program/played_game.h"
#include "game/program/program_files.h"
#include "game/program/program_parts.h"
#include "game/program/session.h"
#include "game/program/title.h"
#include "game/program/walk_saves.h"
#include "game/sound/game_sound.h"

namespace oblong {

/// The screens behind the menu (title, walk, gallery), their order, their saves and their sound. Implements the menu's
/// interface to the program.
class Screens final : public MenuHost {
  public:
    /// `store`, which keeps the player's changes, `platform` and the workers outlive it.
    Screens(const Options& options, ProgramFiles files, PreferencesStore& store, Platform& platform,
            ProgramParts parts);

    GameScreen& up() { return *screens_.back(); }
    const GameScreen& up() const { return *screens_.back(); }
    Menu& menu() { return menu_; }
    MenuPages& pages() { return pages_; }
    ViewOptions& view_options() { return view_options_; }
    bool has_left() const { return has_left_; }
    bool is_gallery_over_another() const { return screens_.size() > 1; }
    /// A walk or a replay is on the screen.
    bool is_in_level() const { return walk_ && &up() == walk_; }
    bool is_walking() const { return is_in_level() && walk_->kind() == SessionKind::Walk; }
    /// Whether the screen or its level has changed since the last call.
    bool take_has_changed() { return std::exchange(has_changed_, false); }
    /// What the menu asked the screen for, if it did.
    std::optional<Action> take_asked() { return std::exchange(asked_, {}); }

    /// Work between two pictures: autosaves the walk, reloads a level whose source has changed, and applies the sound
    /// settings.
    void follow();
    void play(Sound sound) { sound_.play(sound); }
    void close_gallery();  ///< back to the screen below
    void quick_save();
    void quick_load();
    /// Saves the walk, as leaving does. Returns the error, or "".
    std::string keep() { return saves_.save_on_leaving(); }
    /// Writes the recorded demo, if any. Throws FileError.
    void finish();

    // MenuHost's.
    Preferences& preferences() override { return view_options_.preferences; }
    KeyNames key_names() const override { return view_options_.key_names(platform_); }
    std::string local_name_of(Input input) const override { return platform_.local_name_of(input); }
    std::vector<KeyHelp> key_help() const override { return screens_.back()->key_help(key_names()); }
    std::string game_title() const override { return game_.title(); }
    Goal goal() const override { return walk_ ? goal_of(walk_->loaded().level, walk_->state()) : Goal{}; }
    std::vector<std::string> messages() const override {
        return walk_ ? walk_->messages() : std::vector<std::string>();
    }
    std::string figures() const override { return screens_.back()->figures(); }
    std::vector<LevelEntry> levels() const override { return game_.levels(level_below()); }
    std::vector<SaveEntry> saves() override;
    EndFigures end_figures() const override;
    std::string credits() const override { return game_.credits(); }
    bool can_save() const override { return saves_.can_save(); }
    std::optional<SaveEntry> last_walk() const override;
    bool has_unsaved_progress() const override { return saves_.has_unsaved_progress(); }
    void act(Action action) override { asked_ = action; }
    void walk() override;
    bool has_visit() const override { return level_below().level.visit != kNoTarget; }
    void visit() override;
    void continue_walk() override { load_from(last_walk_->slot); }
    void restart() override;
    void play_level(const std::string& file) override;
    void play_next() override;
    std::string save_picture(const std::string& text) override { return walk_->save_picture(text); }
    std::string save(std::size_t entry) override;
    void load(std::size_t entry) override { load_from(listed_.at(entry).slot); }
    std::string remove_save(std::size_t entry) override;
    void show_title() override;
    bool has_gallery() const override { return game_.definition().has_gallery; }
    void show_gallery() override;
    void leave() override;

  private:
    /// The first walk, with or without a title before it: a replay, a recorded walk, or one in a level that is named.
    struct FirstWalk {
        std::shared_ptr<const LoadedLevel> loaded;
        TickInputSource input;
    };

    void show_only(std::unique_ptr<GameScreen> screen);
    void finish_walk(const LoadedLevel& next);
    void start(std::shared_ptr<const LoadedLevel> loaded, TickInputSource input, SessionKind kind);
    void start_walk(std::shared_ptr<const LoadedLevel> loaded);
    void begin_in_room();
    void start_title(std::shared_ptr<const LoadedLevel> loaded);
    const LoadedLevel& level_below() const { return *screens_.front()->shared_level(); }
    std::shared_ptr<const LoadedLevel> load_level(const std::string& file) const;
    const Demo* recorded_demo() const;  // null: none
    void keep_recorded();
    void follow_map();
    void show_changed_level();
    void follow_game(const LoadedLevel& loaded);
    void name_window();  ///< by the level's name
    /// Runs work with files; shows its error on a page of the menu.
    void try_with_files(const std::string& what, const std::function<void()>& work);
    void load_from(SaveSlot slot);
    /// `why_new`: why the game goes on as a new walk, if it does.
    void go_on_with(const SlotContent& content, std::optional<HeldWalk> held, const std::string& why_new);
    /// Saves the walk, then calls `go`; if saving fails, asks first.
    void leave_walk(const std::function<void()>& go);

    const Options options_;
    const PlayedGame game_;
    ViewOptions view_options_;
    PreferencesStore& store_;
    Platform& platform_;
    const ProgramParts parts_;
    const std::shared_ptr<LevelWatch> watch_;
    GameSound sound_;
    WalkSaves saves_;
    std::unique_ptr<FirstWalk> first_walk_;             // until it begins, as by "Walk" on the title
    std::vector<std::unique_ptr<GameScreen>> screens_;  // the title or a walk, and perhaps the gallery over it
    Session* walk_ = nullptr;                           // the walk, if the first screen is one
    std::unique_ptr<Demo> recorded_;                    // of a recorded walk that has ended
    Menu menu_;
    MenuPages pages_;
    std::optional<ListedSlot> last_walk_;  // offered by the title
    std::optional<Action> asked_;
    std::vector<ListedSlot> listed_;  // as last shown by the menu
    bool has_left_ = false, has_changed_ = true, is_first_game_ = true;
};

}  // namespace oblong
