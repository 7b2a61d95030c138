#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr double kX = 512, kY = 1712, kFloor = 48;
constexpr double kInner = 112, kOuter = 144, kRoof = 168;

/// An octagon with sides to the north, east ... of which each is `apothem` from the middle; to whole units.
std::vector<std::array<double, 2>> octagon(double apothem) {
    return circle(8, kX, kY, apothem / 0.92387953, 22.5);
}

/// The walls between two octagons. `leave_out`, if not negative, is a side: 0 north-east, then counter-clockwise.
void add_ring(Draft& draft, double inner, double outer, double z_low, double z_high, const Skin& skin,
              int leave_out = -1) {
    const auto near = octagon(inner), far = octagon(outer);
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t next = (i + 1) % 8;
        if (static_cast<int>(i) == leave_out) continue;
        draft.add(extrude({2, {near[i], near[next], far[next], far[i]}}, z_low, z_high, skin));
    }
}

/// The north wall, with the doorway that the passage comes in by.
void add_north_wall(Draft& draft, double z_high, const Skin& skin) {
    constexpr double kDoorHalf = 40, kDoorTop = 160;
    const auto near = octagon(kInner), far = octagon(kOuter);
    const double y_near = near[1][1], y_far = far[1][1];
    const std::array<double, 2> east_near{kX + kDoorHalf, y_near}, east_far{kX + kDoorHalf, y_far};
    const std::array<double, 2> west_near{kX - kDoorHalf, y_near}, west_far{kX - kDoorHalf, y_far};
    draft.add(extrude({2, {near[1], east_near, east_far, far[1]}}, 0, z_high, skin));
    draft.add(extrude({2, {near[2], west_near, west_far, far[2]}}, 0, z_high, skin));
    draft.add(extrude({2, {east_near, west_near, west_far, east_far}}, kDoorTop, z_high, skin));
    draft.add(extrude({2, {east_near, west_near, west_far, east_far}}, 0, kFloor, skin));
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
    draft.add(make_solid(faces, {kX, kY, z_low + 8}, "copper_roof"));
}

void add_windows(Draft& draft) {
    for (const double z : {136.0, 232.0, 360.0}) {
        add_panel(draft,
                  {Side::South, {{kX - 16, kY - kOuter - 4, z}, {kX + 16, kY - kOuter, z + 64}}, "lit_window", 32, 64});
        add_panel(draft,
                  {Side::East, {{kX + kOuter, kY - 16, z}, {kX + kOuter + 4, kY + 16, z + 64}}, "lit_window", 32, 64});
        add_panel(draft,
                  {Side::West, {{kX - kOuter - 4, kY - 16, z}, {kX - kOuter, kY + 16, z + 64}}, "lit_window", 32, 64});
        draft.add_light({kX, kY - kOuter - 40, z + 24}, 290);
        draft.add_light({kX + kOuter + 40, kY, z + 24}, 240);
    }
    add_panel(draft, {Side::South, {{kX - 32, kY - kOuter - 4, 0}, {kX + 32, kY - kOuter, 112}}, "wood_door", 64, 128});
    for (const double x : {kX - 52, kX + 52}) add_wall_lamp(draft, {x, kY - kOuter - 8, 84}, Side::South, 350);
}

/// The end of the visit: a light on a dais under painted stars.
void add_end(Draft& draft) {
    draft.add(extrude({2, octagon(64)}, kFloor, kFloor + 8, "marble_green"));
    draft.add(extrude({2, octagon(28)}, kFloor + 8, kFloor + 36, "brass_panel"));
    draft.add(make_crystal({kX, kY, kFloor + 64}, 14, 22, 45, "lamp_blue"));
    draft.add_light({kX, kY + 40, kFloor + 72}, 360);
    draft.add_light({kX, kY - 40, kFloor + 72}, 360);
    draft.add_light({kX, kY, 280}, 400);
    add_panel(draft, {Side::North, {{kX - 44, kY - kInner, 200}, {kX + 44, kY - kInner + 4, 222}}, "title", 128, 32});
    add_panel(draft, {Side::North, {{kX - 32, kY - kInner, 160}, {kX + 32, kY - kInner + 4, 192}}, "+0exit", 64, 32});
    draft.add_entity({{{"classname", "trigger_changelevel"}, {"map", "demo"}, {"message", "You have seen the museum."}},
                      {make_box({{kX - 60, kY - 60, kFloor + 8}, {kX + 60, kY + 60, kFloor + 72}}, "brass_trim")}});
}

}  // namespace

void build_tower(Draft& draft) {
    constexpr double kTop = 456;
    constexpr int kNorthSide = 1;
    const Skin stone{"stone_dark"};
    draft.add(extrude({2, octagon(kInner)}, 0, kFloor, {"stone_dark", "diamond"}));
    add_ring(draft, kInner, kOuter, 0, kTop, stone, kNorthSide);
    add_north_wall(draft, kTop, stone);
    draft.add(extrude({2, octagon(kInner)}, 400, 416, "plaster_night"));
    for (const double z : {208.0, 320.0}) add_ring(draft, kOuter, kOuter + 8, z, z + 16, "sand_frieze");
    add_ring(draft, kOuter - 8, kOuter + 16, kTop - 16, kTop, "sand_frieze");
    draft.add(extrude({2, octagon(kOuter)}, kTop, kTop + 8, "stone_dark"));
    add_roof(draft, kTop + 8, 672);
    add_windows(draft);
    add_end(draft);
}

}  // namespace oblong::map_source
