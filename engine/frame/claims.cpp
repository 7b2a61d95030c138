#include "engine/frame/claims.h"

#include "engine/frame/frame_context.h"
#include "engine/frame/workspace.h"
#include "engine/raster/scan.h"
#include "engine/visibility/model_cutter.h"

namespace oblong {

namespace {

/// The corners of a face, those at T-junctions only if the settings mend them.
std::span<const VertexIndex> corners_of(FaceIndex index, const FrameContext& frame, FrameWorkspace& work) {
    if (frame.accuracy().mends_t_junctions) return work.faces.corners_of(index);
    const Level& level = frame.scene.level;
    work.own_corners.clear();
    for (const SurfEdge step : level.edges_of(level.faces[index])) work.own_corners.push_back(level.start_of(step));
    return work.own_corners;
}

/// Copies the corners of a face into work.mirror.corners.
void copy_corners(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    std::vector<Vec3<World>>& corners = work.mirror.corners;
    corners.clear();
    if (visible.fragment) {
        const auto own = work.brush_models.corners_of(*visible.fragment);
        corners.assign(own.begin(), own.end());
        return;
    }
    for (const VertexIndex corner : corners_of(visible.face, frame, work))
        corners.push_back(frame.scene.level.vertices[corner]);
}

/// Whether the part of a projected face that is before the frame's mirror is in view; projects that part alone.
bool keep_before_mirror(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    const MirrorPlane& mirror = frame.mirror->plane;
    std::vector<Vec3<World>>& corners = work.mirror.corners;
    copy_corners(visible, frame, work);
    const PolygonSide side =
        polygon_side(frame.scene.level.planes[mirror.plane], mirror.offset, corners, work.mirror.distances);
    if (side != PolygonSide::Both) return side == (mirror.is_back ? PolygonSide::Back : PolygonSide::Front);
    const std::size_t count = corners.size();
    append_part(corners, 0, work.mirror.distances, !mirror.is_back);
    return project_polygon(std::span(corners).subspan(count), frame.view, work.polygon);
}

/// Transforms, clips and projects the corners into work.polygon. False if nothing of the face is in view.
bool project(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    if (work.counts) ++work.counts->faces_visited;
    const bool is_in_view =
        visible.fragment ? project_polygon(work.brush_models.corners_of(*visible.fragment), frame.view, work.polygon)
                         : project_face(corners_of(visible.face, frame, work), frame.view, work.vertices, work.polygon);
    return is_in_view && (!frame.mirror || keep_before_mirror(visible, frame, work));
}

/// The list of a face that calls for these effects. What is not allowed is drawn in one colour, or as a wall.
FaceList list_for(EffectSet needs, EffectSet allowed) {
    const EffectSet effects = needs & allowed;
    if (needs.has(Effect::Sky)) return effects.has(Effect::Sky) ? FaceList::Sky : FaceList::Flat;
    if (needs.has(Effect::Liquid) && !effects.has(Effect::Liquid)) return FaceList::Flat;
    if (effects.has(Effect::Translucency) || effects.has(Effect::Fence)) return FaceList::SeeThrough;
    if (effects.has(Effect::Liquid)) return FaceList::Liquid;
    return effects.has(Effect::Mirror) ? FaceList::Mirror : FaceList::Walls;
}

/// Adds a face to its list if spans were appended for it, from `first` on.
void add_claim(const VisibleFace& visible, std::size_t first, View nearest_z, View farthest_z,
               const FrameContext& frame, FrameWorkspace& work) {
    Claims& claims = work.claims;
    const std::size_t count = claims.spans.size() - first;
    if (count == 0) return;
    const EffectSet needs = work.faces.faces[visible.face].effects;
    const EffectSet effects = visible.fragment ? needs.with(Effect::BrushModels) : needs;
    claims.effects = claims.effects | (effects & frame.settings.allowed_effects);
    claims.list(list_for(needs, frame.settings.allowed_effects))
        .push_back(
            {visible, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count), nearest_z, farthest_z});
    if (work.counts) count_face(effects, std::span(claims.spans).subspan(first), *work.counts);
}

bool is_seen_through(const VisibleFace& visible, const FrameContext& frame, const FrameWorkspace& work) {
    return list_for(work.faces.faces[visible.face].effects, frame.settings.allowed_effects) == FaceList::SeeThrough;
}

/// Lets a face claim the pixels of the scanned rows that are free. The second walk comes again to faces that are seen
/// through: they have their pixels.
void claim_face(const VisibleFace& visible, bool is_second_walk, const FrameContext& frame, FrameWorkspace& work) {
    const bool stays_free = is_seen_through(visible, frame, work);
    if (stays_free && is_second_walk) return;
    Claims& claims = work.claims;
    const std::size_t first = claims.spans.size();
    if (stays_free)
        work.span_buffer.find_free(work.rows, claims.spans);
    else
        work.span_buffer.claim(work.rows, claims.spans);
    add_claim(visible, first, work.polygon.nearest_z, work.polygon.farthest_z, frame, work);
}

/// Whether a face is in view; its polygon and rows, if it is.
bool project_and_scan(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    if (!project(visible, frame, work)) return false;
    scan_convex(work.polygon.screen, work.rows, frame.accuracy().edges);
    if (work.counts) count_polygon(work.polygon, work.rows, work.counts->stages);
    return true;
}

/// The corners of a face that was projected; of its part before the mirror, if the frame is one's.
std::span<const Vec3<World>> projected_corners(const VisibleFace& visible, const FrameContext& frame,
                                               FrameWorkspace& work) {
    std::vector<Vec3<World>>& corners = work.mirror.corners;
    if (!frame.mirror) {
        copy_corners(visible, frame, work);
        return corners;
    }
    const std::size_t whole =
        visible.fragment ? visible.fragment->corner_count : corners_of(visible.face, frame, work).size();
    return std::span(corners).subspan(corners.size() > whole ? whole : 0);
}

/// Hands the faces the pixels that a method other than the span buffer found to be theirs; what has no owner stays
/// free.
void claim_owned(const FrameContext& frame, FrameWorkspace& work) {
    const ScannedFaces& scanned = work.hidden_surfaces->scanned;
    const std::vector<OwnedRun> runs = owned_runs(work.hidden_surfaces->owners);
    for (auto run = runs.begin(); run != runs.end();) {
        const ScannedFace& face = at(scanned.faces, run->face);
        const std::size_t first = work.claims.spans.size();
        for (const std::int32_t index = run->face; run != runs.end() && run->face == index; ++run) {
            if (face.is_seen_through)
                work.claims.spans.push_back(run->span);
            else
                work.span_buffer.claim(run->span.y, run->span.first, run->span.end, work.claims.spans);
        }
        add_claim(face.visible, first, face.nearest_z, face.farthest_z, frame, work);
    }
}

/// Takes the first of the two walks without the span buffer. The first face of the second, if there is one.
std::optional<VisibleFace> claim_first_walk(FrontToBackWalk& walk, const FrameContext& frame, FrameWorkspace& work) {
    start_scanned_faces(work);
    std::optional<VisibleFace> visible = walk.next();
    for (; visible && !walk.takes_all_faces(); visible = walk.next())
        if (project_and_scan(*visible, frame, work))
            add_scanned_face(*visible, is_seen_through(*visible, frame, work), projected_corners(*visible, frame, work),
                             frame, work);
    find_pixel_owners(frame, work);
    claim_owned(frame, work);
    return visible;
}

/// A walk stays before a mirror; one that moves with its model sets no limit.
WalkLimit limit_of(const MirrorView& mirror, const Level& level) {
    if (mirror.plane.offset != Vec3<World>{}) return {};
    return {&level.planes[mirror.plane.plane], mirror.plane.is_back};
}

}  // namespace

