#include "tools/demo_level/art/noise.h"

namespace oblong::art {
namespace {

int wrapped(int value, int period) {
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

/// 3 t^2 - 2 t^3 for t in cells of 256.
int ease_256(int t) {
    return t * t * (768 - 2 * t) / 65536;
}

int blend(int from, int to, int weight_256) {
    return from + (to - from) * weight_256 / 256;
}

}  // namespace

int hash_255(int x, int y, int seed) {
    auto bits = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u ^
                static_cast<std::uint32_t>(seed) * 0xc2b2ae3du;
    bits = (bits ^ bits >> 15) * 0x2c1b3c6du;
    bits = (bits ^ bits >> 12) * 0x297a2d39u;
    return static_cast<int>((bits ^ bits >> 15) & 255u);
}

int value_noise(const NoiseField& field, int x, int y, int cell) {
    const int columns = field.width / cell, rows = field.height / cell;
    const int texel_x = wrapped(x, field.width), texel_y = wrapped(y, field.height);
    const int column = texel_x / cell, row = texel_y / cell;
    const int weight_x = ease_256(texel_x % cell * 256 / cell), weight_y = ease_256(texel_y % cell * 256 / cell);
    const auto height = [&](int dx, int dy) {
        return hash_255((column + dx) % columns, (row + dy) % rows, field.seed * 31 + cell) - 128;
    };
    const int above = blend(height(0, 0), height(1, 0), weight_x);
    const int below = blend(height(0, 1), height(1, 1), weight_x);
    return blend(above, below, weight_y);
}

int fractal_noise(const NoiseField& field, int x, int y, int cell) {
    int sum = 0;
    for (int divisor = 1; cell >= divisor; divisor *= 2) {
        sum += value_noise(field, x, y, cell / divisor) / divisor;
    }
    return sum;
}

}  // namespace oblong::art
