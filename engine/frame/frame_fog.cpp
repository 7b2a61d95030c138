#include "engine/frame/frame_fog.h"

#include <utility>

#include "engine/base/table.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/surface_pass.h"
#include "engine/frame/torn_pixels.h"
#include "engine/frame/workspace.h"
#include "engine/view/gradients.h"

namespace oblong {

FrameFog make_frame_fog(const FrameContext& frame) {
    const std::optional<LevelFog>& fog = frame.cache.effects.fog;
    if (!fog || !frame.allows(Effect::Fog)) return {};
    if (!frame.cache.fog_tables)
        frame.cache.fog_tables = std::make_unique<LevelFogTables>(*fog, frame.scene.colormap.palette);
    FrameFog found;
    found.tables = frame.cache.fog_tables.get();
    if (!fog->has_top) return found;
    found.top = fog->top;
    found.height = make_height_fog_view({fog->top, fog->fade_depth}, frame.view.eye,
                                        make_view_directions(frame.view.rays, frame.view.projection));
    return found;
}

bool is_clear(World lowest_z, const FrameFog& fog, const Vec3<World>& eye) {
    constexpr auto kRounding = WorldWide::from_int(3);  // of boxes in a level's file, and of positions
    return fog.height && eye.z >= fog.top && convert<WorldWide>(lowest_z) > convert<WorldWide>(fog.top) + kRounding;
}

bool may_have_fog(const VisibleFace& face, std::span<const Span> spans, const FrameContext& frame) {
    const FrameFog& fog = frame.fog;
    if (!fog.tables) return false;
    if (!fog.height || frame.view.eye.z < fog.top) return true;
    if (!face.fragment && frame.cache.faces[face.face].is_above_fog) return false;
    return !is_clear(face.bounds, face.inverse_z, *fog.height) &&
           !is_clear(rectangle_around(spans), face.inverse_z, *fog.height);
}

void append_runs(std::span<const Span> spans, const LinearQuantity<InverseZ>& inverse_z, const FrameFog& fog,
                 std::vector<FogRun>& runs) {
    for (const Span& span : spans) {
        if (fog.height)
            append_height_fog_runs(span, inverse_z, *fog.height, fog.tables->depths(), runs);
        else
            append_fog_runs(span, inverse_z, fog.tables->depths(), runs);
    }
}

const ColourRow& fog_colours(std::int32_t column, std::int32_t row, InverseZ inverse_z, const FrameFog& fog,
                             std::vector<FogRun>& runs) {
    if (fog.height && is_clear(column, row, inverse_z, *fog.height)) return fog.tables->colours(0);
    runs.clear();
    const Span pixel{row, column, column + 1};
    append_runs(std::span(&pixel, 1), {inverse_z, {}, {}}, fog, runs);
    return fog.tables->colours(runs.front().level);
}

void find_fog(const FrameContext& frame, ViewScratch& scratch) {
    const FrameFog& fog = frame.fog;
    if (!fog.tables || (scratch.claims.torn.empty() && is_clear(scratch.claiming->walk.lowest_z, fog, frame.view.eye)))
        return;
    const Stopwatch watch(frame.observers.times, Effect::Fog);
    Claims& claims = scratch.claims;
    for (const FaceList list : {FaceList::Walls, FaceList::Liquid, FaceList::Flat})
        for (const VisibleFace& claimed : claims.list(list)) {
            const std::span<const Span> spans = claims.spans_of(claimed);
            if (may_have_fog(claimed, spans, frame))
                append_runs(spans, inverse_z_of(claimed, frame), fog, claims.fog_runs);
        }
    for (const TornSpan& torn : claims.torn)
        append_runs({&torn.span, 1}, inverse_z_of(torn, frame), fog, claims.fog_runs);
    const std::int32_t sky_level = fog.height ? 0 : sky_fog_level(frame.cache.effects.sky_fog_256);
    if (sky_level > 0)
        for (const VisibleFace& claimed : claims.list(FaceList::Sky))
            for (const Span& span : claims.spans_of(claimed)) claims.fog_runs.emplace_back(span, sky_level);
    std::erase_if(claims.fog_runs, [](const FogRun& run) { return run.level == 0; });
    if (claims.fog_runs.empty()) return;
    claims.add(Effect::Fog, pixels_of(claims.fog_runs), frame.observers.counts);
}

}  // namespace oblong
