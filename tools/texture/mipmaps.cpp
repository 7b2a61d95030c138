#include "tools/texture/mipmaps.h"

#include "engine/base/table.h"
#include "engine/surface/nearest_colour.h"

namespace oblong {

namespace {

/// The sums over a block of texels. Holes have no colour.
struct BlockSum {
    int red = 0, green = 0, blue = 0, coloured = 0, fullbright = 0, holes = 0;

    void add(std::uint8_t index, const Palette& palette) {
        const Rgb8 colour = palette.colours[index];
        red += colour.red;
        green += colour.green;
        blue += colour.blue;
        ++coloured;
        if (index >= kFirstFullbright) ++fullbright;
    }
    std::uint8_t mean(int sum) const { return static_cast<std::uint8_t>((sum + coloured / 2) / coloured); }
    Rgb8 mean_colour() const { return {mean(red), mean(green), mean(blue)}; }
    bool glows() const { return 2 * fullbright >= coloured; }
    bool is_hole() const { return holes >= coloured; }
};

BlockSum sum_block(const MipTexture& texture, const Palette& palette, int left, int top, int size) {
    BlockSum sum;
    for (int y = top; y < top + size; ++y) {
        for (int x = left; x < left + size; ++x) {
            const std::uint8_t index = at(texture.mips[0], y * texture.width + x);
            if (index == kHole && has_holes(texture.name))
                ++sum.holes;
            else
                sum.add(index, palette);
        }
    }
    return sum;
}

std::vector<std::uint8_t> shrink(const MipTexture& texture, const Palette& palette, int level) {
    const int size = 1 << level;
    const ColourRange fullbright{kFirstFullbright, has_holes(texture.name) ? kHole : 256};
    std::vector<std::uint8_t> texels;
    for (int top = 0; top < texture.height; top += size) {
        for (int left = 0; left < texture.width; left += size) {
            const BlockSum sum = sum_block(texture, palette, left, top, size);
            const ColourRange range = sum.glows() ? fullbright : kOrdinaryColours;
            texels.push_back(sum.is_hole() ? kHole : nearest_colour(palette, sum.mean_colour(), range));
        }
    }
    return texels;
}

}  // namespace

MipTexture make_mip_texture(const std::string& name, std::int32_t width, std::int32_t height,
                            std::vector<std::uint8_t> texels, const Palette& palette) {
    MipTexture texture;
    texture.name = name;
    texture.width = width;
    texture.height = height;
    texture.mips[0] = std::move(texels);
    for (int level = 1; level < 4; ++level) {
        at(texture.mips, level) = shrink(texture, palette, level);
    }
    return texture;
}

}  // namespace oblong
