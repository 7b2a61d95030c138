#include "engine/frame/wireframe.h"

#include <algorithm>

#include "engine/frame/workspace.h"
#include "engine/view/clip_line.h"

namespace oblong {

namespace {

/// Nothing nearer is drawn, and nothing in the world is farther.
constexpr View kWireFront = View::from_raw(1 << 12), kWireBack = View::from_int(1 << 21);

struct WireEdge {
    EdgeIndex edge;
    Vec3<World> offset;  ///< of its model
};

/// Two faces share most edges: each is returned once.
std::vector<WireEdge> edges_of_claims(const Level& level, const FrameWorkspace& work) {
    std::vector<WireEdge> edges;
    for (const auto& list : work.view.claims.lists)
        for (const VisibleFace& claimed : list) {
            const Vec3<World> offset = work.cache.brush_models.offset_of(claimed.fragment);
            for (const SurfEdge& step : level.edges_of(level.faces[claimed.face])) edges.push_back({step.edge, offset});
        }
    std::sort(edges.begin(), edges.end(), [](const WireEdge& a, const WireEdge& b) { return a.edge < b.edge; });
    const auto end =
        std::unique(edges.begin(), edges.end(), [](const WireEdge& a, const WireEdge& b) { return a.edge == b.edge; });
    edges.erase(end, edges.end());
    return edges;
}

}  // namespace

void draw_wireframe(const Level& level, const ViewSpec& view, const ScreenMode& mode, const Settings& settings,
                    const FrameWorkspace& work, const LineStyle& style, Framebuffer out) {
    const ViewContext context = make_view_context(view, mode, {.corrects_aspect = settings.correct_aspect});
    const ViewVolume volume = make_view_volume(context.frustum, kWireFront, kWireBack);
    for (const WireEdge& wire : edges_of_claims(level, work)) {
        const Edge& edge = level.edges[wire.edge];
        const auto end = [&](VertexIndex vertex) { return to_view(level.vertices[vertex] + wire.offset, context); };
        const auto line = project_line(volume, context.projection, {end(edge.from), end(edge.to)});
        if (line) draw_line(line->from, line->to, style, out);
    }
}

}  // namespace oblong
