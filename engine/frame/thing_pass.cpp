#include "engine/frame/thing_pass.h"

#include <algorithm>

#include "engine/frame/face_cover.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/mesh_pass.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

/// The shade of a shadow; the radii of its edge and its darker core, as shares of its radius (256: 1).
constexpr int kShadowShade = Colormap::kOwnShade + 12;
constexpr std::int32_t kWholeRadius_8 = 256, kCoreRadius_8 = 160;

std::span<ParticleDot> dots_of(FrameThings& things, std::size_t first, std::size_t count) {
    return std::span(things.in_view.dots).subspan(first, count);
}

/// Sets the depth of all pixels that things may cover.
void fill_depth(const FrameContext& frame, ViewScratch& scratch) {
    scratch.depth.clear();
    for (const FaceList list : {FaceList::Walls, FaceList::Flat, FaceList::Liquid, FaceList::Mirror})
        for (const VisibleFace& claimed : scratch.claims.list(list)) {
            const std::span<const Span> spans = scratch.claims.spans_of(claimed);
            if (!scratch.depth.touches(spans, claimed.bounds)) continue;
            scratch.depth.fill(spans, inverse_z_of(claimed, frame));
        }
}

/// The number of a rectangle's pixels where nothing is nearer.
std::int64_t visible_pixels(const ScreenRectangle& pixels, InverseDepth inverse_depth, DepthBuffer& depth) {
    std::int64_t count = 0;
    for (std::int32_t y = pixels.first_row; y < pixels.end_row; ++y) {
        const InverseDepth* const row = depth.row(y);
        count += std::count_if(row + pixels.first_column, row + pixels.end_column,
                               [inverse_depth](InverseDepth face) { return face <= inverse_depth; });
    }
    return count;
}

std::int64_t visible_pixels(const ParticleDot& dot, DepthBuffer& depth) {
    return visible_pixels({dot.first_column, dot.end_column, dot.first_row, dot.end_row}, dot.inverse_depth, depth);
}

InverseZ inverse_z_of(InverseDepth depth) {
    return InverseZ::from_raw(std::int64_t{depth} << (InverseZ::kFractionBits - 32));
}

/// Keeps the things that faces do not wholly hide, and counts their pixels.
void keep_visible(const FrameContext& frame, ViewScratch& scratch) {
    FrameThings& things = scratch.claims.things;
    std::int64_t dot_pixels = 0, sprite_pixels = 0;
    for (const EmitterInView& emitter : things.in_view.emitters) {
        std::int64_t pixels = 0;
        if (frame.mirror && is_behind(*frame.mirror, emitter.middle, frame.scene.level)) continue;
        for (const ParticleDot& dot : dots_of(things, emitter.first_dot, emitter.dot_count))
            pixels += visible_pixels(dot, scratch.depth);
        dot_pixels += pixels;
        if (pixels > 0)
            things.visible.push_back(
                {emitter.middle, emitter.lowest_z, emitter.first_dot, emitter.dot_count, nullptr, nullptr});
    }
    const std::uint8_t* const own_colours = frame.scene.colormap.shades[Colormap::kOwnShade].data();
    for (const SpriteInView& sprite : things.in_view.sprites) {
        if (frame.mirror && is_behind(*frame.mirror, sprite.position, frame.scene.level)) continue;
        const std::int64_t pixels =
            visible_pixels(sprite.screen.pixels, middle_inverse_depth(sprite.screen), scratch.depth);
        sprite_pixels += pixels;
        if (pixels > 0) things.visible.push_back({sprite.position, World::lowest(), 0, 0, &sprite.screen, own_colours});
    }
    if (dot_pixels > 0) scratch.claims.add(Effect::Particles, dot_pixels, frame.observers.counts);
    if (sprite_pixels > 0) scratch.claims.add(Effect::Sprites, sprite_pixels, frame.observers.counts);
}

/// Gives things the colours of fog, and adds its pixels on them.
void colour_by_fog(const FrameContext& frame, ViewScratch& scratch) {
    const FrameFog& fog = frame.fog;
    std::vector<FogRun>& runs = scratch.effects->fog_runs;
    FrameThings& things = scratch.claims.things;
    std::int64_t pixels = 0;
    const auto colours_at = [&](std::int32_t column, std::int32_t row, InverseDepth depth, auto visible_pixels_of) {
        const ColourRow& colours = fog_colours(column, row, inverse_z_of(depth), fog, runs);
        if (&colours != &fog.tables->colours(0) && (pixels == 0 || frame.observers.counts))
            pixels += visible_pixels_of();
        return colours.data();
    };
    for (VisibleThing& thing : things.visible) {
        if (is_clear(thing.lowest_z, fog, frame.view.eye)) continue;
        for (ParticleDot& dot : dots_of(things, thing.first_dot, thing.dot_count))
            dot.colour = colours_at(dot.first_column, dot.first_row, dot.inverse_depth,
                                    [&] { return visible_pixels(dot, scratch.depth); })[dot.colour];
        if (!thing.sprite) continue;
        const ScreenRectangle& drawn = thing.sprite->pixels;
        const InverseDepth depth = middle_inverse_depth(*thing.sprite);
        thing.colours = colours_at((drawn.first_column + drawn.end_column) / 2, (drawn.first_row + drawn.end_row) / 2,
                                   depth, [&] { return visible_pixels(drawn, depth, scratch.depth); });
    }
    if (pixels > 0) scratch.claims.add(Effect::Fog, pixels, frame.observers.counts);
}

