#include "engine/frame/frame_counts.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {

namespace {

void count_run(std::uint32_t pixel, std::uint32_t count, std::vector<std::uint8_t>& writes) {
    for (std::uint32_t i = pixel; i < pixel + count; ++i)
        writes[i] = static_cast<std::uint8_t>(std::min(writes[i] + 1, 255));
}

void count_runs(std::span<const Span> spans, std::int32_t pitch, std::vector<std::uint8_t>& writes) {
    for (const Span& span : spans)
        count_run(static_cast<std::uint32_t>(span.y * pitch + span.first),
                  static_cast<std::uint32_t>(span.end - span.first), writes);
}

}  // namespace

std::vector<NamedCount> named_counts(const FrameCounts& counts) {
    const StageCounts& stages = counts.stages;
    return {{"faces_visited", counts.faces_visited},
            {"faces_drawn", counts.faces_drawn},
            {"spans", counts.spans},
            {"divisions", counts.divisions},
            {"nodes", stages.nodes},
            {"vertices", stages.vertices},
            {"projected", stages.projected},
            {"clipped_corners", stages.clipped_corners},
            {"edges", stages.edges},
            {"edge_rows", stages.edge_rows},
            {"claimed_rows", stages.claimed_rows},
            {"surfaces", stages.surfaces},
            {"blocks", stages.blocks},
            {"last_blocks", stages.last_blocks},
            {"textured_pixels", stages.textured_pixels},
            {"divided_pixels", stages.divided_pixels},
            {"exact_divisions", stages.exact_divisions},
            {"flat_pixels", stages.flat_pixels},
            {"sky_pixels", stages.sky_pixels},
            {"sky_blocks", stages.sky_blocks},
            {"sky_directions", stages.sky_directions},
            {"sky_texels", stages.sky_texels},
            {"particles", stages.particles},
            {"lit_texels", stages.lit_texels},
            {"coloured_texels", stages.coloured_texels}};
}

std::int64_t pixels_of(std::span<const Span> spans) {
    std::int64_t pixels = 0;
    for (const Span& span : spans) pixels += span.end - span.first;
    return pixels;
}

FrameCounts make_frame_counts(const Framebuffer& out) {
    FrameCounts counts;
    counts.writes.resize(pixel_count(out.pitch, out.height_px));
    return counts;
}

void count_face(EffectSet effects, std::span<const Span> spans, FrameCounts& counts) {
    ++counts.faces_drawn;
    counts.spans += static_cast<std::int64_t>(spans.size());
    const std::int64_t pixels = pixels_of(spans);
    for (std::size_t effect = 0; effect < kEffectNames.size(); ++effect)
        if (effects.has(static_cast<Effect>(effect))) counts.effect_pixels[effect] += pixels;
}

void count_writes(std::span<const Span> spans, std::int32_t pitch, FrameCounts& counts) {
    count_runs(spans, pitch, counts.writes);
    counts.stages.flat_pixels += pixels_of(spans);
}

void count_divided_pixels(std::span<const Span> spans, std::int64_t divisions, std::int32_t pitch,
                          FrameCounts& counts) {
    count_runs(spans, pitch, counts.writes);
    const std::int64_t pixels = pixels_of(spans);
    counts.stages.textured_pixels += pixels;
    counts.stages.divided_pixels += pixels;
    counts.stages.exact_divisions += divisions;
    counts.divisions += divisions;
}

void count_blocks(std::span<const Span> spans, const BlockCutting& cutting, const BlockList& blocks,
                  FrameCounts& counts) {
    counts.divisions += divisions_of(spans, cutting, blocks);
    for (const TexelBlock& block : blocks.waiting()) {
        count_run(block.pixel, static_cast<std::uint32_t>(block.count), counts.writes);
        counts.stages.textured_pixels += block.count;
        counts.stages.last_blocks += (block.count & (block.count - 1)) != 0;
    }
    counts.stages.blocks += std::ssize(blocks.waiting());
}

void count_sky(std::span<const Span> spans, std::int64_t blocks, const SkyNow& sky, StageCounts& stages) {
    stages.sky_pixels = pixels_of(spans);
    stages.flat_pixels -= stages.sky_pixels;
    stages.sky_blocks = blocks;
    stages.sky_directions = blocks + std::ssize(spans);
    stages.sky_texels = std::ssize(sky.tile);
}

void count_walk(std::int64_t nodes, const VertexCache::Counts& vertices, StageCounts& stages) {
    stages.nodes = nodes;
    stages.vertices = vertices.transformed;
    stages.projected = vertices.projected;
}

void count_polygon(const ScreenPolygon& polygon, const ScanlineExtents& rows, StageCounts& stages) {
    const auto corners = static_cast<std::int64_t>(polygon.vertices.size());
    if (polygon.is_clipped) stages.clipped_corners += corners;
    stages.edges += corners;
    stages.edge_rows += 2 * (rows.end - rows.first);
    stages.claimed_rows += rows.end - rows.first;
}

}  // namespace oblong
