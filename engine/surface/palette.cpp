#include "engine/surface/palette.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "engine/base/input_error.h"
#include "engine/base/table.h"

namespace oblong {

namespace {

constexpr std::int32_t kWeightSum = 299 + 587 + 114;

/// Squared difference, each channel weighted as in luminance_1000. By Cauchy and Schwarz it is at least the square of
/// the difference of luminances / kWeightSum: colours too far in luminance need not be tried.
std::int32_t weighted_difference(Rgb8 a, Rgb8 b) {
    const std::int32_t red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return 299 * red * red + 587 * green * green + 114 * blue * blue;
}

struct Candidate {
    std::int32_t luminance;
    Rgb8 colour;
    std::uint8_t index;
};

/// The candidate colours, from dark to light.
std::vector<Candidate> sort_by_luminance(const Palette& palette, std::size_t count) {
    std::vector<Candidate> sorted;
    for (std::size_t i = 0; i < count; ++i)
        sorted.push_back({luminance_1000(palette.colours[i]), palette.colours[i], static_cast<std::uint8_t>(i)});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Candidate& a, const Candidate& b) { return a.luminance < b.luminance; });
    return sorted;
}

bool is_too_far(std::int32_t luminance_difference, std::int32_t best) {
    return std::int64_t{luminance_difference} * luminance_difference > std::int64_t{best} * kWeightSum;
}

/// The position in `sorted` of the colour nearest to `target` among those up to position `last`: outward from the
/// target's own luminance, until the luminance alone is farther than the best found.
std::size_t find_nearest(const std::vector<Candidate>& sorted, std::size_t last, Rgb8 target) {
    const std::int32_t luminance = luminance_1000(target);
    std::size_t nearest = last;
    std::int32_t best = std::numeric_limits<std::int32_t>::max();
    const auto try_colour = [&](std::size_t position) {
        const std::int32_t difference = weighted_difference(sorted[position].colour, target);
        if (difference < best) best = difference, nearest = position;
    };

    const auto split = std::partition_point(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                            [=](const Candidate& c) { return c.luminance < luminance; });
    const auto start = static_cast<std::size_t>(split - sorted.begin());
    for (std::size_t i = start; i <= last && !is_too_far(sorted[i].luminance - luminance, best); ++i) try_colour(i);
    for (std::size_t i = start; i-- > 0 && !is_too_far(sorted[i].luminance - luminance, best);) try_colour(i);
    return nearest;
}

Rgb8 darken(Rgb8 colour, int shade) {
    constexpr int kDarkest = Colormap::kShades - 1;
    const auto channel = [=](std::uint8_t full) {
        return static_cast<std::uint8_t>((full * (kDarkest - shade) + kDarkest / 2) / kDarkest);
    };
    return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

/// Each shade may only take colours as dark as the shade before, so that luminance never rises.
void shade_colour(const std::vector<Candidate>& sorted, std::size_t position, Colormap& map) {
    const Candidate& full = sorted[position];
    map.shades[0][full.index] = full.index;
    std::size_t last = position;
    for (int shade = 1; shade < Colormap::kShades; ++shade) {
        last = find_nearest(sorted, last, darken(full.colour, shade));
        at(map.shades, shade)[full.index] = sorted[last].index;
    }
}

}  // namespace

Palette read_palette(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kSize = 256 * 3;
    if (bytes.size() != kSize)
        throw InputError("palette", std::to_string(bytes.size()) + " bytes, expected 256 colours of 3 bytes");
    Palette palette;
    for (std::size_t i = 0; i < 256; ++i) palette.colours[i] = {bytes[i * 3], bytes[i * 3 + 1], bytes[i * 3 + 2]};
    return palette;
}

Palette as_shown_by_dac6(const Palette& palette) {
    const auto through_dac = [](std::uint8_t channel) { return widen_dac6(narrow_dac6(channel)); };
    Palette shown;
    for (std::size_t i = 0; i < 256; ++i) {
        const Rgb8 colour = palette.colours[i];
        shown.colours[i] = {through_dac(colour.red), through_dac(colour.green), through_dac(colour.blue)};
    }
    return shown;
}

Colormap make_colormap(const Palette& palette, int fullbright_count) {
    const auto ordinary = static_cast<std::size_t>(256 - std::clamp(fullbright_count, 0, 256));
    const std::vector<Candidate> sorted = sort_by_luminance(palette, ordinary);
    Colormap map;
    for (std::size_t position = 0; position < ordinary; ++position) shade_colour(sorted, position, map);
    for (auto& shade : map.shades)
        for (std::size_t i = ordinary; i < 256; ++i) shade[i] = static_cast<std::uint8_t>(i);
    return map;
}

Colormap with_shades(const Colormap& colormap, std::int32_t count) {
    Colormap fewer;
    for (std::int32_t shade = 0; shade < Colormap::kShades; ++shade) {
        const std::int32_t level = shade * count / Colormap::kShades;
        at(fewer.shades, shade) = at(colormap.shades, level * (Colormap::kShades - 1) / (count - 1));
    }
    return fewer;
}

}  // namespace oblong
