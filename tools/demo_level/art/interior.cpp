#include <algorithm>
#include <cstdlib>

#include "tools/demo_level/art/canvas.h"
#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

/// Grain runs along y: noise stretched sixteen times, and rings.
Texel wood(int x, int y, int base, int seed) {
    const NoiseField field{64, 64, seed};
    const int wander = value_noise(field, x, y, 32) / 16;
    const int rings = std::abs((x * 5 + wander * 3 + seed * 7) % 24 - 12) * 40 - 240;
    const int fibre = hash_255(x, y / 12 + (x * 7) % 5, seed) - 128;
    return {Ramp::Wood, base + rings + fibre + value_noise(field, x, y, 16) * 2};
}

void paint_board(Canvas& canvas, Box box, int base, int seed) {
    canvas.paint(box, [&](int x, int y) { return wood(x, y + seed * 13, base, seed); });
    canvas.lighten({box.x, box.y, 1, box.height}, steps(2));
    canvas.lighten({box.x + box.width - 1, box.y, 1, box.height}, -steps(4));
}

/// A panel sunk into wood: a frame of four bevels, then a field that rises again.
void paint_sunk_panel(Canvas& canvas, Box box, int seed) {
    canvas.paint(box, [&](int x, int y) { return wood(x, y, steps(8), seed); });
    canvas.bevel(box, -steps(4));
    canvas.bevel({box.x + 1, box.y + 1, box.width - 2, box.height - 2}, -steps(2));
    if (box.width < 14 || box.height < 14) return;
    canvas.bevel({box.x + 4, box.y + 4, box.width - 8, box.height - 8}, steps(3));
    canvas.lighten({box.x + 5, box.y + 5, box.width - 10, box.height - 10}, steps(1));
}

Texel plaster(Ramp ramp, int base, int x, int y, int seed) {
    const NoiseField field{64, 64, seed};
    return {ramp, base + fractal_noise(field, x, y, 32) + (hash_255(x, y, seed) - 128) * 2};
}

void paint_gold_star(Canvas& canvas, int x, int y) {
    canvas.at(x, y) = {Ramp::Brass, steps(14)};
    for (const int step : {-1, 1}) {
        canvas.at(x + step, y) = {Ramp::Brass, steps(10)};
        canvas.at(x, y + step) = {Ramp::Brass, steps(10)};
        canvas.at(x, y + 2 * step) = {Ramp::Brass, steps(7)};
    }
}

/// |x| + |y| from the centre of a 32x32 cell.
int diamond_distance(int x, int y) {
    return std::abs(x % 32 - 16) + std::abs(y % 32 - 16);
}

Texel carpet_texel(int x, int y) {
    const int weave = (x + y) % 2 * 120 + hash_255(x, y, 83) / 2;
    const int distance = diamond_distance(x, y);
    if (distance == 14) return {Ramp::Brass, steps(8) + weave};
    if (distance < 4) return {Ramp::Brass, steps(9 - distance) + weave};
    if (distance < 9) return {Ramp::Night, steps(5) + weave};
    return {Ramp::Red, steps(distance > 14 ? 8 : 10) + weave};
}

}  // namespace

Canvas paint_wood_planks() {
    Canvas canvas(64, 64);
    for (int x = 0; x < 64; x += 16) {
        const int seed = 80 + x / 16, joint = hash_255(x, 0, 80) % 64;
        paint_board(canvas, {x, 0, 16, 64}, steps(7) + hash_255(x, 1, 80) * 2, seed);
        canvas.lighten({x, joint, 16, 1}, -steps(4));
        canvas.lighten({x, joint + 1, 16, 1}, steps(1));
        for (const int nail : {joint - 3, joint + 4}) canvas.at(x + 8, nail) = {Ramp::Wood, steps(1)};
    }
    return canvas;
}

Canvas paint_wood_panel() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) { return wood(x, y, steps(7), 85); });
    paint_sunk_panel(canvas, {5, 5, 22, 54}, 86);
    paint_sunk_panel(canvas, {37, 5, 22, 54}, 87);
    return canvas;
}

