#include "tools/bench/stage_inputs.h"

#include "engine/view/views.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

/// The faces of a frame until no pixel is free, by the stages that a frame takes them through.
void collect_geometry(const BenchLevel& level, FrameWorkspace& work, StageInputs& inputs) {
    work.view.visible.see_from(level.level, inputs.leaf);
    work.view.vertices.start_frame();
    work.view.span_buffer.reset();
    SpanList owned;
    FrontToBackWalk walk(level.level, inputs.view, work.view.visible, nullptr, work.view.span_buffer, work.view.walk);
    while (const std::optional<VisibleFace> visible = walk.next()) {
        inputs.visited.push_back(visible->face);
        if (!project_face(work.cache.faces.corners_of(visible->face), inputs.view, work.view.vertices, work.view.polygon)) continue;
        scan_convex(work.view.polygon.screen, work.view.rows);
        work.view.span_buffer.claim(work.view.rows, owned);
        inputs.polygons.emplace_back(work.view.polygon.screen.begin(), work.view.polygon.screen.end());
        inputs.rows.push_back(work.view.rows);
    }
}

/// The walls of the frame drawn last in the workspace.
void collect_walls(const BenchLevel& level, FrameWorkspace& work, StageInputs& inputs) {
    const InverseProjection inverse_projection = make_inverse_projection(inputs.view.projection);
    inputs.least_pixel_width = inverse_projection.least_pixel_width;
    for (const ClaimedFace& claimed : work.view.claims.list(FaceList::Walls)) {
        const FaceIndex face = claimed.face;
        const auto spans = work.view.claims.spans_of(claimed);
        const Vec3<World> offset = work.cache.brush_models.offset_of(claimed.fragment);
        const int mip = work.cache.surfaces.mip_level(face, claimed.nearest_z, inputs.view.projection.x, 0);
        const FaceSurface surface = work.cache.surfaces.get(face, mip, {work.view.light.styles, TextureIndex::none(), offset});
        inputs.walls.push_back({claimed,
                                {spans.begin(), spans.end()},
                                surface,
                                make_face_gradients(level.level, level.level.faces[face], surface, offset, inputs.view,
                                                    inverse_projection),
                                work.cache.faces.faces[face].least_density});
        for (const Span& span : spans) inputs.pixels += span.end - span.first;
    }
}

}  // namespace

StageInputs collect_stage_inputs(const BenchLevel& level, const Camera& camera, const ScreenMode& mode,
                                 FrameWorkspace& work) {
    ViewSpec spec = first_person_view(camera);
    const PlacedEye eye = place_eye(level.level, spec.eye);
    spec.eye = eye.position;
    StageInputs inputs;
    inputs.view = make_view_context(spec, mode);
    inputs.leaf = eye.leaf;

    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px));
    draw_frame(level.scene(), camera, mode, {}, work, {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    collect_walls(level, work, inputs);
    collect_geometry(level, work, inputs);
    return inputs;
}

}  // namespace oblong
