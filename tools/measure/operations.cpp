#include "tools/measure/operations.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {

namespace {

/// Operations of a hundred events of a stage.
struct EventCost {
    int adds = 0, multiplications = 0, divisions = 0, lookups = 0, bytes_read = 0, bytes_written = 0;
};

/// The width for operands of `bits` bits, with the sign.
Width width_of(int bits) {
    return bits <= 16 ? Width::Bits16 : bits <= 32 ? Width::Bits32 : Width::Bits64;
}

/// The widths that the dials require, for a world of +-32,768 units, a surface of 2,048 texels, and 1/z from z = 1
/// unit, the least distance of a player's eye from a wall.
struct Widths {
    Width matrix, view, screen, inverse_z, over_z;

    explicit Widths(const Accuracy& accuracy)
        : matrix(width_of(accuracy.matrix_bits + 2)),
          view(width_of(accuracy.view_bits + 17)),
          screen(width_of(accuracy.subpixel_bits + 11)),
          inverse_z(width_of(accuracy.inverse_z_bits + 2)),
          over_z(width_of(accuracy.over_z_bits + 12)) {}
};

void add(std::int64_t events, const EventCost& cost, Width width, StageOperations& stage) {
    Operations& sum = stage.operations;
    const auto times = [events](int of_a_hundred) { return events * of_a_hundred / 100; };
    sum.adds[width] += times(cost.adds);
    sum.multiplications[width] += times(cost.multiplications);
    sum.divisions[width] += times(cost.divisions);
    sum.lookups += times(cost.lookups);
    sum.bytes_read += times(cost.bytes_read);
    sum.bytes_written += times(cost.bytes_written);
}

StageOperations stage_of(std::string_view name, std::int64_t events, const EventCost& cost, Width width) {
    StageOperations stage{name, events, {}};
    add(events, cost, width, stage);
    return stage;
}

// Additions, multiplications and divisions as tests/operations counts them in the code; means over the cameras of the
// demo level if an event's work varies. Look-ups and bytes are read from the code, and cover only its data.

/// visibility/front_to_back.cpp, box_culler.cpp: the distance to the node's plane, its box against
/// the sides of the view that its parent's crosses, above the leaves its rectangle on the screen and the rows there;
/// the leaves and faces below it. And half of the additions, since each camera is in another leaf: visible_set.cpp,
/// which leaves can be seen from the eye's.
constexpr EventCost kNode{26470, 1841, 68, 0, 10000, 8600};
/// math/basis.h, to_view(): three differences, nine products, three roundings.
constexpr EventCost kRotation{1800, 900, 0, 0, 4800, 2400};
/// view/frustum.h, outcode_of(): four products, five comparisons and what joins them.
constexpr EventCost kOutcode{1800, 400, 0, 0, 0, 100};
/// view/screen_polygon.cpp: a face's corner looked up, its outcode joined to the others'; the z of scanned faces'
/// corners. A scanned edge also includes an edge of faces that turn out to be covered.
constexpr EventCost kCorner{4443};
/// view/projection.h, project_axis(), twice; view/project.h: rounding, snapping, keeping on the screen.
constexpr EventCost kProjection{3300, 200, 200, 0, 2400, 800};
/// Further projections, of a hundred corners of clipped faces: corners made by clipping (others are already projected),
/// and corners where the tree cuts brush models.
constexpr std::int64_t kNewCorners_100 = 84;
/// view/clip.cpp: distances of both ends of an edge to a plane, the place between them; also of faces without a free
/// row.
constexpr EventCost kClippedCorner{7210, 1017, 64, 0, 6400, 3200};
/// raster/scan.cpp: the survey of a polygon, also of covered ones; the constructors of both walkers, for the edges that
/// reach a row (two thirds of them).
constexpr EventCost kExactEdge{5457, 169, 67, 0, 1600, 0}, kAccumulatedEdge{6838, 67, 67, 0, 1600, 0};
/// raster/scan.cpp, next_row() and the column written, of exact edges in fours.
constexpr EventCost kExactEdgeRow{400, 0, 0, 0, 0, 400}, kAccumulatedEdgeRow{800, 0, 0, 0, 0, 400};
/// visibility/span_buffer.cpp, rows_with_free(), claim_row(): a row's hull; claim_listed(), claim_several(): the rest
/// of it; a span and its work in frame/.
constexpr EventCost kClaimedRow{1200, 0, 0, 0, 1600, 400}, kSpan{3100, 138, 0, 0, 400, 1200};
/// view/texture_gradients.cpp: three vectors rotated, the plane's distance, nine slopes, three anchors, those of 1/z
/// for four of five faces, since others are on the plane of the previous face; scene/face_surface.cpp: the mip level,
/// the size of the lit surface, its place in the cache.
constexpr EventCost kGradients{31142, 5780, 80, 0, 16000, 7200};
/// raster/block_rule.cpp, block_threshold(): one for each surface, and all for surfaces whose spans are not one block
/// each.
constexpr EventCost kThresholds{4669, 414, 0, 0, 4000, 4000};
/// frame/surface_pass.cpp, for each surface: the rectangle around its spans and whether all of it fits; and, before
/// blocks get the length that the bound allows, whether all of it is near enough.
constexpr EventCost kSurfaceBlocks{16900, 1800}, kSurfaceBound{3570, 810};
/// raster/texture_blocks.cpp, a span (nineteen of twenty are textured): 1/z, u/z and v/z at its first pixel, u and v.
constexpr EventCost kSpanInverseZ{500, 190}, kSpanOverZ{1580, 662};
/// raster/texture_blocks.cpp, advance(), a block: the next 1/z; the next u/z and v/z, times z; clamps and steps.
constexpr EventCost kInverseZAdvance{500}, kOverZAdvance{1740, 187, 0, 0, 0, 2400};
/// cut_rest(): three products with its length, and steps from a table of reciprocals, also for a block of 2^k pixels,
/// which does not count as a last one.
constexpr EventCost kLastBlock{850, 710, 0, 142, 1136, 0};
/// The same where blocks have lengths of their own: those of 2^k pixels take shifts (products on i386).
constexpr EventCost kLastBoundedBlock{850, 452, 0, 142, 1136, 0};
/// cut_whole_spans(), of affine spans: the same, with fewer products where a row's ends repeat those of another row.
constexpr EventCost kAffineSpan{850, 440, 0, 142, 1136, 0};
/// cut_bounded(): comparisons with thresholds, for each block.
constexpr EventCost kThresholdTest{538, 0, 0, 200, 1600, 0};
/// If blocks have one length: products with it, the same for a span that has room for one.
constexpr EventCost kOneLengthProducts{0, 11};
/// cut_bounded_texels(): the attempts, is_straight().
constexpr EventCost kStraightTest{5600, 848};
/// Depth, reciprocal_of(): clamping, normalising, and the method.
constexpr EventCost kDivision{300, 0, 100}, kTable{1460, 0, 0, 100, 400, 0}, kTableNewton{1760, 200, 0, 100, 400, 0},
    kTableTwoNewton{2560, 400, 0, 100, 400, 0};
/// raster/exact_spans.cpp, octave_row.h, a pixel of the parts of spans that bounded texturing divides: three steps and
/// shifts, two products; a division, except in rows with the 1/z of others. The texel, the pixel.
constexpr EventCost kExactOverZ{300, 200}, kExactInverseZ{300, 0, 38}, kExactTexel{900, 0, 0, 100, 100, 100};
/// The same if all spans are divided: most pixels are interpolated between two divided ones.
constexpr EventCost kLineInverseZ{574, 29, 23};
/// The same, for each span or part: the ends of octaves, whether one needs clamping.
constexpr EventCost kDividedPart{7370, 1713, 39};
/// The least mean length of such parts in pixels.
constexpr std::int64_t kDividedPart_px = 3;
/// raster/kernels/plain.cpp: two steps, two shifts, two masks, three addresses, the loop; the texel; the pixel.
constexpr EventCost kPixel{1300, 0, 0, 100, 100, 100};
/// The same from a block: its six numbers read.
constexpr EventCost kBlockRead{325, 0, 0, 0, 2400, 0};
constexpr EventCost kFlatPixel{100, 0, 0, 0, 0, 100};
/// effects/sky.cpp: one of the directions (products, a root without a division), the block to it, and the lengths of
/// its row's blocks; a pixel of two layers that are not merged; the sky of a frame. Merging layers, once in an eighth
/// of a second, is left out.
constexpr EventCost kSkyDirection{5674, 2147}, kSkyPixel{1845, 200, 0, 200, 200, 100}, kSkyFrame{0, 0, 1300};
/// surface/lit_surface.cpp, build_cell_row(): texel and colormap looked up; a step of the shade; a threshold. And of
/// 512 texels: the shades at cells' corners, where in its texture a surface begins; how far thresholds are apart.
constexpr EventCost kLitTexel{538, 0, 0, 200, 200, 100}, kNearestTexel{194, 0, 0, 200, 200, 100},
    kDither{270, 39, 0, 100, 100, 0};
constexpr EventCost kLitTexels_512{0, 2358, 69}, kDither_512{0, 0, 35};

StageOperations vertices_of(const StageCounts& stages, const Widths& widths) {
    // A position has 20.12 bits: products with axes of up to 32 bits are of 32.
    StageOperations stage = stage_of("vertices", stages.vertices, {0, kRotation.multiplications, 0, 0, 4800, 2400},
                                     widths.matrix == Width::Bits64 ? Width::Bits64 : Width::Bits32);
    add(stages.vertices, {kRotation.adds}, Width::Bits64, stage);
    add(stages.vertices, kOutcode, widths.view, stage);
    add(stages.edges, kCorner, Width::Bits32, stage);
    return stage;
}

StageOperations edges_of(const StageCounts& stages, const Accuracy& accuracy, const Widths& widths) {
    const bool is_exact = accuracy.edges == EdgeStepping::Exact;
    // An edge's numerator is a product of two screen coordinates.
    const Width setup = widths.screen == Width::Bits16 ? Width::Bits32 : Width::Bits64;
    return stage_of("edges", stages.edges, is_exact ? kExactEdge : kAccumulatedEdge, is_exact ? setup : Width::Bits32);
}

StageOperations edge_rows_of(const StageCounts& stages, const Accuracy& accuracy) {
    const bool is_exact = accuracy.edges == EdgeStepping::Exact;
    return stage_of("edge rows", stages.edge_rows, is_exact ? kExactEdgeRow : kAccumulatedEdgeRow, Width::Bits32);
}

EventCost reciprocal_cost(ReciprocalMethod method) {
    switch (method) {
        case ReciprocalMethod::Table256:
            return kTable;
        case ReciprocalMethod::Table256Newton:
        case ReciprocalMethod::Table1024Newton:
            return kTableNewton;
        case ReciprocalMethod::Table256TwoNewton:
            return kTableTwoNewton;
        case ReciprocalMethod::Exact:
            break;
    }
    return kDivision;
}

/// Whether spans are drawn only by raster/exact_spans.h, without blocks.
bool divides_spans(const Accuracy& accuracy) {
    return accuracy.texturing == Texturing::Exact && accuracy.reciprocal == ReciprocalMethod::Exact;
}

bool has_one_length(Texturing texturing) {
    return texturing == Texturing::Every8 || texturing == Texturing::Every16 || texturing == Texturing::Every32;
}

StageOperations blocks_of(const FrameCounts& counts, const Accuracy& accuracy, const Widths& widths) {
    const StageCounts& stages = counts.stages;
    const std::int64_t blocks = stages.blocks;
    StageOperations stage{"blocks", blocks, {}};
    add(blocks, kInverseZAdvance, widths.inverse_z, stage);
    add(blocks, kOverZAdvance, widths.over_z, stage);
    const bool is_affine = accuracy.texturing == Texturing::Affine;
    const bool is_bounded = accuracy.texturing == Texturing::Bounded || accuracy.texturing == Texturing::BoundedTexels;
    const EventCost last_block = is_affine ? kAffineSpan : is_bounded ? kLastBoundedBlock : kLastBlock;
    add(stages.last_blocks, last_block, Width::Bits32, stage);
    if (has_one_length(accuracy.texturing)) add(counts.spans, kOneLengthProducts, widths.over_z, stage);
    if (accuracy.texturing == Texturing::Bounded) {
        add(stages.surfaces, kSurfaceBound, widths.inverse_z, stage);
        add(blocks, kThresholdTest, widths.inverse_z, stage);
    }
    if (accuracy.texturing == Texturing::BoundedTexels) add(blocks, kStraightTest, widths.inverse_z, stage);
    if (divides_spans(accuracy)) return stage;
    add(counts.spans, kSpanInverseZ, widths.inverse_z, stage);
    add(counts.spans, kSpanOverZ, widths.over_z, stage);
    add(stages.surfaces, kSurfaceBlocks, widths.over_z, stage);
    return stage;
}

StageOperations divisions_of(const FrameCounts& counts, const Accuracy& accuracy, const Widths& widths) {
    const std::int64_t divided = counts.stages.divided_pixels;
    StageOperations stage = stage_of("1/z", counts.divisions - counts.stages.exact_divisions,
                                     reciprocal_cost(accuracy.reciprocal), widths.inverse_z);
    stage.events += divided;
    add(divided, kExactOverZ, widths.over_z, stage);
    add(divided, divides_spans(accuracy) ? kLineInverseZ : kExactInverseZ, widths.inverse_z, stage);
    const std::int64_t parts =
        divides_spans(accuracy) ? counts.spans : std::min(counts.spans, divided / kDividedPart_px);
    add(parts, kDividedPart, widths.inverse_z, stage);
    return stage;
}

StageOperations textured_of(const StageCounts& stages) {
    const std::int64_t divided = stages.divided_pixels;
    const bool is_sky_one_layer = stages.sky_texels > 0;  // drawn by the same kernel
    const std::int64_t pixels = stages.textured_pixels - divided + (is_sky_one_layer ? stages.sky_pixels : 0);
    StageOperations stage = stage_of("pixels", pixels, kPixel, Width::Bits32);
    stage.events += divided;
    if (is_sky_one_layer) add(stages.sky_blocks, kBlockRead, Width::Bits32, stage);
    add(divided, kExactTexel, Width::Bits32, stage);
    add(stages.blocks, kBlockRead, Width::Bits32, stage);
    add(stages.flat_pixels, kFlatPixel, Width::Bits32, stage);
    return stage;
}

StageOperations sky_of(const StageCounts& stages) {
    StageOperations stage = stage_of("sky", stages.sky_directions, kSkyDirection, Width::Bits64);
    if (stages.sky_directions > 0) add(1, kSkyFrame, Width::Bits64, stage);
    if (stages.sky_texels == 0 && stages.sky_directions > 0) add(stages.sky_pixels, kSkyPixel, Width::Bits32, stage);
    return stage;
}

StageOperations lit_texels_of(const StageCounts& stages, const Accuracy& accuracy) {
    const bool interpolates = accuracy.light == LightSampling::Interpolated;
    StageOperations stage =
        stage_of("lit texels", stages.lit_texels, interpolates ? kLitTexel : kNearestTexel, Width::Bits32);
    add(stages.lit_texels / 512, kLitTexels_512, Width::Bits32, stage);
    if (!accuracy.dithers_light) return stage;
    add(stages.lit_texels, kDither, Width::Bits32, stage);
    add(stages.lit_texels / 512, kDither_512, Width::Bits32, stage);
    return stage;
}

StageOperations spans_of(const FrameCounts& counts) {
    StageOperations stage = stage_of("spans", counts.stages.claimed_rows, kClaimedRow, Width::Bits32);
    add(counts.spans, kSpan, Width::Bits32, stage);
    return stage;
}

StageOperations surfaces_of(const StageCounts& stages, const Accuracy& accuracy, const Widths& widths) {
    StageOperations stage = stage_of("gradients", stages.surfaces, kGradients, widths.inverse_z);
    if (accuracy.texturing == Texturing::Bounded) add(stages.surfaces, kThresholds, widths.inverse_z, stage);
    return stage;
}

}  // namespace

