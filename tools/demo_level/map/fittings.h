#pragma once

#include "tools/demo_level/map/room.h"

namespace oblong::map_source {

/// A column of eight sides with a square base and capital; `radius` at least 6.
void add_column(Draft& draft, const Point& foot, double height, double radius, const Skin& skin);

/// A flat board on a wall that faces `facing`, its front `box` high and wide and showing the whole of a texture.
struct Panel {
    Side facing = Side::South;
    Box box;
    std::string texture;
    double texture_width = 64, texture_height = 64;
};
void add_panel(Draft& draft, const Panel& panel);

/// A board whose back's middle is at `at`, 4 units thick, its texture at `scale` units a texel.
struct Sign {
    Side facing = Side::South;
    Point at;
    double scale = 1;
    std::string texture;
    double texture_width = 112, texture_height = 32;
};
void add_sign(Draft& draft, const Sign& sign);
/// Free, on two posts behind it that stand on the ground at z = 0.
void add_way_board(Draft& draft, const Sign& sign);
/// On two rods from the ceiling.
void add_hanging_sign(Draft& draft, const Sign& sign, double ceiling_z);

/// A lamp of 16 units at `centre` and its light, which stands before it to the given side; `style` as of add_light().
void add_wall_lamp(Draft& draft, const Point& centre, Side facing, int brightness, int style = 0);

/// A lamp that hangs from `ceiling_z`, its light below it.
void add_hanging_lamp(Draft& draft, const Point& centre, double ceiling_z, int brightness, int style = 0);

/// Two pyramids of four sides base to base: eight faces, none along an axis.
Brush make_crystal(const Point& middle, double radius, double height, double turn_degrees, const Skin& skin);

/// A pyramid of six sides, as a tree is clipped: `foot` is the middle of its base.
Brush make_cone(const Point& foot, double radius, double height, const Skin& skin);

/// A post that stands free, a lamp on it.
void add_lamp_post(Draft& draft, const Point& foot, int brightness);

/// Balusters and a rail, 32 high, from `from` to `to` (along x or along y).
void add_balustrade(Draft& draft, const Point& from, const Point& to, const Skin& skin);

/// Fills the upper corners of a doorway through a wall from `low` to `high` so that it ends in a half circle. `axis`
/// is the one that the way goes along: 0 or 1.
void add_arch(Draft& draft, int axis, const Box& doorway, const Skin& skin);

/// Jambs and a lintel of brass around a doorway, `depth` proud of the wall on the side that they face.
void add_door_frame(Draft& draft, Side facing, const Opening& opening, double wall_at);

/// Steps of 16 units that climb from `foot` along y (`rise_to_north`) or against it, `run` long each.
struct Stairs {
    double x_low = 0, x_high = 0, y_start = 0, z_foot = 0, run = 24;
    int count = 0;
    bool climbs_north = true;
};
void add_stairs(Draft& draft, const Stairs& stairs, const Skin& skin);

}  // namespace oblong::map_source
