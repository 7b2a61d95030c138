#include "engine/surface/colormap.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/base/table.h"
#include "engine/surface/oklab.h"

namespace oblong {

namespace {

/// How much more a difference of hue or colourfulness counts than one of lightness (their squares are compared).
constexpr std::int32_t kHueWeight = 8;

struct Candidate {
    Oklab seen;
    std::int32_t luminance;
    Rgb8 colour;
    std::uint8_t index;
};

/// The channels of a colour in some light, with 8 fraction bits.
FineRgb lit(Rgb8 colour, ShadeLight light) {
    const auto channel = [=](std::int32_t full) { return std::min(full * 256 * light.parts / light.whole, 255 * 256); };
    return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

/// The candidate colours, from dark to light.
std::vector<Candidate> sort_by_luminance(const Palette& palette, std::size_t count) {
    std::vector<Candidate> sorted;
    for (std::size_t i = 0; i < count; ++i) {
        const Rgb8 colour = palette.colours[i];
        sorted.push_back({oklab_of(lit(colour, {1, 1})), luminance_1000(colour), colour, static_cast<std::uint8_t>(i)});
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Candidate& a, const Candidate& b) { return a.luminance < b.luminance; });
    return sorted;
}

std::int32_t difference(const Oklab& a, const Oklab& b) {
    const std::int32_t lightness = a.lightness_14 - b.lightness_14, green_red = a.green_red_14 - b.green_red_14,
                       blue_yellow = a.blue_yellow_14 - b.blue_yellow_14;
    return lightness * lightness + kHueWeight * (green_red * green_red + blue_yellow * blue_yellow);
}

/// The position in `sorted`, from `first` to `last`, of the colour nearest to `target`.
std::size_t find_nearest(const std::vector<Candidate>& sorted, std::size_t first, std::size_t last,
                         const Oklab& target) {
    std::size_t nearest = first;
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    for (std::size_t i = first; i <= last; ++i) {
        const std::int32_t found = difference(sorted[i].seen, target);
        if (found < least) least = found, nearest = i;
    }
    return nearest;
}

/// From the colour itself outwards each shade may only take colours as dark as the shade before, or as bright, so that
/// luminance never rises with the shade.
void shade_colour(const std::vector<Candidate>& sorted, std::size_t position, Colormap& map) {
    const Candidate& own = sorted[position];
    at(map.shades, Colormap::kOwnShade)[own.index] = own.index;
    std::size_t last = position, first = position;
    for (int shade = Colormap::kOwnShade + 1; shade < Colormap::kShades; ++shade) {
        last = find_nearest(sorted, 0, last, oklab_of(lit(own.colour, light_of_shade(shade))));
        at(map.shades, shade)[own.index] = sorted[last].index;
    }
    for (int shade = Colormap::kOwnShade - 1; shade >= 0; --shade) {
        first = find_nearest(sorted, first, sorted.size() - 1, oklab_of(lit(own.colour, light_of_shade(shade))));
        at(map.shades, shade)[own.index] = sorted[first].index;
    }
}

}  // namespace

Colormap make_colormap(const Palette& palette, int fullbright_count) {
    const auto ordinary = static_cast<std::size_t>(256 - std::clamp(fullbright_count, 0, 256));
    const std::vector<Candidate> sorted = sort_by_luminance(palette, ordinary);
    Colormap map;
    map.palette = palette;
    for (std::size_t position = 0; position < ordinary; ++position) shade_colour(sorted, position, map);
    for (auto& shade : map.shades)
        for (std::size_t i = ordinary; i < 256; ++i) shade[i] = static_cast<std::uint8_t>(i);
    return map;
}

Colormap with_shades(const Colormap& colormap, std::int32_t count) {
    constexpr std::int32_t kOwn = Colormap::kOwnShade;
    const std::int32_t step = Colormap::kShades / count, most = count / 2 - 1;
    Colormap fewer;
    fewer.palette = colormap.palette;
    for (std::int32_t shade = 0; shade < kOwn; ++shade) {
        at(fewer.shades, shade) = at(colormap.shades, shade / step * step);
        at(fewer.shades, kOwn + shade) = at(colormap.shades, kOwn + shade / step * (kOwn - 1) / most);
    }
    return fewer;
}

}  // namespace oblong
