// Seeds 2 and 3: six planes, the canonical view volume, polygons into triangles.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/draw/drawing.h"
#include "engine/mesh/triangulate.h"
#include "engine/methods/canonical_volume.h"
#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
#include "engine/view/views.h"
#include "tools/gallery/row.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

constexpr std::array<const char*, kVolumeSideCount> kVolumeSides{"left", "right", "bottom", "top", "near", "far"};

std::string sides_text(unsigned outcode) {
    std::string text;
    for (std::size_t i = 0; i < kVolumeSides.size(); ++i)
        if (outcode >> i & 1) text += std::string(text.empty() ? "" : " ") + kVolumeSides[i];
    return text.empty() ? "inside" : text;
}

enum class VolumeKind { Perspective, Parallel, Oblique };

/// A view shown from outside: from the origin along +x. The parallel volumes are a box, and one sheared by kLean of its
/// depth to the left and down (seed 4's parallel projection matrix, L cos a = L sin a = kLean).
struct ShownView {
    static constexpr double kNear = 4, kFar = 14, kHalfWidth = 6, kLean = 0.25;
    VolumeKind kind;
    Matrix4 to_volume, from_volume;

    /// Half of the volume's width at a distance; its height is three quarters of its width.
    double half_width(double ahead) const {
        return kind == VolumeKind::Perspective ? ahead * std::tan(30 * std::numbers::pi / 180) : kHalfWidth;
    }
    double lean() const { return kind == VolumeKind::Oblique ? kLean : 0; }
};

/// Viewspace to the canonical volume of a parallel view: a shear makes the volume upright, then it is moved and scaled.
Matrix4 parallel_volume_matrix(double lean) {
    Matrix4 shear = Matrix4::identity();
    shear.rows[0][2] = shear.rows[1][2] = entry_of(lean);
    return scaling({entry_of(1 / ShownView::kHalfWidth), entry_of(4 / (3 * ShownView::kHalfWidth)),
                    entry_of(1 / (ShownView::kFar - ShownView::kNear))}) *
           translation({Entry{}, Entry{}, entry_of(-ShownView::kNear)}) * shear;
}

ShownView make_shown_view(VolumeKind kind) {
    ShownView shown{kind, {}, {}};
    const ViewContext view = make_view_context(look_at_view({}, world_point(1, 0, 0), Degrees::from_int(60)), {});
    shown.to_volume = (kind == VolumeKind::Perspective
                           ? volume_matrix(view.projection, entry_of(ShownView::kNear), entry_of(ShownView::kFar))
                           : parallel_volume_matrix(shown.lean())) *
                      view_matrix(view.axes, view.eye);
    shown.from_volume = *inverse(shown.to_volume);
    return shown;
}

Vec3<World> world_of(const ShownView& shown, const Vec4& corner) {
    const Vec3<Entry> p = *point_of(shown.from_volume * corner);
    return saturating_convert<World>(p);
}

/// A corner of the volume: x and y -1 or 1, z 0 or 1.
Vec3<World> volume_corner(const ShownView& shown, int x, int y, int z) {
    return world_of(shown, {entry_of(x), entry_of(y), entry_of(z)});
}

std::array<Vec3<World>, 4> volume_end(const ShownView& shown, int z) {
    return {volume_corner(shown, -1, -1, z), volume_corner(shown, -1, 1, z), volume_corner(shown, 1, 1, z),
            volume_corner(shown, 1, -1, z)};
}

/// A point on a triangle: coordinates along the edges from its first to its second and third corner.
struct TrianglePlace {
    double b = 0, c = 0;
};

/// The points with a + along_b b + along_c c >= 0.
struct HalfPlane {
    double a = 0, along_b = 0, along_c = 0;

    double at(const TrianglePlace& p) const { return a + along_b * p.b + along_c * p.c; }
};

/// The triangle's own three sides, and the view's six planes, as half planes on it.
std::vector<HalfPlane> half_planes_of(const std::array<Vec3<World>, 3>& triangle, const ShownView& shown) {
    std::vector<HalfPlane> sides{{0, 1, 0}, {0, 0, 1}, {1, -1, -1}};
    const auto keep = [&](auto inside_at) {
        const auto at = [&](std::size_t i) {
            return inside_at(number_of(triangle[i].x), number_of(triangle[i].y), number_of(triangle[i].z));
        };
        sides.push_back({at(0), at(1) - at(0), at(2) - at(0)});
    };
    keep([](double x, double, double) { return x - ShownView::kNear; });
    keep([](double x, double, double) { return ShownView::kFar - x; });
    for (const double sign : {-1.0, 1.0}) {
        keep([&](double x, double y, double) { return shown.half_width(x) + sign * (y - shown.lean() * x); });
        keep([&](double x, double, double z) { return shown.half_width(x) * 3 / 4 + sign * (z + shown.lean() * x); });
    }
    return sides;
}

