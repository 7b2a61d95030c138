#pragma once

#include <cstdint>

namespace oblong::art {

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
