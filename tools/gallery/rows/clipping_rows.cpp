// Seeds 2 and 3: six planes, the canonical view volume, polygons into triangles.

#include "engine/mesh/triangulate.h"
#include "engine/methods/canonical_volume.h"
#include "engine/methods/polygons.h"
#include "engine/methods/transforms.h"
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
        return kind == VolumeKind::Perspective ? ahead * std::tan(30 * kDegree) : kHalfWidth;
    }
    double lean() const { return kind == VolumeKind::Oblique ? kLean : 0; }
};

/// Viewspace to the canonical volume of a parallel view: a shear makes the volume upright, then it is moved and scaled.
Matrix4 parallel_volume_matrix(double lean) {
    Matrix4 shear = Matrix4::identity();
    shear.rows[0][2] = shear.rows[1][2] = entry_of(lean);
    constexpr double kDepth = ShownView::kFar - ShownView::kNear;
    return scaling(entries_of({1 / ShownView::kHalfWidth, 4 / (3 * ShownView::kHalfWidth), 1 / kDepth})) *
           translation(entries_of({0, 0, -ShownView::kNear})) * shear;
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

Vec world_of(const ShownView& shown, const Vec4& corner) {
    return vec_of(saturating_convert<World>(*point_of(shown.from_volume * corner)));
}

/// The corners of the canonical volume's near (0) or far (1) end.
std::array<Vec, 4> volume_end(int z) {
    const double depth = z;
    return {{{-1, -1, depth}, {-1, 1, depth}, {1, 1, depth}, {1, -1, depth}}};
}

/// The same in the world.
std::array<Vec, 4> volume_end(const ShownView& shown, int z) {
    std::array<Vec, 4> corners = volume_end(z);
    for (Vec& corner : corners) corner = world_of(shown, homogeneous_of(corner));
    return corners;
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
std::vector<HalfPlane> half_planes_of(const std::array<Vec, 3>& triangle, const ShownView& shown) {
    std::vector<HalfPlane> sides{{0, 1, 0}, {0, 0, 1}, {1, -1, -1}};
    const auto keep = [&](auto inside_at) {
        const double at = inside_at(triangle[0]);
        sides.push_back({at, inside_at(triangle[1]) - at, inside_at(triangle[2]) - at});
    };
    keep([](const Vec& p) { return p.x - ShownView::kNear; });
    keep([](const Vec& p) { return ShownView::kFar - p.x; });
    for (const double sign : {-1.0, 1.0}) {
        keep([&](const Vec& p) { return shown.half_width(p.x) + sign * (p.y - shown.lean() * p.x); });
        keep([&](const Vec& p) { return shown.half_width(p.x) * 3 / 4 + sign * (p.z + shown.lean() * p.x); });
    }
    return sides;
}

/// The share of a triangle's area in the view, in closed form, without clipping by one side after the other. Each
/// side's line is cut by all other half planes: the rest is an edge of the visible part, or nothing. The edges' cross
/// products add up to twice the area (Green); the whole is 1/2.
double share_inside(const std::array<Vec, 3>& triangle, const ShownView& shown) {
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

/// Twice the area of a flat polygon, along its normal.
Vec area_vector(std::span<const Vec> corners) {
    Vec doubled;
    for (std::size_t i = 0; i < corners.size(); ++i)
        doubled = doubled + cross(corners[i], corners[(i + 1) % corners.size()]);
    return doubled;
}

/// The canonical volume, with the clipped polygon in it: x right, y up, depth away from the viewer.
void draw_canonical_volume(std::span<const Vec4> polygon, const Canvas& canvas) {
    const std::int32_t x = canvas.width_px * 206 / 320, y = kHeader_px + 5 * kLineHeight_px;
    const Area area{x, y, canvas.width_px - x, std::max(canvas.height_px - kFooter_px - y, 8)};
    Sketch sketch(canvas, area, {{-3.2, -6, 3}, {0, 1, 0}, 46});
    const auto place = [](const Vec& p) { return Vec{2 * p.x, 2 * p.z, 2 * p.y}; };
    std::array<Vec, 4> near = volume_end(0), far = volume_end(1);
    for (Vec& corner : near) corner = place(corner);
    for (Vec& corner : far) corner = place(corner);
    constexpr Rgb8 kDeep{50, 70, 120};
    sketch.outline(far, kDeep);
    for (std::size_t i = 0; i < 4; ++i) sketch.line(near[i], far[i], kDeep);
    std::vector<Vec> corners;
    for (const Vec4& corner : polygon) corners.push_back(place(vec_of(*point_of(corner))));
    sketch.polygon(corners, kAmber);
    sketch.outline(corners, kGold);
    sketch.outline(near, kBlue);
    sketch.label(near[0], "-1 -1 0", kBlue);
    sketch.label(far[2], "1 1 1", kBlue);
}

/// The volume in the world: its two ends, the edges between them, and the rays to its near corners.
void draw_volume(const ShownView& shown, Sketch& sketch) {
    const auto near = volume_end(shown, 0), far = volume_end(shown, 1);
    sketch.outline(near, kBlue);
    sketch.outline(far, kBlue);
    for (std::size_t i = 0; i < 4; ++i) {
        sketch.line(near[i], far[i], kBlue);
        // Back by 2/5 of the depth, to x = 0: the eye, or a point on a parallel ray.
        sketch.line(near[i] * 1.4 - far[i] * 0.4, near[i], kDim);
    }
    if (shown.kind == VolumeKind::Perspective) sketch.label({0, 0}, "eye", kDim);
    sketch.label(far[1], "far", kBlue);
    sketch.label(near[1], "near", kBlue);
}

Figures draw_view_volume(const RowInput& input, Canvas& canvas) {
    const ShownView shown = make_shown_view(static_cast<VolumeKind>(input.values[0]));
    const auto move = input.number(1);
    const std::array<Vec, 3> triangle{{{2 + move, 5, -2}, {9 + move, -8, 1}, {10 + move, 4, 7}}};
    std::vector<Vec4> corners;
    for (const Vec& p : triangle) corners.push_back(shown.to_volume * homogeneous_of(p));
    const std::vector<Vec4> clipped = clip_to_volume(corners);
    std::vector<Vec> inside;
    for (const Vec4& corner : clipped) inside.push_back(world_of(shown, corner));

    Sketch sketch(canvas, canvas.scene(206), {{2, -28, 16}, {7.5, 0, -1}, 46});
    sketch.outline(triangle, kRed);
    sketch.polygon(inside, kAmber);
    sketch.outline(inside, kGold);
    draw_volume(shown, sketch);
    std::vector<std::string> lines;
    for (const Vec4& corner : corners) lines.push_back(sides_text(volume_outcode(corner)));
    lines.push_back(std::to_string(clipped.size()) + " corners left");
    canvas.column(canvas.width_px * 206 / 320, 4, lines);
    draw_canonical_volume(clipped, canvas);

    const auto far = volume_end(shown, 1);
    const bool is_parallel = shown.kind != VolumeKind::Perspective;
    const double wide = 2 * shown.half_width(ShownView::kFar);
    return {{"area inside, by the edges that nine half-planes leave each other",
             share_inside(triangle, shown) * length(area_vector(triangle)) / 2, length(area_vector(inside)) / 2, 2e-3},
            {is_parallel ? "width of the far side, the near side's" : "width of the far side: 2 z tan(30)", wide,
             far[0].y - far[3].y, 2e-3},
            {"its height: 3/4 of that", wide * 3 / 4, far[1].z - far[0].z, 2e-3},
            {is_parallel ? "depth half way: even" : "depth half way: f / (f - n) (1 - n / z)",
             is_parallel ? 0.5 : 14 / 10.0 * (1 - 4 / 9.0), point_of(shown.to_volume * homogeneous_of({9, 0, 0}))->z,
             1e-6, 6}};
}

/// Seed 3's pentagon against one plane, with both lists.
Figures draw_two_lists(const RowInput& input, Canvas& canvas) {
    const double height = -1 + input.number(0) / 4;
    // The plane is the volume's bottom side, y = -1.
    std::vector<Vec4> pentagon;
    for (const Vec& p : {Vec{-0.5, -2}, Vec{-2, 0}, Vec{0, 2}, Vec{2, 0}, Vec{0.5, -2}})
        pentagon.push_back(homogeneous_of({p.x, p.y - height - 1, 0.5}));
    const SplitPolygon split = split_polygon(pentagon, VolumeSide::Bottom);
    const auto flat = [&](const std::vector<Vec4>& polygon) {
        std::vector<Vec> points;
        for (const Vec4& v : polygon) points.push_back({number_of(v.x), number_of(v.y) + height + 1});
        return points;
    };
    const std::vector<Vec> whole = flat(pentagon), inside = flat(split.inside), outside = flat(split.outside);
    const auto area = [](const std::vector<Vec>& polygon) { return -area_vector(polygon).z / 2; };
    Diagram diagram(canvas, {0, 0}, 4.8);
    diagram.line({-5, height}, {5, height}, kBlue);
    diagram.arrow({-3, height}, {-3, height + 0.7}, kBlue);
    diagram.outline(outside, kRed);
    diagram.outline(inside, kOrange);
    for (std::size_t i = 0; i < whole.size(); ++i)
        diagram.label(whole[i], "Q" + std::to_string(i + 1), kWhite, whole[i].x < 0 ? -16 : 4);
    int crossings = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (distance_inside(split.inside[i], VolumeSide::Bottom) != Entry{}) continue;
        diagram.disc(inside[i], 0.07, kGreen);
        diagram.label(inside[i], "I" + std::to_string(++crossings), kGreen, 4, 3);
    }
    return {{"area inside + area outside = the pentagon's", area(whole), area(inside) + area(outside), 1e-8, 6},
            {"area of the pentagon", 9, area(whole), 1e-8},
            {"crossings in each list", 2, crossings}};
}

Figures draw_triangulations(const RowInput& input, Canvas& canvas) {
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
    std::vector<Vec> flat;
    for (const Vec3<World>& corner : corners) flat.push_back(vec_of(corner));
    const double whole = length(area_vector(flat)) / 2;
    flat.push_back(vec_of(middle_of(corners)));

    Diagram diagram(canvas, {0, 0}, 4.4);
    double sum = 0, turned_over = 0;
    for (const CornerTriple& triangle : triangles) {
        const std::array sides{flat[triangle[0]], flat[triangle[1]], flat[triangle[2]]};
        const double area = -area_vector(sides).z / 2;
        sum += std::abs(area);
        turned_over += area < 0;
        diagram.outline(sides, area < 0 ? kScarlet : kBlue);
    }
    for (std::size_t i = 0; i < count; ++i) {
        diagram.line(flat[i], flat[(i + 1) % count], kOrange);
        diagram.label(flat[i], std::to_string(i), kWhite, flat[i].x < 0 ? -9 : 4);
    }
    const bool tiles = !is_concave || method != 0;
    return {{"triangles", method == 1 ? 8 : 6, std::ssize(triangles)},
            tiles ? Figure{"sum of their areas = the polygon's", whole, sum, 2e-3}
                  : Figure{"sum of their areas, which overlap",
                           decimal_text(sum) + ", the polygon's " + decimal_text(whole)},
            {"triangles turned over", decimal_text(turned_over, "%.0f")}};
}

}  // namespace

std::vector<Row> clipping_rows() {
    return {
        {"view-volume",
         draw_view_volume,
         {{"projection", {"perspective", "parallel", "oblique parallel"}}, {"triangle moved by, units", -4, 8, 1, 1}}},
        {"two-lists", draw_two_lists, {{"plane, quarters of a unit", -3, 3, 1, 0}}},
        {"triangulate",
         draw_triangulations,
         {{"by", {"a fan from one corner", "a point in the middle", "diagonals"}, 2},
          {"polygon", {"convex", "concave"}, 1}}}};
}

}  // namespace oblong
