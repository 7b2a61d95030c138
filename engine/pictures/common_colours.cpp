#include <algorithm>
#include <array>
#include <map>

#include "engine/pictures/picture.h"

namespace oblong {
namespace {

struct CountedColour {
    std::array<std::uint8_t, 3> channels;
    std::int64_t pixels;
};

/// Colours that share an entry of the palette.
struct ColourBox {
    std::span<CountedColour> colours;
    std::size_t longest = 0;     ///< the channel in which they differ most
    std::int64_t spread = 0;     ///< their square error, roughly; 0: all are the same
    std::int64_t pixels_in = 0;  ///< of all colours
};

ColourBox measured(std::span<CountedColour> colours) {
    ColourBox box{colours};
    for (const CountedColour& each : colours) box.pixels_in += each.pixels;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto [least, most] = std::minmax_element(
            colours.begin(), colours.end(),
            [=](const CountedColour& a, const CountedColour& b) { return a.channels[channel] < b.channels[channel]; });
        const std::int64_t range = most->channels[channel] - least->channels[channel],
                           spread = range * range * box.pixels_in;
        if (spread > box.spread) {
            box.spread = spread;
            box.longest = channel;
        }
    }
    return box;
}

/// The first colours of a box, sorted along its longest channel, with half of its pixels; neither all nor none.
std::size_t sorted_half(const ColourBox& box) {
    std::sort(box.colours.begin(), box.colours.end(), [&](const CountedColour& a, const CountedColour& b) {
        return std::pair(a.channels[box.longest], a.channels) < std::pair(b.channels[box.longest], b.channels);
    });
    std::size_t count = 0;
    for (std::int64_t pixels = 0; 2 * pixels < box.pixels_in; ++count) pixels += box.colours[count].pixels;
    return std::clamp<std::size_t>(count, 1, box.colours.size() - 1);
}

Rgb8 mean_of(const ColourBox& box) {
    std::array<std::int64_t, 3> sums{};
    for (const CountedColour& each : box.colours)
        for (std::size_t channel = 0; channel < 3; ++channel) sums[channel] += each.channels[channel] * each.pixels;
    const auto mean = [&](std::size_t channel) {
        return static_cast<std::uint8_t>((sums[channel] + box.pixels_in / 2) / box.pixels_in);
    };
    return {mean(0), mean(1), mean(2)};
}

std::vector<CountedColour> colours_in(std::span<const PngImage> images) {
    std::map<std::array<std::uint8_t, 3>, std::int64_t> counts;
    for (const PngImage& image : images)
        for (std::size_t at = 0;
             at < static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px); ++at) {
            const Rgba8 pixel = image.pixel(at);
            if (pixel.alpha >= 128) ++counts[{pixel.colour.red, pixel.colour.green, pixel.colour.blue}];
        }
    std::vector<CountedColour> colours;
    for (const auto& [channels, pixels] : counts) colours.push_back({channels, pixels});
    return colours;
}

}  // namespace

std::vector<Rgb8> common_colours(std::span<const PngImage> images, std::size_t most) {
    std::vector<CountedColour> colours = colours_in(images);
    if (colours.empty() || most == 0) return {};
    std::vector<ColourBox> boxes{measured(colours)};
    while (boxes.size() < most) {
        const auto widest = std::max_element(
            boxes.begin(), boxes.end(), [](const ColourBox& a, const ColourBox& b) { return a.spread < b.spread; });
        if (widest->spread == 0) break;
        const std::span<CountedColour> all = widest->colours;
        const std::size_t half = sorted_half(*widest);
        *widest = measured(all.first(half));
        boxes.push_back(measured(all.subspan(half)));
    }
    std::vector<Rgb8> means;
    for (const ColourBox& box : boxes) means.push_back(mean_of(box));
    std::sort(means.begin(), means.end(), [](Rgb8 a, Rgb8 b) { return luminance_1000(a) < luminance_1000(b); });
    return means;
}

}  // namespace oblong
