#include <algorithm>
#include <cstdlib>

#include "tools/demo_level/art/canvas.h"
#include "tools/demo_level/art/textures.h"

namespace oblong::art {
namespace {

constexpr int kSkyHalf = 128;

/// Night blue, with the milky way as a brighter slanting band.
Texel night(int x, int y) {
    const NoiseField field{kSkyHalf, kSkyHalf, 101};
    const int cloud = fractal_noise(field, x, y, 32);
    const int off_band = std::abs((x + y + cloud / 16) % kSkyHalf - kSkyHalf / 2);
    const int glow = std::max(0, 30 - off_band) * 14;
    return {cloud > 60 ? Ramp::Violet : Ramp::Night, steps(2) + glow + std::max(0, cloud) * 3 / 4};
}

/// About one texel in `rarity` is a star; a few are bright enough for a cross of light.
void paint_stars(Canvas& canvas) {
    for (int y = 0; y < kSkyHalf; ++y) {
        for (int x = 0; x < kSkyHalf; ++x) {
            const int chance = hash_255(x, y, 102), brightness = hash_255(y, x, 103);
            if (chance > 3) continue;
            canvas.at(kSkyHalf + x, y) = {Ramp::Ice, steps(2) + brightness * 3};
            if (brightness < 250 || x < 2 || x > kSkyHalf - 3) continue;
            canvas.fill({kSkyHalf + x - 1, y, 3, 1}, {Ramp::Ice, steps(4)});
            canvas.fill({kSkyHalf + x, y - 1, 1, 3}, {Ramp::Ice, steps(4)});
            canvas.at(kSkyHalf + x, y) = {Ramp::Ice, steps(7)};
        }
    }
}

/// Thin clouds: where the noise is low, index 0 lets the stars through.
Texel cloud(int x, int y) {
    const NoiseField field{kSkyHalf, kSkyHalf, 104};
    const int density = fractal_noise(field, x, y, 64) - 40 + hash_255(x, y, 105) / 6;
    if (density < 0) return {Ramp::Grey, 0};
    return {density > 70 ? Ramp::Stone : Ramp::Night, steps(2) + density * 9 / 2};
}

}  // namespace

Canvas paint_sky() {
    Canvas canvas(2 * kSkyHalf, kSkyHalf);
    canvas.paint({kSkyHalf, 0, kSkyHalf, kSkyHalf}, night);
    paint_stars(canvas);
    canvas.paint({0, 0, kSkyHalf, kSkyHalf}, cloud);
    return canvas;
}

Canvas paint_water() {
    Canvas canvas(64, 64);
    const NoiseField slow{64, 64, 106}, fast{64, 64, 107};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int swell = value_noise(slow, x, y, 16) + value_noise(fast, x, y, 8);
        const int caustic = std::max(0, 26 - std::abs(swell)) * 36;
        return Texel{caustic > 500 ? Ramp::Water : Ramp::Night, steps(7) + swell * 2 + caustic};
    });
    return canvas;
}

Canvas paint_lava() {
    Canvas canvas(64, 64);
    const NoiseField field{64, 64, 108};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int heat = fractal_noise(field, x, y, 16);
        if (heat > 110) return Texel{Ramp::Red, steps(5) - heat * 3};
        return Texel{Ramp::Flame, steps(3) - heat * 4};
    });
    return canvas;
}

Canvas paint_earth() {
    Canvas canvas(64, 64);
    const NoiseField field{64, 64, 109};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int blade = hash_255(x, y / 3 + x % 2, 110) * 2;
        const int patch = fractal_noise(field, x, y, 16);
        return Texel{patch > 150 ? Ramp::Wood : Ramp::Moss, steps(5) + blade + patch};
    });
    return canvas;
}

Canvas paint_hedge() {
    Canvas canvas(64, 64);
    const NoiseField field{64, 64, 111};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int leaf = (hash_255(x / 3 + y / 4, y / 3 - x / 5, 112) - 90) * 3;
        return Texel{Ramp::Moss, steps(5) + leaf + fractal_noise(field, x, y, 8) * 2};
    });
    return canvas;
}

}  // namespace oblong::art
