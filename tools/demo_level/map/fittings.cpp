#include "tools/demo_level/map/fittings.h"

#include <algorithm>
#include <cmath>

namespace oblong::map_source {
namespace {

Box box_around(const Point& centre, double half) {
    return {{centre.x - half, centre.y - half, centre.z - half}, {centre.x + half, centre.y + half, centre.z + half}};
}

Point towards(Side side) {
    switch (side) {
        case Side::North:
            return {0, 1, 0};
        case Side::East:
            return {1, 0, 0};
        case Side::South:
            return {0, -1, 0};
        default:
            return {-1, 0, 0};
    }
}

bool looks_to(const Point& normal, Side side) {
    const Point wanted = towards(side);
    return normal.x * wanted.x + normal.y * wanted.y > 0 && normal.z == 0;
}

/// The whole texture on the panel's front. Texture axes run east and north, so that a front that faces north or west
/// would show it mirrored: its scale is negative.
Placement panel_placement(const Panel& panel) {
    const bool spans_x = panel.facing == Side::North || panel.facing == Side::South;
    const double low = spans_x ? panel.box.low.x : panel.box.low.y,
                 high = spans_x ? panel.box.high.x : panel.box.high.y;
    const bool is_mirrored = panel.facing == Side::North || panel.facing == Side::West;
    Placement placement{panel.texture, 0, 0, (high - low) / panel.texture_width,
                        (panel.box.high.z - panel.box.low.z) / panel.texture_height};
    if (is_mirrored) placement.scale_u = -placement.scale_u;
    placement.offset_u = -(is_mirrored ? high : low) / placement.scale_u;
    placement.offset_v = panel.box.high.z / placement.scale_v;
    return placement;
}

/// From the middle of a sign's back, half its width along the wall, to the front's corner.
Box sign_box(const Sign& sign) {
    constexpr double kThickness = 4;
    const Point out = towards(sign.facing);
    const double half_width = sign.texture_width * sign.scale / 2, half_height = sign.texture_height * sign.scale / 2;
    const bool spans_x = out.x == 0;
    Box box{sign.at, sign.at};
    (out.x + out.y > 0 ? (spans_x ? box.high.y : box.high.x) : (spans_x ? box.low.y : box.low.x)) +=
        kThickness * (out.x + out.y);
    (spans_x ? box.low.x : box.low.y) -= half_width;
    (spans_x ? box.high.x : box.high.y) += half_width;
    box.low.z -= half_height;
    box.high.z += half_height;
    return box;
}

/// From a light before a lamp's body to the farthest corner of the body and its cap.
constexpr int kLampRadius = 28;

void add_lamp_body(Draft& draft, const Point& centre) {
    const Box box = within(box_around(centre, 8));
    Brush brush = make_box(box, "lamp");
    fit_textures(brush, box, 0.5);
    draft.add_detail(std::move(brush));
}

}  // namespace

void add_column(Draft& draft, const Point& foot, double height, double radius, const Skin& skin) {
    const double plinth = radius + 4, slab = radius / 2 + 2;
    const auto square = [&](double z_low, double z_high) {
        return Box{{foot.x - plinth, foot.y - plinth, z_low}, {foot.x + plinth, foot.y + plinth, z_high}};
    };
    draft.add_detail_box(square(foot.z, foot.z + slab), skin);
    draft.add_detail_box(square(foot.z + height - slab, foot.z + height), skin);
    draft.add_detail_prism({2, circle(8, foot.x, foot.y, radius, 22.5)}, foot.z + slab, foot.z + height - slab, skin);
}

void add_panel(Draft& draft, const Panel& panel) {
    Brush brush = make_box(within(panel.box), "brass_trim");
    for (BrushFace& face : brush.faces) {
        if (looks_to(outward_normal(face), panel.facing)) face.placement = panel_placement(panel);
    }
    draft.add_detail(std::move(brush));
}

void add_sign(Draft& draft, const Sign& sign) {
    add_panel(draft, {sign.facing, sign_box(sign), sign.texture, sign.texture_width, sign.texture_height});
}

namespace {

/// Two rods between two heights, a sixth of the board's width from its ends and on its back.
void add_rods(Draft& draft, const Sign& sign, double half, double z_low, double z_high) {
    const Point out = towards(sign.facing);
    const double reach = std::round(sign.texture_width * sign.scale / 3);
    for (const double side : {-reach, reach}) {
        const Point at{sign.at.x + side * out.y - half * out.x, sign.at.y + side * out.x - half * out.y, 0};
        draft.add_detail_box({{at.x - half, at.y - half, z_low}, {at.x + half, at.y + half, z_high}}, "brass_trim");
    }
}

}  // namespace

void add_way_board(Draft& draft, const Sign& sign) {
    add_sign(draft, sign);
    add_rods(draft, sign, 3, 0, sign.at.z + sign.texture_height * sign.scale / 2);
}

void add_hanging_sign(Draft& draft, const Sign& sign, double ceiling_z) {
    add_sign(draft, sign);
    add_rods(draft, sign, 1, sign.at.z, ceiling_z);
}

void add_wall_lamp(Draft& draft, const Point& centre, Side facing, int brightness, int style) {
    add_lamp_body(draft, centre);
    const Point out = towards(facing);
    const Point cap{centre.x + out.x, centre.y + out.y, 0};
    const double x_half = out.x == 0 ? 10 : 9, y_half = out.y == 0 ? 10 : 9;
    draft.add_detail_box(
        {{cap.x - x_half, cap.y - y_half, centre.z + 8}, {cap.x + x_half, cap.y + y_half, centre.z + 12}},
        "brass_trim");
    draft.add_light({centre.x + out.x * 12, centre.y + out.y * 12, centre.z}, brightness, style, kLampRadius);
}

void add_hanging_lamp(Draft& draft, const Point& centre, double ceiling_z, int brightness, int style) {
    add_lamp_body(draft, centre);
    draft.add_detail_box({{centre.x - 1, centre.y - 1, centre.z + 8}, {centre.x + 1, centre.y + 1, ceiling_z}},
                         "brass_trim");
    draft.add_light({centre.x, centre.y, centre.z - 12}, brightness, style, kLampRadius);
}

Brush make_crystal(const Point& middle, double radius, double height, double turn_degrees, const Skin& skin) {
    std::vector<std::vector<Point>> triangles;
    const auto base = circle(4, middle.x, middle.y, radius, turn_degrees);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto &a = base[i], &b = base[(i + 1) % 4];
        for (const double tip : {middle.z + height, middle.z - height}) {
            triangles.push_back({{a[0], a[1], middle.z}, {b[0], b[1], middle.z}, {middle.x, middle.y, tip}});
        }
    }
    return make_solid(triangles, middle, skin);
}

