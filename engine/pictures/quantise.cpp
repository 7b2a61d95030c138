#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/pictures/picture.h"
#include "engine/view/screen.h"

namespace oblong {
namespace {

/// Red, green and blue, sixteenths.
using Channels16 = std::array<int, 3>;

constexpr Channels16 in_16(Rgb8 colour) {
    return {colour.red * 16, colour.green * 16, colour.blue * 16};
}

/// The errors that pixels pass on, within their row and to the row below. Pixel x is at x + 1, so that errors beyond
/// both sides have a place.
struct PassedErrors {
    explicit PassedErrors(int width_px) : here(as_size(width_px) + 2), below(here.size()) {}

    /// Passes 7/16 to the next pixel, and below 3/16, 5/16 and 1/16; the last one gets the rounding rest, so that none
    /// is lost.
    void pass(int x, int step, const Channels16& errors) {
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const int next = errors[i] * 7 / 16, behind = errors[i] * 3 / 16, under = errors[i] * 5 / 16;
            item(here, x + 1 + step)[i] += next;
            item(below, x + 1 - step)[i] += behind;
            item(below, x + 1)[i] += under;
            item(below, x + 1 + step)[i] += errors[i] - next - behind - under;
        }
    }
    void end_row() {
        here.swap(below);
        std::fill(below.begin(), below.end(), Channels16{});
    }

    std::vector<Channels16> here, below;
};

/// The colour with the errors that reached it, clamped: if the palette has no such colour, errors would add up without
/// bound.
Channels16 wanted_colour(Rgb8 colour, const Channels16& passed) {
    Channels16 wanted = in_16(colour);
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = std::clamp(wanted[i] + passed[i], 0, 255 * 16);
    return wanted;
}

Rgb8 rounded(const Channels16& colour) {
    const auto channel = [](int value_16) { return static_cast<std::uint8_t>((value_16 + 8) / 16); };
    return {channel(colour[0]), channel(colour[1]), channel(colour[2])};
}

/// nearest_colour() for the pixels of a picture, which has each colour many times: remembers one colour for each hash.
class NearestColours {
  public:
    NearestColours(const Palette& palette, ColourRange range) : palette_(palette), range_(range) {}

    std::uint8_t of(Rgb8 colour) {
        const std::uint32_t rgb = std::uint32_t{colour.red} << 16 | std::uint32_t{colour.green} << 8 | colour.blue;
        Known& known = known_[rgb * 0x9e3779b1 >> (32 - kHashBits)];
        if (known.rgb != rgb) known = {rgb, nearest_colour(palette_, colour, range_)};
        return known.index;
    }

  private:
    static constexpr int kHashBits = 12;
    struct Known {
        std::uint32_t rgb = 0xffff'ffff;  // none
        std::uint8_t index = 0;
    };

    const Palette& palette_;
    const ColourRange range_;
    std::vector<Known> known_ = std::vector<Known>(std::size_t{1} << kHashBits);
};

// Rows alternate in direction: otherwise the patterns would slant.
std::vector<std::uint8_t> dithered(const PngImage& image, const Palette& palette, ColourRange range) {
    std::vector<std::uint8_t> indices(pixel_count(image.width_px, image.height_px));
    PassedErrors passed(image.width_px);
    NearestColours nearest(palette, range);
    for (int y = 0; y < image.height_px; ++y) {
        const int step = y % 2 == 0 ? 1 : -1;
        for (int i = 0; i < image.width_px; ++i) {
            const int x = step > 0 ? i : image.width_px - 1 - i;
            const auto place = pixel_count(image.width_px, y) + as_size(x);
            const Channels16 wanted = wanted_colour(image.pixel(place).colour, item(passed.here, x + 1));
            indices[place] = nearest.of(rounded(wanted));
            const Channels16 taken = in_16(palette.colours[indices[place]]);
            passed.pass(x, step, {wanted[0] - taken[0], wanted[1] - taken[1], wanted[2] - taken[2]});
        }
        passed.end_row();
    }
    return indices;
}

}  // namespace

bool has_palette(const PngImage& image, const Palette& palette) {
    return !image.indices.empty() &&
           std::equal(image.colours.begin(), image.colours.end(), palette.colours.begin(),
                      [](const Rgba8& ours, const Rgb8& theirs) { return ours.colour == theirs; });
}

std::vector<std::uint8_t> indices_of(const PngImage& image, const Palette& palette, ColourRange range, Dither dither) {
    if (has_palette(image, palette)) return image.indices;
    if (dither == Dither::FloydSteinberg) return dithered(image, palette, range);
    NearestColours nearest(palette, range);
    std::vector<std::uint8_t> indices;
    for (std::size_t i = 0; i < pixel_count(image.width_px, image.height_px); ++i)
        indices.push_back(nearest.of(image.pixel(i).colour));
    return indices;
}

}  // namespace oblong
