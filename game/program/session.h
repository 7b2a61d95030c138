#pragma once

#include <memory>
#include <set>
#include <string_view>

#include "engine/files/frame_log.h"
#include "engine/platform/platform.h"
#include "game/input/key_names.h"
#include "game/input/tick_input_source.h"
#include "game/lab/four_aspects.h"
#include "game/lab/lab.h"
#include "game/level/loaded_level.h"
#include "game/program/game_screen.h"
#include "game/program/view_options.h"
#include "game/saves/thumbnail.h"
#include "game/simulation/tick_clock.h"
#include "game/sound/game_sound.h"
#include "game/view/automap.h"
#include "game/view/game_renderer.h"
#include "game/view/hud.h"
#include "game/view/shown_palette.h"

namespace oblong {

enum class SessionKind : std::uint8_t {
    Walk,
    Replay,  ///< of a demo, after which the player walks on; it cannot be saved
    Title    ///< behind the title: no overlays are drawn, whatever is on
};

/// What a session is given and never changes.
struct SessionSettings {
    Workers* workers = nullptr;  ///< who share in drawing the game's pictures; null: one thread draws
    std::string screenshot_folder = ".";
    GameSound* sound = nullptr;  ///< that is heard; null: none, not even captions
    SessionKind kind = SessionKind::Walk;
};

/// One game in one level: ticks, what keys switch on, and the picture.
class Session final : public GameScreen {
  public:
    /// The game starts at the level's start. `view_options`, which keys change, `platform` and the workers outlive the
    /// session.
    Session(std::shared_ptr<const LoadedLevel> loaded, const SessionSettings& settings, ViewOptions& view_options,
            TickInputSource input, Platform& platform);

    void advance(const Controls& controls, std::uint64_t now_us) override;
    void advance_behind_menu(std::uint64_t now_us) override {
        last_us_ = now_us;
        has_drawn_ = false;
    }
    bool captures_mouse() const override;
    /// A level's last sounds are heard to their end.
    bool is_heard(bool is_behind_menu) const override { return !is_behind_menu || after_.has_ended; }
    ShownPicture draw(bool is_behind_menu) override;
    const MenuLook& menu_look() const override { return menu_look_; }
    void open_page(Action command, MenuPages& pages) override;
    void open_due_page(MenuPages& pages) override;
    const std::shared_ptr<const LoadedLevel>& shared_level() const override { return loaded_; }
    std::vector<KeyHelp> key_help(const KeyNames& names) const override { return game_help(names); }

    /// Goes on from another state of the level.
    void restore(const GameState& state);
    /// Shows the player a message, with the names of keys in it (KeyNames::in()).
    void show(const std::string& message);
    /// Shows a path in the level from now on, through walls too; an empty one ends that.
    void show_path(std::vector<Vec3<World>> points);
    /// What the player was told, the newest first.
    const std::vector<std::string>& told() const { return messages_.told(); }
    /// The game's picture as it is now, without text.
    Thumbnail thumbnail();

    const LoadedLevel& loaded() const { return *loaded_; }
    const GameState& state() const { return after_; }
    const TickInputSource& input() const { return input_; }
    SessionKind kind() const { return settings_.kind; }

  private:
    GameView shown_view() const;
    KeyNames key_names() const;
    Palette palette_of(const GameView& view, const PaletteEffects& effects) const;
    void play_due_ticks(std::uint64_t elapsed_us);
    void warn_of(const TickReport& report);
    void inspect(const GameView& view);
    void show_level_message();
    void draw_over(const GameView& view, const Settings& settings);
    void draw_text();
    TextColours scaled_text() const;
    void draw_path(const GameView& view, const Settings& settings);
    void draw_wires(const GameView& view, const Settings& settings);
    void handle_commands(const Controls& controls);
    void keep_what_is_on();
    void follow_mode();
    void follow_colours();
    void note_cost(const GameView& view, const Settings& settings, const PaletteEffects& effects);

    std::shared_ptr<const LoadedLevel> loaded_;
    const GameData& data_;    // of loaded_
    const GameLevel& level_;  // likewise
    TickInputSource input_;
    Platform& platform_;
    ViewOptions& view_options_;
    Overlays no_overlays_;
    Overlays& overlays_;  // view_options_, or none
    SessionSettings settings_;
    std::unique_ptr<GameRenderer> renderer_;               // of the mode that is chosen now
    ColourScheme drawn_colours_ = ColourScheme::Standard;  // of what is below
    std::int32_t lab_text_scale_ = 1;                      // that lab_ was made for
    std::unique_ptr<Lab> lab_;                             // only while something of it is on
    std::unique_ptr<FourAspects> four_aspects_;            // likewise
    std::unique_ptr<FrameLog> log_;                        // likewise
    std::unique_ptr<Automap> map_;                         // likewise
    std::unique_ptr<LineColour> wire_colour_;              // of the edges of faces; likewise
    std::vector<Vec3<World>> path_;
    std::unique_ptr<LineColour> path_colour_;  // likewise, while there is one
    ShownPalette palette_;
    TextColours text_colours_;
    const MenuLook menu_look_;
    Messages messages_;
    HudText text_;
    TickClock clock_;
    GameState before_, after_;
    std::uint64_t last_us_;            // the platform's time up to which the game was played
    std::uint64_t played_us_ = 0;      // since the session began, without pauses
    std::unique_ptr<FrameCost> cost_;  // only while it is shown
    CostText cost_text_;
    std::int32_t text_bottom_ = 0;  // the row above which the text at the bottom ends
    bool wants_screenshot_ = false;
    bool has_drawn_ = false;                // thumbnail(): the picture that the next draw() shows
    std::set<std::string_view> warned_of_;  // what a tick left for later
};

}  // namespace oblong
