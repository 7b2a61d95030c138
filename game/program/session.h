#pragma once

#include <memory>
#include <set>
#include <string_view>

#include "engine/platform/platform.h"
#include "game/input/bindings.h"
#include "game/input/tick_input_source.h"
#include "game/level/load.h"
#include "game/program/game_screen.h"
#include "game/program/shown_overlays.h"
#include "game/program/view_options.h"
#include "game/saves/saved_game.h"
#include "game/simulation/tick.h"
#include "game/sound/game_sound.h"
#include "game/view/game_renderer.h"
#include "game/view/hud.h"
#include "game/view/shown_view.h"

namespace oblong {

enum class SessionKind : std::uint8_t {
    Walk,
    Replay,  ///< of a demo, after which the player goes on; cannot be saved
    Title    ///< behind the title: draws no overlays
};

/// The fixed settings of a session.
struct SessionSettings {
    Workers* workers = nullptr;  ///< that share the drawing; null: one thread
    GameSound* sound = nullptr;  ///< null: neither sound nor captions
    SessionKind kind = SessionKind::Walk;
    OpenErrorMeter open_meter = nullptr;
};

/// One game in one level: its ticks, overlays and picture.
class Session final : public GameScreen {
  public:
    /// The game begins at the level's start. `view_options`, which keys change, `platform` and the workers outlive the
    /// session.
    Session(std::shared_ptr<const LoadedLevel> loaded, const SessionSettings& settings, ViewOptions& view_options,
            TickInputSource input, Platform& platform);

    void advance(const Controls& controls, std::uint64_t now_us) override;
    void advance_behind_menu(std::uint64_t now_us) override {
        last_us_ = now_us;
        has_drawn_ = false;
    }
    bool captures_mouse() const override;
    /// After the end of a level its last sounds play on.
    bool is_heard(bool is_behind_menu) const override { return !is_behind_menu || state().has_ended; }
    ShownPicture draw(bool is_behind_menu) override;
    std::uint64_t shows_until_us() const override { return shows_until_us_; }
    std::optional<ShownPicture> recoloured() override;
    const MenuLook& menu_look() const override { return menu_look_; }
    void open_page(Action command, MenuPages& pages) override;
    void open_due_page(MenuPages& menu) override;
    const std::shared_ptr<const LoadedLevel>& shared_level() const override { return loaded_; }
    std::vector<KeyHelp> key_help(const KeyNames& names) const override;
    /// The time and the error of the picture that is shown.
    std::string figures() const override;

    /// Opens what the level opens for who only wants to walk.
    void visit() { input_.visit(); }
    /// Continues from another state of the level.
    void restore(const GameState& state);
    /// Shows the player a message, or its pages, with the names of keys in it (KeyNames::in()).
    void show(const std::string& message);
    /// Saves the view without overlays, with a text under it; what to tell the player, for KeyNames::in().
    std::string save_picture(const std::string& text);
    /// All messages to the player, the newest first.
    const std::vector<std::string>& messages() const { return messages_.all(); }
    /// The game's current picture, without text.
    Thumbnail thumbnail();

    const LoadedLevel& loaded() const { return *loaded_; }
    const GameState& state() const { return after_; }
    /// 0 while the level goes on.
    std::int64_t ticks_since_end() const { return state().has_ended ? state().tick - ended_tick_ : 0; }
    const TickInputSource& input() const { return input_; }
    SessionKind kind() const { return settings_.kind; }

  private:
    ShownPicture draw_all(bool is_behind_menu);
    void draw_picture(const GameView& view, const Settings& drawn);
    void follow_demo();
    std::string turn_exhibit();
    std::string map_key() const;
    std::int64_t intermission_ticks() const {
        return loaded_->level.intermission && !state().is_lost() ? loaded_->level.intermission->wait_ticks : 0;
    }
    std::optional<Processor> machine() const;
    InterpolatedState shown() const { return {before_, after_, clock_.fraction_16()}; }
    GameView shown_view() const;
    Palette palette_of(const InterpolatedState& state, const PaletteEffects& effects) const;
    void note_tick(const TickReport& report, bool is_last);
    void warn_of(const TickReport& report);
    void handle_commands(const Controls& controls);
    bool has_lab() const { return !loaded_->files.game || loaded_->files.game->has_lab; }
    void follow_mode();

    std::shared_ptr<const LoadedLevel> loaded_;
    Platform& platform_;
    ViewOptions& view_options_;
    SessionSettings settings_;
    TickInputSource input_;
    TickClock clock_;
    GameState before_, after_;                // the picture is between them
    std::unique_ptr<GameRenderer> renderer_;  // for the current mode
    ShownPalette palette_;
    PaletteEffects shown_effects_;  // of the last picture
    Palette shown_colours_;
    Overlays no_overlays_;  // of a title
    ShownOverlays overlays_;
    const MenuLook menu_look_;
    Messages messages_;
    std::string pages_;      // of a message that the menu shows next
    std::uint64_t last_us_;  // the platform's time up to which the game was played
    std::uint64_t shows_until_us_ = 0;
    std::int64_t ended_tick_ = 0;           // after which the level's intermission is shown
    std::int64_t cycles_ = 0;               // that the chosen machine takes for the last picture
    std::uint16_t work_ = 0;                // of the last picture: TickInput::work
    ViewDials replayed_view_ = kUsualView;  // of the replay's last tick
    std::uint64_t played_us_ = 0;           // since the session began, without pauses
    bool wants_screenshot_ = false;
    bool has_drawn_ = false;                // thumbnail() has drawn the picture of the next draw()
    std::set<std::string_view> warned_of_;  // kinds of work left by ticks
};

}  // namespace oblong
