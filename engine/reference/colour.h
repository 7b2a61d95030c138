#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/reference/frame.h"

namespace oblong::reference {

/// 0 to 255 a channel.
struct Rgb {
    double red = 0, green = 0, blue = 0;
};

using Palette = std::array<Rgb, 256>;

/// The light of a lit face at a texel (not wrapped), 0 to 2 a channel: interpolated between four light samples, each
/// the sum of the face's styles as stored; 128 is 1, 256 or more is 2. Faces without a lightmap are dark, or 1 if the
/// level has no light at all.
Rgb light_at(const Level& level, const Face& face, double u, double v);

/// The texel's colour times the light of each channel, no channel above 255. Liquids, skies and the palette's last 32
/// colours are not lit.
Rgb true_colour(const Level& level, const Face& face, double u, double v, const Palette& palette);

struct ColourPixel {
    Rgb colour;
    bool is_excluded = false;  ///< a part is sky or liquid, which move, or no face
    bool is_border = false;    ///< shows several faces
};

/// Colours without colormap, mip levels or rounding: the mean of samples_per_axis^2 rays a pixel, evenly spread; 1:
/// only the centre. Rows top to bottom.
std::vector<ColourPixel> draw_colours(const Level& level, std::span<const PlacedModel> models, const View& view,
                                      const Palette& palette, int samples_per_axis = 1);

}  // namespace oblong::reference
