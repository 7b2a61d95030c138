#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/accuracy/accuracy.h"
#include "engine/costs/costs.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/scene/light_styles.h"
#include "engine/view/present_rect.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"
#include "game/input/bindings.h"
#include "game/input/tick_input_source.h"

namespace oblong {

/// The colours of signs, which carry a meaning: text, lines of the map, the map of the error, keys.
enum class ColourScheme : std::uint8_t {
    Standard,
    RedGreen,   ///< for players who confuse red and green: blue, orange, white, of different brightness
    BlueYellow  ///< for players who confuse blue and yellow: red, cyan, white
};
inline constexpr int kColourSchemeCount = 3;

/// Whether the map is shown, and which direction is up.
enum class MapView : std::uint8_t { Off, PlayerUp, NorthUp };
inline constexpr int kMapViewCount = 3;

/// Whether the edges of visible faces are drawn: over the picture, or alone.
enum class Wireframe : std::uint8_t { Off, Over, Alone };
inline constexpr int kWireframeCount = 3;

/// How a game's pictures are lit.
struct Light {
    std::int32_t brightness_100 = 100;  ///< of the light on surfaces, 25 to 800
    std::int32_t gamma_100 = 100;       ///< of the display, 50 to 200
    bool is_of_tube = false;            ///< colours as a tube showed them
    bool operator==(const Light&) const = default;
};
/// Games without a folder: Oblong's own levels, and levels without a --game.
inline constexpr const char *kMuseum = "museum", *kQuake = "quake";
/// The default light of a game: all games except the museum were made on tubes.
inline Light light_of_new(const std::string& game) {
    return {100, 100, game != kMuseum};
}

/// How much of a picture shows the view, as in games of 1993 for slow machines.
struct ViewSize {
    std::int32_t size_100 = 100;   ///< of its width and height, 30 to 100; the rest is a border
    bool doubles_columns = false;  ///< half as many columns are drawn, each is shown twice
    bool operator==(const ViewSize&) const = default;
};

/// The picture, and how a window shows it.
struct PicturePreferences : ViewSize {
    ScreenMode mode;  ///< of the picture, and the display that it is for
    Degrees field_of_view = Degrees::from_int(90);
    bool corrects_projection = true;  ///< the projection is for the display's shape
    ShownAs shown_as = ShownAs::OnDisplay;
    Scaling scaling = Scaling::SharpBilinear;
    bool has_crt_look = false;
    bool has_dac6 = false;  ///< colours of 6 bits a channel
    bool operator==(const PicturePreferences&) const = default;
};

struct WindowPreferences {
    bool fills_screen = false;        ///< the whole screen instead of a window
    bool waits_for_display = true;    ///< vsync, where the system offers it
    std::int32_t frame_cap_hz = 144;  ///< the most frames a second, 1 to 1,000; 0: no limit
    bool operator==(const WindowPreferences&) const = default;
};

struct ComfortPreferences {
    Flashes flashes = Flashes::Full;
    std::int32_t view_bob_100 = 0;      ///< vertical motion of the view in walking, 0 to 200, 100: as in Quake
    std::int32_t view_roll_100 = 0;     ///< roll in stepping sideways; likewise
    std::int32_t game_speed_100 = 100;  ///< game time per real time, 25 to 1,600
    std::int32_t text_scale = 1;        ///< pixels of the picture for a pixel of a letter, 1 or 2
    ColourScheme colours = ColourScheme::Standard;
    bool shows_captions = false;  ///< a line of text for each sound
    bool operator==(const ComfortPreferences&) const = default;
};

/// All settings of a player that are kept in a file. They change how the game is shown and controlled, never the game
/// itself.
struct Preferences : PicturePreferences, WindowPreferences, ComfortPreferences, Steering {
    std::map<std::string, Light> lights;       ///< by game, where it differs from light_of_new()
    std::string game = kMuseum;                ///< the current game, which light() returns the light of
    std::int32_t volume_100 = 100;             ///< of all, 0 to 100; 0: no sound device is opened
    std::int32_t sounds_volume_100 = 80;       ///< of sounds in the level and in menus, 0 to 100
    std::int32_t music_volume_100 = 60;        ///< 0 to 100
    Preset preset = Preset::Bounded;           ///< the last one chosen
    Accuracy accuracy;                         ///< the preset's dials, with later changes
    std::optional<Processor> machine = {};     ///< for whose time each picture stays; none: it does not
    Bindings bindings = default_bindings();    ///< the inputs of each action
    const Kernels* kernels = &best_kernels();  ///< of the command line; not kept

    Light light() const { return light_of(game); }
    Light light_of(const std::string& name) const {
        const auto found = lights.find(name);
        return found == lights.end() ? light_of_new(name) : found->second;
    }
    void set_light(const Light& light) {
        lights[game] = light;
        if (light == light_of_new(game)) lights.erase(game);
    }
    bool operator==(const Preferences&) const = default;
};

}  // namespace oblong
