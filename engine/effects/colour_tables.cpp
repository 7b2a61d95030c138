#include "engine/effects/colour_tables.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "engine/base/table.h"

namespace oblong {

namespace {

/// A share of a mixture: 0 to 2^16.
using Share16 = std::int32_t;
constexpr Share16 kAll = 65536;

/// Squared difference, channels weighted as in luminance_1000.
constexpr std::int32_t kGreenWeight = 587;
std::int32_t difference(Rgb8 a, Rgb8 b) {
    const std::int32_t red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return 299 * red * red + kGreenWeight * green * green + 114 * blue * blue;
}

/// Finds the nearest of the first `count` colours of a palette to any colour; of equals, the first.
class NearestColours {
  public:
    NearestColours(const Palette& palette, int count) : palette_(palette) {
        for (int i = 0; i < count; ++i) by_green_.push_back({item(palette.colours, i), static_cast<std::uint8_t>(i)});
        std::stable_sort(by_green_.begin(), by_green_.end(),
                         [](const Entry& a, const Entry& b) { return a.colour.green < b.colour.green; });
    }

    /// Searches outward from the colour's green until green alone differs more than the nearest colour does. A near
    /// `guess`, one of the colours, shortens this.
    std::uint8_t find(Rgb8 colour, std::uint8_t guess) const {
        Best best{difference(item(palette_.colours, guess), colour), guess};
        const auto middle = std::partition_point(by_green_.begin(), by_green_.end(),
                                                 [&](const Entry& e) { return e.colour.green < colour.green; });
        for (auto entry = middle; entry != by_green_.end() && best.may_be_beaten_by(*entry, colour); ++entry)
            best.try_entry(*entry, colour);
        for (auto entry = middle; entry != by_green_.begin() && best.may_be_beaten_by(*(entry - 1), colour); --entry)
            best.try_entry(*(entry - 1), colour);
        return best.index;
    }

  private:
    struct Entry {
        Rgb8 colour;
        std::uint8_t index;
    };
    struct Best {
        std::int32_t least;
        std::uint8_t index;

        bool may_be_beaten_by(const Entry& entry, Rgb8 colour) const {
            const std::int32_t green = entry.colour.green - colour.green;
            return kGreenWeight * green * green <= least;
        }
        void try_entry(const Entry& entry, Rgb8 colour) {
            const std::int32_t far = difference(entry.colour, colour);
            if (far > least || (far == least && entry.index > index)) return;
            least = far;
            index = entry.index;
        }
    };

    const Palette& palette_;
    std::vector<Entry> by_green_;
};

Rgb8 mixture(Rgb8 front, Rgb8 behind, Share16 share) {
    const auto channel = [=](std::int32_t a, std::int32_t b) {
        return static_cast<std::uint8_t>((a * share + b * (kAll - share) + kAll / 2) >> 16);
    };
    return {channel(front.red, behind.red), channel(front.green, behind.green), channel(front.blue, behind.blue)};
}

/// Mixtures of a palette's colours.
class Mixer {
  public:
    explicit Mixer(const Palette& palette) : ordinary_(palette, kFirstFullbright), all_(palette, 256) {}

    /// The result and `guess` may be fullbright only if one of the two colours is.
    std::uint8_t find(Rgb8 front, Rgb8 behind, Share16 share, bool is_fullbright, std::uint8_t guess) const {
        return (is_fullbright ? all_ : ordinary_).find(mixture(front, behind, share), guess);
    }

  private:
    NearestColours ordinary_, all_;
};

bool is_fullbright(int colour) {
    return colour >= kFirstFullbright;
}

ColourRow every_colour() {
    ColourRow row;
    std::iota(row.begin(), row.end(), std::uint8_t{0});
    return row;
}

Share16 fog_share(std::int32_t share_256, int level) {
    return std::clamp(share_256, 0, 256) * 256 * level / (FogTable::kLevels - 1);
}

/// The colours seen through this share of fog; `near` are those through slightly less.
ColourRow fog_level(const Palette& palette, const Mixer& mixer, Rgb8 fog, Share16 share, const ColourRow& near) {
    ColourRow row;
    for (int colour = 0; colour < 256; ++colour)
        item(row, colour) =
            mixer.find(fog, item(palette.colours, colour), share, is_fullbright(colour), item(near, colour));
    return row;
}

}  // namespace

BlendTable make_blend_table(const Palette& palette, std::int32_t share_256) {
    const Share16 share = std::clamp(share_256, 0, 256) * 256;
    const Mixer mixer(palette);
    const auto blend = [&](int front, int behind, std::uint8_t guess) {
        if (front == behind || share == kAll) return static_cast<std::uint8_t>(front);
        if (share == 0) return static_cast<std::uint8_t>(behind);
        return mixer.find(item(palette.colours, front), item(palette.colours, behind), share,
                          is_fullbright(front) || is_fullbright(behind), guess);
    };
    BlendTable table;
    for (int front = 0; front < 256; ++front) {
        auto blended = static_cast<std::uint8_t>(front);
        for (int behind = 0; behind < 256; ++behind)
            item(item(table.rows, front), behind) = blended = blend(front, behind, blended);
    }
    return table;
}

FogTable make_fog_table(const Palette& palette, Rgb8 fog, std::int32_t share_256) {
    const Mixer mixer(palette);
    FogTable table;
    table.levels[0] = every_colour();
    for (int level = 1; level < FogTable::kLevels; ++level)
        item(table.levels, level) =
            fog_level(palette, mixer, fog, fog_share(share_256, level), item(table.levels, level - 1));
    return table;
}

ColourRow make_fog_level(const Palette& palette, Rgb8 fog, std::int32_t share_256, int level) {
    if (level == 0) return every_colour();
    return fog_level(palette, Mixer(palette), fog, fog_share(share_256, level), every_colour());
}

}  // namespace oblong
