#pragma once

#include <vector>

#include "engine/draw/drawing.h"
#include "engine/visibility/visible_set.h"
#include "game/options/preferences.h"
#include "game/view/game_renderer.h"
#include "game/view/sign_colours.h"

namespace oblong {

/// The meaning of a line of the map.
enum class MapLineKind : std::uint8_t {
    Wall,  ///< where a wall meets its floor
    Step   ///< the same, of a wall low enough to walk up
};

struct MapLine {
    Vec3<World> from, to;
    MapLineKind kind = MapLineKind::Wall;
    bool operator==(const MapLine&) const = default;
};

/// The lines where a face of the world steeper than 45 degrees meets a floor. Floors, liquids, skies, and walls that
/// begin above the ground, as over a door, have none.
std::vector<MapLine> map_lines_of(const Level& level, FaceIndex face);

/// A map of the level around the player: an orthographic view from above, as lines over the darkened picture. Steps are
/// broken lines; doors that may shut a way and other models have crosses; the last missing lenses are diamonds, small
/// ones on the way to those beyond the map's rim. It exists only while it is shown.
class Automap {
  public:
    /// `data` and `level` outlive it.
    Automap(const GameData& data, const GameLevel& level, ColourScheme scheme);

    /// Draws the map over the canvas. Lines in leaves outside the potentially visible set are dark.
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
