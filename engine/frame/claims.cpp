#include "engine/frame/claims.h"

#include "engine/frame/frame_context.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/torn_pixels.h"
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

/// Whether the part of a projected face that is within the frame's limits is in view; projects that part alone. Faces
/// in the plane of a limit are left out: so is a mirror from its own picture.
bool keep_within_limits(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    std::vector<Vec3<World>>& corners = work.mirror.corners;
    copy_corners(visible, frame, work);
    bool is_cut = false;
    for (const WalkLimit& limit : frame.limits) {
        const PolygonSide side = polygon_side(limit.plane, limit.offset, corners, work.mirror.distances);
        if (side == (limit.is_back ? PolygonSide::Back : PolygonSide::Front)) continue;
        if (side != PolygonSide::Both) return false;
        const auto count = static_cast<std::ptrdiff_t>(corners.size());
        append_part(corners, 0, work.mirror.distances, !limit.is_back);
        corners.erase(corners.begin(), corners.begin() + count);
        is_cut = true;
    }
    return !is_cut || project_polygon(corners, frame.view, work.polygon);
}

/// Transforms, clips and projects the corners into work.polygon. False if nothing of the face is in view.
bool project(const VisibleFace& visible, const FrameContext& frame, FrameWorkspace& work) {
    if (work.counts) ++work.counts->faces_visited;
    const bool is_in_view =
        visible.fragment ? project_polygon(work.brush_models.corners_of(*visible.fragment), frame.view, work.polygon)
                         : project_face(corners_of(visible.face, frame, work), frame.view, work.vertices, work.polygon);
    return is_in_view && (frame.limits.empty() || keep_within_limits(visible, frame, work));
}

/// Scans the projected face, but for rows at its top and its bottom that have nothing free. False if none are left.
bool scan(const FrameContext& frame, FrameWorkspace& work) {
    const std::span<const ScreenVertex> corners = work.polygon.screen;
    const PolygonShape shape = shape_of(corners, frame.out.height_px, frame.accuracy().edges);
    const PixelRange rows = work.span_buffer.rows_with_free(shape.bounds);
    if (rows.first >= rows.end) return false;
    scan_convex(corners, shape, rows, work.rows);
    return true;
}

/// Lets a face claim the pixels of the scanned rows that are free. The second walk comes again to faces that are seen
/// through: they have their pixels.
void claim_face(const VisibleFace& visible, bool is_second_walk, const FrameContext& frame, FrameWorkspace& work) {
    const EffectSet needs = work.faces.faces[visible.face].effects;
    const EffectSet effects = visible.fragment ? needs.with(Effect::BrushModels) : needs;
    const FaceList list = list_for(needs, frame.settings.allowed_effects);
    if (list == FaceList::SeeThrough && is_second_walk) return;
    Claims& claims = work.claims;
    const std::size_t first = claims.spans.size();
    if (list == FaceList::SeeThrough)
        work.span_buffer.find_free(work.rows, claims.spans);
    else
        work.span_buffer.claim(work.rows, claims.spans);
    if (claims.spans.size() == first) return;
    claims.add(list, {visible, 0, 0, work.polygon.nearest_z, work.polygon.farthest_z}, first);
    claims.effects = claims.effects | (effects & frame.settings.allowed_effects);
    if (work.counts) count_face(effects, std::span<const Span>(claims.spans).subspan(first), *work.counts);
}

/// The corners of a face that was projected; of its part within the frame's limits, if it has any.
std::span<const Vec3<World>> projected_corners(const VisibleFace& visible, const FrameContext& frame,
                                               FrameWorkspace& work) {
    if (frame.limits.empty()) copy_corners(visible, frame, work);
    return work.mirror.corners;
}

bool is_by_span_buffer(const FrameContext& frame) {
    const HiddenSurfaces method = frame.settings.hidden_surfaces;
    return method == HiddenSurfaces::SpanBuffer || (frame.view.is_parallel() && !serves_parallel_views(method));
}

bool shares_walls_at_once(const FrameContext& frame) {
    return frame.shared && frame.shared->takes_walls_at_once;
}

/// Hands over the walls claimed before a scanned face, if threads share in drawing them; counts it, if the frame is
/// counted; and keeps it for claim_owned() while the first walk lasts, if `keeps_faces`. Whether it was kept.
bool note_scanned_face(const VisibleFace& visible, bool is_second_walk, bool& keeps_faces, const FrameContext& frame,
                       FrameWorkspace& work) {
    if (shares_walls_at_once(frame)) share_surfaces(FaceList::Walls, {}, frame, work);
    if (work.counts) count_polygon(work.polygon, work.rows, work.counts->stages);
    if (!keeps_faces) return false;
    keeps_faces = !is_second_walk;
    if (keeps_faces)
        add_scanned_face(visible, projected_corners(visible, frame, work), frame, work);
    else
        claim_owned(frame, work);
    return keeps_faces;
}

/// The next face of the walk. One in 16 is timed, less what reading the clock takes: to read it at every face would
/// take about as long as the walk.
std::optional<VisibleFace> next_face(FrontToBackWalk& walk, PassTimes* times) {
    constexpr std::uint32_t kSample = 16;
    if (!times || ++times->faces_walked % kSample != 0) return walk.next();
    const std::int64_t before_ns = times->clock(), began_ns = times->clock();
    const std::optional<VisibleFace> face = walk.next();
    times->walk_ns += kSample * ((times->clock() - began_ns) - (began_ns - before_ns));
    return face;
}

}  // namespace

void Claims::clear() {
    spans.clear();
    for (auto& faces : lists) faces.clear();
    torn.clear();
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
    FrontToBackWalk walk(frame.scene.level, frame.view, work.visible, models, work.span_buffer, work.walk, frame.limits,
                         work.faces.torn_edges == 0);
    bool keeps_faces = !is_by_span_buffer(frame);
    const bool is_watched =
        keeps_faces || work.counts || shares_walls_at_once(frame);  // one test a face instead of three
    if (keeps_faces) start_scanned_faces(work);
    while (const std::optional<VisibleFace> visible = next_face(walk, work.times.get())) {
        const Stopwatch of_models(visible->fragment ? work.times.get() : nullptr, Effect::BrushModels);
        if (!project(*visible, frame, work) || !scan(frame, work)) continue;
        if (is_watched && note_scanned_face(*visible, walk.takes_all_faces(), keeps_faces, frame, work)) continue;
        claim_face(*visible, walk.takes_all_faces(), frame, work);
    }
    if (keeps_faces) claim_owned(frame, work);
    if (!work.span_buffer.is_full()) claim_torn_pixels(frame, work);
    if (work.counts) count_walk(walk.nodes_entered(), work.vertices.count(), work.counts->stages);
}

}  // namespace oblong
