#include <cmath>
#include <cstdlib>

#include "engine/base/table.h"
#include "tools/demo_level/art/canvas.h"
#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

/// Brushed metal: long thin scratches, and a broad reflection that falls across the plate.
Texel brushed(Ramp ramp, int x, int y, int height, int seed) {
    const NoiseField field{64, 64, seed};
    const int scratches = (hash_255(x / 7, y, seed) - 128) + value_noise(field, x, y, 16);
    const int reflection = std::abs((y * 2 + x) % (height * 2) - height) * steps(4) / height;
    return {ramp, steps(7) + reflection + scratches};
}

void paint_rivet(Canvas& canvas, int x, int y) {
    canvas.lighten({x - 1, y - 1, 4, 4}, -steps(3));
    canvas.fill({x, y, 2, 2}, {Ramp::Brass, steps(11)});
    canvas.at(x, y).level = steps(15);
    canvas.at(x + 1, y + 1).level = steps(7);
}

void paint_plate(Canvas& canvas, Box box, int seed) {
    canvas.paint(box, [&](int x, int y) { return brushed(Ramp::Brass, x + seed, y, box.height, seed); });
    canvas.bevel(box, steps(3));
    canvas.outline({box.x + box.width - 1, box.y, 1, box.height}, {Ramp::Brass, steps(1)});
    canvas.outline({box.x, box.y + box.height - 1, box.width, 1}, {Ramp::Brass, steps(1)});
    for (const int x : {box.x + 4, box.x + box.width - 7}) {
        for (const int y : {box.y + 4, box.y + box.height - 7}) paint_rivet(canvas, x, y);
    }
}

/// Verdigris gathers along the lower edges.
void paint_tarnish(Canvas& canvas, int seed) {
    const NoiseField field{canvas.width(), canvas.height(), seed};
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) {
            const int amount = fractal_noise(field, x, y, 16) + y % 32 * 4 - 190;
            if (amount + hash_255(x, y, seed) / 4 < 0) continue;
            Texel& texel = canvas.at(x, y);
            texel = {Ramp::Verdigris, texel.level - steps(1)};
        }
    }
}

/// Brightness of a moulding's rows, top to bottom: two round bars and a groove.
constexpr std::array<int, 16> kMoulding{3, 8, 13, 15, 12, 8, 5, 2, 4, 9, 12, 9, 6, 4, 2, 1};

}  // namespace

Canvas paint_brass_panel() {
    Canvas canvas(64, 64);
    for (const Box plate : {Box{0, 0, 32, 32}, Box{32, 0, 32, 32}, Box{0, 32, 64, 32}}) {
        paint_plate(canvas, plate, 70 + plate.x + plate.y);
    }
    paint_tarnish(canvas, 77);
    return canvas;
}

Canvas paint_brass_trim() {
    Canvas canvas(64, 16);
    canvas.paint(canvas.whole(), [](int x, int y) {
        const int bead = y > 8 && y < 13 && x % 8 == 7 ? -steps(4) : 0;
        const int level = steps(at(kMoulding, y)) + (hash_255(x / 3, y, 71) - 128) / 2;
        return Texel{Ramp::Brass, level + bead - steps(1)};
    });
    return canvas;
}

Canvas paint_brass_dial() {
    Canvas canvas(64, 64);
    paint_plate(canvas, canvas.whole(), 72);
    canvas.disc(32, 32, 25, {Ramp::Brass, steps(3)});
    canvas.disc(31, 31, 24, {Ramp::Brass, steps(12)});
    canvas.disc(32, 32, 22, {Ramp::Ivory, steps(11)});
    for (int hour = 0; hour < 12; ++hour) {
        const double angle = hour * 3.14159265358979 / 6;
        const auto x = static_cast<int>(std::lround(32 + 19 * std::cos(angle)));
        const auto y = static_cast<int>(std::lround(32 + 19 * std::sin(angle)));
        canvas.fill({x - (hour % 3 == 0), y - (hour % 3 == 0), 2, 2}, {Ramp::Night, steps(3)});
    }
    canvas.line(32, 32, 32, 17, {Ramp::Night, steps(2)});
    canvas.line(32, 32, 43, 38, {Ramp::Red, steps(8)});
    canvas.disc(32, 32, 2, {Ramp::Brass, steps(13)});
    return canvas;
}

