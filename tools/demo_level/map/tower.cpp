#include <algorithm>
#include <cmath>
#include <set>

#include "tools/demo_level/map/exhibits.h"
#include "tools/demo_level/map/fittings.h"
#include "tools/demo_level/map/museum.h"

namespace oblong::map_source {
namespace {

constexpr double kX = 512, kY = 1712, kFloor = 48;
constexpr double kInner = 112, kOuter = 144, kRoofApothem = 160, kGateTop = 152;
constexpr double kTerrace = 320, kLoge = 464, kEaves = 572, kTip = 688;  ///< heights of what is above the walls
const Box kLift{{472, 1736, kFloor}, {552, 1816, kLoge}};                ///< the shaft
const Point kPool{kX, 1652, kTerrace};

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

/// The part of a convex polygon on one side of a line across `axis` (0: x, 1: y).
Outline part_of(const Outline& outline, std::size_t axis, double at, bool is_below) {
    Outline part{outline.axis, {}};
    const auto is_in = [&](const std::array<double, 2>& p) { return is_below ? p[axis] <= at : p[axis] >= at; };
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
        const auto &a = outline.corners[i], &b = outline.corners[(i + 1) % outline.corners.size()];
        if (is_in(a)) part.corners.push_back(a);
        if (is_in(a) == is_in(b) || a[axis] == at || b[axis] == at) continue;
        const std::size_t other = 1 - axis;
        std::array<double, 2> crossing{};
        crossing[axis] = at;
        crossing[other] = a[other] + (b[other] - a[other]) * (at - a[axis]) / (b[axis] - a[axis]);
        part.corners.push_back(crossing);
    }
    return part;
}

/// A floor of this outline around the lift's shaft: south of it, beside it and north of it.
std::vector<Outline> around_shaft(const Outline& floor) {
    const Outline rest = part_of(floor, 1, kLift.low.y, false);
    const Outline middle = part_of(part_of(rest, 0, kLift.low.x, false), 0, kLift.high.x, true);
    return {part_of(floor, 1, kLift.low.y, true), part_of(rest, 0, kLift.low.x, true),
            part_of(rest, 0, kLift.high.x, false), part_of(middle, 1, kLift.high.y, false)};
}

/// Bars in a doorway, seen through, that rise when all lenses are found, and stay up.
void add_gate(Draft& draft, double y, double half_width, double z_top) {
    const Box box{{kX - half_width, y - 2, kFloor}, {kX + half_width, y + 2, z_top}};
    Brush bars = make_box(box, "{grate");
    fit_textures(bars, box, 0.5);
    draft.add_entity({{{"classname", "func_door"},
                       {"targetname", kTowerGate},
                       {"angle", "-1"},
                       {"lip", "2"},
                       {"speed", "40"},
                       {"wait", "-1"}},
                      {bars}});
}

void add_roof(Draft& draft, double z_low, double z_tip) {
    const auto base = octagon(kRoofApothem);
    const Point tip{kX, kY, z_tip};
    std::vector<std::vector<Point>> faces{
        {{base[0][0], base[0][1], z_low}, {base[1][0], base[1][1], z_low}, {base[2][0], base[2][1], z_low}}};
    for (std::size_t i = 0; i < 8; ++i) {
        const auto &a = base[i], &b = base[(i + 1) % 8];
        faces.push_back({{a[0], a[1], z_low}, {b[0], b[1], z_low}, tip});
    }
    draft.add_detail(make_solid(faces, {kX, kY, z_low + 8}, {"copper_roof", "copper_roof", "copper_roof", "coffer"}));
}

void add_windows(Draft& draft) {
    for (const double z : {136.0, 228.0}) {
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

/// Whether a face of a window looks away from the tower's middle.
bool looks_out(const BrushFace& face) {
    const Point normal = outward_normal(face), &at = face.points[0];
    const double along = normal.x * (at.x - kX) + normal.y * (at.y - kY);
    return along > 0.9 * std::hypot(normal.x, normal.y) * std::hypot(at.x - kX, at.y - kY);
}

/// A lens's 16 texels from end to end of a face. Texture axes run east or, on a face that looks as much east, north.
Placement window_placement(const BrushFace& face, std::size_t lens, double z_low, double z_high) {
    const Point normal = outward_normal(face);
    const bool runs_north = std::abs(normal.x) >= std::abs(normal.y);
    double low = 1e9, high = -1e9;
    for (const Point& point : face.points) {
        low = std::min(low, runs_north ? point.y : point.x);
        high = std::max(high, runs_north ? point.y : point.x);
    }
    Placement placement{"+0lenses", 0, 0, (high - low) / 16, (z_high - z_low) / 16};
    placement.offset_u = 16 * static_cast<double>(lens) - low / placement.scale_u;
    placement.offset_v = z_high / placement.scale_v;
    return placement;
}

/// A round window for each lens around the tower's south, dark until the lens is found.
void add_lens_windows(Draft& draft) {
    constexpr double kLow = 172, kHigh = 192, kHalf = 10.0 / 120;  // of a side's length
    constexpr std::size_t kFirstSide = 4, kOnASide = 4;
    const auto wall = octagon(kOuter), front = octagon(kOuter + 4);
    for (std::size_t lens = 0; lens < kLensCount; ++lens) {
        const std::size_t side = kFirstSide + lens / kOnASide;
        const double middle = (static_cast<double>(lens % kOnASide) + 0.5) / kOnASide;
        const auto corner = [&](const auto& ring, double part) {
            const auto &a = ring[side], &b = ring[(side + 1) % ring.size()];
            const auto between = [&](std::size_t axis) {
                return std::round((a[axis] + (b[axis] - a[axis]) * part) * 4) / 4;
            };
            return std::array<double, 2>{between(0), between(1)};
        };
        const Outline outline{2,
                              {corner(wall, middle - kHalf), corner(wall, middle + kHalf),
                               corner(front, middle + kHalf), corner(front, middle - kHalf)}};
        Brush window = extrude(outline, kLow, kHigh, "brass_trim");
        for (BrushFace& face : window.faces)
            if (looks_out(face)) face.placement = window_placement(face, lens, kLow, kHigh);
        draft.add_entity(
            {{{"classname", "func_wall"}, {"targetname", lens_target(lens)}, {"_minlight", "255"}}, {window}});
    }
}

/// A brass plate that goes up past a band for each exhibit, of what its room is made of, and out into the night.
void add_lift(Draft& draft) {
    for (const Outline& part : around_shaft({2, octagon(kInner)}))
        draft.add(extrude(part, kFloor - 24, kFloor, {"stone_dark", "diamond"}));
    draft.add(extrude({2, octagon(kInner)}, 0, kFloor - 24, "stone_dark"));
    const Box plate{{kLift.low.x + 2, kLift.low.y + 2, kLoge - 16}, {kLift.high.x - 2, kLift.high.y - 2, kLoge}};
    Brush brush = make_box(plate, {"brass_trim", "brass_trim", "brass_dial", "brass_panel"});
    fit_textures(brush, plate, 76.0 / 64);
    draft.add_entity({{{"classname", "func_plat"}, {"height", "416"}, {"speed", "90"}, {"sounds", "1"}}, {brush}});
    constexpr std::array<const char*, kLensCount> kOfExhibits{
        "carpet",    "checker",     "plaster_night", "stone_floor", "brick",     "grid_paper",
        "cube_blue", "brass_panel", "basin_tiles",   "hedge",       "sand_wall", "ruler"};
    double z = kGateTop + 16;
    for (const char* texture : kOfExhibits) {
        for (const Outline& side : ring_sides(kInner - 3, kInner - 1)) draft.add_detail_prism(side, z, z + 11, texture);
        z += 11;
    }
    add_panel(draft, {Side::North, {{kX - 44, kY - kInner, 104}, {kX + 44, kY - kInner + 4, 126}}, "title", 128, 32});
    for (const double x : {kX - 60, kX + 60}) draft.add_light({x, kY - 40, 120}, 330);
    draft.add_light({kX, kY - 30, 240}, 400);
    add_caption(draft, {{kX - 60, kY - 90, kFloor}, {kX + 60, kY - 30, kFloor + 72}}, "The brass plate goes up.");
}

/// An orrery over a pool that mirrors it and the stars: its lenses are those of the exhibits.
void add_orrery(Draft& draft) {
    const auto around_pool = [](double apothem) {
        return Outline{2, circle(8, kPool.x, kPool.y, apothem / 0.92387953, 22.5)};
    };
    draft.add_detail_prism(around_pool(66), kTerrace, kTerrace + 6, "marble_green");
    draft.add_detail_prism(around_pool(60), kTerrace + 6, kTerrace + 8, {"brass_trim", "mirror_hall"});
    const Point middle{kPool.x, kPool.y, kTerrace + 92};
    const std::array<std::pair<const char*, const char*>, 3> kParts{
        {{"orrery_sun", "16"}, {"orrery_lenses", "48"}, {"orrery_stand", ""}}};
    for (const auto& [name, period] : kParts) {
        std::vector<std::pair<std::string, std::string>> pairs{{"model", std::string("models/") + name + ".obj"},
                                                               {"scale", "54"},
                                                               {"shading", "phong"},
                                                               {"highlight", "120"},
                                                               {"least_light", "110"}};
        if (*period != 0) pairs.emplace_back("period", period);
        draft.add_point("misc_model", middle, std::move(pairs));
    }
    for (const double x : {kPool.x - 90, kPool.x + 90}) draft.add_light({x, kPool.y, kTerrace + 100}, 300);
    draft.add_light({kPool.x, kPool.y + 70, kTerrace + 70}, 260);
}

/// Where the lift ends, above the orrery: the courtyard, and a lens as tall as a visitor, which ends the visit.
void add_loge(Draft& draft) {
    const std::vector<Outline> parts = around_shaft({2, octagon(kOuter)});
    for (std::size_t i = 1; i < parts.size(); ++i)  // what is south of the lift stays open
        draft.add_detail_prism(parts[i], kLoge - 16, kLoge, {"sand_frieze", "stone_floor"});
    for (const double side : {-1.0, 1.0}) {
        const double near = kX + side * 44, far = kX + side * 130, y = kLift.low.y + 4;
        add_balustrade(draft, {std::min(near, far), y, kLoge}, {std::max(near, far), y, kLoge}, "marble_ivory");
    }
    const Point lens{kX - 88, kY + 92, kLoge};
    draft.add_detail_prism({2, circle(8, lens.x, lens.y, 14, 22.5)}, kLoge, kLoge + 10, "marble_green");
    draft.add_point("misc_model", {lens.x, lens.y, kLoge + 54},
                    {{"model", "models/lens.obj"},
                     {"scale", "20"},
                     {"angle", "-60"},
                     {"shading", "phong"},
                     {"highlight", "120"},
                     {"least_light", "110"}});
    draft.add_entity(
        {{{"classname", "trigger_changelevel"}, {"map", "demo"}, {"message", "You have seen the museum."}},
         {make_box({{lens.x - 16, lens.y - 16, kLoge}, {lens.x + 16, lens.y + 16, kLoge + 72}}, "brass_trim")}});
    add_caption(draft,
                {{kLift.low.x + 24, kLift.low.y + 24, kLoge + 8}, {kLift.high.x - 24, kLift.high.y - 24, kLoge + 72}},
                "THE ORRERY - your twelve lenses turn in it.", "The great lens behind you ends the walk.");
    draft.add_light({lens.x + 30, lens.y - 20, kLoge + 60}, 220);
    draft.add_light({kX + 88, kY + 80, kLoge + 60}, 220);
}

/// An open lantern on the walls: a terrace, six columns (none where one looks out over the courtyard), the roof.
void add_lantern(Draft& draft) {
    for (const Outline& part : around_shaft({2, octagon(kOuter)}))
        draft.add(extrude(part, kTerrace - 16, kTerrace, {"stone_dark", "diamond"}));
    for (const Point& foot :
         {Point{kX - 132, kY - 55, kTerrace}, Point{kX + 132, kY - 55, kTerrace}, Point{kX - 132, kY + 55, kTerrace},
          Point{kX + 132, kY + 55, kTerrace}, Point{kX - 55, kY + 132, kTerrace}, Point{kX + 55, kY + 132, kTerrace}})
        add_column(draft, foot, kEaves - kTerrace, 9, "marble_ivory");
    add_band(draft, 16, kTerrace - 20);
    draft.add_detail(
        extrude({2, octagon(kOuter + 4)}, kEaves, kEaves + 8, {"sand_frieze", "sand_frieze", "copper_roof", "coffer"}));
    add_roof(draft, kEaves + 8, kTip);
}

}  // namespace

void build_tower(Draft& draft) {
    constexpr double kWallTop = kTerrace - 16;
    constexpr std::size_t kNorthSide = 1, kSouthSide = 5;
    constexpr double kGateHalf = 32, kDoorHalf = 40;
    const Skin stone{"stone_dark"};
    add_walls(draft, kWallTop, stone, {kNorthSide, kSouthSide});
    add_wall_with_door(draft, {1, 2, kDoorHalf, 160}, kWallTop, stone);
    add_wall_with_door(draft, {6, 5, kGateHalf, kGateTop}, kWallTop, stone);
    const double in_wall = (kInner + kOuter) / 2, south = kY - kOuter;
    add_gate(draft, kY - in_wall, kGateHalf, kGateTop);
    add_gate(draft, kY + in_wall, kDoorHalf, 160);
    add_door_frame(draft, Side::South, {Side::South, kX - kGateHalf, kX + kGateHalf, kFloor, kGateTop}, south);
    add_stairs(draft, {kX - 64, kX + 64, south - 72, 0, 24, 3, true}, {"sand_frieze", "stone_floor"});
    add_band(draft, 8, 204);
    add_windows(draft);
    add_lens_windows(draft);
    add_lift(draft);
    add_lantern(draft);
    add_orrery(draft);
    add_loge(draft);
}

}  // namespace oblong::map_source
