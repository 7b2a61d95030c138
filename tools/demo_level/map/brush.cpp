#include "tools/demo_level/map/brush.h"

#include <algorithm>
#include <cmath>

namespace oblong::map_source {
namespace {

Point minus(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// 0, 1, 2: the axis that a normal is nearest to; the earlier one of equals, as Quake's compilers choose texture axes.
int main_axis(const Point& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    if (z >= x && z >= y) return 2;
    return x >= y ? 0 : 1;
}

const std::string& texture_for(const Skin& skin, const Point& normal) {
    switch (main_axis(normal)) {
        case 0:
            return skin.east_west;
        case 1:
            return skin.north_south;
        default:
            return normal.z > 0 ? skin.top : skin.bottom;
    }
}

BrushFace make_face(const std::vector<Point>& polygon, const Point& inside, const Skin& skin) {
    BrushFace face{{polygon[0], polygon[1], polygon[2]}, {}};
    if (dot(outward_normal(face), minus(inside, polygon[0])) > 0) std::swap(face.points[0], face.points[2]);
    face.placement.texture = texture_for(skin, outward_normal(face));
    return face;
}

/// Puts a polygon's corner at `along` on its axis.
Point lift_corner(int axis, const std::array<double, 2>& corner, double along) {
    if (axis == 0) return {along, corner[0], corner[1]};
    if (axis == 1) return {corner[0], along, corner[1]};
    return {corner[0], corner[1], along};
}

Point mean(const std::vector<Point>& points) {
    Point sum;
    for (const Point& point : points) sum = {sum.x + point.x, sum.y + point.y, sum.z + point.z};
    const auto count = static_cast<double>(points.size());
    return {sum.x / count, sum.y / count, sum.z / count};
}

}  // namespace

Point outward_normal(const BrushFace& face) {
    return cross(minus(face.points[0], face.points[1]), minus(face.points[2], face.points[1]));
}

Brush make_solid(const std::vector<std::vector<Point>>& polygons, Point inside, const Skin& skin) {
    Brush brush;
    for (const auto& polygon : polygons) brush.faces.push_back(make_face(polygon, inside, skin));
    return brush;
}

Brush make_box(const Box& box, const Skin& skin) {
    const std::vector<std::array<double, 2>> corners{
        {box.low.x, box.low.y}, {box.high.x, box.low.y}, {box.high.x, box.high.y}, {box.low.x, box.high.y}};
    return extrude({2, corners}, box.low.z, box.high.z, skin);
}

Box within(const Box& box) {
    constexpr double kGap = kHairsbreadth;
    return {{box.low.x + kGap, box.low.y + kGap, box.low.z + kGap},
            {box.high.x - kGap, box.high.y - kGap, box.high.z - kGap}};
}

void fit_textures(Brush& brush, const Box& box, double scale) {
    for (BrushFace& face : brush.faces) {
        const int axis = main_axis(outward_normal(face));
        const double left = axis == 0 ? box.low.y : box.low.x, top = axis == 2 ? box.high.y : box.high.z;
        face.placement.scale_u = face.placement.scale_v = scale;
        face.placement.offset_u = -left / scale;
        face.placement.offset_v = top / scale;
    }
}

Brush extrude(const Outline& outline, double low, double high, const Skin& skin) {
    std::vector<Point> near_end, far_end;
    for (const auto& corner : outline.corners) {
        near_end.push_back(lift_corner(outline.axis, corner, low));
        far_end.push_back(lift_corner(outline.axis, corner, high));
    }
    std::vector<std::vector<Point>> polygons{near_end, far_end};
    for (std::size_t i = 0; i < near_end.size(); ++i) {
        const std::size_t next = (i + 1) % near_end.size();
        polygons.push_back({near_end[i], near_end[next], far_end[next]});
    }
    std::vector<Point> all = near_end;
    all.insert(all.end(), far_end.begin(), far_end.end());
    return make_solid(polygons, mean(all), skin);
}

std::vector<std::array<double, 2>> circle(int corners, double centre_a, double centre_b, double radius,
                                          double phase_degrees) {
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = (phase_degrees + 360.0 * i / corners) * 3.14159265358979323846 / 180;
        points.push_back(
            {centre_a + std::round(radius * std::cos(angle)), centre_b + std::round(radius * std::sin(angle))});
    }
    return points;
}

}  // namespace oblong::map_source