Canvas paint_iron_grate() {
    Canvas canvas(64, 64);
    canvas.fill(canvas.whole(), {Ramp::Night, steps(1)});
    for (int at = 0; at < 64; at += 16) {
        canvas.paint({at, 0, 5, 64}, [](int x, int y) {
            return Texel{Ramp::Stone, steps(8 - x) + hash_255(x, y, 73)};
        });
    }
    for (int at = 0; at < 64; at += 16) {
        canvas.paint({0, at, 64, 5}, [](int x, int y) {
            return Texel{Ramp::Stone, steps(9 - y) + hash_255(x, y, 74)};
        });
        for (int x = 0; x < 64; x += 16) paint_rivet(canvas, x + 1, at + 1);
    }
    return canvas;
}

Canvas paint_copper_roof() {
    Canvas canvas(64, 64);
    const NoiseField field{64, 64, 75};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int row = y / 16, across = (x + row % 2 * 8) % 16 - 8, down = y % 16;
        const bool is_below_scale = across * across > (16 - down) * (16 - down) + 8;
        const int curve =
            steps(10) - down * steps(1) / 4 - (is_below_scale ? steps(4) : 0) + (down == 0 ? steps(2) : 0);
        const int grain = fractal_noise(field, x, y, 16);
        return Texel{grain > 120 ? Ramp::Brass : Ramp::Verdigris, curve + grain};
    });
    return canvas;
}

namespace {

Canvas paint_caged_lamp(Ramp glow, int brightest) {
    Canvas canvas(32, 32);
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int dx = 2 * x - 31, dy = 2 * y - 31;
        const int distance = static_cast<int>(std::sqrt(dx * dx + dy * dy));
        return Texel{glow, steps(brightest) - distance * steps(brightest) / 52};
    });
    canvas.outline({0, 0, 32, 32}, {Ramp::Brass, steps(5)});
    canvas.outline({1, 1, 30, 30}, {Ramp::Brass, steps(13)});
    canvas.outline({2, 2, 28, 28}, {Ramp::Brass, steps(8)});
    for (const int at : {10, 20}) {
        canvas.paint({at, 3, 2, 26}, [](int x, int) { return Texel{Ramp::Brass, steps(10 - 5 * x)}; });
        canvas.paint({3, at, 26, 2}, [](int, int y) { return Texel{Ramp::Brass, steps(11 - 5 * y)}; });
    }
    return canvas;
}

}  // namespace

Canvas paint_lamp() {
    return paint_caged_lamp(Ramp::Flame, 7);
}

Canvas paint_lamp_blue() {
    return paint_caged_lamp(Ramp::Ice, 7);
}

Canvas paint_lit_window() {
    Canvas canvas(32, 64);
    canvas.paint(canvas.whole(), [](int x, int y) {
        const int flicker = hash_255(x / 3, y / 3, 76) * 2;
        return Texel{Ramp::Flame, steps(5) - std::abs(x - 16) * 40 - std::abs(y - 44) * 20 + flicker / 2};
    });
    for (const int x : {0, 15, 30}) canvas.fill({x, 0, 2, 64}, {Ramp::Stone, steps(3)});
    for (const int y : {0, 20, 41, 62}) canvas.fill({0, y, 32, 2}, {Ramp::Stone, steps(3)});
    return canvas;
}

Canvas paint_grate() {
    Canvas canvas(64, 64);
    canvas.fill(canvas.whole(), kHole);
    for (int at = 4; at < 64; at += 16) {
        canvas.paint({0, at, 64, 4}, [](int x, int y) {
            return Texel{Ramp::Stone, steps(9 - 2 * y) + hash_255(x, y, 78)};
        });
    }
    for (int at = 6; at < 64; at += 16) {
        canvas.paint({at, 0, 5, 64}, [](int x, int y) {
            return Texel{Ramp::Stone, steps(11 - 2 * x) + hash_255(x, y, 79)};
        });
        for (int y = 5; y < 64; y += 16) paint_rivet(canvas, at + 1, y);
    }
    return canvas;
}

}  // namespace oblong::art