/// The share of a triangle's area in the view, in closed form, without clipping by one side after the other. Each
/// side's line is cut by all other half planes: the rest is an edge of the visible part, or nothing. The edges' cross
/// products add up to twice the area (Green); the whole is 1/2.
double share_inside(const std::array<Vec3<World>, 3>& triangle, const ShownView& shown) {
    const std::vector<HalfPlane> sides = half_planes_of(triangle, shown);
    double doubled_area = 0;
    for (const HalfPlane& side : sides) {
        const double square = side.along_b * side.along_b + side.along_c * side.along_c;
        const TrianglePlace foot{-side.a * side.along_b / square, -side.a * side.along_c / square};
        const TrianglePlace way{side.along_c, -side.along_b};  // the inside on its left
        double from = -1e9, to = 1e9;
        for (const HalfPlane& other : sides) {
            const double there = other.at(foot), rise = other.along_b * way.b + other.along_c * way.c;
            if (&other == &side) continue;
            if (rise > 0) from = std::max(from, -there / rise);
            if (rise < 0) to = std::min(to, -there / rise);
            if (rise == 0 && there < 0) to = from;
        }
        if (from < to) doubled_area += (to - from) * (foot.c * way.b - foot.b * way.c);
    }
    return std::abs(doubled_area);
}

double area_of(std::span<const Vec3<World>> corners) {
    Vec doubled;
    for (std::size_t i = 0; i < corners.size(); ++i)
        doubled = doubled + cross(vec_of(corners[i]), vec_of(corners[(i + 1) % corners.size()]));
    return length(doubled) / 2;
}

/// The canonical volume, with the clipped polygon in it: x right, y up, depth away from the viewer.
void draw_canonical_volume(std::span<const Vec4> polygon, const RowInput& input, Framebuffer canvas) {
    const std::int32_t x = canvas.width_px * 206 / 320, y = kHeader_px + 5 * kLineHeight_px;
    const Area area{x, y, canvas.width_px - x, std::max(canvas.height_px - kFooter_px - y, 8)};
    Sketch sketch(input, canvas, area, {world_point(-3.2, -6, 3), world_point(0, 1, 0), 46});
    const auto place = [](double across, double up, double depth) {
        return world_point(2 * across, 2 * depth, 2 * up);
    };
    const auto end = [&](int z) {
        return std::array{place(-1, -1, z), place(-1, 1, z), place(1, 1, z), place(1, -1, z)};
    };
    const auto near = end(0), far = end(1);
    const std::uint8_t blue = input.colour(90, 130, 220), dim = input.colour(50, 70, 120);
    sketch.outline(far, dim);
    for (std::size_t i = 0; i < 4; ++i) sketch.line(near[i], far[i], dim);
    std::vector<Vec3<World>> corners;
    for (const Vec4& corner : polygon) {
        const Vec3<Entry> p = *point_of(corner);
        corners.push_back(place(number_of(p.x), number_of(p.y), number_of(p.z)));
    }
    sketch.polygon(corners, input.colour(200, 150, 60));
    sketch.outline(corners, input.colour(250, 225, 150));
    sketch.outline(near, blue);
    sketch.label(near[0], "-1 -1 0", blue);
    sketch.label(far[2], "1 1 1", blue);
}

/// The volume in the world: its two ends, the edges between them, and the rays to its near corners.
void draw_volume(const ShownView& shown, const GalleryAssets& assets, Sketch& sketch) {
    const std::uint8_t blue = assets.colour(90, 130, 220), grey = assets.colour(80, 88, 110);
    const auto near = volume_end(shown, 0), far = volume_end(shown, 1);
    sketch.outline(near, blue);
    sketch.outline(far, blue);
    for (std::size_t i = 0; i < 4; ++i) {
        sketch.line(near[i], far[i], blue);
        // Back by 2/5 of the depth, to x = 0: the eye, or a point on a parallel ray.
        const auto back = [&](auto part) { return number_of(part(near[i])) * 1.4 - number_of(part(far[i])) * 0.4; };
        sketch.line(world_point(back([](const auto& p) { return p.x; }), back([](const auto& p) { return p.y; }),
                                back([](const auto& p) { return p.z; })),
                    near[i], grey);
    }
    if (shown.kind == VolumeKind::Perspective) sketch.label(world_point(0, 0, 0), "eye", grey);
    sketch.label(far[1], "far", blue);
    sketch.label(near[1], "near", blue);
}

