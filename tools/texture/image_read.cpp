#include "tools/texture/image_read.h"

#include <stb/stb_image.h>

#include <memory>

#include "engine/base/input_error.h"
#include "tools/png/indexed_png.h"
#include "tools/texture/nearest_colour.h"

namespace oblong {
namespace {

IndexedImage nearest_colours(std::span<const std::uint8_t> bytes, const Palette& palette) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> rgb(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height, &channels, 3),
        stbi_image_free);
    if (!rgb) throw InputError("image", std::string("not a readable PNG (") + stbi_failure_reason() + ")");
    IndexedImage image{width, height, {}};
    const std::size_t pixel_count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::size_t at = 0; at < pixel_count; ++at) {
        const stbi_uc* pixel = rgb.get() + at * 3;
        image.pixels.push_back(nearest_colour(palette, {pixel[0], pixel[1], pixel[2]}));
    }
    return image;
}

}  // namespace

IndexedImage read_png_as_indexed(std::span<const std::uint8_t> bytes, const Palette& palette) {
    const auto decoded = decode_indexed_png(bytes);
    if (!decoded || decoded->palette.colours != palette.colours) return nearest_colours(bytes, palette);
    return {decoded->width_px, decoded->height_px, decoded->pixels};
}

}  // namespace oblong
