#include "engine/frame/surface_pass.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/workspace.h"
#include "engine/raster/exact_spans.h"

namespace oblong {

namespace {

/// The current frame of a face's animated texture; none: the face's own texture.
TextureIndex texture_now(const VisibleFace& face, const FrameContext& frame) {
    const LevelCache& cache = frame.cache;
    if (!cache.faces[face.face].effects.has(Effect::AnimatedTextures)) return TextureIndex::none();
    if (!frame.allows(Effect::AnimatedTextures)) return TextureIndex::none();
    const Level& level = frame.scene.level;
    const bool is_switched = face.fragment && cache.brush_models.is_switched(*face.fragment);
    return cache.effects.animations.shown(level.texinfos[level.faces[face.face].texinfo].texture, is_switched,
                                          frame.scene.time_ms);
}

/// A face's effects that own pixels, moving lights among them: some are reasons to build its surface again.
EffectSet effects_on(const VisibleFace& face, const FrameContext& frame, const Claims& claims) {
    LevelCache& cache = frame.cache;
    const EffectSet effects = cache.faces[face.face].effects & claims.effects;
    const bool is_lit =
        claims.effects.has(Effect::Lights) && cache.surfaces.is_touched(face.face, frame.offset_of(face));
    return is_lit ? effects.with(Effect::Lights) : effects;
}

FaceSurface surface_of(const VisibleFace& face, int mip, const FrameContext& frame, const ViewScratch& scratch) {
    PassTimes* const times = frame.observers.times;
    const EffectSet effects = times ? effects_on(face, frame, scratch.claims) : EffectSet{};
    const auto watched = [&](Effect effect) { return effects.has(effect) ? times : nullptr; };
    const Stopwatch of_lights(watched(Effect::Lights), Effect::Lights),
        of_styles(watched(Effect::Styles), Effect::Styles),
        of_animation(watched(Effect::AnimatedTextures), Effect::AnimatedTextures);
    return frame.cache.surfaces.get(face.face, mip,
                                    {scratch.light.styles, texture_now(face, frame), frame.offset_of(face)});
}

/// The kernel for these options, and its arguments.
SurfaceEffect effect_of(const SurfaceOptions& options, const FaceSurface& surface, const FrameContext& frame) {
    LevelCache& cache = frame.cache;
    TexelTraits traits = options.traits;
    traits.is_wrapped_by_masks = surface.is_wrapped_by_masks;
    if (traits.warps && cache.warp_time_ms != frame.scene.time_ms) {
        cache.warp = make_warp_tables(frame.scene.time_ms);
        cache.warp_time_ms = frame.scene.time_ms;
    }
    return {effect_kernel(traits, *frame.settings.kernels),
            {surface.view, &item(cache.warp, surface.mip), options.colours, options.blend},
            traits.warps && !traits.has_holes && !traits.blends};
}

/// The mip level of a face whose nearest pixel has this depth.
int mip_level(FaceIndex face, View nearest_z, const FrameContext& frame) {
    return frame.cache.surfaces.mip_level(face, nearest_z, frame.view.projection.x, frame.accuracy().mip_bias);
}

/// With gradients only.
BlockCutting make_cutting(const VisibleFace& face, const FaceSurface& surface, const FrameContext& frame) {
    const Level& level = frame.scene.level;
    const Accuracy& accuracy = frame.accuracy();
    BlockCutting cutting{make_face_gradients(level, level.faces[face.face], surface, frame.offset_of(face),
                                             face.inverse_z, frame.view, frame.inverse_projection)};
    if (accuracy.inverse_z_bits != InverseZ::kFractionBits || accuracy.over_z_bits != TexelOverZ::kFractionBits)
        cutting.gradients = rounded_to(cutting.gradients, accuracy.inverse_z_bits, accuracy.over_z_bits);
    return cutting;
}

TexturedFace make_textured_face(const VisibleFace& face, int mip, std::span<const Span> spans,
                                const SurfaceOptions& options, const FrameContext& frame, const ViewScratch& scratch) {
    // Made in place: it is neither cleared nor copied.
    TexturedFace textured{
        face, surface_of(face, mip, frame, scratch),
        options.is_plain ? SurfaceEffect{} : effect_of(options, textured.surface, frame),
        make_cutting(face, textured.surface, frame),
        texels_across(face.nearest_z, convert<TexelDensity>(frame.cache.faces[face.face].least_density),
                      frame.inverse_projection.least_pixel_width)};
    set_cutting(textured, spans, frame.texturing);
    return textured;
}

/// Draws spans of a face at one mip level.
void draw_mip(const VisibleFace& face, int mip, std::span<const Span> spans, const SurfaceOptions& options,
              const FrameContext& frame, ViewScratch& scratch) {
    const TexturedFace textured = make_textured_face(face, mip, spans, options, frame, scratch);
    if (is_shared(frame)) return frame.shared->add(textured, spans);
    const FrameObservers observers = options.is_observed ? frame.observers : FrameObservers{};
    if (observers.counts) ++observers.counts->stages.surfaces;
    draw_textured(textured, spans, {frame.texturing, frame.out, scratch.surfaces->spans, observers});
}

/// Whether a face is seen as a floor or a ceiling, within 45 degrees.
bool is_level(const Face& face, const Level& level) {
    constexpr auto kLeast = Unit::from_raw(759'250'125);  // the cosine of 45 degrees
    return absolute(level.planes[face.plane].normal.z) >= kLeast;
}

/// The texel of a surface's row or column that is nearest to its middle and shows the middle of the texture, if it has
/// one; `origin` is the first one's place in the repeated texture.
std::int32_t nearest_to_middle(std::int32_t size, std::int32_t origin, std::int32_t texture_size) {
    const std::int32_t middle = size / 2, place = (middle + origin) % texture_size;
    const std::int32_t beyond = place < 0 ? place + texture_size : place;
    const std::int32_t there = middle + texture_size / 2 - beyond;
    return there >= 0 && there < size ? there : middle;
}

/// In the colour of its texture's middle, so that faces of one floor differ by their light alone.
void draw_in_one_colour(const VisibleFace& face, std::span<const Span> spans, const SurfaceOptions& options,
                        const FrameContext& frame, const ViewScratch& scratch) {
    constexpr int kSmallest = 3;
    const FaceSurface surface = surface_of(face, kSmallest, frame, scratch);
    const SurfaceView& view = surface.view;
    const MipTexture& texture = frame.scene.level.texture_of(frame.scene.level.faces[face.face]);
    const std::int32_t column =
        nearest_to_middle(view.width, floor_shift(surface.origin_u, kSmallest), texture.width >> kSmallest);
    const std::int32_t row =
        nearest_to_middle(view.height, floor_shift(surface.origin_v, kSmallest), texture.height >> kSmallest);
    if (options.is_observed) observe_spans(face, spans, frame.out, frame.observers);
    fill_spans(spans, view.texels[(row << view.stride_log2) + column], frame.out);
}

/// Draws each span at the mip level of its nearest pixel.
void draw_by_span_mips(const VisibleFace& claimed, std::span<const Span> whole, const SurfaceOptions& options,
                       const FrameContext& frame, ViewScratch& scratch) {
    const auto inverse_z = inverse_z_of(claimed, frame);
    auto& of_mip = scratch.surfaces->of_mip;
    for (std::vector<Span>& spans : of_mip) spans.clear();
    for (const Span& span : whole) {
        const InverseZ first = inverse_z.at(span.first, span.y), last = inverse_z.at(span.end - 1, span.y);
        const auto nearest_z = reciprocal<View>(std::max({first, last, InverseZ::ulp()}));
        item(of_mip, mip_level(claimed.face, nearest_z, frame)).push_back(span);
    }
    for (int mip = 0; mip < 4; ++mip)
        if (!item(of_mip, mip).empty()) draw_mip(claimed, mip, item(of_mip, mip), options, frame, scratch);
}

/// Shorter blocks, below 2^3 pixels, are slower than a division at each pixel.
constexpr int kLeastBlockLog2 = 3;

/// Cuts spans into blocks and draws them, as many at a time as fit.
void draw_blocks(const TexturedFace& face, std::span<const Span> spans, BlockCutter cut_blocks,
                 const BlockCutting& cutting, const SpanTarget& target) {
    const auto [counts, record, times] = target.observers;
    BlockList& blocks = target.scratch.blocks;
    while (!spans.empty()) {
        const std::span<const Span> rest = cut_blocks(spans, target.out.pitch, cutting, blocks);
        if (face.effect.kernel)
            face.effect.kernel(blocks.waiting(), face.effect.texels, target.out.pixels);
        else
            face.surface.kernel(blocks.waiting(), face.surface.view, target.out.pixels);
        if (counts) count_blocks(spans.first(spans.size() - rest.size()), cutting, blocks, *counts);
        if (record) record_blocks(record_of(face.face), blocks.waiting(), face.surface, *record);
        blocks.clear();
        spans = rest;
    }
}

/// The kernels for pieces with almost linear texels; null if a search for them is not worth it: for Bounded it is only
/// if there are many pixels, near a wall.
const Kernels* line_kernels(std::span<const Span> spans, const SpanTarget& target) {
    constexpr std::int64_t kMany = 8192;
    const bool is_worth_it = target.texturing.texturing == Texturing::Exact || pixels_of(spans) >= kMany;
    return is_worth_it ? target.texturing.kernels : nullptr;
}

/// Draws without blocks if surface and effect allow it.
void divide_at_each_pixel(const TexturedFace& face, std::span<const Span> spans, const SpanTarget& target) {
    const FaceSurface& surface = face.surface;
    BlockCutting cutting = face.cutting;
    cutting.limits = surface.limits;
    cutting.limits.least = {};  // there are no steps, so no drift
    if (!surface.is_wrapped_by_masks || (face.effect.kernel && !face.effect.warps_alone))
        return draw_blocks(face, spans, target.texturing.cut_pixels, cutting, target);
    const std::int64_t divisions =
        face.effect.warps_alone
            ? draw_exact_warped_spans(spans, cutting, face.effect.texels, target.out)
            : draw_exact_spans(spans, cutting, surface.view, line_kernels(spans, target), target.out);
    const auto [counts, record, times] = target.observers;
    if (counts) count_divided_pixels(spans, divisions, target.out.pitch, *counts);
    if (record) record_divided_pixels(record_of(face.face), spans, cutting, surface, target.out, *record);
}

/// Whether bounded blocks are at least as long as the spans in this rectangle, so that each span is one block.
bool takes_whole_spans(const BlockRule& rule, const ScreenRectangle& rectangle, int longest_log2,
                       const LinearQuantity<InverseZ>& inverse_z) {
    const auto beyond_first = static_cast<std::uint32_t>(rectangle.end_column - rectangle.first_column - 1);
    const int log2 = std::max(static_cast<int>(std::bit_width(beyond_first)), kLeastBlockLog2);
    return log2 <= longest_log2 &&
           least_inverse_z(inverse_z, rectangle) >= block_threshold(rule, inverse_z.per_column, log2);
}

/// Sets the lengths of blocks for Texturing::Bounded, limited by longest_block_log2().
void limit_blocks(const BlockRule& rule, const ScreenRectangle& rectangle, TexturedFace& face) {
    BlockCutting& cutting = face.cutting;
    const LinearQuantity<InverseZ>& inverse_z = cutting.gradients.inverse_z;
    const int longest = longest_block_log2(rule, floor_shift(face.texels_per_pixel, face.surface.mip));
    cutting.takes_whole_spans = cutting.fits_range && takes_whole_spans(rule, rectangle, longest, inverse_z);
    if (!cutting.takes_whole_spans) cutting.thresholds = make_block_thresholds(rule, inverse_z.per_column, longest);
    cutting.limits.least = std::min(cutting.limits.least, Texel::from_raw(std::int64_t{1} << longest));
}

/// Returns a rectangle around spans of a face, and sets fits_range for it. If the face's bounds fit, they are used,
/// which saves a pass over the spans.
ScreenRectangle cutting_rectangle(const VisibleFace& face, std::span<const Span> spans, BlockCutting& cutting) {
    const ScreenRectangle& bounds = face.bounds;
    cutting.fits_range = fits_range(cutting.gradients, bounds);
    if (cutting.fits_range) return bounds;
    const ScreenRectangle around = rectangle_around(spans);
    cutting.fits_range = fits_range(cutting.gradients, around);
    return around;
}

/// Whether 1/z is above `least` on the whole face.
bool is_above(InverseZ least, View farthest_z) {
    return product<InverseZ>(least, farthest_z) < InverseZ::from_int(1);
}

/// Splits a span where 1/z crosses `least`.
void split_at(InverseZ least, const Span& span, const LinearQuantity<InverseZ>& inverse_z, std::vector<Span>& above,
              std::vector<Span>& below) {
    const InverseZ first = inverse_z.at(span.first, span.y), last = inverse_z.at(span.end - 1, span.y);
    const bool begins_above = first >= least;
    std::vector<Span>& beginning = begins_above ? above : below;
    if (begins_above == (last >= least)) return beginning.push_back(span);
    const InverseZ way = begins_above ? first - least : least - std::max(first, InverseZ{}) - InverseZ::ulp();
    const std::int64_t steps = way / absolute(inverse_z.per_column);
    const auto middle = static_cast<std::int32_t>(std::min<std::int64_t>(span.first + steps + 1, span.end - 1));
    beginning.push_back({span.y, span.first, middle});
    (begins_above ? below : above).push_back({span.y, middle, span.end});
}

/// Draws blocks where they are long enough, otherwise pixel by pixel.
void draw_bounded(const TexturedFace& face, std::span<const Span> spans, const SpanTarget& target) {
    const SpanTexturing& texturing = target.texturing;
    const BlockCutting& cutting = face.cutting;
    const InverseZ least = item(cutting.thresholds.least_inverse_z, kLeastBlockLog2);
    if (cutting.takes_whole_spans || !texturing.divides_exactly || is_above(least, face.face.farthest_z))
        return draw_blocks(face, spans, texturing.cut_blocks, cutting, target);
    std::vector<Span>&block_spans = target.scratch.block_spans, &pixel_spans = target.scratch.pixel_spans;
    block_spans.clear();
    pixel_spans.clear();
    for (const Span& span : spans) split_at(least, span, cutting.gradients.inverse_z, block_spans, pixel_spans);
    draw_blocks(face, block_spans, texturing.cut_blocks, cutting, target);
    divide_at_each_pixel(face, pixel_spans, target);
}

}  // namespace

void set_cutting(TexturedFace& face, std::span<const Span> spans, const SpanTexturing& texturing) {
    BlockCutting& cutting = face.cutting;
    cutting.limits = face.surface.limits;
    const ScreenRectangle rectangle = cutting_rectangle(face.face, spans, cutting);
    if (texturing.texturing == Texturing::Bounded) limit_blocks(texturing.rule, rectangle, face);
    if (texturing.texturing == Texturing::Affine) cutting.takes_whole_spans = cutting.fits_range;
    cutting.texel_bound_256 = texturing.rule.texel_bound_256;
}

void draw_textured(const TexturedFace& face, std::span<const Span> spans, const SpanTarget& target) {
    const SpanTexturing& texturing = target.texturing;
    if (texturing.texturing == Texturing::Bounded) return draw_bounded(face, spans, target);
    if (texturing.texturing == Texturing::Exact && texturing.divides_exactly)
        return divide_at_each_pixel(face, spans, target);
    draw_blocks(face, spans, texturing.cut_blocks, face.cutting, target);
}

void draw_surface(const VisibleFace& claimed, std::span<const Span> spans, const SurfaceOptions& options,
                  const FrameContext& frame, ViewScratch& scratch) {
    const Level& level = frame.scene.level;
    if (!frame.accuracy().textures_floors && options.is_plain && is_level(level.faces[claimed.face], level))
        return draw_in_one_colour(claimed, spans, options, frame, scratch);
    const MipSelection selection = frame.accuracy().mip;
    if (selection == MipSelection::Span) return draw_by_span_mips(claimed, spans, options, frame, scratch);
    const bool is_chosen = selection == MipSelection::Face;
    const int mip = is_chosen ? mip_level(claimed.face, claimed.nearest_z, frame) : 0;
    draw_mip(claimed, mip, spans, options, frame, scratch);
}

void draw_surfaces(std::span<const VisibleFace> faces, const SurfaceOptions& options, const FrameContext& frame,
                   ViewScratch& scratch) {
    for (const VisibleFace& claimed : faces) {
        const SampledStopwatch of_models(claimed.fragment ? frame.observers.times : nullptr, Effect::BrushModels);
        draw_surface(claimed, scratch.claims.spans_of(claimed), options, frame, scratch);
    }
}

void draw_walls(const FrameContext& frame, ViewScratch& scratch) {
    Claims& claims = scratch.claims;
    const std::span<const VisibleFace> walls = claims.list(FaceList::Walls);
    draw_surfaces(walls.subspan(std::exchange(claims.walls_drawn, walls.size())), {}, frame, scratch);
}

LinearQuantity<InverseZ> inverse_z_of(const VisibleFace& face, const FrameContext& frame) {
    const std::int32_t bits = frame.accuracy().inverse_z_bits;
    const LinearQuantity<InverseZ>& inverse_z = face.inverse_z;
    return bits == InverseZ::kFractionBits ? inverse_z : rounded_to(inverse_z, bits);
}

}  // namespace oblong
