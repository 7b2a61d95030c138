#include "engine/frame/mesh_pass.h"

#include <algorithm>

#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/frame_things.h"
#include "engine/frame/workspace.h"
#include "engine/raster/edges.h"
#include "engine/scene/light_styles.h"
#include "engine/visibility/box_culler.h"

namespace oblong {

namespace {

/// The direction of a model's directional light: from above, a little from one side (world axes).
constexpr Vec3<WorldWide> kTowardLight{WorldWide::from_int(2), WorldWide::from_int(1), WorldWide::from_int(4)};

/// The pixels that a box may cover, in the part of the screen that is drawn; null: all of it.
ScreenRectangle pixels_of(const LevelBox& box, const ViewContext& view, const ScreenRectangle* drawn_part) {
    const ScreenRectangle pixels = rectangle_of(box, view);
    return drawn_part ? intersection(pixels, *drawn_part) : pixels;
}

/// The pixels that a part of the mesh begun last may cover; empty if it is hidden.
ScreenRectangle pixels_of_part(const MeshBox& from, const MeshBox& to, const MeshToView& to_view,
                               const MeshTransform& transform, const Sight& sight) {
    const ViewBox box = to_view.is_usable ? view_box_of(from, to, to_view) : ViewBox{};
    if (box.nearest_z() < kExactFrom) {
        const LevelBox in_world = world_box(transform.to_world, from, to);
        return sight.may_show_part(in_world) ? rectangle_of(in_world, sight.view) : ScreenRectangle{};
    }
    const ScreenOutline outline = outline_of(box, sight.view.projection);
    const bool may_show = !is_empty(outline.pixels) && sight.may_show_part(outline, nearest_inverse_depth_of(box));
    return may_show ? outline.pixels : ScreenRectangle{};
}

/// Finds the parts of the mesh begun last that may be visible, and sets its pixels to theirs; empty if there are none.
void find_parts(const Sight& sight, MeshInView& mesh, std::vector<std::uint32_t>& parts) {
    const std::vector<MeshBox>&from = frame_of(*mesh.placed).parts, &to = next_frame_of(*mesh.placed).parts;
    const std::size_t count = std::min(from.size(), to.size());
    if (count == 0) return;
    const MeshToView to_view = make_mesh_to_view(mesh.placed->position, *mesh.transform, sight.view);
    ScreenRectangle all{};
    mesh.first_part = parts.size();
    for (std::uint32_t part = 0; part < count; ++part) {
        const ScreenRectangle pixels = pixels_of_part(from[part], to[part], to_view, *mesh.transform, sight);
        if (is_empty(pixels)) continue;
        all = is_empty(all) ? pixels : joined(all, pixels);
        parts.push_back(part);
    }
    mesh.pixels = is_empty(all) || !sight.drawn_part ? all : intersection(all, *sight.drawn_part);
    mesh.part_count = parts.size() - mesh.first_part;
}

bool is_hidden(const MeshInView& mesh, DepthBuffer& depth) {
    const ScreenRectangle& pixels = mesh.pixels;
    for (std::int32_t y = pixels.first_row; y < pixels.end_row; ++y) {
        const InverseDepth* const row = depth.row(y);
        if (std::any_of(row + pixels.first_column, row + pixels.end_column,
                        [&mesh](InverseDepth face) { return face <= (mesh.nearest_inverse_depth | kThingBit); }))
            return false;
    }
    return true;
}

bool have_same_shape(const PlacedMesh& a, const PlacedMesh& b) {
    return a.mesh == b.mesh && a.position == b.position && a.frame == b.frame && a.next_frame == b.next_frame &&
           a.scale == b.scale;
}

/// Whether a mesh of the scene, in any rotation, is in the visible set; found again when it has moved.
bool is_in_set(const PlacedMesh& placed, const Level& level, const VisibleSet& visible, MeshPlace& known) {
    if (!have_same_shape(known.placed, placed)) {
        const TurningShape shape = turning_shape(placed);
        if (known.shape != shape) {
            known = {};
            known.shape = shape;
            known.any_turn = place_box(level, turning_box(shape));
        }
        known.placed = placed;
        known.box.reset();
    }
    if (known.seen_from != visible.seen_from()) {
        known.seen_from = visible.seen_from();
        known.is_in_set = reaches(known.any_turn, visible.leaf_set());
    }
    return known.is_in_set;
}

/// Its box as it stands, found again when it has turned.
const LevelBox& box_of(const PlacedMesh& placed, MeshPlace& known) {
    if (!known.box || known.placed != placed) {
        known.placed = placed;
        known.box = world_box(placed);
        known.transform.reset();
    }
    return *known.box;
}

/// Half of a box's diagonal.
WorldWide reach_of(const LevelBox& box) {
    const Vec3<World> diagonal{World::from_raw((box.maxs[0] - box.mins[0]) * 2048),
                               World::from_raw((box.maxs[1] - box.mins[1]) * 2048),
                               World::from_raw((box.maxs[2] - box.mins[2]) * 2048)};
    return length(diagonal);
}

/// The frame's lights that reach a mesh's box.
void gather_mesh_lights(const MeshInView& mesh, ViewScratch& scratch) {
    const Vec3<World> middle = middle_of(mesh.box);
    const WorldWide reach = reach_of(mesh.box);
    scratch.effects->mesh_lights.clear();
    for (const MovingLight& light : scratch.light.moving) {
        const auto way = saturating_convert<World>(widening_difference(light.position, middle));
        if (length(way) < convert<WorldWide>(light.radius) + reach) scratch.effects->mesh_lights.push_back(light);
    }
}

/// The light on a mesh: 5/8 of the light of the floor `below` as ambient light, and 5/8 directional; and moving lights.
MeshLight light_on(const MeshInView& mesh, const std::optional<LightAt>& below, const FrameContext& frame,
                   const ViewScratch& scratch) {
    const std::int32_t light_level =
        std::min(below ? below->light_8 / 256 : std::int32_t{kFullLight}, MeshLight::kMostLight);
    MeshLight light;
    light.ambient = std::max(light_level * 5 / 8, mesh.placed->least_light);
    light.directional = {normalised(kTowardLight), light_level * 5 / 8};
    light.points = scratch.effects->mesh_lights;
    light.brightness_100 = frame.settings.brightness_100;
    return light;
}

/// The colours of fog at a mesh's middle, used for all of it; null: no fog there.
const std::uint8_t* fog_over(const MeshInView& mesh, const FrameContext& frame, ViewScratch& scratch) {
    if (!frame.fog.tables) return nullptr;
    const View z = to_view(middle_of(mesh.box), frame.view.eye, frame.view.axes).z;
    const ScreenRectangle& pixels = mesh.box_pixels;
    const ColourRow& colours =
        fog_colours((pixels.first_column + pixels.end_column) / 2, (pixels.first_row + pixels.end_row) / 2,
                    reciprocal<InverseZ>(std::max(z, View::from_int(1))), frame.fog, scratch.effects->fog_runs);
    return &colours == &frame.fog.tables->colours(0) ? nullptr : colours.data();
}

/// The mesh's own effect, and those of its light and fog, with its pixels.
void add_effects(const MeshDrawing& drawing, const std::optional<LightAt>& below, std::int64_t pixels,
                 const FrameContext& frame, Claims& claims) {
    FrameCounts* const counts = frame.observers.counts;
    claims.add(Effect::Meshes, pixels, counts);
    if (!drawing.light.points.empty()) claims.add(Effect::Lights, pixels, counts);
    if (drawing.colours) claims.add(Effect::Fog, pixels, counts);
    if (below && frame.allows(Effect::Styles) && frame.cache.faces[below->face].effects.has(Effect::Styles))
        claims.add(Effect::Styles, pixels, counts);
}

/// Whether a triangle of the mesh begun last may show: asked before any depth is filled.
bool may_show(const MeshInView& mesh, const Sight& sight, ViewScratch& scratch) {
    std::unique_ptr<MeshScratch>& work = scratch.effects->meshes;
    if (!work) work = std::make_unique<MeshScratch>(sight.view.projection.height_px);
    work->begun = nullptr;  // of another view
    const auto may_show_triangle = [&](const std::array<const ScreenPlace*, 3>& corners) {
        const auto& [a, b, c] = corners;
        const ScreenRectangle pixels = box_around({a->screen, b->screen, c->screen}, mesh.pixels);
        return !is_empty(pixels) &&
               sight.may_show_part(pixels, to_inverse_depth(std::max({a->inverse_z, b->inverse_z, c->inverse_z})));
    };
    return any_in_view(*mesh.placed, scratch.claims.things.parts_of(mesh), *mesh.transform, sight.view, *work,
                       may_show_triangle);
}

}  // namespace

void find_meshes(const FrameContext& frame, const Sight& sight, ViewScratch& scratch) {
    FrameThings& things = scratch.claims.things;
    frame.cache.mesh_places.resize(frame.scene.meshes.size());
    for (std::size_t i = 0; i < frame.scene.meshes.size(); ++i) {
        const PlacedMesh& placed = frame.scene.meshes[i];
        MeshPlace& known = frame.cache.mesh_places[i];
        if (!placed.mesh || placed.mesh->frames.empty()) continue;
        if (!is_in_set(placed, frame.scene.level, scratch.visible, known)) continue;
        if (frame.mirror && is_behind(*frame.mirror, placed.position, frame.scene.level)) continue;
        const Hidden hidden = sight.hidden(known.any_turn);
        if (hidden == Hidden::Everywhere) continue;
        const LevelBox& box = box_of(placed, known);
        const ScreenRectangle pixels = pixels_of(box, sight.view, sight.drawn_part);
        const InverseDepth nearest = nearest_inverse_depth_of(box, sight.view);
        if (is_empty(pixels) || !sight.may_show(pixels, nearest, hidden) ||
            !sight.may_show_part(outline_of(box, sight.view), nearest))
            continue;
        if (!known.transform) known.transform = make_mesh_transform(placed);
        if (!known.transform) continue;
        MeshInView mesh{&placed, &*known.transform, box, pixels, nearest, pixels};
        find_parts(sight, mesh, things.mesh_parts);
        if (is_empty(mesh.pixels) || (things.meshes.empty() && !may_show(mesh, sight, scratch))) continue;
        scratch.depth.want(mesh.pixels);
        things.meshes.push_back(mesh);
    }
}

void keep_seen_meshes(const FrameContext& frame, ViewScratch& scratch) {
    FrameThings& things = scratch.claims.things;
    const auto seen = std::find_if(things.meshes.begin(), things.meshes.end(), [&](const MeshInView& mesh) {
        const MeshTarget target{scratch.depth, frame.out, mesh.pixels};
        return !is_hidden(mesh, scratch.depth) && is_seen(*mesh.placed, things.parts_of(mesh), *mesh.transform,
                                                          frame.view, target, *scratch.effects->meshes);
    });
    things.meshes.erase(things.meshes.begin(), seen);
    if (!things.meshes.empty()) scratch.claims.effects = scratch.claims.effects.with(Effect::Meshes);
}

void draw_meshes(const FrameContext& frame, ViewScratch& scratch) {
    for (const MeshInView& mesh : scratch.claims.things.meshes) {
        if (is_hidden(mesh, scratch.depth)) continue;  // by earlier meshes
        gather_mesh_lights(mesh, scratch);
        const std::optional<LightAt> below = light_below(frame.scene.level, middle_of(mesh.box), scratch.light.styles);
        const MeshDrawing drawing{frame.view,
                                  frame.cache.surfaces.colormap(),
                                  light_on(mesh, below, frame, scratch),
                                  fog_over(mesh, frame, scratch),
                                  frame.accuracy().texturing == Texturing::Affine,
                                  scratch.claims.things.parts_of(mesh),
                                  mesh.transform};
        const std::int64_t pixels =
            draw_mesh(*mesh.placed, drawing, {scratch.depth, frame.out, mesh.pixels}, *scratch.effects->meshes).pixels;
        if (pixels > 0) add_effects(drawing, below, pixels, frame, scratch.claims);
    }
}

}  // namespace oblong
