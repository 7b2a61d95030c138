#include "engine/frame/wireframe.h"

#include <algorithm>

#include "engine/frame/workspace.h"
#include "engine/view/clip.h"

namespace oblong {

namespace {

/// Lines are not drawn nearer than this; nothing in the world is farther.
constexpr View kWireFront = View::from_raw(1 << 12), kWireBack = View::from_int(1 << 21);

struct WireEdge {
    EdgeIndex edge;
    Vec3<World> offset;  ///< of its model
};

/// Most edges are shared by two faces; each is returned once.
std::vector<WireEdge> edges_of_claims(const Level& level, const FrameWorkspace& work) {
    std::vector<WireEdge> edges;
    for (const auto& list : work.view.claims.lists)
        for (const VisibleFace& claimed : list) {
            const Vec3<World> offset = work.cache.brush_models.offset_of(claimed.fragment);
            for (const SurfEdge& step : level.edges_of(level.faces[claimed.face]))
                edges.push_back({step.edge(), offset});
        }
    std::sort(edges.begin(), edges.end(), [](const WireEdge& a, const WireEdge& b) { return a.edge < b.edge; });
    const auto end =
        std::unique(edges.begin(), edges.end(), [](const WireEdge& a, const WireEdge& b) { return a.edge == b.edge; });
    edges.erase(end, edges.end());
    return edges;
}

/// Draws lines of the world.
class WirePen {
  public:
    WirePen(const ViewSpec& view, const ScreenMode& mode, const Settings& settings)
        : context_(make_view_context(view, mode, {.corrects_aspect = settings.correct_aspect})),
          volume_(make_view_volume(context_.frustum, kWireFront, kWireBack)) {}

    void draw(const Vec3<World>& from, const Vec3<World>& to, const LineStyle& style, Framebuffer out) const {
        const auto line = project_line(volume_, context_.projection, {to_view(from, context_), to_view(to, context_)});
        if (line) draw_line(line->from, line->to, style, out);
    }

  private:
    ViewContext context_;
    ViewVolume volume_;
};

}  // namespace

void draw_path(std::span<const Vec3<World>> points, const ViewSpec& view, const ScreenMode& mode,
               const Settings& settings, const LineStyle& style, Framebuffer out) {
    constexpr World kAside = World::from_int(4);
    const WirePen pen(view, mode, settings);
    for (const Vec3<World>& aside : {Vec3<World>{kAside, {}, {}}, {{}, kAside, {}}, {{}, {}, kAside}})
        for (std::size_t i = 1; i < points.size(); ++i) {
            pen.draw(points[i - 1] + aside, points[i] + aside, style, out);
            pen.draw(points[i - 1] - aside, points[i] - aside, style, out);
        }
}

void draw_wireframe(const Level& level, const ViewSpec& view, const ScreenMode& mode, const Settings& settings,
                    const FrameWorkspace& work, const LineStyle& style, Framebuffer out) {
    const WirePen pen(view, mode, settings);
    for (const WireEdge& wire : edges_of_claims(level, work)) {
        const Edge& edge = level.edges[wire.edge];
        pen.draw(level.vertices[edge.from] + wire.offset, level.vertices[edge.to] + wire.offset, style, out);
    }
}

}  // namespace oblong