Canvas paint_wood_door() {
    Canvas canvas(64, 128);
    for (int x = 0; x < 64; x += 16) paint_board(canvas, {x, 0, 16, 128}, steps(6), 88 + x / 16);
    for (const int y : {8, 60, 112}) {
        canvas.paint({0, y, 64, 9}, [](int x, int down) {
            return Texel{Ramp::Brass, steps(10) - down * steps(1) + hash_255(x, down, 89)};
        });
        canvas.lighten({0, y + 9, 64, 2}, -steps(3));
        for (int x = 6; x < 64; x += 10) canvas.disc(x, y + 4, 1, {Ramp::Brass, steps(14)});
    }
    canvas.disc(32, 90, 7, {Ramp::Brass, steps(10)});
    canvas.disc(32, 91, 4, {Ramp::Wood, steps(2)});
    return canvas;
}

Canvas paint_carpet() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), carpet_texel);
    return canvas;
}

Canvas paint_plaster_night() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) { return plaster(Ramp::Night, steps(7), x, y, 90); });
    paint_gold_star(canvas, 16, 16);
    paint_gold_star(canvas, 48, 48);
    return canvas;
}

Canvas paint_plaster(Ramp ramp) {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [&](int x, int y) { return plaster(ramp, steps(10), x, y, 91); });
    return canvas;
}

Canvas paint_coffer() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) { return wood(x, y, steps(7), 92); });
    for (int inset = 5; inset < 17; inset += 3) {
        const Box step{inset, inset, 64 - 2 * inset, 64 - 2 * inset};
        canvas.lighten(step, -steps(1) / 2);
        canvas.bevel(step, -steps(3));
    }
    canvas.outline({8, 8, 48, 48}, {Ramp::Brass, steps(7)});
    for (int y = 17; y < 47; ++y) {
        for (int x = 17; x < 47; ++x) canvas.at(x, y) = plaster(Ramp::Night, steps(3), x, y, 93);
    }
    for (const int radius : {9, 6, 2}) canvas.disc(32, 32, radius, {Ramp::Brass, steps(radius == 6 ? 4 : 15 - radius)});
    return canvas;
}

Canvas paint_grid_paper() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) {
        Texel paper = plaster(Ramp::Ivory, steps(11), x, y, 94);
        if (x % 32 == 0 || y % 32 == 0) return Texel{Ramp::Night, steps(8)};
        if (x % 8 == 0 || y % 8 == 0) return Texel{Ramp::Stone, paper.level - steps(1)};
        return paper;
    });
    return canvas;
}

Canvas paint_cube_face(Ramp ramp) {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [&](int x, int y) { return plaster(ramp, steps(10), x, y, 95); });
    canvas.outline({0, 0, 64, 64}, {Ramp::Ivory, steps(13)});
    canvas.outline({1, 1, 62, 62}, {Ramp::Ivory, steps(12)});
    canvas.outline({2, 2, 60, 60}, {ramp, steps(4)});
    for (const int at : {21, 42}) {
        canvas.fill({at, 3, 1, 58}, {ramp, steps(6)});
        canvas.fill({3, at, 58, 1}, {ramp, steps(6)});
    }
    return canvas;
}

Canvas paint_ruler() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) {
        const bool is_dark = (x / 8 + y / 32) % 2 == 0;
        const int grain = hash_255(x, y, 96) - 128;
        return is_dark ? Texel{Ramp::Night, steps(3) + grain} : Texel{Ramp::Ivory, steps(12) + grain};
    });
    canvas.fill({0, 31, 64, 1}, {Ramp::Red, steps(9)});
    canvas.fill({0, 63, 64, 1}, {Ramp::Red, steps(9)});
    return canvas;
}

Canvas paint_diamond() {
    Canvas canvas(64, 64);
    canvas.paint(canvas.whole(), [](int x, int y) {
        const int distance = diamond_distance(x, y);
        const int shade = distance == 15 || distance == 16 ? -steps(4) : (distance == 14 ? steps(1) : 0);
        Texel texel = plaster(distance < 16 ? Ramp::Terracotta : Ramp::Sand, steps(9), x, y, 97);
        texel.level += shade;
        return texel;
    });
    return canvas;
}

}  // namespace oblong::art
