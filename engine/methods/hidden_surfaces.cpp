#include "engine/methods/hidden_surfaces.h"

#include <algorithm>
#include <tuple>

#include "engine/base/table.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"
#include "engine/level/side.h"
#include "engine/methods/pixel_owners.h"

namespace oblong {

namespace {

/// Sets the plane of a face, seen from its front.
void set_plane(const FrameContext& frame, ScannedFace& scanned) {
    const Level& level = frame.scene.level;
    const Face& face = level.faces[scanned.face];
    const LevelPlane& plane = level.planes[face.plane];
    scanned.normal = face.is_back ? -plane.normal : plane.normal;
    scanned.eye_distance = distance_before(plane, face.is_back, frame.view.eye - frame.offset_of(scanned));
    scanned.inverse_z =
        make_face_inverse_z(level, face, frame.offset_of(scanned), frame.view, frame.inverse_projection);
    scanned.inverse_z = {inverse_z_of(scanned, frame), {}};
}

}  // namespace

void HiddenSurfaceMethod::claim(const FrameContext& frame, ViewScratch& scratch) {
    if (!frame.mirror) counts_ = {};
    if (method_ == HiddenSurfaces::SpanBuffer || frame.view.is_parallel()) return claim_faces(frame, scratch);
    scanned_.clear();
    bool are_kept = true;
    FacesInView faces(frame, scratch);
    VisibleFace face;
    while (faces.next(face)) {
        if (!faces.is_second_walk()) {
            keep(face, frame, scratch);
            continue;
        }
        if (are_kept) claim_owned(frame, scratch);
        are_kept = false;
        claim_face(face, true, frame, scratch);
    }
    if (are_kept) claim_owned(frame, scratch);
}

/// Adds a face that is scanned.
void HiddenSurfaceMethod::keep(const VisibleFace& face, const FrameContext& frame, ViewScratch& scratch) {
    const EffectSet needs = frame.cache.faces[face.face].effects;
    ScannedFace scanned;
    static_cast<VisibleFace&>(scanned) = face;
    std::tie(scanned.nearest_z, scanned.farthest_z) = scratch.claiming->polygon.z_range();
    scanned.is_seen_through = list_for(needs, frame.settings.allowed_effects) == FaceList::SeeThrough;
    set_plane(frame, scanned);
    const std::span<const Vec3<World>> corners =
        frame.limits.empty() ? world_corners(face, frame, scratch.claiming->corners) : scratch.claiming->corners.world;
    add_face(scanned, scratch.claiming->rows, frame.out.width_px, corners, frame.view.eye, scanned_);
}

void HiddenSurfaceMethod::paint_by(SortDepth depth) {
    find_owners_by_painting(scanned_, back_to_front_by_depth(scanned_, depth, owners_.counts.order_comparisons),
                            owners_);
}

/// Finds the owner of each pixel among the faces that are kept.
void HiddenSurfaceMethod::find_owners(const FrameContext& frame) {
    owners_.counts.faces_scanned = std::ssize(scanned_.faces);
    switch (method_) {
        case HiddenSurfaces::SpanBuffer:
            break;
        case HiddenSurfaces::ZBuffer:
            return find_owners_by_z_buffer(scanned_, depths_, owners_);
        case HiddenSurfaces::Painter:
            return find_owners_by_painting(scanned_, back_to_front_by_tree(scanned_), owners_);
        case HiddenSurfaces::PainterSorted:
            return paint_by(SortDepth::Farthest);
        case HiddenSurfaces::PainterMean:
            return paint_by(SortDepth::Mean);
        case HiddenSurfaces::RayCasting:
            return find_owners_by_rays(scanned_, make_view_directions(frame.view.rays, frame.view.projection), targets_,
                                       owners_);
    }
}

/// Claims a face's runs of pixels.
void HiddenSurfaceMethod::claim_runs(const ScannedFace& face, std::span<const OwnedRun> runs, const FrameContext& frame,
                                     ViewScratch& scratch) {
    Claims& claims = scratch.claims;
    const std::size_t first = claims.spans.size();
    for (const auto& [index, span] : runs) {
        if (face.is_seen_through)
            claims.spans.push_back(span);
        else
            scratch.claiming->span_buffer.claim(span.y, span.first, span.end, claims.spans);
    }
    VisibleFace claimed = face;
    claimed.bounds = rectangle_around(std::span<const Span>(claims.spans).subspan(first));
    add_claimed(claimed, first, frame, claims);
}

/// Claims each pixel for the face that owns it. What has no owner stays free in the span buffer.
void HiddenSurfaceMethod::claim_owned(const FrameContext& frame, ViewScratch& scratch) {
    owners_.start(frame.out.width_px, frame.out.height_px);
    find_owners(frame);
    if (!frame.mirror) counts_ = owners_.counts;
    const std::vector<OwnedRun> runs = owned_runs(owners_);
    for (auto run = runs.begin(); run != runs.end();) {
        const auto end = std::find_if(run, runs.end(), [&](const OwnedRun& next) { return next.face != run->face; });
        claim_runs(item(scanned_.faces, run->face), {&*run, as_size(end - run)}, frame, scratch);
        run = end;
    }
}

std::vector<NamedCount> named_counts(const HiddenSurfaceCounts& counts) {
    return {{"faces_scanned", counts.faces_scanned},
            {"pixels_tested", counts.pixels_tested},
            {"pixels_written", counts.pixels_written},
            {"order_comparisons", counts.order_comparisons},
            {"ray_face_tests", counts.ray_face_tests}};
}

}  // namespace oblong
