#include "engine/frame/frame_things.h"

#include <algorithm>

#include "engine/frame/fog_pass.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"

namespace oblong {

namespace {

/// How dark a shadow is, and the share of its radius up to which it is that dark, 256: all of it.
constexpr int kShadowShade = Colormap::kOwnShade + 12;
constexpr std::int32_t kWholeRadius_8 = 256, kCoreRadius_8 = 160;

void find_dots(const FrameContext& frame, FrameWorkspace& work) {
    FrameThings& things = work.claims.things;
    for (const PlacedEmitter& placed : work.things.emitters) {
        if (!may_be_seen(placed.place, work.visible, frame.view)) continue;
        const std::size_t first = things.dots.size();
        append_dots(placed.emitter, frame.scene.time_ms, frame.view, things.dots);
        const std::span<const ParticleDot> dots = std::span(things.dots).subspan(first);
        if (dots.empty()) continue;
        work.depth.want(rectangle_around(dots));
        things.found.push_back({placed.emitter.middle, static_cast<std::uint32_t>(first),
                                static_cast<std::uint32_t>(dots.size()), std::nullopt, nullptr});
    }
}

void find_sprite(const Sprite& sprite, const PlacedBox& place, const FrameContext& frame, FrameWorkspace& work) {
    if (!may_be_seen(place, work.visible, frame.view)) return;
    const auto on_screen = project_sprite(sprite, frame.scene.level.textures[sprite.texture], frame.view);
    if (!on_screen) return;
    work.depth.want(on_screen->pixels);
    work.claims.things.found.push_back(
        {sprite.position, 0, 0, on_screen, frame.scene.colormap.shades[Colormap::kOwnShade].data()});
}

void find_sprites(const FrameContext& frame, FrameWorkspace& work) {
    for (const PlacedSprite& placed : work.things.sprites) find_sprite(placed.sprite, placed.place, frame, work);
    for (const PlacedLantern& placed : work.things.lanterns)
        find_sprite(lantern_at(placed.lantern, frame.scene.time_ms), placed.place, frame, work);
}

/// Sets the depth of all pixels that things may cover.
void fill_depth(const FrameContext& frame, FrameWorkspace& work) {
    work.depth.clear();
    for (const FaceList list : {FaceList::Walls, FaceList::Flat, FaceList::Liquid, FaceList::Mirror})
        for (const ClaimedFace& claimed : work.claims.list(list)) {
            const std::span<const Span> spans = work.claims.spans_of(claimed);
            if (!work.depth.touches(spans)) continue;
            work.depth.fill(spans, gradients_of(claimed.visible, FaceSurface{}, frame, work).inverse_z);
        }
}

/// The pixels of a rectangle at which nothing is nearer.
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

InverseDepth middle_depth(const ScreenSprite& sprite) {
    const std::int64_t rows = (sprite.pixels.end_row - sprite.pixels.first_row) / 2;
    return static_cast<InverseDepth>((sprite.inverse_depth_16 + rows * sprite.inverse_depth_step_16) >> 16);
}

InverseZ inverse_z_of(InverseDepth depth) {
    return InverseZ::from_raw(std::int64_t{depth} << (InverseZ::kFractionBits - 32));
}

/// Leaves out what faces hide, and counts the pixels of the rest.
void keep_visible(FrameWorkspace& work) {
    FrameThings& things = work.claims.things;
    std::int64_t dot_pixels = 0, sprite_pixels = 0;
    std::erase_if(things.found, [&](const FoundThing& thing) {
        std::int64_t pixels = 0;
        for (const ParticleDot& dot : std::span(things.dots).subspan(thing.first_dot, thing.dot_count))
            pixels += visible_pixels(dot, work.depth);
        if (thing.sprite) pixels += visible_pixels(thing.sprite->pixels, middle_depth(*thing.sprite), work.depth);
        (thing.sprite ? sprite_pixels : dot_pixels) += pixels;
        return pixels == 0;
    });
    EffectSet& effects = work.claims.effects;
    if (dot_pixels > 0) effects = effects.with(Effect::Particles);
    if (sprite_pixels > 0) effects = effects.with(Effect::Sprites);
    if (!work.counts) return;
    work.counts->of(Effect::Particles) = dot_pixels;
    work.counts->of(Effect::Sprites) = sprite_pixels;
}

void colour_by_fog(const FrameFog& fog, FrameWorkspace& work) {
    FrameThings& things = work.claims.things;
    for (FoundThing& thing : things.found) {
        for (ParticleDot& dot : std::span(things.dots).subspan(thing.first_dot, thing.dot_count))
            dot.colour =
                fog_colours(dot.first_column, dot.first_row, inverse_z_of(dot.inverse_depth), fog, work)[dot.colour];
        if (!thing.sprite) continue;
        const ScreenRectangle& pixels = thing.sprite->pixels;
        thing.colours =
            fog_colours((pixels.first_column + pixels.end_column) / 2, (pixels.first_row + pixels.end_row) / 2,
                        inverse_z_of(middle_depth(*thing.sprite)), fog, work)
                .data();
    }
}

/// How many pixels of spans are within scanned rows.
std::int64_t pixels_within(std::span<const Span> spans, const ScanlineExtents& rows) {
    std::int64_t pixels = 0;
    for (const Span& span : spans) {
        if (span.y < rows.first || span.y >= rows.end) continue;
        const std::int32_t first = std::max(span.first, at(rows.left, span.y));
        pixels += std::max(std::min(span.end, at(rows.right, span.y)) - first, 0);
    }
    return pixels;
}

/// Whether a pixel of a shadow's floor is in it.
bool is_seen(const Shadow& shadow, const FrameContext& frame, FrameWorkspace& work) {
    if (!scan_shadow(shadow, kWholeRadius_8, frame.scene.level, frame.view, work.shadows)) return false;
    std::int64_t pixels = 0;
    for (const ClaimedFace& claimed : work.claims.list(FaceList::Walls))
        if (frame.scene.level.faces[claimed.visible.face].plane == shadow.floor.plane && !claimed.visible.fragment)
            pixels += pixels_within(work.claims.spans_of(claimed), work.shadows.rows);
    if (work.counts) work.counts->of(Effect::Shadows) += pixels;
    return pixels > 0;
}

void find_shadows(const FrameContext& frame, FrameWorkspace& work) {
    std::vector<Shadow>& shadows = work.claims.things.shadows;
    for (const PlacedSprite& placed : work.things.sprites) {
        if (!placed.floor) continue;
        const Shadow shadow = make_shadow(*placed.floor, placed.sprite.position, placed.shadow_radius);
        if (is_seen(shadow, frame, work)) shadows.push_back(shadow);
    }
    if (!shadows.empty()) work.claims.effects = work.claims.effects.with(Effect::Shadows);
}

}  // namespace

void find_things(const FrameContext& frame, const FrameFog& fog, FrameWorkspace& work) {
    work.depth.start_frame();
    if (frame.allows(Effect::Particles)) find_dots(frame, work);
    if (frame.allows(Effect::Sprites)) find_sprites(frame, work);
    if (frame.allows(Effect::Shadows)) find_shadows(frame, work);
    if (!work.depth.is_wanted()) return;
    fill_depth(frame, work);
    keep_visible(work);
    if (fog.tables) colour_by_fog(fog, work);
}

void draw_thing(const FoundThing& thing, const FrameContext& frame, FrameWorkspace& work) {
    const Stopwatch watch(work.times.get(), thing.sprite ? Effect::Sprites : Effect::Particles);
    if (thing.sprite) return draw_sprite(*thing.sprite, thing.colours, work.depth, frame.out);
    draw_dots(std::span(work.claims.things.dots).subspan(thing.first_dot, thing.dot_count), work.depth, frame.out);
}

void draw_shadows(const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const std::uint8_t* const shade = frame.scene.colormap.shades[kShadowShade].data();
    for (const Shadow& shadow : work.claims.things.shadows)
        for (const std::int32_t share_8 : {kWholeRadius_8, kCoreRadius_8}) {
            if (!scan_shadow(shadow, share_8, level, frame.view, work.shadows)) continue;
            for (const ClaimedFace& claimed : work.claims.list(FaceList::Walls))
                if (level.faces[claimed.visible.face].plane == shadow.floor.plane && !claimed.visible.fragment)
                    darken_spans(work.claims.spans_of(claimed), work.shadows.rows, shade, frame.out);
        }
}

}  // namespace oblong
