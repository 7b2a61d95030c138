#pragma once

#include <optional>
#include <vector>

#include "engine/draw/drawing.h"
#include "engine/visibility/visible_set.h"
#include "game/options/preferences.h"
#include "game/view/game_renderer.h"
#include "game/view/line_overlays.h"

namespace oblong {

/// What a line of the map stands for.
enum class MapLineKind : std::uint8_t {
    Wall,  ///< a wall on its floor
    Step   ///< one low enough to walk up
};

struct MapLine {
    Vec3<World> from, to;
    MapLineKind kind = MapLineKind::Wall;
    bool operator==(const MapLine&) const = default;
};

/// The lines at which a face of the world that is steeper than 45 degrees stands on a floor: none for floors, liquids
/// and skies, and for walls that begin above the ground, as over a door.
std::vector<MapLine> map_lines_of(const Level& level, FaceIndex face);

/// The level from above around the player, an orthographic view of lines over a darkened picture: steps are broken
/// lines, doors and other models have crosses; the last lenses that are missing are squares on edge, at the map's rim
/// where they are farther. It exists only while it is shown.
class Automap {
  public:
    /// `data` and `level` outlive it.
    Automap(const GameData& data, const GameLevel& level, ColourScheme scheme);

    /// Draws it over the canvas. Lines in no leaf that may be seen from here are dark.
    void draw(const GameView& view, MapView orientation, LineMethod method, const ScreenMode& mode,
              const Settings& settings, Framebuffer canvas);

  private:
    class Plotter;

    void draw_world(const Plotter& plotter, const Vec3<World>& eye);
    void draw_line_of_world(const Plotter& plotter, const MapLine& line, bool is_visible) const;
    void draw_models(const Plotter& plotter, const GameView& view) const;
    void draw_lenses(const Plotter& plotter, const GameView& view) const;

    const Level& bsp_;
    const GameLevel& level_;
    Table<std::vector<MapLine>, Face> lines_;  ///< of the world's faces
    VisibleSet visible_;
    Table<std::uint8_t, Face> is_visible_;  ///< scratch
    ColourTable darker_;
    LineColour wall_, step_, door_, hidden_, player_, lens_;
};

}  // namespace oblong
