#include "engine/frame/mirror_pass.h"

#include <algorithm>
#include <utility>

#include "engine/fixed/arithmetic.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/light_pass.h"
#include "engine/frame/passes.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/workspace.h"
#include "engine/level/side.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

MirrorPlane plane_of(const ClaimedFace& claimed, const Level& level, const FrameWorkspace& work) {
    const Face& face = level.faces[claimed.visible.face];
    return {face.plane, face.is_back, work.brush_models.offset_of(claimed.visible.fragment)};
}

/// v - 2 (v . n) n: within 2 steps of 2^-30.
Vec3<Unit> reflected(const Vec3<Unit>& v, const Vec3<Unit>& normal) {
    const Sine60 twice = dot(v, normal) + dot(v, normal);
    const auto part = [twice](Unit component) { return product<Unit>(twice, component); };
    return v - Vec3<Unit>{part(normal.x), part(normal.y), part(normal.z)};
}

Basis reflected(const Basis& axes, const Vec3<Unit>& normal) {
    return {-reflected(axes.right, normal), reflected(axes.up, normal), reflected(axes.forward, normal)};
}

Vec3<World> reflected_eye(const Vec3<World>& eye, const LevelPlane& plane, const Vec3<World>& offset) {
    const PlaneDistance distance = plane_distance(plane, eye - offset);
    const auto moved = [distance](World from, Unit component) {
        const auto way = product<WorldWide>(distance, component);
        return saturating_convert<World>(convert<WorldWide>(from) - way - way);
    };
    return {moved(eye.x, plane.normal.x), moved(eye.y, plane.normal.y), moved(eye.z, plane.normal.z)};
}

/// The view whose picture, flipped, is what the mirror shows.
ViewContext mirrored(const ViewContext& view, const MirrorView& mirror, const Level& level) {
    const LevelPlane& plane = level.planes[mirror.plane.plane];
    ViewContext turned = view;
    turned.eye = place_eye(level, reflected_eye(view.eye, plane, mirror.plane.offset)).position;
    turned.viewpoint = {turned.eye};
    turned.axes = reflected(view.axes, plane.normal);
    turned.rays = reflected(view.rays, plane.normal);
    turned.frustum = make_frustum(turned.axes, turned.projection);
    narrow_cull_planes(turned.axes, turned.projection, {}, mirror.pixels, turned.frustum);
    return turned;
}

Vec3<World> middle_of(std::span<const Vec3<World>> corners) {
    Vec3<WorldWide> sum;
    for (const Vec3<World>& corner : corners) sum = sum + convert<WorldWide>(corner);
    const auto part = [&](WorldWide whole) {
        return World::from_raw(static_cast<World::Raw>(whole.raw / static_cast<std::int64_t>(corners.size())));
    };
    return {part(sum.x), part(sum.y), part(sum.z)};
}

/// The leaf before the middle of a mirror: what it shows can be seen from there.
LeafIndex leaf_before(const ClaimedFace& claimed, const MirrorPlane& mirror, const Level& level, FrameWorkspace& work) {
    std::vector<Vec3<World>> corners;
    if (claimed.visible.fragment) {
        const auto own = work.brush_models.corners_of(*claimed.visible.fragment);
        corners.assign(own.begin(), own.end());
    } else {
        for (const VertexIndex corner : work.faces.corners_of(claimed.visible.face))
            corners.push_back(level.vertices[corner]);
    }
    const Vec3<Unit>& normal = level.planes[mirror.plane].normal;
    const auto step = convert<World>(mirror.is_back ? -normal : normal);
    return find_leaf(level, level.world(), middle_of(corners) + step);
}

/// The spans of all faces of one mirror, with columns from the right, sorted.
std::vector<Span> flipped_spans(std::span<const ClaimedFace> faces, const Claims& claims, std::int32_t width_px) {
    std::vector<Span> flipped;
    for (const ClaimedFace& face : faces)
        for (const Span& span : claims.spans_of(face))
            flipped.push_back({span.y, width_px - span.end, width_px - span.first});
    std::sort(flipped.begin(), flipped.end(),
              [](const Span& a, const Span& b) { return std::pair(a.y, a.first) < std::pair(b.y, b.first); });
    return flipped;
}

