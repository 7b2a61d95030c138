#include "engine/frame/frame_record.h"

#include <algorithm>

namespace oblong {

PixelRecord record_of(const VisibleFace& visible) {
    PixelRecord record;
    record.face = visible.face;
    if (visible.fragment) record.model = visible.fragment->placed;
    return record;
}

void record_spans(const PixelRecord& face, std::span<const Span> spans, Framebuffer out, FrameRecord& record) {
    for (const Span& span : spans) {
        const auto row = record.pixels.begin() + std::ptrdiff_t{span.y} * out.pitch;
        std::fill(row + span.first, row + span.end, face);
    }
}

void record_blocks(PixelRecord face, std::span<const TexelBlock> blocks, const FaceSurface& surface,
                   FrameRecord& record) {
    face.mip = static_cast<std::int8_t>(surface.mip);
    const auto whole = [&surface](std::int64_t texel_16, std::int32_t origin) {
        return Texel::from_raw(texel_16 * (std::int64_t{1} << surface.mip)) + Texel::from_int(origin);
    };
    for (const TexelBlock& block : blocks)
        for (std::int64_t i = 0; i < block.count; ++i) {
            face.u = whole(block.u_16 + i * block.u_step_16, surface.origin_u);
            face.v = whole(block.v_16 + i * block.v_step_16, surface.origin_v);
            record.pixels[block.pixel + static_cast<std::size_t>(i)] = face;
        }
}

}  // namespace oblong
