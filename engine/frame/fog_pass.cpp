#include "engine/frame/fog_pass.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/torn_pixels.h"
#include "engine/frame/workspace.h"
#include "engine/view/view_directions.h"

namespace oblong {

namespace {

LevelFogTables make_tables(const LevelFog& fog, const Palette& palette) {
    return {make_fog_depths(convert<FogDensity>(fog.density), convert<View>(fog.nearest), convert<View>(fog.farthest)),
            make_fog_table(palette, fog.colour, fog.alpha_256)};
}

/// Whether a face may be in fog: it, or the eye, reaches below the top.
bool may_have_fog(const ClaimedFace& claimed, const FrameContext& frame, const FrameFog& fog,
                  const FrameWorkspace& work) {
    if (!fog.height || frame.view.eye.z < fog.top) return true;
    const auto is_low = [&](const Vec3<World>& corner) { return corner.z < fog.top; };
    if (const Fragment* const fragment = claimed.visible.fragment) {
        const auto corners = work.brush_models.corners_of(*fragment);
        return std::any_of(corners.begin(), corners.end(), is_low);
    }
    const auto corners = work.faces.corners_of(claimed.visible.face);
    return std::any_of(corners.begin(), corners.end(),
                       [&](VertexIndex corner) { return is_low(frame.scene.level.vertices[corner]); });
}

}  // namespace

FrameFog make_frame_fog(const FrameContext& frame, FrameWorkspace& work) {
    const std::optional<LevelFog>& fog = work.effects.fog;
    if (!fog || !frame.allows(Effect::Fog)) return {};
    if (!work.fog_tables)
        work.fog_tables = std::make_unique<LevelFogTables>(make_tables(*fog, frame.scene.colormap.palette));
    FrameFog found;
    found.tables = work.fog_tables.get();
    if (!fog->has_top) return found;
    found.top = fog->top;
    found.height = make_height_fog_view({fog->top, fog->fade_depth}, frame.view.eye,
                                        make_view_directions(frame.view.rays, frame.view.projection));
    return found;
}

void append_runs(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z, const FrameFog& fog,
                 std::vector<FogRun>& runs) {
    for (const Span& span : spans) {
        if (fog.height)
            append_height_fog_runs(span, inverse_z, *fog.height, fog.tables->depths, runs);
        else
            append_fog_runs(span, inverse_z, fog.tables->depths, runs);
    }
}

const ColourRow& fog_colours(std::int32_t column, std::int32_t row, InverseZ inverse_z, const FrameFog& fog,
                             FrameWorkspace& work) {
    work.thing_runs.clear();
    const Span pixel{row, column, column + 1};
    append_runs(std::span(&pixel, 1), {inverse_z, {}, {}}, fog, work.thing_runs);
    return fog.tables->colours.levels[static_cast<std::size_t>(work.thing_runs.front().level)];
}

void find_fog(const FrameContext& frame, const FrameFog& fog, FrameWorkspace& work) {
    if (!fog.tables) return;
    Claims& claims = work.claims;
    for (const FaceList list : {FaceList::Walls, FaceList::Liquid, FaceList::Flat})
        for (const ClaimedFace& claimed : claims.list(list)) {
            if (!may_have_fog(claimed, frame, fog, work)) continue;
            const auto inverse_z = gradients_of(claimed.visible, FaceSurface{}, frame, work).inverse_z;
            append_runs(claims.spans_of(claimed), inverse_z, fog, claims.fog_runs);
        }
    for (const TornSpan& torn : claims.torn)
        append_runs({&torn.span, 1}, inverse_z_of(torn, frame), fog, claims.fog_runs);
    const std::int32_t sky_level = fog.height ? 0 : sky_fog_level(work.effects.sky_fog_256);
    for (const ClaimedFace& claimed : claims.list(FaceList::Sky))
        for (const Span& span : claims.spans_of(claimed)) claims.fog_runs.push_back({span, sky_level});
    std::erase_if(claims.fog_runs, [](const FogRun& run) { return run.level == 0; });
    if (!claims.fog_runs.empty()) claims.effects = claims.effects.with(Effect::Fog);
}

}  // namespace oblong
