#pragma once

#include "engine/platform/platform.h"
#include "game/choices.h"
#include "game/hands.h"
#include "game/hud.h"
#include "game/load.h"
#include "game/painter.h"
#include "game/tick_clock.h"

namespace oblong {

/// What a session is played with.
struct SessionSettings {
    ScreenMode mode;
    Degrees field_of_view;
    Choices choices;
    std::string screenshot_folder = ".";
};

/// A game from its start until the platform closes: the loop of input, ticks and frames.
class Session {
  public:
    /// All outlive the session.
    Session(const GameData& data, const Stage& stage, const SessionSettings& settings, Hands& hands,
            Platform& platform);

    void run();

  private:
    void play_frame();
    void advance(std::uint64_t now_us);
    void draw(std::uint64_t now_us);
    void obey(const Controls& controls, std::uint64_t now_us);
    void note_cost(std::uint64_t began_us, std::uint64_t ended_us);

    const GameData& data_;
    const Stage& stage_;
    Hands& hands_;
    Platform& platform_;
    Choices choices_;
    Degrees field_of_view_;
    std::string screenshot_folder_;
    Painter painter_;
    Inks inks_;
    Hud hud_;
    TickClock clock_;
    GameState before_, after_;
    std::uint64_t last_us_ = 0;
    std::uint64_t cost_since_us_ = 0, drawing_us_ = 0;
    std::uint64_t frames_since_ = 0;
    bool wants_screenshot_ = false;
};

}  // namespace oblong
