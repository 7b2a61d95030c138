#include "tools/map/compile.h"

#include <algorithm>
#include <deque>
#include <set>
#include <tuple>

#include "engine/level/entity_classes.h"
#include "tools/map/light/level_checks.h"
#include "tools/map/light/lightmaps.h"
#include "tools/map/light/sources.h"
#include "tools/map/source/entities.h"
#include "tools/map/tree/emit.h"
#include "tools/map/tree/mesh.h"
#include "tools/map/vis/visibility.h"

namespace oblong::map {
namespace {

// The brushes of a level: the world's, and each brush entity's.
struct LevelBrushes {
    PlaneList planes;
    TextureList textures;
    std::vector<std::vector<Brush>> models;
};

bool is_left_out(const MapBrush& brush, Warnings& warnings) {
    const auto has_side_of = [&](std::string_view texture) {
        return std::any_of(brush.sides.begin(), brush.sides.end(),
                           [&](const MapSide& side) { return side.texture.name == texture; });
    };
    const bool is_origin = has_side_of("origin");
    if (is_origin)
        warnings.add(brush.line,
                     "a brush with the texture 'origin', which marks the axis of a turning entity in other engines, is "
                     "ignored: expected the key 'origin' instead");
    return is_origin || has_side_of("hint") || has_side_of("hintskip");  // the latter: where others cut the tree
}

LevelBrushes make_brushes(const std::vector<MapEntity>& entities, Warnings& warnings, const WorkSharing& sharing) {
    LevelBrushes level;
    level.models.emplace_back();
    for (const MapEntity& entity : entities) {
        if (entity.brushes.empty()) continue;
        const bool is_of_world = belongs_to_world(entity);
        std::vector<Brush>& model = is_of_world ? level.models.front() : level.models.emplace_back();
        for (const MapBrush& source : entity.brushes) {
            if (is_left_out(source, warnings)) continue;
            Brush& brush = model.emplace_back(start_brush(source, level.planes, level.textures));
            brush.is_detail = is_detail_entity(entity);
            brush.shows_inside = !is_of_world && number_of(entity, "_mirrorinside", 0) > 0;
            // As with id's compiler: an entity of liquid or sky stops players; what it looks like goes by its texture.
            if (!is_of_world) brush.contents = contents::kSolid;
        }
    }
    for (const TextureUse& use : shown_textures(entities)) level.textures.find_or_add_name(use);
    if (level.models.front().empty())
        throw InputError(at_line(entities.front().line),
                         "the world has no brushes, expected a room that encloses the entities");
    std::vector<Brush*> started;
    for (std::vector<Brush>& model : level.models)
        for (Brush& brush : model) started.push_back(&brush);
    sharing.begin("tree", started.size());
    sharing.for_each(started.size(), [&](std::size_t i) { complete_brush(*started[i], level.planes); });
    return level;
}

bool is_start(const MapEntity& entity) {
    return role_of(entity) == ClassRole::Start;
}

bool is_start_inside(const Leak& leak, const std::vector<const MapEntity*>& inhabitants) {
    for (std::size_t i = 0; i < inhabitants.size(); ++i)
        if (leak.inside[i] && is_start(*inhabitants[i])) return true;
    return false;
}

void check_arrivals(const Tree& player_hull, const PlaneList& planes, const std::vector<MapEntity>& entities,
                    Warnings& warnings) {
    for (const MapEntity& entity : entities) {
        const auto origin = origin_of(entity);
        if (!origin || (!is_start(entity) && role_of(entity) != ClassRole::TeleportExit)) continue;
        const double height = is_start(entity) ? 1 : 27;  // at which the player arrives
        const auto leaves = leaves_at(player_hull, planes, *origin + Point{0, 0, height});
        if (std::all_of(leaves.begin(), leaves.end(),
                        [&](int leaf) { return is_opaque(player_hull.leaf(leaf).contents); }))
            warnings.add(entity.line, "the " + entity.value("classname") + " at " + point_text(*origin) +
                                          " is in a wall, expected room for the player, 32 x 32 x 56 units");
    }
}

// A train goes where its path begins; a trigger that others activate need not be where players are.
bool may_be_outside(const MapEntity& entity) {
    const ClassRole role = role_of(entity);
    const bool is_never_touched = role == ClassRole::TriggerRelay || role == ClassRole::TriggerCounter ||
                                  role == ClassRole::Timer || role == ClassRole::Lightning;
    return role == ClassRole::Train || is_never_touched || (is_trigger(role) && !entity.value("targetname").empty());
}

// Brushes in a wall are meant, as a hidden door's are.
void check_models(const Tree& world, const LevelBrushes& level, const std::vector<MapEntity>& entities,
                  Warnings& warnings) {
    const BrushContents walls(level.models.front(), level.planes);
    const auto is_in_open = [&](const BrushSide& side) {
        const auto pieces =
            pieces_in_leaves(world, level.planes, world.root, side.winding, level.planes.facing(side.plane));
        return std::any_of(pieces.begin(), pieces.end(),
                           [&](const LeafPiece& piece) { return !is_opaque(world.leaf(piece.leaf).contents); });
    };
    const auto is_placed = [&](const Brush& brush) {
        return is_opaque(walls.at((brush.box.mins + brush.box.maxs) * 0.5)) ||
               std::any_of(brush.sides.begin(), brush.sides.end(), is_in_open);
    };
    std::size_t model = 0;
    for (const MapEntity& entity : entities) {
        if (entity.brushes.empty() || belongs_to_world(entity)) continue;
        const std::vector<Brush>& brushes = level.models[++model];
        if (may_be_outside(entity) || std::any_of(brushes.begin(), brushes.end(), is_placed)) continue;
        warnings.add(entity.line, "the brushes of " + entity.value("classname", "an entity") +
                                      " are outside of the level, which is sealed: expected them inside");
    }
}

// Entities from whose origin the void must not be reachable.
std::vector<const MapEntity*> inhabitants_of(const std::vector<MapEntity>& entities) {
    std::vector<const MapEntity*> found;
    for (const MapEntity& entity : entities)
        if (origin_of(entity) && entity.brushes.empty() && !shines_by_surfaces(entity)) found.push_back(&entity);
    return found;
}

// A draft keeps what is outside.
void check_world(const ModelResult& world, const std::vector<const MapEntity*>& inhabitants,
                 const MapEntity& worldspawn, const CompileOptions& options, Warnings& warnings) {
    if (world.leak) {
        const MapEntity& entity = *inhabitants[world.leak->start];
        const LeakError leak(entity, world.leak->path, is_start_inside(*world.leak, inhabitants));
        if (!options.is_fast || options.leak_path == nullptr) throw leak;
        *options.leak_path = leak.path;
        warnings.add(entity.line, std::string(leak.what()) + "; the draft shows its outside, too");
    }
    if (!has_inside(world.model.tree))
        throw InputError(at_line(worldspawn.line), "the level encloses no space, expected a room around the entities");
}

// The world is first.
std::vector<CompiledModel> compile_models(LevelBrushes& level, const std::vector<MapEntity>& entities,
                                          const CompileOptions& options, Warnings& warnings,
                                          const WorkSharing& sharing) {
    const std::vector<const MapEntity*> inhabitants = inhabitants_of(entities);
    std::vector<Point> starts;
    for (const MapEntity* inhabitant : inhabitants) starts.push_back(*origin_of(*inhabitant));
    std::deque<ModelCompiler> compilers;
    for (const std::vector<Brush>& brushes : level.models)
        compilers.emplace_back(brushes, level.planes, level.textures.texinfos(),
                               compilers.empty() ? SealStarts(starts) : std::nullopt, options.is_fast);
    const std::size_t parts = compilers.front().part_count();
    sharing.begin("tree", parts * compilers.size());
    sharing.for_each(parts * compilers.size(), [&](std::size_t i) { compilers[i / parts].do_part(i % parts); });
    check_world(compilers.front().result(), inhabitants, entities.front(), options, warnings);
    std::vector<CompiledModel> models;
    for (ModelCompiler& compiler : compilers) models.push_back(std::move(compiler.result().model));
    return models;
}

LightOptions light_options(const CompileOptions& options, const TextureList& textures) {
    LightOptions light{options.is_fast, options.has_dirt, options.has_bounce, options.palette, {}};
    for (const TexInfo& texinfo : textures.texinfos()) light.surfaces.push_back(texinfo.light);
    return light;
}

void check_same_brushes(bool are_same) {
    if (!are_same)
        throw InputError("--only",
                         "the brushes differ from those of the existing level: compile it once without --only");
}

// Whether each face is in the plane of a brush side with its texture: a moved brush leaves its faces behind.
bool are_on_sides(const BspFile& bsp, const LevelBrushes& brushes) {
    std::set<std::tuple<Floats, float, int>> sides;  // normal, distance, texinfo
    for (const std::vector<Brush>& model : brushes.models)
        for (const Brush& brush : model)
            for (const BrushSide& side : brush.sides) {
                const Plane& plane = brushes.planes[side.plane.plane];
                sides.insert({to_floats(plane.normal), static_cast<float>(plane.distance), side.texinfo});
            }
    return std::all_of(bsp.faces.begin(), bsp.faces.end(), [&](const FileFace& face) {
        const FilePlane& plane = item(bsp.planes, face.plane);
        return sides.contains({plane.normal, plane.distance, face.texinfo});
    });
}

// The former level with new entities, and new light if required.
BspFile changed_level(const std::vector<MapEntity>& entities, const LevelBrushes& brushes,
                      const CompileOptions& options, Warnings& warnings, const WorkSharing& sharing) {
    sharing.begin("tree", 1);
    BspFile bsp = options.former, expected;
    expected.textures = bsp.textures;
    check_same_brushes(brushes.textures.names().size() <= bsp.textures.size());
    Emitter(expected, brushes.planes).add_texinfos(brushes.textures.texinfos());
    check_same_brushes(bsp.models.size() == brushes.models.size() && bsp.texinfos == expected.texinfos &&
                       are_on_sides(bsp, brushes));
    bsp.entities = entities_text(entities);
    if (options.part == CompilePart::Entities) return bsp;
    bsp.lighting.clear();
    bsp.coloured_lighting.clear();
    for (FileFace& face : bsp.faces) {
        face.styles = FileFace{}.styles;
        face.light_offset = -1;
    }
    add_light(bsp, entities, light_options(options, brushes.textures), warnings, sharing);
    return bsp;
}

void check_budget(const BspFile& bsp, int line, Warnings& warnings) {
    const WidestView widest = widest_view(bsp);
    if (widest.faces > kMostInSight)
        warnings.add(line, std::to_string(widest.faces) + " faces may be visible from around " +
                               point_text(widest.place) + ", expected at most " + std::to_string(kMostInSight) +
                               ": hide rooms from each other behind walls, or make textures of what is small");
}

void take_light(BspFile& bsp, const BspFile& former) {
    check_same_brushes(bsp.faces.size() == former.faces.size() && bsp.vertices == former.vertices);
    for (std::size_t i = 0; i < bsp.faces.size(); ++i) {
        bsp.faces[i].styles = former.faces[i].styles;
        bsp.faces[i].light_offset = former.faces[i].light_offset;
    }
    bsp.lighting = former.lighting;
    bsp.coloured_lighting = former.coloured_lighting;
}

}  // namespace

LeakError::LeakError(const MapEntity& entity, std::vector<Point> way_out, bool is_start_inside)
    : InputError(at_line(entity.line),
                 (is_start_inside ? "" : "the level leaks: ") + entity.value("classname", "an entity") + " at " +
                     point_text(way_out.front()) +
                     (is_start_inside ? " is outside of the level, which is sealed around its start: expected it inside"
                                      : " is open to the void, expected brushes all around")),
      path(std::move(way_out)) {}

BspFile compile_map(std::vector<MapEntity> entities, const std::vector<Wad>& wads, const CompileOptions& options) {
    const WorkSharing sharing(options.workers, options.progress);
    Warnings unheard;
    Warnings& warnings = options.warnings != nullptr ? *options.warnings : unheard;
    assign_switchable_styles(entities);
    set_surface_light(entities);
    bring_world_forward(entities);
    split_off_fences(entities);
    LevelBrushes level = make_brushes(entities, warnings, sharing);
    if (options.part == CompilePart::Entities || options.part == CompilePart::Light)
        return changed_level(entities, level, options, warnings, sharing);
    BspFile bsp;
    bsp.textures = collect_textures(level.textures.names(), wads, warnings);
    const std::vector<CompiledModel> models = compile_models(level, entities, options, warnings, sharing);
    const CompiledModel& world = models.front();
    Emitter emitter(bsp, level.planes);
    emitter.add_texinfos(level.textures.texinfos());
    check_arrivals(world.hulls[0], level.planes, entities, warnings);
    check_models(world.tree, level, entities, warnings);
    const std::vector<int> leaf_indices = emitter.add_model(world);
    for (std::size_t i = 1; i < models.size(); ++i) emitter.add_model(models[i]);
    bsp.entities = entities_text(entities);
    if (bsp.faces.empty())
        throw InputError(at_line(entities.front().line),
                         "no face of the level is drawn, expected a texture other than 'skip' and 'clip'");
    check_size(bsp);
    find_unused_wads(wads, level.textures.names(), warnings);
    find_level_warnings(bsp, entities, level.textures.names(), warnings);
    if (options.before_long_passes) options.before_long_passes();
    const bool is_open = options.leak_path != nullptr && !options.leak_path->empty();  // all of it is in sight
    if (!is_open) add_visibility(bsp, world, leaf_indices, level.planes, options.is_fast, sharing, options.portals);
    if (!is_open) check_budget(bsp, entities.front().line, warnings);
    if (options.part == CompilePart::Visibility)
        take_light(bsp, options.former);
    else
        add_light(bsp, entities, light_options(options, level.textures), warnings, sharing);
    return bsp;
}

}  // namespace oblong::map
