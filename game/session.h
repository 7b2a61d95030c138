#pragma once

#include <memory>

#include "engine/platform/platform.h"
#include "game/automap.h"
#include "game/four_aspects.h"
#include "game/game_renderer.h"
#include "game/hud.h"
#include "game/lab.h"
#include "game/load.h"
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
    ViewOptions view_options;
    Workers* workers = nullptr;  ///< who share in drawing the game's pictures; null: one thread draws
    std::string screenshot_folder = ".";
};

/// A game from its start until the platform closes: the loop of input, ticks and frames.
class Session {
  public:
    /// All arguments must outlive the session.
    Session(const GameData& data, const GameLevel& level, const SessionSettings& settings, TickInputSource& input,
            Platform& platform);

    void run();

  private:
    void play_frame();
    void advance(std::uint64_t now_us);
    void draw(std::uint64_t now_us);
    void inspect(const GameView& view);
    void draw_over(const GameView& view, const Settings& settings, std::uint64_t now_us);
    void draw_wires(const GameView& view, const Settings& settings);
    void handle_commands(const Controls& controls, std::uint64_t now_us);
    void keep_what_is_on();
    PresentRect shown_rect() const;
    void note_cost(const GameView& view, const Settings& settings, const PaletteEffects& effects,
                   std::uint64_t began_us);

    const GameData& data_;
    const GameLevel& level_;
    TickInputSource& input_;
    Platform& platform_;
    ViewOptions view_options_;
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
    std::uint64_t last_us_ = 0;
    std::unique_ptr<FrameCost> cost_;  // only while it is shown
    std::int32_t text_bottom_ = 0;     // the row above which the text at the bottom ends
    bool wants_screenshot_ = false;
};

}  // namespace oblong
