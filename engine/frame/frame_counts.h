#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/table.h"
#include "engine/effects/sky.h"
#include "engine/frame/frame_plan.h"
#include "engine/raster/scan.h"
#include "engine/raster/texture_blocks.h"
#include "engine/view/screen.h"
#include "engine/view/screen_polygon.h"

namespace oblong {

/// Counts of the stages of a frame, from which its operations are computed.
struct StageCounts {
    std::int64_t nodes = 0;            ///< tested
    std::int64_t vertices = 0;         ///< transformed
    std::int64_t projected = 0;        ///< vertices projected
    std::int64_t clipped_corners = 0;  ///< after clipping
    std::int64_t edges = 0;            ///< scanned
    std::int64_t edge_rows = 0;        ///< steps down edges
    std::int64_t claimed_rows = 0;     ///< rows of faces looked up in the span buffer
    std::int64_t surfaces = 0;         ///< with gradients
    std::int64_t blocks = 0;           ///< of spans
    std::int64_t last_blocks = 0;      ///< blocks whose length is not a power of two
    std::int64_t textured_pixels = 0, flat_pixels = 0, sky_pixels = 0;
    std::int64_t sky_blocks = 0, sky_directions = 0;  ///< draw_sky()
    std::int64_t sky_texels = 0;                      ///< composed of both layers; 0: looked up at each pixel
    std::int64_t divided_pixels = 0;                  ///< textured by raster/exact_spans.h
    std::int64_t exact_divisions = 0;                 ///< for these, in `divisions`; fewer, as it shares divisions
    std::int64_t particles = 0;                       ///< computed, including those out of view
    std::int64_t lit_texels = 0;                      ///< built, as they were not in the cache
    std::int64_t coloured_texels = 0;                 ///< of these, in coloured light
};

/// Statistics of one frame, collected on request (FrameObservers).
struct FrameCounts {
    std::int64_t faces_visited = 0, faces_drawn = 0, spans = 0;
    std::int64_t divisions = 0;  ///< of 1/z, for texels
    StageCounts stages;
    std::vector<std::uint8_t> writes;                          ///< to each pixel by faces, including sky; at most 255
    std::array<std::int64_t, kEffectCount> effect_pixels{};    ///< by Effect: pixels of what needs it
    std::array<std::int64_t, kPassCount> pass_pixels{};        ///< by index in kPasses
    std::array<std::int64_t, kEffectCount> mirrored_pixels{};  ///< the part of `effect_pixels` in mirrors

    std::int64_t& of(Effect effect) { return item(effect_pixels, effect); }
    std::int64_t of(Effect effect) const { return item(effect_pixels, effect); }
};

/// For reports.
struct NamedCount {
    std::string_view name;
    std::int64_t count;
};
/// All counts except those of single pixels and effects.
std::vector<NamedCount> named_counts(const FrameCounts& counts);

/// The number of pixels in spans.
std::int64_t pixels_of(std::span<const Span> spans);
/// Zero counts for a frame in `out`.
FrameCounts make_frame_counts(const Framebuffer& out);

/// Adds a face that owns `spans`, and adds their pixels to the effects that it needs.
void count_face(EffectSet effects, std::span<const Span> spans, FrameCounts& counts);
/// Adds a write to each pixel of spans drawn without a surface. `pitch` is the framebuffer's.
void count_writes(std::span<const Span> spans, std::int32_t pitch, FrameCounts& counts);
/// Adds spans drawn as these blocks.
void count_blocks(std::span<const Span> spans, const BlockCutting& cutting, const BlockList& blocks,
                  FrameCounts& counts);
/// Adds spans drawn by raster/exact_spans.h with this number of divisions.
void count_divided_pixels(std::span<const Span> spans, std::int64_t divisions, std::int32_t pitch, FrameCounts& counts);
/// Moves the pixels of all sky spans from `flat_pixels` to `sky_pixels`; adds the blocks.
void count_sky(std::span<const Span> spans, std::int64_t blocks, const SkyNow& sky, StageCounts& stages);
/// Sets the counts of a walk and its vertices.
void count_walk(std::int64_t nodes, const VertexCache::Counts& vertices, StageCounts& stages);
/// Adds a polygon scanned to `rows`.
void count_polygon(const ScreenPolygon& polygon, const ScanlineExtents& rows, StageCounts& stages);

}  // namespace oblong
