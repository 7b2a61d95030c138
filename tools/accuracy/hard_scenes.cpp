#include <cmath>
#include <numbers>

#include "engine/io/doubles.h"
#include "tools/accuracy/measured_level.h"
#include "tools/accuracy/scene_map.h"
#include "tools/map/compile.h"

namespace oblong {

namespace {

using map::Point;

/// A camera's position and angles: world units, degrees.
struct Eye {
    Point position;
    double yaw = 0, pitch = 0, roll = 0;
};

struct HardScene {
    std::string name, about;
    SceneMap source;
    std::vector<Eye> eyes;
    bool has_loose_edges = false;  ///< its file keeps T-junctions
};

/// A lit room with a place to start in.
SceneMap make_room(const Point& size) {
    SceneMap room({{0, 0, 0}, size});
    room.add_start({size.x / 2, 24, 32});
    for (const double x : {0.05, 0.2, 0.4, 0.6, 0.8, 0.95})
        for (const double y : {0.2, 0.8})
            room.add_light({size.x * x, size.y * y, size.z * 0.7}, static_cast<int>(200 + (size.x + size.y) / 12));
    return room;
}

/// The wall y = 0, seen at an angle. Its 1/z is (X cos(-yaw) + sin(-yaw)) / y, X from -1 to 1 across the screen:
/// depths of 1:10 at 50.71 degrees, of 1:1000 at 45.057.
HardScene make_wall_1_to_10() {
    return {"wall, z 1:10",
            "A wall that runs across the whole screen, ten times as far at one end as at the other; also over fewer "
            "columns, and leaning.",
            make_room({1024, 512, 256}),
            {{{100, 32, 128}, -50.71},
             {{100, 8, 100}, -50.71, 0, 25},
             {{900, 32, 128}, 230.71},
             {{100, 16, 128}, 20},
             {{100, 24, 128}, -5, 10, 40}}};
}

HardScene make_wall_1_to_1000() {
    return {"wall, z 1:1000",
            "The same wall, a thousand times as far at one end as at the other.",
            make_room({4096, 512, 256}),
            {{{40, 4, 128}, -45.057}, {{40, 4, 120}, -45.057, 0, 30}, {{4056, 4, 128}, 225.057}}};
}

/// Blocks are long if the depth changes little, so that the rounding of their steps adds up.
HardScene make_close_wall() {
    SceneMap room = make_room({1024, 512, 256});
    room.add(make_box({{560, 0, 0}, {900, 16, 256}}, "stone", 4));
    return {"wall close by",
            "A wall 1 to 16 units from the eye, on part of it texels of 4 units: a texel is up to 640 pixels wide.",
            std::move(room),
            {{{103, 1, 128}, -89.76, 0, 81.3},
             {{700.5, 20, 100}, -90.21},
             {{110, 2, 100}, -75, 10},
             {{110, 16, 90}, -90.21},
             {{701, 17, 128}, -89.8, 0, 40},
             {{720, 32, 120}, -60}}};
}

HardScene make_horizon() {
    return {"floor to the horizon",
            "A floor and a ceiling that reach 4,000 units away.",
            make_room({4096, 4096, 512}),
            {{{30, 30, 48}, 33}, {{30, 30, 48}, 45, -6, 15}, {{4000, 100, 200}, 130, 4}}};
}

map::MapBrush make_ramp() {
    const Point a{200, 150, 0}, b{800, 250, 0}, c{700, 800, 0}, d{180, 700, 0}, top{850, 850, 320}, side{150, 820, 140};
    return make_solid({{a, b, c}, {a, top, b}, {a, side, top}, {a, d, side}, {d, c, top}, {b, top, c}}, {500, 500, 40},
                      "stone");
}

HardScene make_tilted_plane() {
    SceneMap room = make_room({1024, 1024, 512});
    room.add(make_ramp());
    return {"tilted plane",
            "A slope at odds with every axis, the eye leaning too: u, v and 1/z all change along a row.",
            std::move(room),
            {{{120, 100, 200}, 48, 12, 20}, {{900, 120, 260}, 120, 20, -35}, {{120, 900, 300}, -40, 25, 70}}};
}

/// Walls of one degree each around a point that they nearly reach.
HardScene make_slivers() {
    SceneMap room = make_room({1024, 1024, 256});
    const auto corner = [](double degrees, double radius) {
        const double angle = degrees * std::numbers::pi / 180;
        const auto snapped = [](double value) { return std::round(value * 32) / 32; };
        return std::array<double, 2>{snapped(512 + radius * std::cos(angle)), snapped(512 + radius * std::sin(angle))};
    };
    for (int i = 0; i < 40; ++i) {
        const double from = i * 9.0 + 0.3;
        room.add(make_wedge({corner(from, 24), corner(from, 320), corner(from + 1, 320)}, 60.0 + i, "stone"));
    }
    return {
        "slivers",
        "A fan of forty wedges one degree wide: faces thinner than a pixel. Its file leaves T-junctions to the engine.",
        std::move(room),
        {{{511.8986, 216.0928, 153.1861}, 175.3435, 13.6788, -7.7630},
         {{512, 60, 130}, 90, 2},
         {{853.5051, 127.4749, 73.9897}, 61.4817, -6.0480, -23.7854},
         {{100, 120, 190}, 45, 12},
         {{520, 90, 230}, 90, 25, 15}},
        true};
}

HardScene make_far_tower() {
    SceneMap room = make_room({6144, 1024, 1024});
    for (int floor = 0; floor < 12; ++floor) {
        const double half = 90 - floor * 6, low = floor * 64, centre = 512;
        room.add(make_box({{5600 - half, centre - half, low}, {5600 + half, centre + half, low + 56}},
                          floor % 2 != 0 ? "stone" : "tiles"));
        room.add(make_box({{5604 - half, centre - half + 4, low + 56}, {5596 + half, centre + half - 4, low + 64}},
                          "tiles"));
    }
    return {"far tower",
            "A tower of twelve storeys 5,500 units away: many edges a pixel, small texels.",
            std::move(room),
            {{{80, 500, 60}, 0.3, -3}, {{80, 60, 300}, 5, 1, 10}, {{3000, 700, 90}, -4, -4}}};
}

/// The sphere does not move: the eye goes around it.
HardScene make_rotating_sphere() {
    SceneMap room = make_room({512, 512, 256});
    room.add(make_sphere({256, 256, 120}, "stone", "tiles"));
    std::vector<Eye> eyes;
    for (int i = 0; i < 5; ++i) {
        const double angle = (i * 15.7 + 7) * std::numbers::pi / 180, radius = 110 + 20 * i;
        const auto snapped = [](double value) { return std::round(value * 16) / 16; };
        eyes.push_back(
            {{snapped(256 - radius * std::cos(angle)), snapped(256 - radius * std::sin(angle)), 110.0 + 8 * i},
             angle * 180 / std::numbers::pi,
             2.0 * i,
             7.0 * i});
    }
    return {"rotating sphere", "A sphere of 24 by 12 facets, seen from five sides.", std::move(room), std::move(eyes)};
}

HardScene make_coloured_lamps() {
    SceneMap room({{0, 0, 0}, {512, 512, 256}});
    room.add_start({256, 24, 32});
    for (const auto& [place, colour] : {std::pair{Point{60, 450, 100}, "255 40 20"},
                                        {{256, 470, 40}, "40 255 60"},
                                        {{450, 400, 180}, "50 80 255"},
                                        {{256, 60, 220}, "255 230 180"}})
        room.add_light(place, 420, colour);
    room.add(make_sphere({256, 330, 100}, "stone", "tiles"));
    return {"coloured lamps",
            "Red, green, blue and warm white lamps, on a sphere and on walls: more hues than the palette has.",
            std::move(room),
            {{{256, 60, 90}, 90, 4}, {{420, 120, 140}, 120, 10, 12}, {{90, 200, 60}, 40, -8}}};
}

Camera camera_of(const Eye& eye) {
    const auto angle = [](double degrees) { return Angle::from_bam(std::lround(degrees * 65536 / 360)); };
    Camera camera;
    camera.eye = {fixed_of<World>(eye.position.x), fixed_of<World>(eye.position.y), fixed_of<World>(eye.position.z)};
    camera.yaw = angle(eye.yaw);
    camera.pitch = angle(eye.pitch);
    camera.roll = angle(eye.roll);
    return camera;
}

MeasuredLevel compiled(const HardScene& scene, const map::Wad& wad, std::size_t most_cameras) {
    map::BspFile bsp = map::compile_map(scene.source.entities(), {wad}, {true});
    if (scene.has_loose_edges) loosen_edges(bsp);
    const std::string bytes = map::to_bytes(bsp);
    std::vector<Camera> cameras;
    for (const Eye& eye : scene.eyes)
        if (cameras.size() < most_cameras) cameras.push_back(camera_of(eye));
    const std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
    return make_measured_level(scene.name, scene.about, file, std::move(cameras));
}

}  // namespace

std::vector<MeasuredLevel> make_hard_scenes(const Palette& palette, std::size_t most_cameras) {
    const map::Wad wad(make_scene_wad(palette));
    std::vector<MeasuredLevel> levels;
    for (const auto make : {make_wall_1_to_10, make_wall_1_to_1000, make_close_wall, make_horizon, make_tilted_plane,
                            make_slivers, make_far_tower, make_rotating_sphere, make_coloured_lamps})
        levels.push_back(compiled(make(), wad, most_cameras));
    return levels;
}

}  // namespace oblong
