#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

using Textures = std::vector<NamedCanvas>;

void add_stone(Textures& all) {
    all.push_back({"stone_wall", paint_stone_wall()});
    all.push_back({"stone_dark", paint_stone_dark()});
    all.push_back({"stone_floor", paint_stone_floor()});
    all.push_back({"sand_wall", paint_sand_wall()});
    all.push_back({"sand_frieze", paint_sand_frieze()});
    all.push_back({"brick", paint_brick()});
    all.push_back({"checker", paint_checker()});
    all.push_back({"marble_ivory", paint_marble_ivory()});
    all.push_back({"marble_green", paint_marble_green()});
    all.push_back({"basin_tiles", paint_basin_tiles()});
}

void add_metal(Textures& all) {
    all.push_back({"brass_panel", paint_brass_panel()});
    all.push_back({"brass_trim", paint_brass_trim()});
    all.push_back({"brass_dial", paint_brass_dial()});
    all.push_back({"iron_grate", paint_iron_grate()});
    all.push_back({"copper_roof", paint_copper_roof()});
    all.push_back({"lamp", paint_lamp()});
    all.push_back({"lamp_blue", paint_lamp_blue()});
    all.push_back({"lit_window", paint_lit_window()});
    all.push_back({"{grate", paint_grate()});
}

void add_interior(Textures& all) {
    all.push_back({"wood_planks", paint_wood_planks()});
    all.push_back({"wood_panel", paint_wood_panel()});
    all.push_back({"wood_door", paint_wood_door()});
    all.push_back({"carpet", paint_carpet()});
    all.push_back({"plaster_night", paint_plaster_night()});
    all.push_back({"plaster_ivory", paint_plaster(Ramp::Ivory)});
    all.push_back({"plaster_red", paint_plaster(Ramp::Red)});
    all.push_back({"coffer", paint_coffer()});
    all.push_back({"grid_paper", paint_grid_paper()});
    all.push_back({"cube_red", paint_cube_face(Ramp::Red)});
    all.push_back({"cube_blue", paint_cube_face(Ramp::Night)});
    all.push_back({"cube_gold", paint_cube_face(Ramp::Brass)});
    all.push_back({"ruler", paint_ruler()});
    all.push_back({"diamond", paint_diamond()});
}

void add_outdoors(Textures& all) {
    all.push_back({"sky_night", paint_sky()});
    all.push_back({"#water", paint_water()});
    all.push_back({"#lava", paint_lava()});
    all.push_back({"earth", paint_earth()});
    all.push_back({"hedge", paint_hedge()});
}

void add_signs(Textures& all) {
    all.push_back({"title", paint_title("OBLONG")});
    all.push_back({"sign_museum", paint_sign("A MUSEUM OF", "PERSPECTIVE")});
    all.push_back({"sign_aspect", paint_sign("ASPECT")});
    all.push_back({"sign_vanish", paint_sign("THE VANISHING", "POINT")});
    all.push_back({"sign_axono", paint_sign("AXONOMETRY")});
    all.push_back({"sign_planes", paint_sign("ANY PLANE")});
    all.push_back({"sign_fov", paint_sign("FIELD OF VIEW")});
    all.push_back({"sign_forced", paint_sign("FORCED", "PERSPECTIVE")});
    all.push_back({"sign_accuracy", paint_sign("ACCURACY")});
    all.push_back({"sign_distance", paint_sign("DISTANCE")});
    all.push_back({"sign_light", paint_sign("LIGHT AND", "SHADOW")});
    all.push_back({"sign_dust", paint_sign("DUST")});
    all.push_back({"sign_sparks", paint_sign("SPARKS")});
    all.push_back({"sign_rain", paint_sign("RAIN")});
    all.push_back({"sign_fog", paint_sign("FOG")});
    for (int frame = 0; frame < kExitFrames; ++frame) {
        all.push_back({"+" + std::to_string(frame) + "exit", paint_exit_sign(frame)});
    }
    all.push_back({"picture_road", paint_picture_road()});
    all.push_back({"picture_cubes", paint_picture_cubes()});
    all.push_back({"picture_eye", paint_picture_eye()});
    all.push_back({"picture_moon", paint_picture_moon()});
}

void add_furnishings(Textures& all) {
    all.push_back({"#teleport", paint_teleport()});
    all.push_back({"mirror_hall", paint_mirror()});
    all.push_back({"{lantern", paint_lantern()});
    all.push_back({"{fern", paint_fern()});
    all.push_back({"neon", paint_neon()});
    all.push_back({"lamp_dead", paint_lamp_dead()});
    all.push_back({"+0lenses", paint_lens_windows(false)});
    all.push_back({"+alenses", paint_lens_windows(true)});
    for (int frame = 0; frame < kVoltFrames; ++frame) {
        all.push_back({"+" + std::to_string(frame) + "volt", paint_volt(frame)});
    }
}

}  // namespace

std::vector<NamedCanvas> paint_all_textures() {
    Textures all;
    add_stone(all);
    add_metal(all);
    add_interior(all);
    add_outdoors(all);
    add_signs(all);
    add_furnishings(all);
    return all;
}

}  // namespace oblong::art
