#pragma once

#include <memory>

#include "engine/platform/platform.h"
#include "game/automap.h"
#include "game/four_aspects.h"
#include "game/game_renderer.h"
#include "game/hud.h"
#include "game/lab.h"
#include "game/loaded_level.h"
#include "game/game_screen.h"
#include "game/shown_palette.h"
#include "game/tick_clock.h"
#include "game/tick_input_source.h"
#include "game/view_options.h"
#include "tools/common/frame_log.h"

namespace oblong {

/// The settings that a session begins with.
struct SessionSettings {
    ScreenMode mode;
    Degrees field_of_view;
    Workers* workers = nullptr;  ///< who share in drawing the game's pictures; null: one thread draws
    std::string screenshot_folder = ".";
};

/// One game in one level: ticks, what keys switch on, and the picture.
class Session final : public GameScreen {
  public:
    /// The game starts at the level's start. `view_options`, which keys change, `platform` and the workers outlive the
    /// session.
    Session(std::shared_ptr<const LoadedLevel> loaded, const SessionSettings& settings, ViewOptions& view_options,
            TickInputSource input, Platform& platform);

    void advance(const Controls& controls, std::uint64_t now_us) override;
    void pause(std::uint64_t now_us) override;
    ShownPicture draw() override;

    const LoadedLevel& loaded() const { return *loaded_; }
    const GameState& state() const { return after_; }
    const TickInputSource& input() const { return input_; }

  private:
    void play_due_ticks(std::uint64_t elapsed_us);
    void inspect(const GameView& view);
    void draw_over(const GameView& view, const Settings& settings);
    void draw_wires(const GameView& view, const Settings& settings);
    void handle_commands(const Controls& controls);
    void keep_what_is_on();
    PresentRect shown_rect() const;
    void note_cost(const GameView& view, const Settings& settings, const PaletteEffects& effects,
                   std::uint64_t began_us);

    std::shared_ptr<const LoadedLevel> loaded_;
    const GameData& data_;    // of loaded_
    const GameLevel& level_;  // likewise
    TickInputSource input_;
    Platform& platform_;
    ViewOptions& view_options_;
    Degrees field_of_view_;
    std::string screenshot_folder_;
    GameRenderer renderer_;
    std::unique_ptr<Lab> lab_;                   // only while something of it is on
    std::unique_ptr<FourAspects> four_aspects_;  // likewise
    std::unique_ptr<FrameLog> log_;              // likewise
    std::unique_ptr<Automap> map_;               // likewise
    std::unique_ptr<LineColour> wire_colour_;    // of the edges of faces; likewise
    ShownPalette palette_;
    TextColours text_colours_;
    Hud hud_;
    TickClock clock_;
    GameState before_, after_;
    std::uint64_t last_us_;            // the platform's time up to which the game was played
    std::uint64_t played_us_ = 0;      // since the session began, without pauses
    std::unique_ptr<FrameCost> cost_;  // only while it is shown
    std::int32_t text_bottom_ = 0;     // the row above which the text at the bottom ends
    bool wants_screenshot_ = false;
};

}  // namespace oblong
