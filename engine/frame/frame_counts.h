#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/table.h"
#include "engine/effects/sky.h"
#include "engine/frame/passes.h"
#include "engine/raster/scan.h"
#include "engine/raster/texture_blocks.h"
#include "engine/view/screen.h"
#include "engine/view/screen_polygon.h"
#include "engine/view/vertex_cache.h"

namespace oblong {

/// How often the stages of a frame did their work: what its operations are worked out from.
struct StageCounts {
    std::int64_t nodes = 0;            ///< of the tree, entered
    std::int64_t vertices = 0;         ///< transformed
    std::int64_t projected = 0;        ///< vertices put on the screen
    std::int64_t clipped_corners = 0;  ///< left after clipping
    std::int64_t edges = 0;            ///< scanned
    std::int64_t edge_rows = 0;        ///< steps down those edges
    std::int64_t claimed_rows = 0;     ///< rows of faces looked up in the span buffer
    std::int64_t surfaces = 0;         ///< for which gradients were made
    std::int64_t blocks = 0;           ///< that spans are cut into
    std::int64_t last_blocks = 0;      ///< those whose length is no power of two
    std::int64_t textured_pixels = 0, flat_pixels = 0, sky_pixels = 0;
    std::int64_t sky_blocks = 0, sky_directions = 0;  ///< draw_sky()
    std::int64_t sky_texels = 0;                      ///< of both layers, composed; 0: they are looked up at each pixel
    std::int64_t divided_pixels = 0;   ///< textured ones of raster/exact_spans.h, in `divisions` as one each
    std::int64_t exact_divisions = 0;  ///< that they took: fewer, where texels lie on lines or rows share depths
    std::int64_t particles = 0;        ///< computed, in view or not
    std::int64_t lit_texels = 0;       ///< built because the cache did not have them
};

/// Statistics of a frame, collected only on request (FrameObservers): of each frame anew.
struct FrameCounts {
    std::int64_t faces_visited = 0, faces_drawn = 0, spans = 0, divisions = 0;
    StageCounts stages;
    std::vector<std::uint8_t> writes;  ///< of each pixel, by faces, those of the sky too; at most 255
    std::array<std::int64_t, kEffectCount> effect_pixels{};  ///< of each Effect: of what needs it
    std::array<std::int64_t, kPassCount> pass_pixels{};      ///< of each of kPasses

    std::int64_t& of(Effect effect) { return item(effect_pixels, effect); }
    std::int64_t of(Effect effect) const { return item(effect_pixels, effect); }
    /// Of the pass of this name, one of kPasses.
    std::int64_t of(std::string_view pass) const;
};

/// A count and its name, for reports.
struct NamedCount {
    std::string_view name;
    std::int64_t count;
};
/// All counts but those of single pixels and effects.
std::vector<NamedCount> named_counts(const FrameCounts& counts);

/// The pixels of spans.
std::int64_t pixels_of(std::span<const Span> spans);
/// Counts of a frame in `out` that has drawn nothing yet.
FrameCounts make_frame_counts(const Framebuffer& out);

/// Adds a face that owns `spans`, and their pixels to the effects that it needs.
void count_face(EffectSet effects, std::span<const Span> spans, FrameCounts& counts);
/// Adds a write to each pixel of spans that are drawn without a surface. `pitch` is the framebuffer's.
void count_writes(std::span<const Span> spans, std::int32_t pitch, FrameCounts& counts);
/// Adds spans that were cut into these blocks, which are drawn.
void count_blocks(std::span<const Span> spans, const BlockCutting& cutting, const BlockList& blocks,
                  FrameCounts& counts);
/// Adds spans drawn by raster/exact_spans.h, which made so many divisions.
void count_divided_pixels(std::span<const Span> spans, std::int64_t divisions, std::int32_t pitch, FrameCounts& counts);
/// Moves these spans, all of the sky's, from the pixels of one colour to those of the sky, drawn in so many blocks.
void count_sky(std::span<const Span> spans, std::int64_t blocks, const SkyNow& sky, StageCounts& stages);
/// Adds what a walk and its vertices took.
void count_walk(std::int64_t nodes, const VertexCache::Counts& vertices, StageCounts& stages);
/// Adds a polygon that was scanned into `rows`.
void count_polygon(const ScreenPolygon& polygon, const ScanlineExtents& rows, StageCounts& stages);

}  // namespace oblong