void Claims::clear() {
    spans.clear();
    for (auto& faces : lists) faces.clear();
    left_free.clear();
    fog_runs.clear();
    things.clear();
    is_under_liquid = false;
    effects = {};
}

std::int64_t pixels_of(const Claims& claims, FaceList list) {
    std::int64_t pixels = 0;
    for (const ClaimedFace& face : claims.list(list)) pixels += pixels_of(claims.spans_of(face));
    return pixels;
}

void claim_faces(const FrameContext& frame, FrameWorkspace& work) {
    const Stopwatch watch(work.times.get(), &PassTimes::claims_ns);
    BrushModels* const models = frame.allows(Effect::BrushModels) ? &work.brush_models : nullptr;
    const WalkLimit limit = frame.mirror ? limit_of(*frame.mirror, frame.scene.level) : WalkLimit{};
    FrontToBackWalk walk(frame.scene.level, frame.view, work.visible, models, work.span_buffer, work.walk, limit);
    const bool is_by_span_buffer = frame.settings.hidden_surfaces == HiddenSurfaces::SpanBuffer;
    std::optional<VisibleFace> visible = is_by_span_buffer ? walk.next() : claim_first_walk(walk, frame, work);
    for (; visible; visible = walk.next()) {
        const Stopwatch of_models(visible->fragment ? work.times.get() : nullptr, Effect::BrushModels);
        if (project_and_scan(*visible, frame, work)) claim_face(*visible, walk.takes_all_faces(), frame, work);
    }
    work.span_buffer.claim_rest(work.claims.left_free);
    if (work.counts) count_walk(walk.nodes_entered(), work.vertices.count(), work.counts->stages);
}

}  // namespace oblong
