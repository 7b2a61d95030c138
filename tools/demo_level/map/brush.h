#pragma once

#include <array>
#include <string>
#include <vector>

namespace oblong::map_source {

/// World units. All coordinates of the demo level are multiples of 1/32, so that they are exact in a double, in a float
/// and in the text of a .map.
struct Point {
    double x = 0, y = 0, z = 0;
};

struct Box {
    Point low, high;

    Point centre() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2}; }
};

/// A texture as a .map lays it on a face: along the world's axes, scaled, then moved by texels.
struct Placement {
    std::string texture;
    double offset_u = 0, offset_v = 0, scale_u = 1, scale_v = 1;
};

/// A half-space: three points on its plane, clockwise seen from outside the brush.
struct BrushFace {
    std::array<Point, 3> points;
    Placement placement;
};

/// A convex solid: the common part of its half-spaces.
struct Brush {
    std::vector<BrushFace> faces;
};

/// Textures by the way a face looks.
struct Skin {
    std::string east_west, north_south, top, bottom;

    Skin(const std::string& all) : Skin(all, all) {}
    Skin(const char* all) : Skin(std::string(all)) {}
    Skin(const std::string& sides, const std::string& top_and_bottom)
        : Skin(sides, sides, top_and_bottom, top_and_bottom) {}
    Skin(std::string x, std::string y, std::string up, std::string down)
        : east_west(std::move(x)), north_south(std::move(y)), top(std::move(up)), bottom(std::move(down)) {}
};

/// The outward normal of a face, not normalised.
Point outward_normal(const BrushFace& face);

/// A solid with these polygons (their first three points count) and `inside` in its interior.
Brush make_solid(const std::vector<std::vector<Point>>& polygons, Point inside, const Skin& skin);

Brush make_box(const Box& box, const Skin& skin);

/// The gap that details leave to what they stand on or hang on. Nobody sees it, and the face behind it stays whole,
/// where it would be cut into a dozen around their foot.
inline constexpr double kHairsbreadth = 1.0 / 16;

/// The box without a hair's breadth on every side.
Box within(const Box& box);

/// Lays the textures of a box's faces so that each begins at the face's upper left corner, at `scale` units a texel.
void fit_textures(Brush& brush, const Box& box, double scale);

/// A convex polygon in the plane across `axis` (0: y and z; 1: x and z; 2: x and y), drawn out from `low` to `high`.
struct Outline {
    int axis = 2;
    std::vector<std::array<double, 2>> corners;
};
Brush extrude(const Outline& outline, double low, double high, const Skin& skin);

/// The corners of a regular polygon, rounded to whole units; the first at `phase_degrees`.
std::vector<std::array<double, 2>> circle(int corners, double centre_a, double centre_b, double radius,
                                          double phase_degrees);

}  // namespace oblong::map_source
