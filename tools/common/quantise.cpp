#include "tools/common/quantise.h"

#include <libimagequant.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/base/table.h"

namespace oblong {
namespace {

template <auto Destroy>
struct Destroyer {
    void operator()(auto* what) const { Destroy(what); }
};
using LiqAttributes = std::unique_ptr<liq_attr, Destroyer<liq_attr_destroy>>;
using LiqImage = std::unique_ptr<liq_image, Destroyer<liq_image_destroy>>;
using LiqResult = std::unique_ptr<liq_result, Destroyer<liq_result_destroy>>;

void expect(bool succeeded, const char* what) {
    if (!succeeded) throw std::runtime_error(std::string("libimagequant: ") + what + " failed");
}

liq_color opaque(Rgb8 colour) {
    return {colour.red, colour.green, colour.blue, 255};
}

std::vector<liq_color> opaque_pixels(const PngImage& image) {
    const std::size_t count = image.indices.empty() ? image.colours.size() : image.indices.size();
    std::vector<liq_color> pixels;
    pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) pixels.push_back(opaque(image.pixel(i).colour));
    return pixels;
}

/// The colours of a range are all that the library may use: fixed ones, and no more of them.
LiqResult with_fixed_colours(liq_image* image, const Palette& palette, ColourRange range) {
    const LiqAttributes attributes(liq_attr_create());
    expect(attributes && liq_set_max_colors(attributes.get(), std::max(range.end - range.begin, 2)) == LIQ_OK,
           "its set-up");
    for (int index = range.begin; index < range.end; ++index)
        expect(liq_image_add_fixed_color(image, opaque(at(palette.colours, index))) == LIQ_OK, "a colour");
    liq_result* result = nullptr;
    expect(liq_image_quantize(image, attributes.get(), &result) == LIQ_OK, "the choice of colours");
    return LiqResult(result);
}

std::vector<std::uint8_t> dithered(const PngImage& image, const Palette& palette, ColourRange range) {
    const std::vector<liq_color> pixels = opaque_pixels(image);
    const LiqAttributes attributes(liq_attr_create());
    const LiqImage picture(liq_image_create_rgba(attributes.get(), pixels.data(), image.width_px, image.height_px, 0));
    expect(picture != nullptr, "its set-up");
    const LiqResult result = with_fixed_colours(picture.get(), palette, range);
    expect(liq_set_dithering_level(result.get(), 1) == LIQ_OK, "its set-up");
    std::vector<std::uint8_t> indices(pixels.size());
    expect(liq_write_remapped_image(result.get(), picture.get(), indices.data(), indices.size()) == LIQ_OK,
           "dithering");
    // The library has the colours in an order of its own.
    const liq_palette& used = *liq_get_palette(result.get());
    std::vector<std::uint8_t> ours;
    for (unsigned i = 0; i < used.count; ++i)
        ours.push_back(nearest_colour(palette, {used.entries[i].r, used.entries[i].g, used.entries[i].b}, range));
    for (std::uint8_t& index : indices) index = ours.at(index);
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
    std::vector<std::uint8_t> indices;
    for (const liq_color& pixel : opaque_pixels(image))
        indices.push_back(nearest_colour(palette, {pixel.r, pixel.g, pixel.b}, range));
    return indices;
}

}  // namespace oblong
