#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/platform/platform.h"
#include "engine/programs/frame_log.h"
#include "game/lab/aspects.h"
#include "game/lab/lab.h"
#include "game/level/load.h"
#include "game/program/view_options.h"
#include "game/view/automap.h"
#include "game/view/hud.h"

namespace oblong {

/// The notes of the panels over a picture, and the row above which there is room for text.
struct PanelText {
    std::vector<std::string> notes;
    std::int32_t bottom = 0;
};

/// The overlays of a walk's picture, switched by keys. Each is created when it is switched on, and freed when it is
/// switched off.
class ShownOverlays {
  public:
    /// All outlive it. `on`: the state of the overlays; a title has its own, with none on.
    ShownOverlays(const LoadedLevel& loaded, const ViewOptions& view_options, Overlays& on, const Platform& platform,
                  OpenErrorMeter open_meter);

    const Overlays& on() const { return on_; }
    /// Moves the line of a split picture with the mouse.
    void drag(Controls& controls);

    /// Creates and frees overlays as they are switched. Then, for each picture, the following in this order.
    void follow(std::uint64_t now_us);
    /// Whether a picture of the same view may differ from the last one.
    bool changes_picture() const { return lab_ != nullptr; }
    /// The settings to draw the picture with: the player's, or those that the lab compares with them.
    Settings shown(Settings settings, std::uint64_t now_us) const;
    /// Measures and logs the picture, which `drawn` was used for.
    void note(const GameView& view, const Settings& drawn, const PaletteEffects& effects, std::uint64_t now_us,
              GameRenderer& renderer);
    /// Draws the lab's pictures over the picture. `settings`: the player's.
    void draw_lab_pictures(const GameView& view, const Settings& settings, std::uint64_t now_us, Framebuffer canvas);
    /// Draws lines of the level over the picture: edges of faces, and the path.
    void draw_lines(const GameView& view, const Settings& drawn, GameRenderer& renderer);
    /// Draws maps and panels over the picture. `settings`: the player's.
    PanelText draw_panels(const GameView& view, const Settings& settings, std::uint64_t now_us, Framebuffer canvas);
    /// Draws all text. `background` darkens the picture behind it.
    void draw_text(PanelText panels, std::vector<std::string> captions, Messages& messages, std::uint64_t played_us,
                   const ColourTable& background, Framebuffer canvas);

    /// Closes the lab and the four aspects, and frees their memory. False if neither is open.
    bool close_largest();

  private:
    /// The settings that overlays were created for.
    struct MadeFor {
        ScreenMode mode;
        ColourScheme colours = ColourScheme::Standard;
        std::int32_t text_scale = 1;
        bool operator==(const MadeFor&) const = default;
    };

    const Preferences& preferences() const { return view_options_.preferences; }
    ScreenMode mode() const { return picture_in(platform_.window_size(), preferences()).mode; }

    const GameData& data_;
    const GameLevel& level_;
    const std::vector<Vec3<World>>& leak_path_;
    const ViewOptions& view_options_;
    Overlays& on_;
    const Platform& platform_;
    const OpenErrorMeter open_meter_;
    TextColours text_colours_;
    MadeFor made_for_;
    std::unique_ptr<Lab> lab_;
    std::unique_ptr<FourAspects> four_aspects_;
    std::unique_ptr<FrameLog> log_;
    std::vector<std::string> noted_, logged_;  // lines of this picture's log; of the last one that had any
    std::unique_ptr<Automap> map_;
    std::unique_ptr<FrameCost> cost_;
    std::unique_ptr<LineColour> edge_colour_, path_colour_;
};

}  // namespace oblong
