#include <set>

#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr double kX = 512, kY = 1712, kFloor = 48;
constexpr double kInner = 112, kOuter = 144, kRoof = 168, kGateTop = 152;

/// An octagon with sides to the north, east ... of which each is `apothem` from the middle; to whole units.
std::vector<std::array<double, 2>> octagon(double apothem) {
    return circle(8, kX, kY, apothem / 0.92387953, 22.5);
}

/// What is between two octagons, side by side: 0 is north-east, then counter-clockwise.
std::array<Outline, 8> ring_sides(double inner, double outer) {
    const auto near = octagon(inner), far = octagon(outer);
    std::array<Outline, 8> sides;
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t next = (i + 1) % 8;
        sides[i] = {2, {near[i], near[next], far[next], far[i]}};
    }
    return sides;
}

/// The tower's walls, but for the sides left out.
void add_walls(Draft& draft, double z_high, const Skin& skin, const std::set<std::size_t>& left_out) {
    const auto sides = ring_sides(kInner, kOuter);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (!left_out.contains(i)) draft.add(extrude(sides[i], 0, z_high, skin));
    }
}

/// A band around the walls, 16 units high.
void add_band(Draft& draft, double width, double z_low) {
    for (const Outline& side : ring_sides(kOuter + 1, kOuter + width))
        draft.add_detail_prism(side, z_low, z_low + 16, "sand_frieze");
}

/// A doorway in the side of the tower whose corners in the octagons are `east` and `west`, above the tower's floor.
struct Doorway {
    std::size_t east = 0, west = 0;
    double half_width = 0, z_top = 0;
};

void add_wall_with_door(Draft& draft, const Doorway& door, double z_high, const Skin& skin) {
    const auto near = octagon(kInner), far = octagon(kOuter);
    const double y_near = near[door.east][1], y_far = far[door.east][1];
    const std::array<double, 2> east_near{kX + door.half_width, y_near}, east_far{kX + door.half_width, y_far};
    const std::array<double, 2> west_near{kX - door.half_width, y_near}, west_far{kX - door.half_width, y_far};
    draft.add(extrude({2, {near[door.east], east_near, east_far, far[door.east]}}, 0, z_high, skin));
    draft.add(extrude({2, {near[door.west], west_near, west_far, far[door.west]}}, 0, z_high, skin));
    draft.add(extrude({2, {east_near, west_near, west_far, east_far}}, door.z_top, z_high, skin));
    draft.add(extrude({2, {east_near, west_near, west_far, east_far}}, 0, kFloor, skin));
}

/// Seen through from the courtyard, and closed: the way in is by the passage from the north.
void add_portcullis(Draft& draft, double half_width, double z_top) {
    const double y = kY - (kInner + kOuter) / 2;
    const Box box{{kX - half_width, y - 2, kFloor}, {kX + half_width, y + 2, z_top}};
    Brush bars = make_box(box, "{grate");
    fit_textures(bars, box, 0.5);
    draft.add_entity({{{"classname", "func_wall"}}, {bars}});
}

void add_roof(Draft& draft, double z_low, double z_tip) {
    const auto base = octagon(kRoof);
    const Point tip{kX, kY, z_tip};
    std::vector<std::vector<Point>> faces{
        {{base[0][0], base[0][1], z_low}, {base[1][0], base[1][1], z_low}, {base[2][0], base[2][1], z_low}}};
    for (std::size_t i = 0; i < 8; ++i) {
        const auto &a = base[i], &b = base[(i + 1) % 8];
        faces.push_back({{a[0], a[1], z_low}, {b[0], b[1], z_low}, tip});
    }
    draft.add_detail(make_solid(faces, {kX, kY, z_low + 8}, "copper_roof"));
}

void add_windows(Draft& draft) {
    for (const double z : {136.0, 232.0, 360.0}) {
        if (z > kGateTop) add_sign(draft, {Side::South, {kX, kY - kOuter, z + 32}, 1, "lit_window", 32, 64});
        add_panel(draft,
                  {Side::East, {{kX + kOuter, kY - 16, z}, {kX + kOuter + 4, kY + 16, z + 64}}, "lit_window", 32, 64});
        add_panel(draft,
                  {Side::West, {{kX - kOuter - 4, kY - 16, z}, {kX - kOuter, kY + 16, z + 64}}, "lit_window", 32, 64});
        draft.add_light({kX, kY - kOuter - 40, z + 24}, 290);
        for (const double x : {kX - kOuter - 40, kX + kOuter + 40}) draft.add_light({x, kY, z + 24}, 240);
    }
    for (const double x : {kX - 50, kX + 50}) add_wall_lamp(draft, {x, kY - kOuter - 8, 120}, Side::South, 320);
}

/// The end of the visit: a light on a dais under painted stars.
void add_end(Draft& draft) {
    draft.add(extrude({2, octagon(64)}, kFloor, kFloor + 8, "marble_green"));
    draft.add_detail_prism({2, octagon(28)}, kFloor + 8, kFloor + 36, "brass_panel");
    draft.add_detail(make_crystal({kX, kY, kFloor + 64}, 14, 22, 45, "lamp_blue"));
    draft.add_light({kX, kY + 40, kFloor + 72}, 360);
    draft.add_light({kX, kY - 40, kFloor + 72}, 360);
    draft.add_light({kX, kY, 280}, 400);
    add_panel(draft, {Side::North, {{kX - 44, kY - kInner, 204}, {kX + 44, kY - kInner + 4, 226}}, "title", 128, 32});
    add_sign(draft, {Side::North, {kX, kY - kInner, 180}, 0.75, "+0exit", 112, 32});
    draft.add_entity({{{"classname", "trigger_changelevel"}, {"map", "demo"}, {"message", "You have seen the museum."}},
                      {make_box({{kX - 60, kY - 60, kFloor + 8}, {kX + 60, kY + 60, kFloor + 72}}, "brass_trim")}});
}

}  // namespace

void build_tower(Draft& draft) {
    constexpr double kTop = 456;
    constexpr std::size_t kNorthSide = 1, kSouthSide = 5;
    constexpr double kGateHalf = 32;
    const Skin stone{"stone_dark"};
    draft.add(extrude({2, octagon(kInner)}, 0, kFloor, {"stone_dark", "diamond"}));
    add_walls(draft, kTop, stone, {kNorthSide, kSouthSide});
    add_wall_with_door(draft, {1, 2, 40, 160}, kTop, stone);
    add_wall_with_door(draft, {6, 5, kGateHalf, kGateTop}, kTop, stone);
    add_portcullis(draft, kGateHalf, kGateTop);
    const double south = kY - kOuter;
    add_door_frame(draft, Side::South, {Side::South, kX - kGateHalf, kX + kGateHalf, kFloor, kGateTop}, south);
    add_stairs(draft, {kX - 64, kX + 64, south - 72, 0, 24, 3, true}, {"sand_frieze", "stone_floor"});
    draft.add(extrude({2, octagon(kInner)}, 400, 416, "plaster_night"));
    for (const double z : {208.0, 320.0}) add_band(draft, 8, z);
    add_band(draft, 16, kTop - 16);
    draft.add_detail(extrude({2, octagon(kOuter)}, kTop, kTop + 8, "stone_dark"));
    add_roof(draft, kTop + 8, 672);
    add_windows(draft);
    add_end(draft);
}

}  // namespace oblong::map_source