/// The number of pixels of spans inside scanned rows.
std::int64_t pixels_within(std::span<const Span> spans, const ScanlineExtents& rows) {
    std::int64_t pixels = 0;
    for (const Span& span : spans) {
        if (span.y < rows.first || span.y >= rows.end) continue;
        const std::int32_t first = std::max(span.first, item(rows.left, span.y));
        pixels += std::max(std::min(span.end, item(rows.right, span.y)) - first, 0);
    }
    return pixels;
}

/// Whether a face is of a shadow's floor.
bool is_on_floor(const VisibleFace& claimed, const Shadow& shadow, const Level& level) {
    return level.faces[claimed.face].plane == shadow.floor.plane && !claimed.fragment;
}

/// Whether a shadow covers a pixel of its floor.
bool is_seen(const Shadow& shadow, const FrameContext& frame, ViewScratch& scratch) {
    const Level& level = frame.scene.level;
    const std::vector<VisibleFace>& walls = scratch.claims.list(FaceList::Walls);
    const auto is_floor = [&](const VisibleFace& claimed) { return is_on_floor(claimed, shadow, level); };
    if (std::none_of(walls.begin(), walls.end(), is_floor)) return false;
    if (!scan_shadow(shadow, kWholeRadius_8, level, frame.view, scratch.effects->shadows)) return false;
    std::int64_t pixels = 0;
    for (const VisibleFace& claimed : walls)
        if (is_floor(claimed)) pixels += pixels_within(scratch.claims.spans_of(claimed), scratch.effects->shadows.rows);
    if (frame.observers.counts) frame.observers.counts->of(Effect::Shadows) += pixels;
    return pixels > 0;
}

/// What decides which things are visible: the leaves that the walk entered; but things behind the sky are drawn in
/// front of it, and a walk does not enter leaves outside limits.
Sight sight_of(const FrameContext& frame, const ViewScratch& scratch, Cover& cover) {
    const ScreenRectangle* const drawn_part = frame.mirror ? &frame.mirror->pixels : nullptr;
    const LeafSet& visible = scratch.visible.leaf_set();
    if (!frame.limits.empty()) return {visible, frame.view, drawn_part, &cover};
    const bool has_sky = !scratch.claims.list(FaceList::Sky).empty();
    return {scratch.claiming->walk.entered, frame.view, drawn_part, &cover, has_sky ? &visible : nullptr};
}

void find_seen_shadows(const FrameContext& frame, ViewScratch& scratch) {
    ThingsInView& in_view = scratch.claims.things.in_view;
    find_shadows(in_view);
    std::vector<Shadow>& shadows = scratch.claims.things.shadows;
    for (const Shadow& shadow : in_view.shadows)
        if (is_seen(shadow, frame, scratch)) shadows.push_back(shadow);
    if (!shadows.empty()) scratch.claims.effects = scratch.claims.effects.with(Effect::Shadows);
}

}  // namespace

void find_things(const FrameContext& frame, ViewScratch& scratch) {
    scratch.depth.start_frame();
    if (frame.cache.things.is_empty() && frame.scene.meshes.empty()) return;
    ThingsInView& in_view = scratch.claims.things.in_view;
    const ThingsInSet& things = scratch.things;
    scratch.things.keep_up(frame.cache.things, scratch.visible);
    FaceCover cover(frame, scratch.claims, scratch.effects->open_faces);
    const Sight sight = sight_of(frame, scratch, cover);
    const std::int64_t time_ms = frame.scene.time_ms;
    const auto timed = [&](Effect effect, auto step) {
        if (!frame.allows(effect)) return;
        const Stopwatch watch(frame.observers.times, effect);
        step();
    };
    timed(Effect::Particles, [&] { find_particles(things, time_ms, sight, in_view, scratch.depth); });
    if (frame.observers.counts) frame.observers.counts->stages.particles = in_view.particles_computed;
    timed(frame.allows(Effect::Sprites) ? Effect::Sprites : Effect::Shadows,
          [&] { find_placed_sprites(things, sight, in_view); });
    timed(Effect::Sprites, [&] { find_sprites(things, time_ms, frame.scene.level, sight, in_view, scratch.depth); });
    if (!frame.scene.meshes.empty()) timed(Effect::Meshes, [&] { find_meshes(frame, sight, scratch); });
    timed(Effect::Shadows, [&] { find_seen_shadows(frame, scratch); });
    if (!scratch.depth.is_wanted()) return;
    fill_depth(frame, scratch);
    keep_visible(frame, scratch);
    timed(Effect::Meshes, [&] { keep_seen_meshes(frame, scratch); });
    if (frame.fog.tables) timed(Effect::Fog, [&] { colour_by_fog(frame, scratch); });
}

void draw_thing(const VisibleThing& thing, const FrameContext& frame, ViewScratch& scratch) {
    const Stopwatch watch(frame.observers.times, thing.sprite ? Effect::Sprites : Effect::Particles);
    if (thing.sprite) return draw_sprite(*thing.sprite, thing.colours, scratch.depth, frame.out);
    draw_dots(dots_of(scratch.claims.things, thing.first_dot, thing.dot_count), scratch.depth, frame.out);
}

void draw_shadows(const FrameContext& frame, ViewScratch& scratch) {
    const Level& level = frame.scene.level;
    const std::uint8_t* const shade = frame.scene.colormap.shades[kShadowShade].data();
    for (const Shadow& shadow : scratch.claims.things.shadows)
        for (const std::int32_t share_8 : {kWholeRadius_8, kCoreRadius_8}) {
            if (!scan_shadow(shadow, share_8, level, frame.view, scratch.effects->shadows)) continue;
            for (const VisibleFace& claimed : scratch.claims.list(FaceList::Walls))
                if (is_on_floor(claimed, shadow, level))
                    darken_spans(scratch.claims.spans_of(claimed), scratch.effects->shadows.rows, shade, frame.out);
        }
}

}  // namespace oblong
