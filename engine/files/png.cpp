#include <png.h>

#include <string>

#include "engine/base/input_error.h"
#include "engine/files/picture.h"
#include "engine/view/screen.h"

namespace oblong {
namespace {

constexpr std::uint32_t kLargestSide_px = 4096;

/// libpng's state of one picture. Its simplified interface needs no longjmp: a failing call returns 0 and leaves a
/// message.
class PngState {
  public:
    PngState() { image.version = PNG_IMAGE_VERSION; }
    ~PngState() { png_image_free(&image); }
    PngState(const PngState&) = delete;
    PngState& operator=(const PngState&) = delete;

    void expect(int succeeded, const std::string& what) const {
        if (succeeded == 0) throw InputError("image", what + " (libpng: " + image.message + ")");
    }

    png_image image{};
};

void check_size(const png_image& image) {
    if (image.width <= kLargestSide_px && image.height <= kLargestSide_px) return;
    throw InputError("image", std::to_string(image.width) + "x" + std::to_string(image.height) +
                                  " pixels, expected 4096 a side at most");
}

void check_indices(const PngImage& image) {
    for (const std::uint8_t index : image.indices) {
        if (index < image.colours.size()) continue;
        throw InputError("image", "a pixel of colour " + std::to_string(index) + ", expected one of the palette's " +
                                      std::to_string(image.colours.size()));
    }
}

std::vector<Rgba8> colours_of(const std::vector<std::uint8_t>& rgba, std::size_t count) {
    std::vector<Rgba8> colours;
    colours.reserve(count);
    for (std::size_t at = 0; at < count * 4; at += 4)
        colours.push_back({{rgba[at], rgba[at + 1], rgba[at + 2]}, rgba[at + 3]});
    return colours;
}

}  // namespace

PngImage decode_png(std::span<const std::uint8_t> file) {
    PngState state;
    png_image& image = state.image;
    state.expect(png_image_begin_read_from_memory(&image, file.data(), file.size()), "not a readable PNG");
    check_size(image);
    const bool is_indexed = (image.format & PNG_FORMAT_FLAG_COLORMAP) != 0;
    image.format = is_indexed ? PNG_FORMAT_RGBA_COLORMAP : PNG_FORMAT_RGBA;
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image)),
        colormap(PNG_IMAGE_MAXIMUM_COLORMAP_COMPONENTS(PNG_FORMAT_RGBA));
    state.expect(png_image_finish_read(&image, nullptr, pixels.data(), 0, colormap.data()), "a damaged PNG");

    PngImage decoded{static_cast<std::int32_t>(image.width), static_cast<std::int32_t>(image.height), {}, {}};
    decoded.colours = is_indexed ? colours_of(colormap, image.colormap_entries) : colours_of(pixels, pixels.size() / 4);
    if (is_indexed) decoded.indices = std::move(pixels);
    check_indices(decoded);
    return decoded;
}

std::vector<std::uint8_t> encode_indexed_png(std::span<const std::uint8_t> pixels, std::int32_t width_px,
                                             std::int32_t height_px, const Palette& palette) {
    const bool is_sane = width_px > 0 && height_px > 0;
    if (!is_sane || pixels.size() != pixel_count(width_px, height_px)) {
        throw InputError("image", std::to_string(pixels.size()) + " pixels of " + std::to_string(width_px) + "x" +
                                      std::to_string(height_px) + ", expected all, and one or more a side");
    }
    std::vector<std::uint8_t> colormap;
    for (const Rgb8& colour : palette.colours) colormap.insert(colormap.end(), {colour.red, colour.green, colour.blue});
    PngState state;
    png_image& image = state.image;
    image.width = static_cast<png_uint_32>(width_px);
    image.height = static_cast<png_uint_32>(height_px);
    image.format = PNG_FORMAT_RGB_COLORMAP;
    image.colormap_entries = 256;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::uint8_t> file(size);
    state.expect(png_image_write_to_memory(&image, file.data(), &size, 0, pixels.data(), 0, colormap.data()),
                 "the picture could not be compressed");
    file.resize(size);
    return file;
}

}  // namespace oblong
