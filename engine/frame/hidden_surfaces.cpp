#include "engine/frame/hidden_surfaces.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"
#include "engine/level/side.h"
#include "engine/visibility/painter.h"
#include "engine/visibility/z_buffer.h"

namespace oblong {

namespace {

/// Sets the plane of a face from its front.
void set_plane(const FrameContext& frame, const FrameWorkspace& work, ScannedFace& scanned) {
    const Level& level = frame.scene.level;
    const Face& face = level.faces[scanned.visible.face];
    const LevelPlane& plane = level.planes[face.plane];
    const Vec3<World> eye = frame.view.eye - work.brush_models.offset_of(scanned.visible.fragment);
    const PlaneDistance distance = plane_distance(plane, eye);
    scanned.normal = face.is_back ? -plane.normal : plane.normal;
    scanned.eye_distance = face.is_back ? -distance : distance;
    scanned.inverse_z = gradients_of(scanned.visible, FaceSurface{}, frame, work).inverse_z;
}

void paint(std::span<const std::int32_t> back_to_front, HiddenSurfaceScratch& scratch) {
    find_owners_by_painting(scratch.scanned, back_to_front, scratch.owners);
}

void paint_by(SortDepth depth, HiddenSurfaceScratch& scratch) {
    paint(back_to_front_by_depth(scratch.scanned, depth, scratch.owners.counts.order_comparisons), scratch);
}

/// Finds the owner of each pixel.
void find_owners(const FrameContext& frame, HiddenSurfaceScratch& scratch) {
    scratch.owners.counts.faces_scanned = std::ssize(scratch.scanned.faces);
    switch (frame.settings.hidden_surfaces) {
        case HiddenSurfaces::SpanBuffer:
            break;
        case HiddenSurfaces::ZBuffer:
            find_owners_by_z_buffer(scratch.scanned, scratch.depths, scratch.owners);
            break;
        case HiddenSurfaces::Painter:
            paint(back_to_front_by_tree(scratch.scanned), scratch);
            break;
        case HiddenSurfaces::PainterSorted:
            paint_by(SortDepth::Farthest, scratch);
            break;
        case HiddenSurfaces::PainterMean:
            paint_by(SortDepth::Mean, scratch);
            break;
        case HiddenSurfaces::RayCasting:
            find_owners_by_rays(scratch.scanned, make_view_directions(frame.view.rays, frame.view.projection),
                                scratch.targets, scratch.owners);
            break;
    }
}

/// Claims a face's own runs for it.
void claim_runs(const ScannedFace& face, std::span<const OwnedRun> runs, const FrameContext& frame,
                FrameWorkspace& work) {
    Claims& claims = work.claims;
    const std::size_t first = claims.spans.size();
    for (const auto& [index, span] : runs) {
        if (face.is_seen_through)
            claims.spans.push_back(span);
        else
            work.span_buffer.claim(span.y, span.first, span.end, claims.spans);
    }
    if (claims.spans.size() == first) return;
    const EffectSet needs = work.faces.faces[face.visible.face].effects, allowed = frame.settings.allowed_effects;
    const EffectSet effects = face.visible.fragment ? needs.with(Effect::BrushModels) : needs;
    claims.add(list_for(needs, allowed), {face.visible, 0, 0, face.nearest_z, face.farthest_z}, first);
    claims.effects = claims.effects | (effects & allowed);
    if (work.counts) count_face(effects, std::span<const Span>(claims.spans).subspan(first), *work.counts);
}

}  // namespace

void start_scanned_faces(FrameWorkspace& work) {
    if (!work.hidden_surfaces) work.hidden_surfaces = std::make_unique<HiddenSurfaceScratch>();
    work.hidden_surfaces->scanned.clear();
}

void add_scanned_face(const VisibleFace& visible, std::span<const Vec3<World>> corners, const FrameContext& frame,
                      FrameWorkspace& work) {
    const EffectSet needs = work.faces.faces[visible.face].effects;
    ScannedFace scanned;
    scanned.visible = visible;
    scanned.nearest_z = work.polygon.nearest_z;
    scanned.farthest_z = work.polygon.farthest_z;
    scanned.is_seen_through = list_for(needs, frame.settings.allowed_effects) == FaceList::SeeThrough;
    set_plane(frame, work, scanned);
    add_face(scanned, work.rows, frame.out.width_px, corners, frame.view.eye, work.hidden_surfaces->scanned);
}

void claim_owned(const FrameContext& frame, FrameWorkspace& work) {
    HiddenSurfaceScratch& scratch = *work.hidden_surfaces;
    scratch.owners.start(frame.out.width_px, frame.out.height_px);
    find_owners(frame, scratch);
    if (work.counts) work.counts->hidden_surfaces = scratch.owners.counts;
    const std::vector<OwnedRun> runs = owned_runs(scratch.owners);
    for (auto run = runs.begin(); run != runs.end();) {
        const auto end = std::find_if(run, runs.end(), [&](const OwnedRun& next) { return next.face != run->face; });
        claim_runs(at(scratch.scanned.faces, run->face), {&*run, static_cast<std::size_t>(end - run)}, frame, work);
        run = end;
    }
}

}  // namespace oblong
