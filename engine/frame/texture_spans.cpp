#include "engine/frame/texture_spans.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/raster/exact_spans.h"

namespace oblong {

namespace {

/// Blocks shorter than 2^3 pixels take longer than a division at each of their pixels.
constexpr int kLeastBlockLog2 = 3;

void draw_waiting_blocks(const TexturedFace& face, const SpanDrawing& drawing) {
    BlockList& blocks = drawing.scratch.blocks;
    if (face.effect.kernel)
        face.effect.kernel(blocks.waiting(), face.effect.texels, drawing.out.pixels);
    else
        face.surface.kernel(blocks.waiting(), face.surface.view, drawing.out.pixels);
    if (drawing.counts) count_writes(blocks.waiting(), *drawing.counts);
    if (drawing.record) record_blocks(record_of(face.claimed.visible), blocks.waiting(), face.surface, *drawing.record);
    blocks.clear();
}

/// Cuts spans into blocks, then draws them, as many at a time as there is room for.
void draw_blocks(const TexturedFace& face, std::span<const Span> spans, BlockCutter cut_blocks,
                 const BlockCutting& cutting, const SpanDrawing& drawing) {
    BlockList& blocks = drawing.scratch.blocks;
    while (!spans.empty()) {
        const std::span<const Span> left = cut_blocks(spans, drawing.out.pitch, cutting, blocks);
        if (drawing.counts)
            drawing.counts->divisions += divisions_of(spans.first(spans.size() - left.size()), face.gradients, blocks);
        draw_waiting_blocks(face, drawing);
        spans = left;
    }
}

/// What draws pixels that lie on lines, if it is worth looking for those: among pixels for which bounded blocks would
/// be too short it is only where they are many, near to a wall.
BlockKernel line_kernel(std::span<const Span> spans, const TexturedFace& face, const SpanDrawing& drawing) {
    constexpr std::int64_t kMany = 8192;
    const bool is_worth_it = drawing.texturing.texturing == Texturing::Exact || pixels_of(spans) >= kMany;
    return is_worth_it ? face.surface.kernel : nullptr;
}

/// Without blocks, where surface and effect allow that.
void divide_at_each_pixel(const TexturedFace& face, std::span<const Span> spans, const SpanDrawing& drawing) {
    const FaceSurface& surface = face.surface;
    BlockCutting cutting{face.gradients, surface.limits, {}};
    cutting.limits.least = {};  // without steps nothing drifts
    if (!surface.is_wrapped_by_masks || (face.effect.kernel && !face.effect.warps_alone))
        return draw_blocks(face, spans, drawing.texturing.cut_pixels, cutting, drawing);
    const std::int64_t divisions =
        face.effect.warps_alone
            ? draw_exact_warped_spans(spans, face.gradients, cutting.limits, face.effect.texels, drawing.out)
            : draw_exact_spans(spans, face.gradients, cutting.limits, surface.view, line_kernel(spans, face, drawing),
                               drawing.out);
    if (drawing.counts) count_divided_pixels(spans, divisions, drawing.out.pitch, *drawing.counts);
    if (drawing.record)
        record_divided_pixels(record_of(face.claimed.visible), spans, cutting, surface, drawing.out, *drawing.record);
}

/// The longest block of a face that rounding allows (longest_block_log2).
int longest_block_of(const TexturedFace& face, View nearest_z, const BlockRule& rule) {
    const auto nearest_width = product<WidthAtOne>(nearest_z, face.least_pixel_width, Rounding::Floor);
    const auto texels = product<TexelDensity>(nearest_width, face.least_density, Rounding::Floor);
    return longest_block_log2(rule, floor_shift(texels, face.surface.mip));
}

BlockCutting bounded_cutting(const TexturedFace& face, std::span<const Span> spans, const BlockRule& rule) {
    const int longest = longest_block_of(face, face.claimed.nearest_z, rule);
    BlockCutting cutting{face.gradients, face.surface.limits,
                         make_block_thresholds(rule, face.gradients.inverse_z.per_column, longest)};
    cutting.limits.least = std::min(cutting.limits.least, Texel::from_raw(std::int64_t{1} << longest));
    cutting.fits_range = fits_range(face.gradients, rectangle_around(spans));
    return cutting;
}

/// Whether 1/z falls below `least` nowhere on the face.
bool is_above(InverseZ least, View farthest_z) {
    return product<InverseZ>(least, farthest_z) < InverseZ::from_int(1);
}

/// Splits a span where 1/z, which is linear along it, crosses `least`.
void split_at(InverseZ least, const Span& span, const LinearQuantity<InverseZ>& inverse_z, std::vector<Span>& above,
              std::vector<Span>& below) {
    const InverseZ first = inverse_z.at(span.first, span.y), last = inverse_z.at(span.end - 1, span.y);
    const bool begins_above = first >= least;
    std::vector<Span>& beginning = begins_above ? above : below;
    if (begins_above == (last >= least)) return beginning.push_back(span);
    const InverseZ way = begins_above ? first - least : least - std::max(first, InverseZ{}) - InverseZ::ulp();
    const std::int64_t steps = way.raw / absolute(inverse_z.per_column).raw;
    const auto middle = static_cast<std::int32_t>(std::min<std::int64_t>(span.first + steps + 1, span.end - 1));
    beginning.push_back({span.y, span.first, middle});
    (begins_above ? below : above).push_back({span.y, middle, span.end});
}

/// Blocks where they are long enough to be worth it.
void draw_bounded(const TexturedFace& face, std::span<const Span> spans, const SpanDrawing& drawing) {
    const SpanTexturing& texturing = drawing.texturing;
    const BlockCutting cutting = bounded_cutting(face, spans, texturing.rule);
    const InverseZ least = at(cutting.thresholds.least_inverse_z, kLeastBlockLog2);
    if (!texturing.divides_exactly || is_above(least, face.claimed.farthest_z))
        return draw_blocks(face, spans, texturing.cut_blocks, cutting, drawing);
    std::vector<Span>&long_blocks = drawing.scratch.long_blocks, &short_blocks = drawing.scratch.short_blocks;
    long_blocks.clear();
    short_blocks.clear();
    for (const Span& span : spans) split_at(least, span, face.gradients.inverse_z, long_blocks, short_blocks);
    draw_blocks(face, long_blocks, texturing.cut_blocks, cutting, drawing);
    divide_at_each_pixel(face, short_blocks, drawing);
}

}  // namespace

SpanTexturing make_span_texturing(const Accuracy& accuracy) {
    Accuracy pixels = accuracy;
    pixels.texturing = Texturing::Exact;
    return {accuracy.texturing, make_block_rule(accuracy), block_cutter(accuracy), block_cutter(pixels),
            accuracy.reciprocal == ReciprocalMethod::Exact};
}

void draw_texture_spans(const TexturedFace& face, std::span<const Span> spans, const SpanDrawing& drawing) {
    const SpanTexturing& texturing = drawing.texturing;
    if (texturing.texturing == Texturing::Bounded) return draw_bounded(face, spans, drawing);
    if (texturing.texturing == Texturing::Exact && texturing.divides_exactly)
        return divide_at_each_pixel(face, spans, drawing);
    const BlockCutting cutting{face.gradients,
                               face.surface.limits,
                               {},
                               texturing.rule.texel_bound_256,
                               fits_range(face.gradients, rectangle_around(spans))};
    draw_blocks(face, spans, texturing.cut_blocks, cutting, drawing);
}

}  // namespace oblong
