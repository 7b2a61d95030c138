#include "engine/surface/colormap.h"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/base/table.h"
#include "engine/fixed/divide.h"
#include "engine/fixed/power.h"

namespace oblong {
namespace {

/// A row of one of Ottosson's matrices, in millionths.
struct Row {
    std::int32_t first, second, third;
    constexpr std::int64_t times(std::int32_t x, std::int32_t y, std::int32_t z) const {
        return std::int64_t{first} * x + std::int64_t{second} * y + std::int64_t{third} * z;
    }
};
constexpr std::int32_t kMillion = 1'000'000;
constexpr Row kLongCone{412'221, 536'333, 51'446}, kMiddleCone{211'903, 680'700, 107'397},
    kShortCone{88'302, 281'719, 629'979};
constexpr Row kLightness{210'454, 793'618, -4'072}, kGreenRed{1'977'998, -2'428'592, 450'594},
    kBlueYellow{25'904, 782'772, -808'676};

/// Linear light of an sRGB channel's 256 values (IEC 61966-2-1), 30 fraction bits; the last value is repeated.
constexpr auto kLinear_30 = [] {
    std::array<std::int32_t, 257> table{};
    for (std::int64_t channel = 0; channel < 256; ++channel) {
        const std::int64_t base_30 = ((channel * 1000 + 255 * 55) << 30) / (255 * 1055);
        const bool is_in_linear_part = channel * 100'000 <= 255 * 4045;
        item(table, channel) = static_cast<std::int32_t>(
            is_in_linear_part ? (channel << 30) * 100 / (255 * 1292)
                              : std::int64_t{power_30(static_cast<std::uint32_t>(base_30), 12, 5)});
    }
    table[256] = table[255];
    return table;
}();

std::int32_t linear_30(std::int32_t channel_8) {
    const std::int32_t below = item(kLinear_30, channel_8 >> 8), above = item(kLinear_30, (channel_8 >> 8) + 1);
    return below + static_cast<std::int32_t>(std::int64_t{above - below} * (channel_8 & 0xff) >> 8);
}

std::int32_t cone_response_30(const Row& cone, std::int32_t red_30, std::int32_t green_30, std::int32_t blue_30) {
    const auto light = static_cast<std::uint64_t>(cone.times(red_30, green_30, blue_30));
    return static_cast<std::int32_t>(power_30(native::divide_to_32(light, kMillion).quotient, 1, 3));
}

}  // namespace

Oklab oklab_of(const FineRgb& colour) {
    const std::int32_t red = linear_30(colour.red_8), green = linear_30(colour.green_8),
                       blue = linear_30(colour.blue_8);
    const std::int32_t long_30 = cone_response_30(kLongCone, red, green, blue),
                       middle_30 = cone_response_30(kMiddleCone, red, green, blue),
                       short_30 = cone_response_30(kShortCone, red, green, blue);
    const auto component_14 = [&](const Row& row) {
        return static_cast<std::int32_t>(row.times(long_30, middle_30, short_30) / (1 << 16) / kMillion);
    };
    return {component_14(kLightness), component_14(kGreenRed), component_14(kBlueYellow)};
}

namespace {

/// The weight of a squared difference of hue or chroma, relative to one of lightness.
constexpr std::int32_t kHueWeight = 8;

struct Candidate {
    Oklab seen;
    Rgb8 colour;
    std::uint8_t index;
};

/// The channels of a colour in a light, with 8 fraction bits.
FineRgb lit(Rgb8 colour, ShadeLight light) {
    const auto channel = [=](std::int32_t full) { return std::min(full * 256 * light.parts / light.whole, 255 * 256); };
    return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

/// The candidate colours, from dark to light.
std::vector<Candidate> sort_by_luminance(const Palette& palette, std::size_t count) {
    std::vector<Candidate> sorted;
    for (std::size_t i = 0; i < count; ++i) {
        const Rgb8 colour = palette.colours[i];
        sorted.push_back({oklab_of(lit(colour, {1, 1})), colour, static_cast<std::uint8_t>(i)});
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const Candidate& a, const Candidate& b) {
        return luminance_1000(a.colour) < luminance_1000(b.colour);
    });
    return sorted;
}

std::int32_t difference(const Oklab& a, const Oklab& b) {
    const std::int32_t lightness = a.lightness_14 - b.lightness_14, green_red = a.green_red_14 - b.green_red_14,
                       blue_yellow = a.blue_yellow_14 - b.blue_yellow_14;
    return lightness * lightness + kHueWeight * (green_red * green_red + blue_yellow * blue_yellow);
}

/// Finds the nearest of the candidates to any colour.
class NearestColour {
  public:
    explicit NearestColour(const std::vector<Candidate>& sorted) : sorted_(sorted) {
        for (const Candidate& candidate : sorted) by_lightness_.push_back({candidate.seen, by_lightness_.size()});
        std::stable_sort(by_lightness_.begin(), by_lightness_.end(),
                         [](const Entry& a, const Entry& b) { return a.seen.lightness_14 < b.seen.lightness_14; });
    }

    /// The position of the nearest one from `first` to `last`; of equals, the first. Searches outward from the target's
    /// lightness until the lightness alone differs more than the nearest colour does; a near `guess` shortens this.
    std::size_t find(std::size_t first, std::size_t last, const Oklab& target, std::size_t guess) const {
        Best best{first, last, target, guess, difference(sorted_[guess].seen, target)};
        const auto middle = std::partition_point(by_lightness_.begin(), by_lightness_.end(), [&](const Entry& e) {
            return e.seen.lightness_14 < target.lightness_14;
        });
        for (auto entry = middle; entry != by_lightness_.end() && best.may_be_beaten_by(*entry); ++entry)
            best.try_entry(*entry);
        for (auto entry = middle; entry != by_lightness_.begin() && best.may_be_beaten_by(*(entry - 1)); --entry)
            best.try_entry(*(entry - 1));
        return best.position;
    }

  private:
    struct Entry {
        Oklab seen;
        std::size_t position;
    };
    struct Best {
        std::size_t first, last;
        const Oklab& target;
        std::size_t position;
        std::int32_t least;

        bool may_be_beaten_by(const Entry& entry) const {
            const std::int32_t lightness = entry.seen.lightness_14 - target.lightness_14;
            return lightness * lightness <= least;
        }
        void try_entry(const Entry& entry) {
            if (entry.position < first || entry.position > last) return;
            const std::int32_t found = difference(entry.seen, target);
            if (found > least || (found == least && entry.position > position)) return;
            least = found;
            position = entry.position;
        }
    };

    const std::vector<Candidate>& sorted_;
    std::vector<Entry> by_lightness_;
};

/// From the colour itself outward, each darker shade takes only colours at most as bright as the previous one, and each
/// brighter shade only colours at least as bright, so that luminance never rises with the shade.
void shade_colour(const std::vector<Candidate>& sorted, const NearestColour& nearest, std::size_t position,
                  Colormap& map) {
    const Candidate& own = sorted[position];
    item(map.shades, Colormap::kOwnShade)[own.index] = own.index;
    std::size_t last = position, first = position;
    for (int shade = Colormap::kOwnShade + 1; shade < Colormap::kShades; ++shade) {
        last = nearest.find(0, last, oklab_of(lit(own.colour, light_of_shade(shade))), last);
        item(map.shades, shade)[own.index] = sorted[last].index;
    }
    for (int shade = Colormap::kOwnShade - 1; shade >= 0; --shade) {
        first = nearest.find(first, sorted.size() - 1, oklab_of(lit(own.colour, light_of_shade(shade))), first);
        item(map.shades, shade)[own.index] = sorted[first].index;
    }
}

}  // namespace

Colormap make_colormap(const Palette& palette, std::size_t first_fullbright) {
    const std::vector<Candidate> sorted = sort_by_luminance(palette, first_fullbright);
    Colormap map;
    map.palette = palette;
    const NearestColour nearest(sorted);
    for (std::size_t position = 0; position < first_fullbright; ++position)
        shade_colour(sorted, nearest, position, map);
    for (auto& shade : map.shades)
        for (std::size_t i = first_fullbright; i < 256; ++i) shade[i] = static_cast<std::uint8_t>(i);
    return map;
}

ColourCube make_colour_cube(const Palette& palette, std::int32_t levels) {
    const std::vector<Candidate> sorted = sort_by_luminance(palette, kFirstFullbright);
    const NearestColour nearest(sorted);
    const auto channel_8 = [levels](std::int32_t level) { return level * (255 * 256) / (levels - 1); };
    const auto level_8 = [levels](std::int32_t channel) { return (channel * (levels - 1) * 512 + 255) / 510; };
    ColourCube cube{levels, {}, {}, {}};
    cube.nearest.reserve(as_size(levels * levels * levels));
    std::size_t found = 0;
    for (std::int32_t red = 0; red < levels; ++red)
        for (std::int32_t green = 0; green < levels; ++green)
            for (std::int32_t blue = 0; blue < levels; ++blue) {
                const Oklab target = oklab_of({channel_8(red), channel_8(green), channel_8(blue)});
                found = nearest.find(0, sorted.size() - 1, target, found);
                cube.nearest.push_back(sorted[found].index);
            }
    for (std::int32_t level = 0; level < 128; ++level) {
        const std::int32_t shown = std::min(level, levels - 1);
        item(cube.parts[0], level) = shown * levels * levels;
        item(cube.parts[1], level) = shown * levels;
        item(cube.parts[2], level) = shown;
    }
    for (std::size_t i = 0; i < 256; ++i) {
        const Rgb8 colour = palette.colours[i];
        cube.levels_8[i] = {level_8(colour.red), level_8(colour.green), level_8(colour.blue)};
    }
    return cube;
}

Colormap with_shades(const Colormap& colormap, std::int32_t count) {
    constexpr std::int32_t kOwn = Colormap::kOwnShade;
    const std::int32_t step = Colormap::kShades / count, most = count / 2 - 1;
    Colormap fewer;
    fewer.palette = colormap.palette;
    for (std::int32_t shade = 0; shade < kOwn; ++shade) {
        item(fewer.shades, shade) = item(colormap.shades, shade / step * step);
        item(fewer.shades, kOwn + shade) = item(colormap.shades, kOwn + shade / step * (kOwn - 1) / most);
    }
    return fewer;
}

}  // namespace oblong
