#pragma once

#include <string>

#include "engine/accuracy/presets.h"
#include "engine/frame/settings.h"
#include "engine/platform/controls.h"
#include "engine/platform/present_rect.h"
#include "engine/screen/screen.h"
#include "game/lab_options.h"
#include "game/line_overlays.h"
#include "tools/common/log_channels.h"

namespace oblong {

/// What keys change during a game: how it is drawn and shown, never what happens in it.
struct ViewOptions {
    Preset preset = Preset::Bounded;  ///< the last one chosen
    Accuracy accuracy;                ///< its dials, perhaps turned since
    std::int32_t brightness_100 = 100;
    std::int32_t gamma_100 = 100;
    Flashes flashes = Flashes::Full;
    bool corrects_projection = true, has_torch = false, has_crt_look = false;
    bool is_isometric = false;      ///< the level from outside, instead of from the player's eye
    std::int32_t zoom_degrees = 0;  ///< the field of view of zoom against dolly; 0: off
    ShownAs shown_as = ShownAs::OnDisplay;
    Scaling scaling = Scaling::SharpBilinear;
    bool shows_help = false, shows_cost = false, shows_aspect_guide = false, shows_four_aspects = false;
    bool inspects = false;  ///< says what is in the middle of the picture
    LogChannels log;        ///< written on standard error while any is on
    MapView map = MapView::Off;
    Wireframe wireframe = Wireframe::Off;
    LineMethod line_method = LineMethod::GuptaSproull;  ///< of both
    LabOptions lab;
};

Settings settings_of(const ViewOptions& options);

/// Carries out a command; the message that tells the user ("" where there is none). Ignores Command::Screenshot.
std::string apply(Command command, ViewOptions& options, const ScreenMode& mode, WindowSize window);

}  // namespace oblong
