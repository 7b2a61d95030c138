#include "engine/frame/frame_record.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/frame/frame_counts.h"

namespace oblong {

namespace {

/// Texels of the surface's mip level, 16.16.
void show_texel(std::int64_t u_16, std::int64_t v_16, const FaceSurface& surface, PixelRecord& pixel) {
    const auto whole = [&surface](std::int64_t texel_16, std::int32_t origin) {
        return Texel::from_raw(texel_16 * (std::int64_t{1} << surface.mip)) + Texel::from_int(origin);
    };
    pixel.mip = static_cast<std::int8_t>(surface.mip);
    pixel.u = whole(u_16, surface.origin_u);
    pixel.v = whole(v_16, surface.origin_v);
}

}  // namespace

void observe_spans(const VisibleFace& face, std::span<const Span> spans, Framebuffer out,
                   const FrameObservers& observers) {
    if (observers.counts) count_writes(spans, out.pitch, *observers.counts);
    if (observers.record) record_spans(record_of(face), spans, out, *observers.record);
}

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
    for (const TexelBlock& block : blocks)
        for (std::int64_t i = 0; i < block.count; ++i) {
            show_texel(block.u_16 + i * block.u_step_16, block.v_16 + i * block.v_step_16, surface, face);
            record.pixels[block.pixel + as_size(i)] = face;
        }
}

void record_divided_pixels(PixelRecord face, std::span<const Span> spans, const BlockCutting& cutting,
                           const FaceSurface& surface, Framebuffer out, FrameRecord& record) {
    for (const Span& span : spans)
        for (std::int32_t column = span.first; column < span.end; ++column) {
            const TexelPosition texel = texel_at(cutting.gradients, cutting.limits, column, span.y);
            show_texel(texel.u_16, texel.v_16, surface, face);
            item(record.pixels, span.y * out.pitch + column) = face;
        }
}

}  // namespace oblong
