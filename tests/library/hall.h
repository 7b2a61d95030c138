#pragma once

#include <string>

#include "engine/library/oblong.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"

// A level of one room, and what stands in it.
namespace oblong::test {

// The space of -256..256 each way, 256 high, with things in it.
inline std::string hall(const std::string& brushes, const std::string& entities) {
    return level(room({-256, -256, 0}, {256, 256, 256}) + brushes,
                 entities_of("info_player_start -100 0 24 angle=90 + light 0 0 200") + entities);
}

// In units: east, north, up.
inline Pose beside(Pose pose, std::int32_t east, std::int32_t north, std::int32_t up) {
    pose.x_256 += east * 256;
    pose.y_256 += north * 256;
    pose.z_256 += up * 256;
    return pose;
}

// Greys, 64 reds, and of red the texture "other".
inline Palette red_palette() {
    Palette palette = grey_palette();
    palette.colours[1] = {160, 160, 160};
    palette.colours[3] = {255, 0, 0};
    for (std::uint8_t i = 192; i != 0; ++i) palette.colours[i] = {static_cast<std::uint8_t>((i - 191) * 3), 0, 0};
    return palette;
}

struct Hall {
    explicit Hall(const std::string& brushes = "", const std::string& entities = "")
        : file(folder.write("hall.bsp", bytes_of(hall(brushes, entities)))), level(file, red_palette()) {}

    // Goes on for some steps of 8 units, and falls between them.
    Pose walk_east(Pose eye, int steps) const {
        for (int i = 0; i < steps; ++i) {
            eye = level.walked(eye, beside(eye, 8, 0, 0));
            if (!level.stands(eye)) eye = level.walked(eye, beside(eye, 0, 0, -20));
        }
        return eye;
    }

    std::vector<std::uint8_t> picture(const Pose& eye, std::int64_t time_ms = 0) {
        Picture picture = Picture::of_size(320, 200);
        level.draw(eye, time_ms, picture.canvas());
        return picture.pixels;
    }

    TemporaryFolder folder;
    std::string file;
    LevelScene level;
};

inline double units(std::int32_t units_256) {
    return units_256 / 256.0;
}

// A body is 32 units wide; its eye is 22 above its middle, 24 above its feet.
inline constexpr double kStop = 256 - 16, kEye = 24 + 22;

// A stage's picture of a model alone, from the origin to the east; in one colour its edges, if that is not negative.
inline Picture drawn(Stage& stage, const Model& model, const Pose& pose, std::int32_t edges = -1) {
    Picture picture = Picture::of_size(320, 200);
    edges < 0 ? stage.draw(model, pose, picture.canvas()) : stage.draw_edges(model, pose, edges, picture.canvas());
    return picture;
}

// Two triangles in one colour, 2 x 2 units around (at, 0, 0), that face west.
inline void add_square(Model& model, std::int32_t at, std::int32_t half, std::uint8_t colour) {
    Picture picture = Picture::of_size(1, 1);
    picture.pixels = {colour};
    const std::int32_t skin = model.add_picture(picture);
    const Corner left_up{at, half, half}, right_up{at, -half, half}, right_down{at, -half, -half},
        left_down{at, half, -half};
    model.add_triangle(left_up, right_up, right_down, skin);
    model.add_triangle(left_up, right_down, left_down, skin);
}
inline Model square_of(std::int32_t half, std::uint8_t colour) {
    Model model;
    add_square(model, 0, half, colour);
    return model;
}

}  // namespace oblong::test
