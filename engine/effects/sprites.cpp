#include "engine/effects/sprites.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/view/project.h"

namespace oblong {

namespace {

constexpr View kNearestSprite = View::from_int(4);

/// The sprite's borders along one axis of the screen.
struct SpriteExtent {
    ScreenWide first, end;

    ScreenWide size() const { return end - first; }
};

PixelRange pixels_of(const SpriteExtent& extent, std::int32_t size_px) {
    const auto first_centre = [size_px](ScreenWide position) {
        const ScreenWide within = std::clamp(position, ScreenWide{}, ScreenWide::from_int(size_px));
        return static_cast<std::int32_t>(floor_of(within + ScreenWide::from_raw(127)));
    };
    return {first_centre(extent.first), first_centre(extent.end)};
}

/// A quantity that goes from 0 to `whole` over an extent: its value at a pixel's centre, and its step. Floored, so that
/// it is below `whole` at all pixels.
struct Steps {
    std::int64_t at_first, step;

    Steps(const SpriteExtent& extent, std::int32_t pixel, std::int64_t whole) {
        const std::int64_t to_centre_8 =
            floor_of<8>(ScreenWide::from_int(pixel) + ScreenWide::from_raw(128) - extent.first);
        at_first = mul_div(whole, to_centre_8, floor_of<8>(extent.size()), Rounding::Floor);
        step = mul_div(whole, 256, floor_of<8>(extent.size()), Rounding::Floor);
    }
};

/// The finest mip level whose texels are larger than half a pixel.
int mip_level(const MipTexture& texture, const SpriteExtent& across, const SpriteExtent& down) {
    const auto texels_a_pixel_16 = [](std::int32_t texels, const SpriteExtent& extent) {
        return mul_div(std::int64_t{texels} << 16, 256, floor_of<8>(extent.size()));
    };
    const std::int64_t densest_16 =
        std::max(texels_a_pixel_16(texture.width, across), texels_a_pixel_16(texture.height, down));
    return (densest_16 >= 2 << 16) + (densest_16 >= 4 << 16) + (densest_16 >= 8 << 16);
}

View half_of(std::int32_t texels, World scale) {
    return floor_shift(convert<View>(scale) * texels, 1);
}

/// The sprite's vertical middle line in viewspace; x is constant, as roll is ignored.
struct MiddleLine {
    Vec3<View> middle;
    View top_y, top_z, bottom_y, bottom_z;

    MiddleLine(const Vec3<World>& position, View half_height, const ViewContext& view)
        : middle(to_view(position, view.eye, view.axes)) {
        const View up = product<View>(half_height, view.axes.up.z),
                   forward = product<View>(half_height, view.axes.forward.z);
        top_y = middle.y + up;
        top_z = middle.z + forward;
        bottom_y = middle.y - up;
        bottom_z = middle.z - forward;
    }
    bool is_near() const { return std::min(top_z, bottom_z) < kNearestSprite; }
};

std::int64_t inverse_depth_16_of(View z) {
    return (View::from_raw(std::int64_t{1} << 48) / z) * 65536;
}

void draw_row(const ScreenSprite& sprite, const std::uint8_t* texels, const std::uint8_t* shade, InverseDepth inverse,
              InverseDepth* depths, std::uint8_t* pixels) {
    std::int64_t u_16 = sprite.u_16;
    for (std::int32_t x = sprite.pixels.first_column; x < sprite.pixels.end_column; ++x, u_16 += sprite.u_step_16) {
        const std::uint8_t texel = texels[u_16 >> 16];
        if (texel == kHoleTexel || depths[x] > inverse) continue;
        depths[x] = inverse;
        pixels[x] = shade[texel];
    }
}

}  // namespace

std::optional<ScreenSprite> project_sprite(const Sprite& sprite, const MipTexture& texture, const ViewContext& view) {
    const MiddleLine line(sprite.position, half_of(texture.height, sprite.scale), view);
    if (line.is_near()) return std::nullopt;
    const ProjectionAxis &x = view.projection.x, &y = view.projection.y;
    const ScreenWide middle = x.centre + project_axis(x, line.middle.x, line.middle.z);
    const ScreenWide half = project_axis(x, half_of(texture.width, sprite.scale), line.middle.z);
    const SpriteExtent across{middle - half, middle + half};
    const SpriteExtent down{y.centre + project_axis(y, -line.top_y, line.top_z),
                            y.centre + project_axis(y, -line.bottom_y, line.bottom_z)};
    const PixelRange columns = pixels_of(across, view.projection.width_px);
    const PixelRange rows = pixels_of(down, view.projection.height_px);
    if (columns.first >= columns.end || rows.first >= rows.end) return std::nullopt;

    const int mip = mip_level(texture, across, down);
    const Steps u(across, columns.first, std::int64_t{texture.width >> mip} << 16);
    const Steps v(down, rows.first, std::int64_t{texture.height >> mip} << 16);
    const std::int64_t at_top_16 = inverse_depth_16_of(line.top_z);
    const Steps inverse_16(down, rows.first, inverse_depth_16_of(line.bottom_z) - at_top_16);
    return ScreenSprite{{columns.first, columns.end, rows.first, rows.end},
                        item(texture.mips, mip).data(),
                        texture.width >> mip,
                        u.at_first,
                        u.step,
                        v.at_first,
                        v.step,
                        at_top_16 + inverse_16.at_first,
                        inverse_16.step};
}

InverseDepth middle_inverse_depth(const ScreenSprite& sprite) {
    const std::int64_t rows = (sprite.pixels.end_row - sprite.pixels.first_row) / 2;
    return static_cast<InverseDepth>((sprite.inverse_depth_16 + rows * sprite.inverse_depth_step_16) >> 16);
}

void draw_sprite(const ScreenSprite& sprite, const std::uint8_t* shade, DepthBuffer& depth, Framebuffer out) {
    std::int64_t v_16 = sprite.v_16, inverse_16 = sprite.inverse_depth_16;
    for (std::int32_t y = sprite.pixels.first_row; y < sprite.pixels.end_row; ++y) {
        const std::uint8_t* const texels = sprite.texels + (v_16 >> 16) * sprite.stride;
        draw_row(sprite, texels, shade, static_cast<InverseDepth>(inverse_16 >> 16) | kThingBit, depth.row(y),
                 out.row(y));
        v_16 += sprite.v_step_16;
        inverse_16 += sprite.inverse_depth_step_16;
    }
}

}  // namespace oblong
