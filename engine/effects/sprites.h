#pragma once

#include <cstdint>
#include <optional>

#include "engine/level/level.h"
#include "engine/raster/depth.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"

namespace oblong {

/// A picture that stands upright and turns toward the eye (Quake's SPR_VP_PARALLEL_UPRIGHT). Palette index 255 is
/// transparent.
struct Sprite {
    Vec3<World> position;  ///< of its middle
    TextureIndex texture;
    World scale = World::from_int(1);  ///< units a texel, above 0, at most 16
};

/// A sprite on the screen. Texels and depth are those of the centre of the first pixel, and their steps.
struct ScreenSprite {
    ScreenRectangle pixels;  ///< not empty
    const std::uint8_t* texels = nullptr;
    std::int32_t stride = 0;
    std::int64_t u_16 = 0, u_step_16 = 0, v_16 = 0, v_step_16 = 0;
    std::int64_t inverse_depth_16 = 0, inverse_depth_step_16 = 0;  ///< per row: in steps of InverseDepth, and 16 bits
};

/// The sprite as a rectangle: as wide as at its middle, as high as from its top to its bottom, and as deep as each row
/// of an upright picture is; the camera's roll is not followed. None where nothing of it is on the screen, or a part of
/// its vertical middle line is nearer than 4 units. `texture` is its own.
std::optional<ScreenSprite> project_sprite(const Sprite& sprite, const MipTexture& texture, const ViewContext& view);

/// Draws it where nothing nearer has been drawn. `shade` is a row of the colormap: 256 colours. The depth of its pixels
/// must be wanted.
void draw_sprite(const ScreenSprite& sprite, const std::uint8_t* shade, DepthBuffer& depth, Framebuffer out);

}  // namespace oblong
