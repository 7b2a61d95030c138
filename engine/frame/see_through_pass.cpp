#include "engine/frame/see_through_pass.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/frame_things.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/thing_pass.h"
#include "engine/frame/workspace.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

bool is_behind(const Vec3<World>& place, const VisibleFace& claimed, const FrameContext& frame) {
    const Face& face = frame.scene.level.faces[claimed.face];
    return is_behind(frame.scene.level.planes[face.plane], face.is_back, place - frame.offset_of(claimed));
}

/// Draws the waiting things; if there is a face, only those behind it.
void draw_waiting(const VisibleFace* face, std::vector<VisibleThing>& waiting, const FrameContext& frame,
                  ViewScratch& scratch) {
    std::erase_if(waiting, [&](const VisibleThing& thing) {
        if (face && !is_behind(thing.middle, *face, frame)) return false;
        draw_thing(thing, frame, scratch);
        return true;
    });
}

/// A blend table, made on first use.
const BlendTable& table_of(FaceBlend& blend, const FrameContext& frame) {
    // In its place: on the stack, DOS has no room for 64 KB more.
    if (!blend.table)
        blend.table.reset(new BlendTable(make_blend_table(frame.scene.colormap.palette, blend.alpha_256)));
    return *blend.table;
}

/// Draws a face's spans where no thing is nearer; in fog, level by level with its colours.
void draw_in_fog(const VisibleFace& claimed, SurfaceOptions drawing, const FrameContext& frame, ViewScratch& scratch) {
    drawing.colours = &frame.scene.colormap.shades[Colormap::kOwnShade];
    EffectScratch& own = *scratch.effects;
    std::span<const Span> spans = scratch.claims.spans_of(claimed);
    if (scratch.depth.touches(spans, claimed.bounds)) {
        own.in_front_spans.clear();
        scratch.depth.append_seen(spans, inverse_z_of(claimed, frame), own.in_front_spans);
        spans = own.in_front_spans;
    }
    if (spans.empty()) return;
    const FrameFog& fog = frame.fog;
    if (fog.tables) drawing.colours = &fog.tables->colours(0);
    if (!may_have_fog(claimed, spans, frame)) return draw_surface(claimed, spans, drawing, frame, scratch);
    std::vector<FogRun>& runs = own.fog_runs;
    runs.clear();
    append_runs(spans, inverse_z_of(claimed, frame), fog, runs);
    std::stable_sort(runs.begin(), runs.end(), [](const FogRun& a, const FogRun& b) { return a.level < b.level; });
    std::vector<Span>& of_level = own.fog_level_spans;
    for (auto run = runs.begin(); run != runs.end();) {
        const std::int32_t level = run->level;
        of_level.clear();
        for (; run != runs.end() && run->level == level; ++run) of_level.push_back(run->span());
        drawing.colours = &fog.tables->colours(level);
        if (level > 0) scratch.claims.add(Effect::Fog, pixels_of(of_level), frame.observers.counts);
        draw_surface(claimed, of_level, drawing, frame, scratch);
    }
}

void draw_face(const VisibleFace& claimed, const FrameContext& frame, ViewScratch& scratch) {
    const PreparedFace& face = frame.cache.faces[claimed.face];
    const bool is_liquid = face.effects.has(Effect::Liquid);
    const bool blends = face.blend > 0 && frame.allows(Effect::Translucency);
    PassTimes* const times = frame.observers.times;
    const Stopwatch watch(times, blends ? Effect::Translucency : Effect::Fence);
    const Stopwatch of_liquid(is_liquid ? times : nullptr, Effect::Liquid);
    SurfaceOptions drawing;
    drawing.is_plain = drawing.is_observed = false;  // counts and records are of what is behind these faces
    drawing.traits.warps = is_liquid;
    drawing.traits.blends = blends;
    drawing.traits.has_holes = face.effects.has(Effect::Fence);
    if (blends) drawing.blend = &table_of(item(frame.cache.blends, face.blend - 1), frame);
    draw_in_fog(claimed, drawing, frame, scratch);
}

}  // namespace

void draw_see_through(const FrameContext& frame, ViewScratch& scratch) {
    std::vector<VisibleThing>& waiting = scratch.claims.things.visible;
    const std::vector<VisibleFace>& faces = scratch.claims.list(FaceList::SeeThrough);
    for (auto face = faces.rbegin(); face != faces.rend(); ++face) {
        if (!waiting.empty()) draw_waiting(&*face, waiting, frame, scratch);
        draw_face(*face, frame, scratch);
    }
    draw_waiting(nullptr, waiting, frame, scratch);
}

}  // namespace oblong
