#include "tools/accuracy/scene_textures.h"

#include <array>
#include <cstdint>
#include <vector>

#include "engine/files/wad.h"
#include "engine/surface/nearest_colour.h"
#include "tools/texture/mipmaps.h"

namespace oblong {

namespace {

constexpr std::int32_t kSize = 64;

/// 0 to 31, as if by chance.
int grain(std::int32_t u, std::int32_t v) {
    auto bits = static_cast<std::uint32_t>(u * 7919 + v * 104729);
    bits = (bits ^ bits >> 13) * 1274126177u;
    return static_cast<int>(bits >> 27);
}

std::uint8_t channel(int value) {
    return static_cast<std::uint8_t>(value < 0 ? 0 : value > 255 ? 255 : value);
}

/// Blocks `block_width` by `block_height` texels in two shades in turn, a dark joint around each.
MipTexture make_texture(const std::string& name, std::int32_t block_width, std::int32_t block_height, Rgb8 light,
                        const Palette& palette) {
    std::vector<std::uint8_t> texels;
    for (std::int32_t v = 0; v < kSize; ++v)
        for (std::int32_t u = 0; u < kSize; ++u) {
            const bool is_joint = u % block_width == 0 || v % block_height == 0;
            const bool is_dark = (u / block_width + v / block_height) % 2 != 0;
            const int change = grain(u, v) - (is_joint ? 140 : is_dark ? 70 : 0);
            const Rgb8 colour{channel(light.red + change), channel(light.green + change), channel(light.blue + change)};
            texels.push_back(nearest_colour(palette, colour, kOrdinaryColours));
        }
    return make_mip_texture(name, kSize, kSize, std::move(texels), palette);
}

}  // namespace

std::string make_scene_wad(const Palette& palette) {
    const std::array<MipTexture, 2> textures{make_texture("stone", 16, 8, {200, 180, 150}, palette),
                                             make_texture("tiles", 8, 8, {150, 180, 200}, palette)};
    const std::vector<std::uint8_t> bytes = write_wad(textures);
    return {bytes.begin(), bytes.end()};
}

}  // namespace oblong