std::array<StageOperations, kStageCount> operations_by_stage(const FrameCounts& counts, const Accuracy& accuracy) {
    const StageCounts& stages = counts.stages;
    const Widths widths(accuracy);
    StageOperations projected = stage_of("projection", stages.projected, kProjection, widths.view);
    add(stages.clipped_corners * kNewCorners_100 / 100, kProjection, widths.view, projected);
    return {stage_of("nodes", stages.nodes, kNode, Width::Bits64),
            vertices_of(stages, widths),
            projected,
            stage_of("clipping", stages.clipped_corners, kClippedCorner, Width::Bits64),
            edges_of(stages, accuracy, widths),
            edge_rows_of(stages, accuracy),
            spans_of(counts),
            surfaces_of(stages, accuracy, widths),
            blocks_of(counts, accuracy, widths),
            divisions_of(counts, accuracy, widths),
            textured_of(stages),
            sky_of(stages),
            lit_texels_of(stages, accuracy)};
}

ByWidth& ByWidth::operator+=(const ByWidth& more) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += more.counts[i];
    return *this;
}

Operations& Operations::operator+=(const Operations& more) {
    adds += more.adds;
    multiplications += more.multiplications;
    divisions += more.divisions;
    lookups += more.lookups;
    bytes_read += more.bytes_read;
    bytes_written += more.bytes_written;
    return *this;
}

Operations sum_of(const std::array<StageOperations, kStageCount>& stages) {
    Operations sum;
    for (const StageOperations& stage : stages) sum += stage.operations;
    return sum;
}

}  // namespace oblong