Brush make_cone(const Point& foot, double radius, double height, const Skin& skin) {
    const auto ring = circle(6, foot.x, foot.y, radius, 30);
    std::vector<std::vector<Point>> polygons(1);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
        polygons.front().push_back({a[0], a[1], foot.z});
        polygons.push_back({{a[0], a[1], foot.z}, {b[0], b[1], foot.z}, {foot.x, foot.y, foot.z + height}});
    }
    return make_solid(polygons, {foot.x, foot.y, foot.z + height / 4}, skin);
}

void add_lamp_post(Draft& draft, const Point& foot, int brightness) {
    constexpr double kLampHeight = 76;
    const auto square = [&](double half, double z_low, double z_high) {
        return Box{{foot.x - half, foot.y - half, foot.z + z_low}, {foot.x + half, foot.y + half, foot.z + z_high}};
    };
    draft.add_detail_box(square(8, 0, 8), "marble_green");
    draft.add_detail_box(square(3, 8, kLampHeight - 8), "brass_trim");
    add_lamp_body(draft, {foot.x, foot.y, foot.z + kLampHeight});
    draft.add_detail_box(square(10, kLampHeight + 8, kLampHeight + 12), "brass_trim");
    for (const double side : {-12.0, 12.0}) {
        draft.add_light({foot.x + side, foot.y, foot.z + kLampHeight}, brightness, 0, kLampRadius);
    }
}

void add_balustrade(Draft& draft, const Point& from, const Point& to, const Skin& skin) {
    constexpr double kSpacing = 43, kHalf = 2.5;
    draft.add_detail_box({{from.x - kHalf, from.y - kHalf, from.z + 26}, {to.x + kHalf, to.y + kHalf, from.z + 32}},
                         skin);
    const double length = (to.x - from.x) + (to.y - from.y);
    const bool along_x = to.x > from.x;
    for (double at = 0; at <= length; at += kSpacing) {
        const Point foot{from.x + (along_x ? at : 0), from.y + (along_x ? 0 : at), from.z};
        draft.add_detail_box({{foot.x - kHalf, foot.y - kHalf, foot.z}, {foot.x + kHalf, foot.y + kHalf, foot.z + 26}},
                             skin);
    }
}

void add_arch(Draft& draft, int axis, const Box& doorway, const Skin& skin) {
    const double low = axis == 0 ? doorway.low.y : doorway.low.x, high = axis == 0 ? doorway.high.y : doorway.high.x;
    const double radius = (high - low) / 2, spring = doorway.high.z - radius;
    const double begin = axis == 0 ? doorway.low.x : doorway.low.y, end = axis == 0 ? doorway.high.x : doorway.high.y;
    const auto arc = circle(16, (low + high) / 2, spring, radius, 0);
    for (std::size_t i = 0; i < 8; ++i) {
        const std::array<double, 2> corner{i < 4 ? high : low, doorway.high.z};
        draft.add_detail(extrude({axis, {corner, arc[i], arc[i + 1]}}, begin, end, skin));
    }
}

void add_door_frame(Draft& draft, Side facing, const Opening& opening, double wall_at) {
    constexpr double kWidth = 8, kProud = 4;
    const bool spans_x = facing == Side::North || facing == Side::South;
    const bool faces_up_axis = facing == Side::North || facing == Side::East;
    const double near = faces_up_axis ? wall_at : wall_at - kProud, far = near + kProud;
    const auto add_bar = [&](double low, double high, double z_low, double z_high) {
        const Box bar =
            spans_x ? Box{{low, near, z_low}, {high, far, z_high}} : Box{{near, low, z_low}, {far, high, z_high}};
        draft.add_detail_box(bar, "brass_trim");
    };
    add_bar(opening.low - kWidth, opening.low, opening.z_low, opening.z_high);
    add_bar(opening.high, opening.high + kWidth, opening.z_low, opening.z_high);
    add_bar(opening.low - kWidth, opening.high + kWidth, opening.z_high, opening.z_high + kWidth);
}

void add_stairs(Draft& draft, const Stairs& stairs, const Skin& skin) {
    constexpr double kRise = 16;
    const double direction = stairs.climbs_north ? 1 : -1;
    const double end = stairs.y_start + direction * stairs.count * stairs.run;
    // One slab on the other, each shorter by a step.
    for (int step = 0; step < stairs.count; ++step) {
        const double begin = stairs.y_start + direction * step * stairs.run, foot = stairs.z_foot + step * kRise;
        draft.add_detail_box(
            {{stairs.x_low, std::min(begin, end), foot}, {stairs.x_high, std::max(begin, end), foot + kRise}}, skin);
    }
}

}  // namespace oblong::map_source