void copy_flipped(std::span<const Span> flipped, const Framebuffer& from, Framebuffer to) {
    for (const Span& span : flipped)
        std::reverse_copy(from.row(span.y) + span.first, from.row(span.y) + span.end,
                          to.row(span.y) + (to.width_px - span.end));
}

/// Those of the frame, and the mirror.
std::vector<WalkLimit> limits_of(const MirrorView& mirror, const FrameContext& frame) {
    std::vector<WalkLimit> limits = frame.limits;
    const MirrorPlane& plane = mirror.plane;
    limits.push_back({frame.scene.level.planes[plane.plane], plane.is_back, plane.offset});
    return limits;
}

/// Draws the mirrored view where `flipped` are free. Uses the workspace's scratch, but not its claims.
void draw_mirrored_view(const MirrorView& mirror, LeafIndex leaf, std::span<const Span> flipped,
                        const FrameContext& frame, FrameWorkspace& work) {
    Settings settings = frame.settings;
    settings.allowed_effects = settings.allowed_effects.without(Effect::Mirror);
    const FrameContext mirrored_frame{
        frame.scene,
        settings,
        mirrored(frame.view, mirror, frame.scene.level),
        frame.inverse_projection,
        frame.texturing,
        {work.mirror.pixels.data(), frame.out.width_px, frame.out.height_px, frame.out.width_px},
        contents::kEmpty,
        &mirror,
        limits_of(mirror, frame)};
    work.visible.see_from(frame.scene.level, leaf);
    work.brush_models.start_frame(frame.scene.level, frame.scene.models, work.faces);
    work.vertices.start_frame();
    work.span_buffer.reset_to(flipped);
    work.claims.clear();
    draw_view(mirrored_frame, work);
    copy_flipped(flipped, mirrored_frame.out, frame.out);
}

}  // namespace

bool is_behind(const MirrorView& mirror, const Vec3<World>& place, const Level& level) {
    const MirrorPlane& plane = mirror.plane;
    return (plane_distance(level.planes[plane.plane], place - plane.offset) > PlaneDistance{}) == plane.is_back;
}

void draw_mirrors(const FrameContext& frame, FrameWorkspace& work) {
    const Level& level = frame.scene.level;
    Claims claims = std::exchange(work.claims, {});
    auto counts = std::exchange(work.counts, nullptr);
    auto record = std::exchange(work.record, nullptr);
    auto times = std::exchange(work.times, nullptr);
    if (!work.mirror.visible) work.mirror.visible = std::make_unique<VisibleSet>(level);
    std::swap(work.visible, *work.mirror.visible);
    std::swap(work.depth, work.mirror.depth);
    work.mirror.pixels.assign(pixel_count(frame.out.width_px, frame.out.height_px), 0);

    std::vector<ClaimedFace> left = claims.list(FaceList::Mirror), drawn_faces;
    for (std::size_t drawn = 0; drawn < kMostMirrors && !left.empty(); ++drawn) {
        const MirrorPlane mirror = plane_of(left.front(), level, work);
        const LeafIndex leaf = leaf_before(left.front(), mirror, level, work);
        const auto others = std::stable_partition(
            left.begin(), left.end(), [&](const ClaimedFace& face) { return plane_of(face, level, work) == mirror; });
        const std::vector<Span> flipped =
            flipped_spans({left.data(), static_cast<std::size_t>(others - left.begin())}, claims, frame.out.width_px);
        draw_mirrored_view({mirror, rectangle_around(flipped)}, leaf, flipped, frame, work);
        drawn_faces.insert(drawn_faces.end(), left.begin(), others);
        left.erase(left.begin(), others);
    }

    work.claims = std::move(claims);
    std::swap(work.visible, *work.mirror.visible);
    std::swap(work.depth, work.mirror.depth);
    find_light(frame, work);  // the frame's own again, counted before
    work.counts = std::move(counts);
    work.record = std::move(record);
    work.times = std::move(times);
    work.claims.list(FaceList::Mirror) = std::move(left);
    for (const ClaimedFace& face : drawn_faces) note_spans(face, work.claims.spans_of(face), frame.out, work);
    draw_surfaces(FaceList::Mirror, {}, frame, work);
}

}  // namespace oblong
