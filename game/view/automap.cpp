#include "game/view/automap.h"

#include <algorithm>
#include <array>

#include "engine/level/side.h"
#include "engine/view/clip.h"
#include "engine/view/views.h"
#include "game/simulation/entity_specs.h"
#include "game/simulation/items.h"

namespace oblong {

namespace {

constexpr View kMapWidth = View::from_int(2048), kMapFarthest = View::from_int(1 << 21);
constexpr int kPictureBrightness = 56;  // of 256, behind the map
constexpr World kBeside = World::from_int(2), kStepHeight = World::from_int(18), kFlatWithin = World::from_int(1);
constexpr World kRim = World::from_int(700), kMark = World::from_int(36),
                kFarMark = World::from_int(14);  // of missing lenses' diamonds
constexpr World kArrowLength = World::from_int(64), kArrowHead = World::from_int(40);
constexpr Unit kRootOfHalf = Unit::from_raw(759'250'125);

bool is_wall(const Level& level, const Face& face) {
    const Material material = level.texinfos[face.texinfo].material;
    return (material == Material::Lit || material == Material::Unlit) &&
           absolute(level.planes[face.plane].normal.z) < kRootOfHalf;
}

// The edges along the face's lowest height.
std::vector<MapLine> lowest_edges(const Level& level, const Face& face) {
    std::vector<MapLine> edges;
    World lowest = World::highest();
    for (const SurfEdge& step : level.edges_of(face)) {
        const Edge& edge = level.edges[step.edge()];
        edges.push_back({level.vertices[edge.from], level.vertices[edge.to]});
        lowest = std::min({lowest, edges.back().from.z, edges.back().to.z});
    }
    std::erase_if(edges, [&](const MapLine& line) { return std::max(line.from.z, line.to.z) > lowest + kFlatWithin; });
    return edges;
}

bool is_solid(const Level& level, const Vec3<World>& p) {
    return level.leaves[find_leaf(level, level.world(), p)].contents == contents::kSolid;
}

// None if there is no ground before the wall.
std::optional<MapLineKind> kind_of(const Level& level, const Face& face, const MapLine& line) {
    const Vec3<World> middle = between(line.from, line.to, World::from_int(1), World::from_int(2));
    const Vec3<World> away = times(kBeside, level.planes[face.plane].normal), out = face.is_back ? -away : away;
    if (!is_solid(level, middle + out - Vec3<World>{{}, {}, kBeside})) return {};
    const Vec3<World> above = Vec3<World>{{}, {}, kStepHeight + kBeside};
    return is_solid(level, middle - out + above) ? MapLineKind::Wall : MapLineKind::Step;
}

// A door that no longer shuts a way. One that starts open ends where it does.
bool stays_open(const GameLevel& level, const GameState& state, std::size_t i) {
    constexpr int kStartsOpen = 1;
    const Mover& mover = level.movers[i];
    return mover.kind == MoverKind::Door && mover.wait_ticks == kForever &&
           state.movers[i].phase == MoverState::Phase::AtEnd &&
           !has_flag(level.bsp->entities[mover.entity], kStartsOpen);
}

}  // namespace

std::vector<MapLine> map_lines_of(const Level& level, FaceIndex index) {
    const Face& face = level.faces[index];
    std::vector<MapLine> lines;
    if (!is_wall(level, face)) return lines;
    for (MapLine line : lowest_edges(level, face)) {
        const auto kind = kind_of(level, face, line);
        if (!kind) continue;
        line.kind = *kind;
        lines.push_back(line);
    }
    return lines;
}

// The map's view, and the canvas.
class Automap::Plotter {
  public:
    Plotter(const Camera& camera, MapView orientation, LineMethod method, const ScreenMode& mode,
            const Settings& settings, Framebuffer canvas)
        : method_(method), canvas_(canvas) {
        const Angle up = orientation == MapView::PlayerUp ? camera.yaw : kQuarterTurn;
        const ViewSpec above = orthographic_view(camera.eye, view_basis(up, kQuarterTurn, {}), kMapWidth);
        view_ = make_view_context(above, mode, {.corrects_aspect = settings.correct_aspect});
        volume_ = make_view_volume(view_.frustum, View::ulp(), kMapFarthest);
    }

    void draw(const Vec3<World>& from, const Vec3<World>& to, const LineColour& colour) const {
        const auto line = project_line(volume_, view_.projection, {to_view(from, view_), to_view(to, view_)});
        if (line) draw_line(line->from, line->to, colour.style(method_), canvas_);
    }
    void draw_arrow(const Camera& camera, const LineColour& colour) const {
        const auto at = [&](Angle turn, World distance) {
            return camera.eye + times(distance, view_basis(camera.yaw + turn, {}, {}).forward);
        };
        constexpr Angle kSideways = Angle::from_bam(0x5800);  // the direction of the barbs: 124 degrees from ahead
        const Vec3<World> tip = at({}, kArrowLength), left = at(kSideways, kArrowHead),
                          right = at(-kSideways, kArrowHead);
        draw(tip, left, colour);
        draw(tip, right, colour);
        draw(left, camera.eye, colour);
        draw(right, camera.eye, colour);
    }

