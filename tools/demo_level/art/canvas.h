#pragma once

#include <cstdint>
#include <vector>

#include "tools/demo_level/art/ramps.h"

namespace oblong::art {

/// A step of a ramp in units of 1/256 step: steps(7) is the ramp's eighth colour.
constexpr int steps(int whole) {
    return whole * 256;
}

/// What a texel is before it becomes a palette index: a hue and a brightness (see steps()).
struct Texel {
    Ramp ramp = Ramp::Grey;
    int level = 0;
};

inline constexpr Texel kHole{Ramp::Hole, 0};

struct Box {
    int x = 0, y = 0, width = 0, height = 0;
};

/// A picture in the making. Coordinates wrap around, so that what crosses an edge comes in at the other: textures tile.
class Canvas {
  public:
    Canvas(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    Box whole() const { return {0, 0, width_, height_}; }
    Texel& at(int x, int y);
    const Texel& at(int x, int y) const;

    /// Sets each texel of `box` to what `paint(x, y)` returns, x and y counted from the corner of the box.
    template <class Paint>
    void paint(Box box, Paint paint_texel) {
        for (int y = 0; y < box.height; ++y) {
            for (int x = 0; x < box.width; ++x) at(box.x + x, box.y + y) = paint_texel(x, y);
        }
    }
    void fill(Box box, Texel texel);
    void lighten(Box box, int levels);
    /// A raised (or, with negative `levels`, sunken) edge one texel wide: light from the top left.
    void bevel(Box box, int levels);
    /// A frame one texel wide.
    void outline(Box box, Texel texel);
    void line(int x0, int y0, int x1, int y1, Texel texel);
    void disc(int centre_x, int centre_y, int radius, Texel texel);

    /// Palette indices. Brightness between two steps is dithered with a 4x4 pattern at half its strength.
    std::vector<std::uint8_t> to_indices() const;

  private:
    std::size_t index_of(int x, int y) const;

    int width_, height_;
    std::vector<Texel> texels_;
};

/// 0 to 255, the same for the same three numbers, and without a pattern to the eye.
int hash_255(int x, int y, int seed);

/// The size on which a noise repeats, so that a texture tiles without a seam, and which noise it is.
struct NoiseField {
    int width = 64, height = 64, seed = 0;
};

/// Smooth noise: random heights on a lattice of `cell` texels (a divisor of both sizes), -128 to 127.
int value_noise(const NoiseField& field, int x, int y, int cell);

/// Octaves from `cell` down to single texels, each half as strong: about -256 to 255.
int fractal_noise(const NoiseField& field, int x, int y, int cell);

}  // namespace oblong::art