Figures draw_view_volume(const RowInput& input, Framebuffer canvas) {
    const GalleryAssets& assets = input.assets;
    fill(canvas, assets.colour(18, 22, 34));
    const ShownView shown = make_shown_view(static_cast<VolumeKind>(input.values[0]));
    const auto move = input.number(1);
    const std::array triangle{world_point(2 + move, 5, -2), world_point(9 + move, -8, 1), world_point(10 + move, 4, 7)};
    std::vector<Vec4> corners;
    for (const Vec3<World>& p : triangle) corners.push_back(shown.to_volume * homogeneous(p));
    const std::vector<Vec4> clipped = clip_to_volume(corners);
    std::vector<Vec3<World>> inside;
    for (const Vec4& corner : clipped) inside.push_back(world_of(shown, corner));

    Sketch sketch(input, canvas, scene_area(canvas, 206), {world_point(2, -28, 16), world_point(7.5, 0, -1), 46});
    sketch.outline(triangle, assets.colour(220, 90, 80));
    sketch.polygon(inside, assets.colour(200, 150, 60));
    sketch.outline(inside, assets.colour(250, 225, 150));
    draw_volume(shown, assets, sketch);
    std::vector<std::string> lines;
    for (const Vec4& corner : corners) lines.push_back(sides_text(volume_outcode(corner)));
    lines.push_back(std::to_string(clipped.size()) + " corners left");
    draw_column(canvas, canvas.width_px * 206 / 320, kHeader_px + 4, lines, assets.text);
    draw_canonical_volume(clipped, input, canvas);

    const auto far = volume_end(shown, 1);
    const bool is_parallel = shown.kind != VolumeKind::Perspective;
    const double whole = area_of(triangle), wide = 2 * shown.half_width(ShownView::kFar);
    const Vec4 middle = shown.to_volume * Vec4{entry_of(9), Entry{}, Entry{}};
    return {number_figure("area inside, by the edges that nine half-planes leave each other",
                          share_inside(triangle, shown) * whole, area_of(inside), 2e-3),
            number_figure(is_parallel ? "width of the far side, the near side's" : "width of the far side: 2 z tan(30)",
                          wide, number_of(far[0].y - far[3].y), 2e-3),
            number_figure("its height: 3/4 of that", wide * 3 / 4, number_of(far[1].z - far[0].z), 2e-3),
            number_figure(is_parallel ? "depth half way: even" : "depth half way: f / (f - n) (1 - n / z)",
                          is_parallel ? 0.5 : 14 / 10.0 * (1 - 4 / 9.0), number_of(point_of(middle)->z), 1e-6, 6)};
}

