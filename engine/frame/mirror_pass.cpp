#include "engine/frame/mirror_pass.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/frame/claim_faces.h"
#include "engine/frame/draw_view.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/frame_light.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/mirror_view.h"
#include "engine/frame/passes.h"
#include "engine/frame/shared_drawing.h"
#include "engine/frame/workspace.h"
#include "engine/level/side.h"
#include "engine/math/vec.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

MirrorPlane plane_of(const VisibleFace& claimed, const FrameContext& frame) {
    const Face& face = frame.scene.level.faces[claimed.face];
    return {face.plane, face.is_back, frame.offset_of(claimed)};
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

/// The view whose flipped picture the mirror shows.
ViewContext mirrored(const ViewContext& view, const MirrorView& mirror, const Level& level) {
    const LevelPlane& plane = level.planes[mirror.plane.plane];
    ViewContext turned = view;
    turned.eye = place_eye(level, reflected_eye(view.eye, plane, mirror.plane.offset)).position;
    turned.viewpoint = {turned.eye};
    turned.axes = reflected(view.axes, plane.normal);
    turned.rays = reflected(view.rays, plane.normal);
    turned.frustum = make_frustum(turned.axes, turned.projection);
    narrow_cull_planes(turned.axes, turned.projection, mirror.pixels, turned.frustum);
    return turned;
}

/// The leaf in front of a mirror's middle; everything in the mirror is visible from there.
LeafIndex leaf_in_front_of(const VisibleFace& claimed, const MirrorPlane& mirror, const FrameContext& frame,
                           CornerScratch& scratch) {
    const Level& level = frame.scene.level;
    const Vec3<Unit>& normal = level.planes[mirror.plane].normal;
    const auto step = convert<World>(mirror.is_back ? -normal : normal);
    return find_leaf(level, level.world(), middle_of(world_corners(claimed, frame, scratch)) + step);
}

/// The spans of all faces of one mirror with columns counted from the right, sorted.
std::vector<Span> flipped_spans(std::span<const VisibleFace> faces, const Claims& claims, std::int32_t width_px) {
    std::vector<Span> flipped;
    for (const VisibleFace& face : faces)
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

/// The frame's limits, and the mirror.
std::vector<WalkLimit> limits_of(const MirrorView& mirror, const FrameContext& frame) {
    std::vector<WalkLimit> limits = frame.limits;
    const MirrorPlane& plane = mirror.plane;
    limits.push_back({frame.scene.level.planes[plane.plane], plane.is_back, plane.offset});
    return limits;
}

/// Adds the pixels and times of a mirror's effects, its own passes among them, to those of the frame.
void add_effects(const FrameObservers& mirrored, const FrameObservers& frame) {
    for (std::size_t i = 0; i < kEffectCount; ++i) {
        if (frame.counts) frame.counts->mirrored_pixels[i] += mirrored.counts->effect_pixels[i];
        if (!frame.times) continue;
        const std::size_t pass = pass_of(static_cast<Effect>(i));
        frame.times->effects_ns[i] +=
            mirrored.times->effects_ns[i] + (pass < kPassCount ? mirrored.times->passes_ns[pass] : 0);
    }
}

/// Draws the mirrored view in the spans `flipped`. Returns the effects that own pixels of it.
EffectSet draw_mirrored_view(const MirrorView& mirror, LeafIndex leaf, std::span<const Span> flipped,
                             const FrameContext& frame, MirrorScratch& scratch) {
    const FrameObservers& outer = frame.observers;
    FrameCounts counts = outer.counts ? make_frame_counts(frame.out) : FrameCounts{};
    PassTimes times{outer.times ? outer.times->clock : nullptr};
    const FrameObservers own{outer.counts ? &counts : nullptr, nullptr, outer.times ? &times : nullptr};
    Settings settings = frame.settings;
    settings.allowed_effects = settings.allowed_effects.without(Effect::Mirror);
    FrameContext mirrored_frame{
        .scene = frame.scene,
        .settings = settings,
        .cache = frame.cache,
        .observers = own,
        .view = mirrored(frame.view, mirror, frame.scene.level),
        .inverse_projection = frame.inverse_projection,
        .texturing = frame.texturing,
        .out = {scratch.picture.data(), frame.out.width_px, frame.out.height_px, frame.out.width_px},
        .limits = limits_of(mirror, frame),
        .mirror = &mirror,
        .claimer = frame.claimer};
    mirrored_frame.fog = make_frame_fog(mirrored_frame);
    fill_spans(flipped, 0, mirrored_frame.out);
    start_view(mirrored_frame, leaf, *scratch.view);
    scratch.view->claiming->span_buffer.reset_to(flipped);
    const EffectSet effects = draw_view(mirrored_frame, *scratch.view).effects;
    copy_flipped(flipped, mirrored_frame.out, frame.out);
    add_effects(own, outer);
    return effects;
}

}  // namespace

void limit_mirrors(const FrameContext& frame, Claims& claims) {
    std::array<MirrorPlane, kMostMirrors> planes;
    std::size_t count = 0;
    std::erase_if(claims.list(FaceList::Mirror), [&](const VisibleFace& face) {
        const MirrorPlane plane = plane_of(face, frame);
        const auto end = planes.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(planes.begin(), end, plane) != end) return false;
        if (count < planes.size()) {
            planes[count++] = plane;
            return false;
        }
        claims.list(FaceList::Walls).push_back(face);
        return true;
    });
}

void draw_mirrors(const FrameContext& frame, ViewScratch& scratch) {
    if (frame.shared) frame.shared->end();  // mirrors are drawn by one thread
    const Framebuffer& out = frame.out;
    MirrorScratch& mirrors = scratch.mirror;
    if (!mirrors.view) mirrors.view = std::make_unique<ViewScratch>(scratch, ScreenMode{out.width_px, out.height_px});
    mirrors.picture.resize(pixel_count(out.width_px, out.height_px));

    EffectSet effects;
    std::vector<VisibleFace> remaining = scratch.claims.list(FaceList::Mirror);
    while (!remaining.empty()) {
        const MirrorPlane mirror = plane_of(remaining.front(), frame);
        const LeafIndex leaf = leaf_in_front_of(remaining.front(), mirror, frame, scratch.claiming->corners);
        const auto others = std::stable_partition(remaining.begin(), remaining.end(), [&](const VisibleFace& face) {
            return plane_of(face, frame) == mirror;
        });
        const auto faces = std::span<const VisibleFace>(remaining).first(as_size(others - remaining.begin()));
        const std::vector<Span> flipped = flipped_spans(faces, scratch.claims, out.width_px);
        effects = effects | draw_mirrored_view({mirror, rectangle_around(flipped)}, leaf, flipped, frame, mirrors);
        for (const VisibleFace& face : faces) observe_spans(face, scratch.claims.spans_of(face), out, frame.observers);
        remaining.erase(remaining.begin(), others);
    }
    if (scratch.effects->meshes) scratch.effects->meshes->begun = nullptr;  // the mirrored views used its scratch
    restore_light(frame, scratch);
    scratch.claims.effects = scratch.claims.effects | effects;
}

}  // namespace oblong
