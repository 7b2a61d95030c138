#include "engine/surface/colormap.h"

#include <algorithm>
#include <vector>

#include "engine/base/table.h"
#include "engine/surface/oklab.h"

namespace oblong {

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

Colormap make_colormap(const Palette& palette, int fullbright_count) {
    const auto ordinary = as_size(256 - std::clamp(fullbright_count, 0, 256));
    const std::vector<Candidate> sorted = sort_by_luminance(palette, ordinary);
    Colormap map;
    map.palette = palette;
    const NearestColour nearest(sorted);
    for (std::size_t position = 0; position < ordinary; ++position) shade_colour(sorted, nearest, position, map);
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
        item(fewer.shades, shade) = item(colormap.shades, shade / step * step);
        item(fewer.shades, kOwn + shade) = item(colormap.shades, kOwn + shade / step * (kOwn - 1) / most);
    }
    return fewer;
}

}  // namespace oblong
