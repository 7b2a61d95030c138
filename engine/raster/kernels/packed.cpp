#include "engine/raster/kernels/packed.h"

namespace oblong {

void draw_blocks_packed(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const PackedFetch fetch(surface);
    for (const TexelBlock& block : blocks) draw_packed_block(block, pixels, fetch);
}

}  // namespace oblong
