#include "engine/frame/see_through_pass.h"

#include <algorithm>
#include <utility>

#include "engine/frame/fog_pass.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"
#include "engine/level/side.h"

namespace oblong {

namespace {

bool is_behind(const Vec3<World>& place, const ClaimedFace& claimed, const Level& level, const FrameWorkspace& work) {
    const Face& face = level.faces[claimed.visible.face];
    const Vec3<World> offset = work.brush_models.offset_of(claimed.visible.fragment);
    return (plane_distance(level.planes[face.plane], place - offset) > PlaneDistance{}) == face.is_back;
}

/// Draws the things that wait, those behind a face alone if there is one.
void draw_waiting(const ClaimedFace* face, std::vector<OwningThing>& waiting, const FrameContext& frame,
                  FrameWorkspace& work) {
    std::erase_if(waiting, [&](const OwningThing& thing) {
        if (face && !is_behind(thing.middle, *face, frame.scene.level, work)) return false;
        draw_thing(thing, frame, work);
        return true;
    });
}

/// The table of a liquid's share, made when a frame first calls for it.
const BlendTable& blend_of(LiquidKind kind, const FrameContext& frame, FrameWorkspace& work) {
    std::unique_ptr<BlendTable>& table = work.blends[static_cast<std::size_t>(kind)];
    const std::int32_t share_256 = work.effects.liquid_alpha_256[static_cast<std::size_t>(kind)];
    if (!table) table = std::make_unique<BlendTable>(make_blend_table(frame.scene.colormap.palette, share_256));
    return *table;
}

/// Draws a face's spans; in fog, those of each level with its colours.
void draw_in_fog(const ClaimedFace& claimed, SurfaceDrawing drawing, const FrameContext& frame, const FrameFog& fog,
                 FrameWorkspace& work) {
    drawing.colours = &frame.scene.colormap.shades[Colormap::kOwnShade];
    std::vector<Span> before_meshes;
    std::span<const Span> spans = work.claims.spans_of(claimed);
    if (!work.claims.things.meshes.empty() && work.depth.touches(spans)) {
        work.depth.append_seen(spans, gradients_of(claimed.visible, FaceSurface{}, frame, work).inverse_z,
                               before_meshes);
        spans = before_meshes;
    }
    if (spans.empty()) return;
    if (!fog.tables) return draw_surface(claimed, spans, drawing, frame, work);
    std::vector<FogRun> runs;
    append_runs(spans, gradients_of(claimed.visible, FaceSurface{}, frame, work).inverse_z, fog, runs);
    std::stable_sort(runs.begin(), runs.end(), [](const FogRun& a, const FogRun& b) { return a.level < b.level; });
    std::vector<Span> of_level;
    for (auto run = runs.begin(); run != runs.end();) {
        const std::int32_t level = run->level;
        of_level.clear();
        for (; run != runs.end() && run->level == level; ++run) of_level.push_back(run->span);
        drawing.colours = &fog.tables->colours.levels[static_cast<std::size_t>(level)];
        draw_surface(claimed, of_level, drawing, frame, work);
    }
}

void draw_face(const ClaimedFace& claimed, const FrameContext& frame, const FrameFog& fog, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    const FaceIndex face = claimed.visible.face;
    const bool is_liquid = work.faces.faces[face].effects.has(Effect::Liquid);
    const Stopwatch watch(work.times.get(), is_liquid ? Effect::Translucency : Effect::Fence);
    SurfaceDrawing drawing;
    drawing.is_plain = false;
    drawing.traits.warps = drawing.traits.blends = is_liquid;
    drawing.traits.has_holes = !is_liquid;
    if (is_liquid)
        drawing.blend = &blend_of(liquid_kind_of_texture(level.texture_of(level.faces[face]).name), frame, work);
    draw_in_fog(claimed, drawing, frame, fog, work);
}

}  // namespace

void draw_see_through(const FrameContext& frame, const FrameFog& fog, FrameWorkspace& work) {
    // What is behind these faces is what counts and records say of their pixels.
    auto counts = std::exchange(work.counts, nullptr);
    auto record = std::exchange(work.record, nullptr);
    std::vector<OwningThing> waiting = std::move(work.claims.things.owning);
    const std::vector<ClaimedFace>& faces = work.claims.list(FaceList::SeeThrough);
    for (auto face = faces.rbegin(); face != faces.rend(); ++face) {
        if (!waiting.empty()) draw_waiting(&*face, waiting, frame, work);
        draw_face(*face, frame, fog, work);
    }
    draw_waiting(nullptr, waiting, frame, work);
    work.counts = std::move(counts);
    work.record = std::move(record);
}

}  // namespace oblong
