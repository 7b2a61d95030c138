#include <algorithm>

#include "engine/base/table.h"
#include "tools/demo_level/art/canvas.h"
#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

struct StoneStyle {
    Ramp ramp = Ramp::Stone, rare_ramp = Ramp::Grey;
    int base = steps(7);
    int tone = steps(2);       ///< how much blocks differ
    int roughness = steps(2);  ///< of the noise on each
    int edge = steps(2);       ///< light and dark edges
    int seed = 1;
};

/// One block; its last row and column are mortar.
void paint_block(Canvas& canvas, Box box, const StoneStyle& style) {
    const int number = hash_255(box.x, box.y, style.seed);
    const bool is_rare = number % 5 == 0;
    const int base = style.base + (number - 128) * style.tone / 256;
    const NoiseField field{canvas.width(), canvas.height(), style.seed + number % 7};
    canvas.paint(box, [&](int x, int y) {
        const int grain = fractal_noise(field, box.x + x, box.y + y, 16) * style.roughness / 256;
        const int falling_light = (box.height / 2 - y) * steps(1) / box.height;
        return Texel{is_rare ? style.rare_ramp : style.ramp, base + grain + falling_light};
    });
    canvas.bevel({box.x, box.y, box.width - 1, box.height - 1}, style.edge);
}

/// The joint under and right of a block, and its rounded corners.
void paint_mortar(Canvas& canvas, Box box, const StoneStyle& style) {
    const auto joint = [&](int x, int y) { return Texel{style.ramp, style.base - steps(5) + hash_255(x, y, 99) * 2}; };
    canvas.paint({box.x, box.y + box.height - 1, box.width, 1}, joint);
    canvas.paint({box.x + box.width - 1, box.y, 1, box.height}, joint);
    for (const int x : {box.x, box.x + box.width - 2}) {
        for (const int y : {box.y, box.y + box.height - 2}) canvas.at(x, y) = joint(x, y);
    }
}

/// A bite out of a block's lower edge: dark above, lit where the broken stone faces up.
void paint_chip(Canvas& canvas, Box box, int seed) {
    const int width = 3 + hash_255(box.x, box.y, seed) % 4, depth = 2 + hash_255(box.y, box.x, seed) % 2;
    const int left = box.x + 2 + hash_255(seed, box.x, box.y) % std::max(1, box.width - width - 4);
    for (int x = 0; x < width; ++x) {
        const int bite = depth - (x == 0 || x == width - 1 ? 1 : 0);
        for (int y = 0; y < bite; ++y) canvas.at(left + x, box.y + box.height - 2 - y).level -= steps(3);
        canvas.at(left + x, box.y + box.height - 2 - bite).level += steps(1);
    }
}

/// A crack wanders down through a block; its right side catches the light.
void paint_crack(Canvas& canvas, Box box, int seed) {
    int x = box.x + 4 + hash_255(box.x, seed, box.y) % std::max(1, box.width - 8);
    for (int y = box.y + 1; y < box.y + box.height - 1; ++y) {
        canvas.at(x, y).level -= steps(3);
        canvas.at(x + 1, y).level += steps(1);
        x += hash_255(x, y, seed) % 3 - 1;
    }
}

void paint_worn_block(Canvas& canvas, Box box, const StoneStyle& style) {
    paint_block(canvas, box, style);
    paint_mortar(canvas, box, style);
    const int wear = hash_255(box.y, style.seed, box.x) % 8;
    if (wear < 3) paint_chip(canvas, box, style.seed + wear);
    if (wear == 7) paint_crack(canvas, box, style.seed);
}

/// Courses of blocks; every second one is shifted by half a block, and block lengths vary by a quarter.
void paint_courses(Canvas& canvas, int block_width, int course_height, const StoneStyle& style) {
    for (int y = 0; y < canvas.height(); y += course_height) {
        const int shift = y / course_height % 2 * block_width / 2 + y / course_height % 3 * 2;
        for (int x = 0; x < canvas.width(); x += block_width * 2) {
            const int vary = (hash_255(x, y, style.seed) - 128) * block_width / 512;
            const int first = block_width + vary;
            paint_worn_block(canvas, {x + shift, y, first, course_height}, style);
            paint_worn_block(canvas, {x + shift + first, y, 2 * block_width - first, course_height}, style);
        }
    }
}

/// Veins: thin lines where a slow noise crosses zero, bent by a second one.
int vein_strength(const NoiseField& field, int x, int y) {
    const NoiseField bend{field.width, field.height, field.seed + 50};
    const int crossing = std::abs(fractal_noise(field, x + value_noise(bend, x, y, 16) / 20, y, 32));
    return std::max(0, 40 - crossing) * 256 / 40;
}

struct MarbleStyle {
    Ramp ramp;
    int base, vein, cloud;
    int seed;
};

Texel marble(const MarbleStyle& style, const NoiseField& field, int x, int y) {
    const NoiseField veins{field.width, field.height, style.seed};
    const int cloud = fractal_noise({field.width, field.height, style.seed + 9}, x, y, 32) * style.cloud / 256;
    return {style.ramp, style.base + cloud + vein_strength(veins, x, y) * style.vein / 256};
}

