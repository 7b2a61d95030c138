#include "engine/frame/model_pass.h"

#include <algorithm>

#include "engine/frame/face_cover.h"
#include "engine/frame/frame_context.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/frame_fog.h"
#include "engine/frame/view_scratch.h"
#include "engine/scene/light_styles.h"
#include "engine/visibility/box_culler.h"

namespace oblong {

namespace {

/// From where a model is lit besides from all sides: from above, a little from one side (world axes).
constexpr Vec3<WorldWide> kTowardLight{WorldWide::from_int(2), WorldWide::from_int(1), WorldWide::from_int(4)};

ScreenRectangle intersection(const ScreenRectangle& a, const ScreenRectangle& b) {
    return {std::max(a.first_column, b.first_column), std::min(a.end_column, b.end_column),
            std::max(a.first_row, b.first_row), std::min(a.end_row, b.end_row)};
}

/// The pixels that a box may take, of those that are drawn.
ScreenRectangle pixels_of(const LevelBox& box, const ViewContext& view, const ScreenRectangle* part) {
    const ScreenRectangle screen{0, view.projection.width_px, 0, view.projection.height_px};
    const ScreenRectangle pixels = rectangle_of(box, view).value_or(screen);
    return part ? intersection(pixels, *part) : pixels;
}

bool is_hidden(const MeshInView& mesh, DepthBuffer& depth) {
    const ScreenRectangle& pixels = mesh.pixels;
    for (std::int32_t y = pixels.first_row; y < pixels.end_row; ++y) {
        const InverseDepth* const row = depth.row(y);
        if (std::any_of(row + pixels.first_column, row + pixels.end_column,
                        [&mesh](InverseDepth face) { return face <= mesh.nearest_depth; }))
            return false;
    }
    return true;
}

/// Half of a box's diagonal, in whole units.
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
    scratch.effects.mesh_lights.clear();
    for (const MovingLight& light : scratch.light.moving) {
        const auto way = saturating_convert<World>(widening_difference(light.position, middle));
        if (length(way) < convert<WorldWide>(light.radius) + reach) scratch.effects.mesh_lights.push_back(light);
    }
}

/// The light at a mesh's place: of the floor below it, a half from everywhere and a good half from above; and of what
/// moves.
MeshLight light_on(const MeshInView& mesh, const FrameContext& frame, const ViewScratch& scratch) {
    const std::optional<std::int32_t> below_8 =
        light_8_below(frame.scene.level, middle_of(mesh.box), scratch.light.styles);
    const std::int32_t level = std::min(below_8.value_or(kFullLight * 256) / 256, MeshLight::kMostLight);
    MeshLight light;
    light.ambient = std::max(level * 5 / 8, mesh.placed->least_light);
    light.directional = {normalised(kTowardLight), level * 5 / 8};
    light.points = scratch.effects.mesh_lights;
    light.brightness_100 = frame.settings.brightness_100;
    return light;
}

/// The colours of fog over a mesh, all of it as in its middle; null: none.
const std::uint8_t* fog_over(const MeshInView& mesh, const FrameContext& frame, ViewScratch& scratch) {
    if (!frame.fog.tables) return nullptr;
    const View z = to_view(middle_of(mesh.box), frame.view.eye, frame.view.axes).z;
    const ScreenRectangle& pixels = mesh.pixels;
    return fog_colours((pixels.first_column + pixels.end_column) / 2, (pixels.first_row + pixels.end_row) / 2,
                       reciprocal<InverseZ>(std::max(z, View::from_int(1))), frame.fog, scratch.effects.thing_runs)
        .data();
}

}  // namespace

void find_meshes(const FrameContext& frame, const Sight& sight, ViewScratch& scratch) {
    for (const PlacedMesh& placed : frame.scene.meshes) {
        if (!placed.mesh || placed.mesh->frames.empty()) continue;
        if (frame.mirror && is_behind(*frame.mirror, placed.position, frame.scene.level)) continue;
        if (!may_be_seen(frame.scene.level, turning_box(placed), sight.visible, sight.culler)) continue;
        const LevelBox box = world_box(placed);
        if (sight.culler.planes_crossed(box, kAllSides) == kOutside) continue;
        const ScreenRectangle pixels = pixels_of(box, sight.view, sight.part);
        if (pixels.first_column >= pixels.end_column || pixels.first_row >= pixels.end_row) continue;
        const InverseDepth nearest = nearest_depth_of(box, sight.view);
        if (!sight.may_show(pixels, nearest)) continue;
        scratch.depth.want(pixels);
        scratch.claims.things.meshes.push_back({&placed, pixels, box, nearest});
    }
    EffectSet& effects = scratch.claims.effects;
    if (!scratch.claims.things.meshes.empty()) effects = effects.with(Effect::Models);
}

void draw_meshes(const FrameContext& frame, ViewScratch& scratch) {
    if (!scratch.effects.meshes) scratch.effects.meshes = std::make_unique<MeshScratch>(frame.out.height_px);
    std::int64_t pixels = 0;
    for (const MeshInView& mesh : scratch.claims.things.meshes) {
        if (is_hidden(mesh, scratch.depth)) continue;  // behind the meshes before it
        gather_mesh_lights(mesh, scratch);
        const MeshDrawing drawing{frame.view, frame.cache.surfaces.colormap(), light_on(mesh, frame, scratch),
                                  fog_over(mesh, frame, scratch), frame.accuracy().texturing == Texturing::Affine};
        pixels +=
            draw_mesh(*mesh.placed, drawing, {scratch.depth, frame.out, mesh.pixels}, *scratch.effects.meshes).pixels;
    }
    if (frame.observers.counts) frame.observers.counts->of(Effect::Models) += pixels;
}

}  // namespace oblong
