#pragma once

#include <cstdint>
#include <optional>

#include "engine/level/level.h"
#include "engine/raster/depth.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"

namespace oblong {

/// An upright picture that turns toward the eye (Quake's SPR_VP_PARALLEL_UPRIGHT). Palette index 255 is transparent.
struct Sprite {
    Vec3<World> position;  ///< of its middle
    TextureIndex texture;
    World scale = World::from_int(1);  ///< units a texel, > 0, at most 16
};

/// A sprite on the screen: texture coordinates and depth at the first pixel's centre, and their steps.
struct ScreenSprite {
    ScreenRectangle pixels;  ///< not empty
    const std::uint8_t* texels = nullptr;
    std::int32_t stride = 0;
    std::int64_t u_16 = 0, u_step_16 = 0, v_16 = 0, v_step_16 = 0;
    std::int64_t inverse_depth_16 = 0, inverse_depth_step_16 = 0;  ///< per row: InverseDepth with 16 fraction bits
};

/// The sprite as a rectangle: its width is that of its middle, each row has the depth of an upright picture, and the
/// camera's roll is ignored. None if it is off the screen or a part of its vertical middle line is nearer than 4 units.
/// `texture` is that of the sprite.
std::optional<ScreenSprite> project_sprite(const Sprite& sprite, const MipTexture& texture, const ViewContext& view);

/// The depth of the middle of the drawn rows: where nothing in `pixels` is nearer, the sprite counts as visible.
InverseDepth middle_inverse_depth(const ScreenSprite& sprite);

/// Draws a sprite where nothing is nearer. `shade` is a row of the colormap or of fog, 256 colours. `depth` must be
/// valid at its pixels (DepthBuffer::want).
void draw_sprite(const ScreenSprite& sprite, const std::uint8_t* shade, DepthBuffer& depth, Framebuffer out);

}  // namespace oblong