/// Seed 3's pentagon against one plane, with both lists.
Figures draw_two_lists(const RowInput& input, Framebuffer canvas) {
    const double height = -1 + input.number(0) / 4;
    const auto corner = [&](double x, double y) {
        // The plane is the volume's bottom side, y = -1.
        return Vec4{entry_of(x), entry_of(y - height - 1), entry_of(0.5), entry_of(1)};
    };
    const std::vector pentagon{corner(-0.5, -2), corner(-2, 0), corner(0, 2), corner(2, 0), corner(0.5, -2)};
    const SplitPolygon split = split_polygon(pentagon, VolumeSide::Bottom);
    const auto flat = [&](const Vec4& v) { return PlanePoint{number_of(v.x), number_of(v.y) + height + 1}; };
    const auto all_flat = [&](const std::vector<Vec4>& polygon) {
        std::vector<PlanePoint> points;
        for (const Vec4& v : polygon) points.push_back(flat(v));
        return points;
    };
    const auto area = [&](const std::vector<Vec4>& polygon) {
        double sum = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const PlanePoint a = flat(polygon[i]), b = flat(polygon[(i + 1) % polygon.size()]);
            sum += (b.x * a.y - a.x * b.y) / 2;
        }
        return sum;
    };
    Diagram diagram(input, canvas, {0, 0}, 4.8);
    diagram.fill(input.colour(18, 22, 34));
    const std::uint8_t blue = input.colour(90, 130, 220);
    diagram.line({-5, height}, {5, height}, blue);
    diagram.arrow({-3, height}, {-3, height + 0.7}, blue);
    diagram.outline(all_flat(split.outside), input.colour(220, 90, 80));
    diagram.outline(all_flat(split.inside), input.colour(240, 190, 90));
    for (std::size_t i = 0; i < pentagon.size(); ++i) {
        const PlanePoint place = flat(pentagon[i]);
        diagram.text(place, "Q" + std::to_string(i + 1), input.colour(235, 235, 225), place.x < 0 ? -16 : 4);
    }
    std::vector<PlanePoint> crossings;
    for (const Vec4& v : split.inside)
        if (distance_inside(v, VolumeSide::Bottom) == Entry{}) crossings.push_back(flat(v));
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        diagram.disc(crossings[i], 0.07, input.colour(110, 200, 110));
        diagram.text(crossings[i], "I" + std::to_string(i + 1), input.colour(110, 200, 110), 4, 3);
    }
    return {number_figure("area inside + area outside = the pentagon's", area(pentagon),
                          area(split.inside) + area(split.outside), 1e-8, 6),
            number_figure("area of the pentagon", 9, area(pentagon), 1e-8),
            count_figure("crossings in each list", 2, std::ssize(crossings))};
}

Figures draw_triangulations(const RowInput& input, Framebuffer canvas) {
    const auto method = input.values[0];
    const bool is_concave = input.values[1] == 1;
    std::vector<Vec3<World>> corners;
    for (int i = 0; i < 8; ++i) {
        const double angle = -i * std::numbers::pi / 4 + 0.3, size = is_concave && i % 2 == 1 ? 0.7 : 2;
        corners.push_back(world_point(size * std::cos(angle) * 1.3, size * std::sin(angle), 0));
    }
    const std::size_t count = corners.size();
    const auto triangles = method == 0   ? triangulate_as_fan(count)
                           : method == 1 ? triangulate_around_middle(count)
                                         : triangulate_by_diagonals(corners);
    const double whole = area_of(corners);
    corners.push_back(middle_of(corners));

    Diagram diagram(input, canvas, {0, 0}, 4.4);
    diagram.fill(input.colour(18, 22, 34));
    const auto flat = [&](std::size_t i) { return PlanePoint{number_of(corners[i].x), number_of(corners[i].y)}; };
    double sum = 0, turned_over = 0;
    for (const CornerTriple& triangle : triangles) {
        const PlanePoint a = flat(triangle[0]), b = flat(triangle[1]), c = flat(triangle[2]);
        const double area = ((c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y)) / 2;
        sum += std::abs(area);
        turned_over += area < 0;
        for (std::size_t i = 0; i < 3; ++i)
            diagram.line(flat(triangle[i]), flat(triangle[(i + 1) % 3]),
                         area < 0 ? input.colour(220, 60, 50) : input.colour(90, 130, 220));
    }
    for (std::size_t i = 0; i < count; ++i) {
        diagram.line(flat(i), flat((i + 1) % count), input.colour(240, 190, 90));
        diagram.text(flat(i), std::to_string(i), input.colour(235, 235, 225), flat(i).x < 0 ? -9 : 4);
    }
    const bool tiles = !is_concave || method != 0;
    return {count_figure("triangles", method == 1 ? 8 : 6, std::ssize(triangles)),
            tiles ? number_figure("sum of their areas = the polygon's", whole, sum, 2e-3)
                  : measured("sum of their areas, which overlap",
                             decimal_text(sum) + ", the polygon's " + decimal_text(whole)),
            measured("triangles turned over", decimal_text(turned_over, "%.0f"))};
}

}  // namespace

std::vector<Row> clipping_rows() {
    return {{"view-volume",
             draw_view_volume,
             {choice_parameter("projection", {"perspective", "parallel", "oblique parallel"}),
              {"triangle moved by, units", -4, 8, 1, 1}}},
            {"two-lists", draw_two_lists, {{"plane, quarters of a unit", -3, 3, 1, 0}}},
            {"triangulate",
             draw_triangulations,
             {choice_parameter("by", {"a fan from one corner", "a point in the middle", "diagonals"}, 2),
              choice_parameter("polygon", {"convex", "concave"}, 1)}}};
}

}  // namespace oblong
