#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/frame_log.h"
#include "engine/platform/platform.h"
#include "game/lab/four_aspects.h"
#include "game/lab/lab.h"
#include "game/level/loaded_level.h"
#include "game/program/view_options.h"
#include "game/view/automap.h"
#include "game/view/hud.h"

namespace oblong {

/// What the panels over a picture have to say, and the row above which they leave room for text.
struct PanelText {
    std::vector<std::string> notes;
    std::int32_t bottom = 0;
};

/// What is drawn over a walk's picture while keys ask for it. Each part is made when it is switched on, and freed when
/// it is switched off.
class ShownOverlays {
  public:
    /// All outlive it. `on`: the parts that are on, of the view options or of nobody.
    ShownOverlays(const LoadedLevel& loaded, const ViewOptions& view_options, Overlays& on, const Platform& platform);

    const Overlays& on() const { return on_; }
    /// The line of a split picture follows the mouse.
    void drag(Controls& controls);

    /// Makes what was switched on, and frees what was switched off. Then, for a picture, in this order:
    void follow(std::uint64_t now_us);
    /// Whether a picture of the same view may differ from the last one.
    bool changes_picture() const { return lab_ != nullptr; }
    /// The settings to draw it with: the player's, or those that the lab compares with them.
    Settings shown(Settings settings, std::uint64_t now_us) const;
    /// Measures and logs it, as `drawn` with those.
    void note(const GameView& view, const Settings& drawn, const PaletteEffects& effects, std::uint64_t now_us,
              GameRenderer& renderer);
    /// Draws lines in the level over it: edges of faces, and the path.
    void draw_lines(const GameView& view, const Settings& drawn, GameRenderer& renderer);
    /// Draws maps and panels over it. `settings`: the player's.
    PanelText draw_panels(const GameView& view, const Settings& settings, std::uint64_t now_us, Framebuffer canvas);
    /// Draws all text above and below those. `background`: what the picture becomes behind it.
    void draw_text(PanelText panels, std::vector<std::string> captions, Messages& messages, std::uint64_t played_us,
                   const ColourTable& background, Framebuffer canvas);

    /// Shows a path in the level from now on, through walls too; an empty one ends that.
    void show_path(std::vector<Vec3<World>> points) { path_ = std::move(points); }

  private:
    /// What the parts were made for.
    struct MadeFor {
        ScreenMode mode;
        ColourScheme colours = ColourScheme::Standard;
        std::int32_t text_scale = 1;
        bool operator==(const MadeFor&) const = default;
    };

    const Preferences& preferences() const { return view_options_.preferences; }
    std::string with_keys(const std::string& note) const;
    std::int32_t text_scale() const;
    void free_all();

    const GameData& data_;
    const GameLevel& level_;
    const ViewOptions& view_options_;
    Overlays& on_;
    const Platform& platform_;
    TextColours text_colours_;
    MadeFor made_for_;
    std::unique_ptr<Lab> lab_;
    std::unique_ptr<FourAspects> four_aspects_;
    std::unique_ptr<FrameLog> log_;
    std::unique_ptr<Automap> map_;
    std::unique_ptr<FrameCost> cost_;
    std::unique_ptr<LineColour> edge_colour_, path_colour_;
    std::vector<Vec3<World>> path_;
};

}  // namespace oblong
