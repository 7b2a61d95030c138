#include <algorithm>

#include "engine/base/checksum.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/effects/palette_effects.h"
#include "engine/io/files.h"
#include "engine/library/conversions.h"
#include "engine/pictures/picture.h"

namespace oblong {
namespace {

constexpr std::size_t kPaletteFile_bytes = 768;

void check(int first, int last) {
    if (first < 0 || last > 255 || first > last)
        throw argument_error("palette", "colours " + std::to_string(first) + " to " + std::to_string(last) +
                                            ", expected a part of 0 to 255");
}

Palette palette_of(const PngImage& image) {
    if (image.indices.empty()) throw InputError("header", "a PNG without a palette, expected one with, or 768 bytes");
    Palette palette;
    for (std::size_t i = 0; i < std::min(image.colours.size(), palette.colours.size()); ++i)
        palette.colours[i] = image.colours[i].colour;
    return palette;
}

}  // namespace

Palette load_palette(const File& file) {
    return read_parsed(file, [](std::span<const std::uint8_t> bytes) {
        const bool is_png = bytes.size() > 1 && bytes[0] == 0x89 && bytes[1] == 'P';
        return bytes.size() != kPaletteFile_bytes && is_png ? palette_of(decode_png(bytes)) : read_palette(bytes);
    });
}

void set_ramp(Palette& palette, int first, int last, Rgb8 from, Rgb8 to) {
    check(first, last);
    const int steps = std::max(last - first, 1);
    for (int i = 0; i <= last - first; ++i) {
        const auto between = [&](std::uint8_t a, std::uint8_t b) {
            return static_cast<std::uint8_t>(a + (b - a) * i / steps);
        };
        item(palette.colours, first + i) = {between(from.red, to.red), between(from.green, to.green),
                                            between(from.blue, to.blue)};
    }
}

void set_from_pictures(Palette& palette, int first, int last, const std::vector<File>& pictures) {
    check(first, last);
    std::vector<PngImage> images;
    for (const File& picture : pictures) images.push_back(read_parsed(picture, decode_picture));
    const std::vector<Rgb8> colours = common_colours(images, as_size(last - first + 1));
    std::copy(colours.begin(), colours.end(), palette.colours.begin() + first);
}

Palette mixed(const Palette& palette, Rgb8 colour, std::int32_t share_256) {
    PaletteEffects effects;
    effects.flash = {colour, std::clamp(share_256, 0, 256)};
    return apply_palette_effects(palette, effects, 0);
}

void cycle_colours(Palette& palette, int first, int last, std::int64_t places) {
    check(first, last);
    const std::int64_t count = last - first + 1;
    const auto begin = palette.colours.begin() + first;
    // Colours move up; the last ones move to the front.
    std::rotate(begin, begin + (count - (places % count + count) % count) % count, begin + count);
}

Picture Picture::of_size(std::int32_t width_px, std::int32_t height_px) {
    if (width_px < 1 || height_px < 1 || width_px > kLargestMode_px || height_px > kLargestMode_px)
        throw argument_error("picture", std::to_string(width_px) + "x" + std::to_string(height_px) +
                                            " pixels, expected 1 to " + std::to_string(kLargestMode_px) + " a side");
    return {width_px, height_px, std::vector<std::uint8_t>(pixel_count(width_px, height_px))};
}

Framebuffer Picture::canvas() {
    checked(*this);
    return {pixels.data(), width_px, height_px, width_px};
}

Picture load_picture(const File& file, const Palette& palette) {
    const PngImage image = read_parsed(file, decode_picture);
    Picture picture{image.width_px, image.height_px, indices_of(image, palette, {0, 255}, Dither::None)};
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (image.pixel(i).alpha < 128) picture.pixels[i] = kTransparent;
    return picture;
}

void save_picture(const std::string& file, Framebuffer canvas, const Palette& palette) {
    if (!lower_case(file).ends_with(".png")) throw FileError(file, "name", "expected one that ends in .png");
    std::vector<std::uint8_t> pixels;
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        pixels.insert(pixels.end(), canvas.row(y), canvas.row(y) + canvas.width_px);
    naming_file(file,
                [&] { write_file(file, encode_indexed_png(pixels, canvas.width_px, canvas.height_px, palette)); });
}

std::uint32_t checksum(Framebuffer canvas) {
    std::uint32_t sum = 0;
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        sum = crc32({canvas.row(y), static_cast<std::size_t>(canvas.width_px)}, sum);
    return sum;
}

}  // namespace oblong
