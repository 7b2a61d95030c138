#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/surface/palette.h"
#include "tools/map/source/map_file.h"
#include "tools/map/tree/bsp_file.h"

namespace oblong {

/// A convex solid with these polygons as sides, their planes from the first three corners, and `inside` in its
/// interior. Textures are aligned with the world's axes, `units` a texel.
map::MapBrush make_solid(const std::vector<std::vector<map::Point>>& polygons, const map::Point& inside,
                         const std::string& texture, double units = 1);
map::MapBrush make_box(const map::Box& box, const std::string& texture, double units = 1);
/// A triangle (x, y) extruded from the floor, z = 0, up to `height`.
map::MapBrush make_wedge(const std::array<std::array<double, 2>, 3>& triangle, double height,
                         const std::string& texture);
/// A sphere of 24 by 12 facets, 112 units across, with two alternating textures.
map::MapBrush make_sphere(const map::Point& centre, const std::string& even_texture, const std::string& odd_texture);

/// The source of a small level: a closed room, and added brushes.
class SceneMap {
  public:
    /// Walls of stone, 16 units thick, tiles on floor and ceiling.
    explicit SceneMap(const map::Box& room);

    void add(map::MapBrush brush) { entities_.front().brushes.push_back(std::move(brush)); }
    void add_start(const map::Point& origin) { add_point("info_player_start", origin, {}); }
    void add_light(const map::Point& origin, int brightness, const std::string& colour = "255 255 255");

    const std::vector<map::MapEntity>& entities() const { return entities_; }

  private:
    void add_point(const std::string& classname, const map::Point& origin, std::vector<map::MapPair> more);

    std::vector<map::MapEntity> entities_;  // the first is the world
};

/// The bytes of a WAD with the hard scenes' textures, `stone` and `tiles`: grain and joints of high contrast, so that
/// misplaced texels are visible.
std::string make_scene_wad(const Palette& palette);

/// Removes from every face the corners within its edges, which the compiler added where corners of other faces touch:
/// the level then has T-junctions for the engine to mend, as from compilers without that step.
void loosen_edges(map::BspFile& bsp);

}  // namespace oblong