  private:
    LineMethod method_;
    Framebuffer canvas_;
    ViewContext view_;
    ViewVolume volume_;
};

Automap::Automap(const GameData& data, const GameLevel& level, ColourScheme scheme)
    : bsp_(data.level),
      level_(level),
      lines_(data.level.faces.size()),
      visible_(data.level),
      is_visible_(data.level.faces.size()),
      darker_(darker_colours(data.palette, kPictureBrightness)),
      wall_(data.palette, sign_colours_of(scheme).wall),
      step_(data.palette, sign_colours_of(scheme).step),
      door_(data.palette, sign_colours_of(scheme).door),
      hidden_(data.palette, sign_colours_of(scheme).hidden),
      player_(data.palette, sign_colours_of(scheme).player),
      lens_(data.palette, sign_colours_of(scheme).lens) {
    for (const FaceIndex face : bsp_.world().faces) lines_[face] = map_lines_of(bsp_, face);
}

void Automap::draw_world(const Plotter& plotter, const Vec3<World>& eye) {
    visible_.see_from(bsp_, find_leaf(bsp_, bsp_.world(), eye));
    is_visible_.assign(is_visible_.size(), 0);
    for (const LeafIndex leaf : bsp_.visible_leaves()) {
        if (!visible_.has_leaf(leaf)) continue;
        for (const FaceIndex face : bsp_.faces_at(bsp_.leaves[leaf])) is_visible_[face] = 1;
    }
    for (const bool shown : {false, true})  // visible lines over hidden ones
        for (const FaceIndex face : bsp_.world().faces) {
            if ((is_visible_[face] != 0) != shown) continue;
            for (const MapLine& line : lines_[face]) draw_line_of_world(plotter, line, shown);
        }
}

void Automap::draw_line_of_world(const Plotter& plotter, const MapLine& line, bool is_visible) const {
    if (line.kind == MapLineKind::Wall) return plotter.draw(line.from, line.to, is_visible ? wall_ : hidden_);
    const auto at = [&](std::int32_t thirds) {
        return between(line.from, line.to, World::from_int(thirds), World::from_int(3));
    };
    plotter.draw(line.from, at(1), is_visible ? step_ : hidden_);
    plotter.draw(at(2), line.to, is_visible ? step_ : hidden_);
}

void Automap::draw_models(const Plotter& plotter, const GameView& view) const {
    std::vector<PlacedModel> models = placed_models(level_, view.state);
    for (std::size_t i = 0; i < level_.movers.size(); ++i)  // doors that turn, while they are shut
        if (level_.movers[i].turns != 0 && view.state.after.movers[i].phase == MoverState::Phase::AtStart)
            models.push_back({level_.movers[i].model, {}});
    for (std::size_t i = 0; i < level_.movers.size(); ++i)
        if (stays_open(level_, view.state.after, i))
            std::erase_if(models, [&](const PlacedModel& each) { return each.model == level_.movers[i].model; });
    for (const PlacedModel& placed : models) {
        const Box box = box_of(bsp_.models[placed.model].box).moved(placed.offset);
        plotter.draw(box.mins, {box.maxs.x, box.maxs.y, box.mins.z}, door_);
        plotter.draw({box.maxs.x, box.mins.y, box.mins.z}, {box.mins.x, box.maxs.y, box.mins.z}, door_);
        for (const FaceIndex index : bsp_.models[placed.model].faces) {
            const Face& face = bsp_.faces[index];
            if (!is_wall(bsp_, face)) continue;
            for (const MapLine& line : lowest_edges(bsp_, face))
                plotter.draw(line.from + placed.offset, line.to + placed.offset, door_);
        }
    }
}

void Automap::draw_lenses(const Plotter& plotter, const GameView& view) const {
    const Vec3<World>& eye = view.camera.eye;
    for (const std::size_t lens : last_lenses(level_, view.state.after)) {
        Vec3<World> way = level_.items[lens].position - eye;
        way.z = {};
        const World distance = length_of(way);
        const bool is_beyond = distance > kRim;
        if (is_beyond) way = scaled(way, kRim, distance);
        const World half = is_beyond ? kFarMark : kMark;
        const Vec3<World> middle = eye + way, across{half, {}, {}}, along{{}, half, {}};
        const std::array corners{middle + across, middle + along, middle - across, middle - along};
        for (std::size_t i = 0; i < 4; ++i) plotter.draw(corners[i], corners[(i + 1) % 4], lens_);
    }
}

void Automap::draw(const GameView& view, MapView orientation, LineMethod method, const ScreenMode& mode,
                   const Settings& settings, Framebuffer canvas) {
    recolour_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, darker_);
    const Plotter plotter(view.camera, orientation, method, mode, settings, canvas);
    draw_world(plotter, view.camera.eye);
    draw_models(plotter, view);
    draw_lenses(plotter, view);
    plotter.draw_arrow(view.camera, player_);
}

}  // namespace oblong
