#include "engine/frame/claim_faces.h"

#include <algorithm>
#include <tuple>

#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/workspace.h"
#include "engine/raster/scan.h"
#include "engine/visibility/fragments.h"

namespace oblong {

namespace {

/// The corners of a face of the world, with those at T-junctions if the dial mends them.
inline std::span<const VertexIndex> corners_of(FaceIndex index, const FrameContext& frame, CornerScratch& scratch) {
    if (frame.accuracy().mends_t_junctions) return frame.cache.faces.corners_of(index);
    const Level& level = frame.scene.level;
    scratch.own.clear();
    for (const SurfEdge step : level.edges_of(level.faces[index])) scratch.own.push_back(level.start_of(step));
    return scratch.own;
}

/// Clips a projected face to the frame's limits, in the world, and if they cut it projects what is left. False if that
/// is out of view or nothing. A face in the plane of a limit counts as outside, so a mirror is not in its own picture.
bool clip_to_limits(const VisibleFace& face, const FrameContext& frame, ClaimScratch& scratch) {
    std::vector<Vec3<World>>& corners = scratch.corners.world;
    world_corners(face, frame, scratch.corners);
    bool is_cut = false;
    for (const WalkLimit& limit : frame.limits) {
        const PolygonSide side = polygon_side(limit.plane, limit.offset, corners, scratch.corners.distances);
        if (side == (limit.is_back ? PolygonSide::Back : PolygonSide::Front)) continue;
        if (side != PolygonSide::Both) return false;
        const auto count = static_cast<std::ptrdiff_t>(corners.size());
        append_part(corners, 0, scratch.corners.distances, !limit.is_back);  // after the old corners
        corners.erase(corners.begin(), corners.begin() + count);
        is_cut = true;
    }
    return !is_cut || project_polygon(corners, frame.view, scratch.polygon);
}

/// Transforms, clips and projects the corners. False if the face is out of view or outside the limits.
bool project(const VisibleFace& face, bool may_reach_limits, const FrameContext& frame, ClaimScratch& scratch) {
    if (frame.observers.counts) ++frame.observers.counts->faces_visited;
    const bool is_in_view = face.fragment ? project_polygon(frame.cache.brush_models.corners_of(*face.fragment),
                                                            frame.view, scratch.polygon)
                                          : project_face(corners_of(face.face, frame, scratch.corners), frame.view,
                                                         scratch.vertices, scratch.polygon);
    return is_in_view && (!may_reach_limits || clip_to_limits(face, frame, scratch));
}

/// Scans the projected face, except rows at its top and bottom without free pixels. False if no row is left.
bool scan(const FrameContext& frame, ClaimScratch& scratch) {
    const std::span<const ScreenVertex> corners = scratch.polygon.vertices;
    const PolygonShape shape = shape_of(corners, frame.out.height_px, frame.accuracy().edges);
    const PixelRange rows = scratch.span_buffer.rows_with_free(shape.bounds);
    if (rows.first >= rows.end) return false;
    scan_convex(corners, shape, rows, scratch.rows);
    return true;
}

/// 1/z of a face; reused from the previous face if both are on the same side of a plane.
PlaneInverseZ inverse_z_after(const VisibleFace& visible, const FrameContext& frame, LastPlane& last) {
    const Face& face = frame.scene.level.faces[visible.face];
    const auto computed = [&] {
        return make_face_inverse_z(frame.scene.level, face, frame.offset_of(visible), frame.view,
                                   frame.inverse_projection);
    };
    if (visible.fragment) return computed();
    if (last.plane != face.plane || last.is_back != face.is_back) last = {face.plane, face.is_back, computed()};
    return last.inverse_z;
}

/// The next face of the walk.
bool next_face(FrontToBackWalk& walk, PassTimes* times, VisibleFace& found) {
    const SampledStopwatch watch(times, &PassTimes::walk_ns);
    return walk.next(found);
}

}  // namespace

std::span<const Vec3<World>> world_corners(const VisibleFace& face, const FrameContext& frame, CornerScratch& scratch) {
    std::vector<Vec3<World>>& corners = scratch.world;
    corners.clear();
    if (face.fragment) {
        const auto own = frame.cache.brush_models.corners_of(*face.fragment);
        corners.assign(own.begin(), own.end());
    } else {
        for (const VertexIndex corner : corners_of(face.face, frame, scratch))
            corners.push_back(frame.scene.level.vertices[corner]);
    }
    return corners;
}

FacesInView::FacesInView(const FrameContext& frame, ViewScratch& scratch)
    : frame_(frame),
      scratch_(*scratch.claiming),
      walk_(frame.scene.level, frame.view, scratch.visible,
            frame.allows(Effect::BrushModels) ? &frame.cache.brush_models : nullptr, scratch_.span_buffer,
            scratch_.walk, frame.limits, frame.cache.faces.torn_edges == 0) {}

FacesInView::~FacesInView() {
    if (FrameCounts* const counts = frame_.observers.counts)
        count_walk(walk_.nodes_tested(), scratch_.vertices.count(), counts->stages);
}

bool FacesInView::next(VisibleFace& found) {
    const FrameObservers& observers = frame_.observers;
    while (next_face(walk_, observers.times, found)) {
        const SampledStopwatch of_models(found.fragment ? observers.times : nullptr, Effect::BrushModels);
        if (!project(found, walk_.may_reach_limits(), frame_, scratch_) || !scan(frame_, scratch_)) continue;
        if (observers.counts) count_polygon(scratch_.polygon, scratch_.rows, observers.counts->stages);
        return true;
    }
    return false;
}

void claim_face(VisibleFace& face, bool is_second_walk, const FrameContext& frame, ViewScratch& scratch) {
    const EffectSet needs = frame.cache.faces[face.face].effects;
    const bool is_seen_through = list_for(needs, frame.settings.allowed_effects) == FaceList::SeeThrough;
    if (is_seen_through && is_second_walk) return;
    ClaimScratch& claiming = *scratch.claiming;
    Claims& claims = scratch.claims;
    const std::size_t first = claims.spans.size();
    std::tie(face.nearest_z, face.farthest_z) = claiming.polygon.z_range();
    face.bounds = {std::max(claiming.rows.columns.first, 0), std::min(claiming.rows.columns.end, frame.out.width_px),
                   claiming.rows.first, claiming.rows.end};
    if (is_seen_through)
        claiming.span_buffer.find_free(claiming.rows, claims.spans);
    else
        claiming.span_buffer.claim(claiming.rows, claims.spans);
    add_claimed(face, first, frame, claims);
}

void add_claimed(const VisibleFace& face, std::size_t first_span, const FrameContext& frame, Claims& claims) {
    if (claims.spans.size() == first_span) return;
    const EffectSet needs = frame.cache.faces[face.face].effects, allowed = frame.settings.allowed_effects;
    const EffectSet effects = face.fragment ? needs.with(Effect::BrushModels) : needs;
    const FaceList list = list_for(needs, allowed);
    VisibleFace& added = claims.list(list).emplace_back(face);
    added.first_span = static_cast<std::uint32_t>(first_span);
    added.span_count = static_cast<std::uint32_t>(claims.spans.size() - first_span);
    // Faces without texels need it only for other effects: fog, and things before and behind them.
    if (list != FaceList::Sky && (list != FaceList::Flat || allowed != EffectSet{}))
        added.inverse_z = inverse_z_after(face, frame, claims.last_plane);
    claims.effects = claims.effects | (effects & allowed);
    if (frame.observers.counts) count_face(effects, claims.spans_of(added), *frame.observers.counts);
}

void claim_faces(const FrameContext& frame, ViewScratch& scratch) {
    FacesInView faces(frame, scratch);
    VisibleFace face;
    while (faces.next(face)) {
        claim_face(face, faces.is_second_walk(), frame, scratch);
        if (frame.shared && frame.shared->takes_walls_at_once) draw_walls(frame, scratch);
    }
}

}  // namespace oblong