void paint_marble_tile(Canvas& canvas, Box box, const MarbleStyle& style) {
    const NoiseField field{canvas.width(), canvas.height(), 0};
    canvas.paint(box, [&](int x, int y) { return marble(style, field, box.x + x, box.y + y); });
    canvas.bevel({box.x, box.y, box.width - 1, box.height - 1}, steps(1));
    canvas.lighten({box.x, box.y + box.height - 1, box.width, 1}, -steps(3));
    canvas.lighten({box.x + box.width - 1, box.y, 1, box.height}, -steps(3));
}

}  // namespace

Canvas paint_stone_wall() {
    Canvas canvas(64, 64);
    paint_courses(canvas, 32, 16, {.base = steps(9), .seed = 3});
    return canvas;
}

Canvas paint_stone_dark() {
    Canvas canvas(64, 64);
    paint_courses(canvas, 32, 32,
                  {.rare_ramp = Ramp::Stone, .base = steps(8), .roughness = steps(3), .edge = steps(3), .seed = 12});
    return canvas;
}

Canvas paint_stone_floor() {
    Canvas canvas(64, 64);
    const StoneStyle style{
        .ramp = Ramp::Grey, .rare_ramp = Ramp::Stone, .base = steps(9), .edge = steps(1), .seed = 21};
    for (const Box slab : {Box{0, 0, 40, 24}, Box{40, 0, 24, 40}, Box{0, 24, 16, 40}, Box{16, 24, 24, 16},
                           Box{16, 40, 24, 24}, Box{40, 40, 24, 24}}) {
        paint_worn_block(canvas, slab, style);
    }
    return canvas;
}

Canvas paint_sand_wall() {
    Canvas canvas(64, 64);
    paint_courses(
        canvas, 32, 16,
        {.ramp = Ramp::Sand, .rare_ramp = Ramp::Terracotta, .base = steps(9), .roughness = steps(1), .seed = 5});
    return canvas;
}

Canvas paint_brick() {
    Canvas canvas(64, 64);
    paint_courses(canvas, 16, 8,
                  {.ramp = Ramp::Terracotta, .rare_ramp = Ramp::Red, .base = steps(8), .tone = steps(3), .seed = 7});
    return canvas;
}

Canvas paint_sand_frieze() {
    Canvas canvas(64, 32);
    const NoiseField field{64, 32, 31};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        return Texel{Ramp::Sand, steps(9) + fractal_noise(field, x, y, 8) / 2};
    });
    for (const int y : {0, 27}) {
        canvas.lighten({0, y, 64, 1}, steps(3));
        canvas.lighten({0, y + 4, 64, 1}, -steps(3));
    }
    // One key of the meander, 16 texels wide; '#' is cut into the stone.
    constexpr std::array<const char*, 16> kKey{
        "................", "................", "###############.", "#...............",
        "#.#############.", "#.#...........#.", "#.#.#########.#.", "#.#.#.......#.#.",
        "#.#.#.#####.#.#.", "#.#.#.#...#.#.#.", "#.#.#.###.#.#.#.", "#.#.#.....#.#.#.",
        "#.#.#######.#.#.", "#.#.........#.#.", "#.###########.##", "................"};
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 64; ++x) {
            if (at(kKey, y)[x % 16] != '#') continue;
            canvas.at(x, y + 8).level -= steps(5);
            canvas.at(x, y + 9).level += steps(1);
        }
    }
    return canvas;
}

Canvas paint_checker() {
    Canvas canvas(128, 128);
    const MarbleStyle white{Ramp::Ivory, steps(13), -steps(3), steps(1), 41};
    const MarbleStyle black{Ramp::Stone, steps(3), steps(4), steps(1), 42};
    for (int y = 0; y < 128; y += 64) {
        for (int x = 0; x < 128; x += 64) paint_marble_tile(canvas, {x, y, 64, 64}, (x + y) % 128 == 0 ? white : black);
    }
    return canvas;
}

Canvas paint_marble_ivory() {
    Canvas canvas(64, 64);
    const MarbleStyle style{Ramp::Ivory, steps(12), -steps(4), steps(2), 43};
    canvas.paint(canvas.whole(), [&](int x, int y) { return marble(style, {64, 64, 0}, x, y); });
    return canvas;
}

Canvas paint_marble_green() {
    Canvas canvas(64, 64);
    const MarbleStyle style{Ramp::Verdigris, steps(7), steps(4), steps(3), 44};
    paint_marble_tile(canvas, canvas.whole(), style);
    return canvas;
}

Canvas paint_basin_tiles() {
    Canvas canvas(64, 64);
    for (int y = 0; y < 64; y += 16) {
        for (int x = 0; x < 64; x += 16) {
            const bool is_dark = hash_255(x, y, 61) % 3 == 0;
            paint_marble_tile(
                canvas, {x, y, 16, 16},
                {is_dark ? Ramp::Night : Ramp::Water, steps(7) + hash_255(y, x, 62) * 2, steps(1), steps(1), 63});
        }
    }
    return canvas;
}

}  // namespace oblong::art
