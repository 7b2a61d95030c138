#include "tools/demo_level/art/canvas.h"

#include <algorithm>
#include <cstdlib>

#include "engine/base/table.h"
#include "engine/view/screen.h"

namespace oblong::art {

namespace {

/// 0 to 15, each once in any 4x4 texels.
constexpr std::array<std::array<int, 4>, 4> kBayer{{{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};

std::uint8_t palette_index(const Texel& texel, int x, int y) {
    const RampPlace place = place_of(texel.ramp);
    const int threshold = at(at(kBayer, y & 3), x & 3);
    constexpr int kHalfStep = 128;
    const int dithered = texel.level + kHalfStep + (threshold * 2 - 15) * 4;
    const int step = std::clamp(std::max(dithered, 0) / 256, 0, place.count - 1);
    return static_cast<std::uint8_t>(place.first + step);
}

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

Canvas::Canvas(int width, int height) : width_(width), height_(height), texels_(pixel_count(width, height)) {}

std::size_t Canvas::index_of(int x, int y) const {
    const int wrapped_x = (x % width_ + width_) % width_, wrapped_y = (y % height_ + height_) % height_;
    return static_cast<std::size_t>(wrapped_y * width_ + wrapped_x);
}

Texel& Canvas::at(int x, int y) {
    return texels_[index_of(x, y)];
}

const Texel& Canvas::at(int x, int y) const {
    return texels_[index_of(x, y)];
}

void Canvas::fill(Box box, Texel texel) {
    paint(box, [&](int, int) { return texel; });
}

void Canvas::lighten(Box box, int levels) {
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) at(x, y).level += levels;
    }
}

void Canvas::bevel(Box box, int levels) {
    lighten({box.x, box.y, box.width, 1}, levels);
    lighten({box.x, box.y + 1, 1, box.height - 1}, levels);
    lighten({box.x + 1, box.y + box.height - 1, box.width - 1, 1}, -levels);
    lighten({box.x + box.width - 1, box.y + 1, 1, box.height - 2}, -levels);
}

void Canvas::outline(Box box, Texel texel) {
    fill({box.x, box.y, box.width, 1}, texel);
    fill({box.x, box.y + box.height - 1, box.width, 1}, texel);
    fill({box.x, box.y, 1, box.height}, texel);
    fill({box.x + box.width - 1, box.y, 1, box.height}, texel);
}

void Canvas::line(int x0, int y0, int x1, int y1, Texel texel) {
    const int count = std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1});
    for (int i = 0; i <= count; ++i) {
        const auto between = [&](int from, int to) { return from + ((to - from) * i * 2 + count) / (2 * count); };
        at(between(x0, x1), between(y0, y1)) = texel;
    }
}

void Canvas::disc(int centre_x, int centre_y, int radius, Texel texel) {
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            if (x * x + y * y <= radius * radius + radius / 2) at(centre_x + x, centre_y + y) = texel;
        }
    }
}

std::vector<std::uint8_t> Canvas::to_indices() const {
    std::vector<std::uint8_t> indices;
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) indices.push_back(palette_index(at(x, y), x, y));
    }
    return indices;
}

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
