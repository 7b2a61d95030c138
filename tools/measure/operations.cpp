#include "tools/measure/operations.h"

#include "engine/base/table.h"

namespace oblong {

namespace {

/// Operations of one event of a stage.
struct EventCost {
    int adds = 0, multiplications = 0, divisions = 0, lookups = 0, bytes_read = 0, bytes_written = 0;
};

/// Width of the operands that `bits`, the sign included, need.
Width width_of(int bits) {
    return bits <= 16 ? Width::Bits16 : bits <= 32 ? Width::Bits32 : Width::Bits64;
}

/// The widths that the dials leave necessary. A world of +-32,768 units, a surface of 2,048 texels, and 1/z from z = 1
/// unit on, nearer than which a player's eye does not come to a wall.
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
    sum.adds[width] += events * cost.adds;
    sum.multiplications[width] += events * cost.multiplications;
    sum.divisions[width] += events * cost.divisions;
    sum.lookups += events * cost.lookups;
    sum.bytes_read += events * cost.bytes_read;
    sum.bytes_written += events * cost.bytes_written;
}

StageOperations stage_of(std::string_view name, std::int64_t events, const EventCost& cost, Width width) {
    StageOperations stage{name, events, {}};
    add(events, cost, width, stage);
    return stage;
}

/// visibility/front_to_back.cpp, enter_node(): the distance to the node's plane, its box against two of the four sides
/// of the view (a parent's box is inside of the others), two to four steps pushed and popped.
constexpr EventCost kNode{45, 15, 0, 0, 60, 48};
/// math/basis.h, to_view(): three differences, nine products, three roundings.
constexpr EventCost kRotation{18, 9, 0, 0, 48, 24};
/// geometry/frustum.h, outcode_of(): four products, nine comparisons and what joins them.
constexpr EventCost kOutcode{17, 4, 0, 0, 0, 1};
/// geometry/projection.h, project_axis(), twice; geometry/project.cpp: rounding, snapping, keeping on the screen.
constexpr EventCost kProjection{22, 2, 2, 0, 24, 8};
/// geometry/clip.cpp: distances of both ends of an edge to a plane, the place between them.
constexpr EventCost kClippedCorner{30, 9, 3, 0, 64, 32};
/// raster/scan.cpp, the constructors of both walkers.
constexpr EventCost kExactEdge{16, 3, 2, 0, 16, 0}, kAccumulatedEdge{9, 1, 1, 0, 16, 0};
/// raster/scan.cpp, next_row() and the column written.
constexpr EventCost kExactEdgeRow{8, 0, 0, 0, 0, 4}, kAccumulatedEdgeRow{4, 0, 0, 0, 0, 4};
/// visibility/span_buffer.cpp, claim(): a row's hull, and what of it is left; a span.
constexpr EventCost kClaimedRow{12, 0, 0, 0, 20, 8}, kSpan{4, 0, 0, 0, 4, 12};
/// geometry/texture_gradients.cpp: three vectors rotated, the plane's distance, nine slopes, three anchors.
constexpr EventCost kGradients{70, 45, 1, 0, 160, 72};
/// raster/block_rule.cpp, make_block_thresholds(): ten of them, once a surface.
constexpr EventCost kThresholds{60, 10, 0, 0, 80, 80};
/// raster/texture_blocks.cpp, advance(): 1/z on, by a product; u/z and v/z on, and times z; its clamps and steps.
constexpr EventCost kInverseZAdvance{7, 1, 0, 0, 0, 0}, kOverZAdvance{22, 4, 0, 0, 0, 24};
/// cut_rest(): steps by division.
constexpr EventCost kLastBlock{6, 0, 2, 0, 0, 0};
/// cut_bounded(): comparisons with thresholds; is_straight().
constexpr EventCost kThresholdTest{4, 0, 0, 2, 16, 0}, kStraightTest{14, 2, 0, 0, 0, 0};
/// reciprocal_of(): normalising, and the method.
constexpr EventCost kDivision{6, 0, 1, 0, 0, 0}, kTable{8, 0, 0, 1, 4, 0}, kTableNewton{14, 2, 0, 1, 4, 0},
    kTableTwoNewton{22, 4, 0, 1, 4, 0};
/// raster/exact_spans.cpp, draw_octave(): three steps and shifts, a division, two products.
constexpr EventCost kExactPixel{8, 2, 1, 0, 0, 0};
/// raster/kernels/plain.cpp: two steps, two shifts, two masks, an address, the loop; the texel; the pixel.
constexpr EventCost kPixel{9, 0, 0, 1, 1, 1};
/// The same from a block: its six numbers read.
constexpr EventCost kBlockRead{4, 0, 0, 0, 24, 0};
constexpr EventCost kFlatPixel{1, 0, 0, 0, 0, 1};
/// effects/sky.cpp: an eighth of a direction (six products, a root of some 40 steps, four divisions), and the texel.
constexpr EventCost kSkyDirection{130, 12, 4, 0, 0, 0}, kSkyPixel{12, 2, 0, 2, 2, 1};
/// surface/lit_surface.cpp, build_cell_row(): texel and colormap looked up; a step of the shade; a threshold.
constexpr EventCost kLitTexel{5, 0, 0, 2, 2, 1}, kNearestTexel{4, 0, 0, 2, 2, 1}, kDither{7, 1, 0, 1, 1, 0};

StageOperations vertices_of(const StageCounts& stages, const Widths& widths) {
    // A position has 20.12 bits: products with axes of up to 32 bits are of 32.
    StageOperations stage = stage_of("vertices", stages.vertices, {0, kRotation.multiplications, 0, 0, 48, 24},
                                     widths.matrix == Width::Bits64 ? Width::Bits64 : Width::Bits32);
    add(stages.vertices, {kRotation.adds}, Width::Bits64, stage);
    add(stages.vertices, kOutcode, widths.view, stage);
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

StageOperations blocks_of(const FrameCounts& counts, const Accuracy& accuracy, const Widths& widths) {
    const StageCounts& stages = counts.stages;
    const std::int64_t blocks = stages.blocks - stages.divided_pixels;
    StageOperations stage{"blocks", blocks, {}};
    add(blocks, kInverseZAdvance, widths.inverse_z, stage);
    add(blocks, kOverZAdvance, widths.over_z, stage);
    add(blocks, kBlockRead, Width::Bits32, stage);
    add(stages.last_blocks, kLastBlock, Width::Bits32, stage);
    if (accuracy.texturing == Texturing::Bounded) add(blocks, kThresholdTest, widths.inverse_z, stage);
    if (accuracy.texturing == Texturing::BoundedTexels) add(blocks, kStraightTest, widths.inverse_z, stage);
    return stage;
}

StageOperations divisions_of(const FrameCounts& counts, const Accuracy& accuracy, const Widths& widths) {
    const StageCounts& stages = counts.stages;
    StageOperations stage = stage_of("1/z", counts.divisions - stages.divided_pixels,
                                     reciprocal_cost(accuracy.reciprocal), widths.inverse_z);
    stage.events += stages.divided_pixels;
    add(stages.divided_pixels, {kExactPixel.adds - 3, kExactPixel.multiplications}, widths.over_z, stage);
    add(stages.divided_pixels, {3, 0, kExactPixel.divisions}, widths.inverse_z, stage);
    return stage;
}

StageOperations textured_of(const FrameCounts& counts) {
    StageOperations stage = stage_of("pixels", counts.stages.textured_pixels, kPixel, Width::Bits32);
    add(counts.stages.flat_pixels, kFlatPixel, Width::Bits32, stage);
    return stage;
}

StageOperations sky_of(const StageCounts& stages) {
    StageOperations stage = stage_of("sky", stages.sky_pixels, kSkyPixel, Width::Bits32);
    add(stages.sky_pixels / 8, kSkyDirection, Width::Bits64, stage);
    return stage;
}

StageOperations lit_texels_of(const StageCounts& stages, const Accuracy& accuracy) {
    const bool interpolates = accuracy.light == LightSampling::Interpolated;
    StageOperations stage =
        stage_of("lit texels", stages.lit_texels, interpolates ? kLitTexel : kNearestTexel, Width::Bits32);
    if (accuracy.dithers_light) add(stages.lit_texels, kDither, Width::Bits32, stage);
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

void add_to(ByWidth& sum, const ByWidth& more) {
    for (std::size_t i = 0; i < sum.counts.size(); ++i) sum.counts[i] += more.counts[i];
}

/// Cycles of one operation of 16, 32 and 64 bits.
struct InstructionTimes {
    std::string_view name;
    double megahertz;
    std::array<double, 3> add, multiply, divide;
    double lookup, byte_read, byte_written;
};

/// 16 and 32 bits: Intel's 80386 and i486 programmer's reference manuals, Agner Fog's tables for the Pentium. A
/// product's time grows with its factor's bits on the 386 and the 486 (max(ceil(log2 m), 3) + 6, and 13 to 42): taken
/// for full factors. 64 bits in 32-bit instructions: an addition is two (ADD, ADC); a product three products and three
/// additions; a quotient by a divisor of up to 32 significant bits two divisions and four additions. A byte read or
/// written is a quarter of a MOV of 32 bits; a lookup, whose bytes are also read, adds what is left of a whole one.
constexpr std::array<InstructionTimes, 3> kTimes{{
    {"386 at 33 MHz", 33, {2, 2, 4}, {22, 38, 120}, {27, 43, 94}, 3, 1, 0.5},
    {"486 at 66 MHz", 66, {1, 1, 2}, {26, 42, 129}, {27, 43, 90}, 0.75, 0.25, 0.25},
    {"Pentium at 90 MHz", 90, {1, 1, 2}, {10, 10, 33}, {30, 46, 96}, 0.75, 0.25, 0.25},
}};

double weighted(const ByWidth& operations, const std::array<double, 3>& cycles) {
    double sum = 0;
    for (std::size_t i = 0; i < cycles.size(); ++i) sum += static_cast<double>(operations.counts[i]) * cycles[i];
    return sum;
}

}  // namespace

std::array<StageOperations, kStageCount> operations_by_stage(const FrameCounts& counts, const Accuracy& accuracy) {
    const StageCounts& stages = counts.stages;
    const Widths widths(accuracy);
    StageOperations projected = stage_of("projection", stages.projected, kProjection, widths.view);
    add(stages.clipped_corners, kProjection, widths.view, projected);
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
            textured_of(counts),
            sky_of(stages),
            lit_texels_of(stages, accuracy)};
}

Operations sum_of(const std::array<StageOperations, kStageCount>& stages) {
    Operations sum;
    for (const StageOperations& stage : stages) {
        add_to(sum.adds, stage.operations.adds);
        add_to(sum.multiplications, stage.operations.multiplications);
        add_to(sum.divisions, stage.operations.divisions);
        sum.lookups += stage.operations.lookups;
        sum.bytes_read += stage.operations.bytes_read;
        sum.bytes_written += stage.operations.bytes_written;
    }
    return sum;
}

std::string_view name_of(Processor processor) {
    return at(kTimes, processor).name;
}

double cycles_on(Processor processor, const Operations& operations) {
    const InstructionTimes& times = at(kTimes, processor);
    return weighted(operations.adds, times.add) + weighted(operations.multiplications, times.multiply) +
           weighted(operations.divisions, times.divide) + static_cast<double>(operations.lookups) * times.lookup +
           static_cast<double>(operations.bytes_read) * times.byte_read +
           static_cast<double>(operations.bytes_written) * times.byte_written;
}

double frame_rate(Processor processor, double cycles) {
    return at(kTimes, processor).megahertz * 1e6 / cycles;
}

}  // namespace oblong
