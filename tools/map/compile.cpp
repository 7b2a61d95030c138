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

bool has_side_of(const MapBrush& brush, bool (*is_meant)(std::string_view)) {
    return std::any_of(brush.sides.begin(), brush.sides.end(),
                       [is_meant](const MapSide& side) { return is_meant(side.texture.name); });
}

bool is_left_out(const MapBrush& brush, Warnings* warnings) {
    const bool is_origin = has_side_of(brush, is_origin_texture);
    if (is_origin && warnings != nullptr)
        warnings->add(
            brush.line,
            "a brush with the texture 'origin', which marks the axis of a turning entity in other engines, is "
            "ignored: expected the key 'origin' instead");
    return is_origin || has_side_of(brush, is_hint_texture);
}

LevelBrushes make_brushes(const std::vector<MapEntity>& entities, Warnings* warnings, const WorkSharing& sharing) {
    struct Started {
        std::size_t model = 0, brush = 0;
        int line = 0;
    };
    std::vector<Started> started;
    LevelBrushes level;
    level.models.emplace_back();
    for (const MapEntity& entity : entities) {
        if (entity.brushes.empty()) continue;
        if (!belongs_to_world(entity)) level.models.emplace_back();
        const std::size_t model = belongs_to_world(entity) ? 0 : level.models.size() - 1;
        for (const MapBrush& brush : entity.brushes) {
            if (is_left_out(brush, warnings)) continue;
            started.push_back({model, level.models[model].size(), brush.line});
            level.models[model].push_back(start_brush(brush, level.planes, level.textures));
            level.models[model].back().is_detail = is_detail_entity(entity);
            level.models[model].back().shows_inside = model > 0 && number_of(entity, "_mirrorinside", 0) > 0;
            // As with id's compiler: an entity of liquid or sky stops players; what it looks like goes by its texture.
            if (model > 0) level.models[model].back().contents = contents::kSolid;
        }
    }
    for (const TextureUse& use : shown_textures(entities)) level.textures.find_or_add_name(use);
    if (level.models.front().empty())
        throw InputError(at_line(entities.front().line),
                         "the world has no brushes, expected a room that encloses the entities");
    sharing.begin("tree", started.size());
    sharing.for_each(started.size(), [&](std::size_t i) {
        complete_brush(level.models[started[i].model][started[i].brush], started[i].line, level.planes);
    });
    return level;
}

bool is_start(const MapEntity& entity) {
    return role_of(entity) == ClassRole::Start;
}

bool is_start_inside(const Leak& leak, const std::vector<const MapEntity*>& at_start) {
    for (std::size_t i = 0; i < at_start.size(); ++i)
        if (leak.inside[i] && is_start(*at_start[i])) return true;
    return false;
}

// The player arrives at this height above a start or a teleporter's exit.
double arrival_height(const MapEntity& entity) {
    return is_start(entity) ? 1 : 27;
}

void check_arrivals(const Tree& player_hull, const PlaneList& planes, const std::vector<MapEntity>& entities,
                    Warnings& warnings) {
    for (const MapEntity& entity : entities) {
        const auto origin = origin_of(entity);
        if (!origin || (!is_start(entity) && role_of(entity) != ClassRole::TeleportExit)) continue;
        const auto leaves = leaves_at(player_hull, planes, *origin + Point{0, 0, arrival_height(entity)});
        if (std::all_of(leaves.begin(), leaves.end(),
                        [&](int leaf) { return is_opaque(player_hull.leaf(leaf).contents); }))
            warnings.add(entity.line, "the " + entity.value("classname") + " at " + points_text({*origin}) +
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

// Positions from which the void must not be reachable, and their entities.
struct Inhabitants {
    std::vector<Point> starts;
    std::vector<const MapEntity*> at_start;
};

Inhabitants inhabitants_of(const std::vector<MapEntity>& entities) {
    Inhabitants found;
    for (const MapEntity& entity : entities) {
        const auto origin = origin_of(entity);
        if (!origin || !entity.brushes.empty() || shines_by_surfaces(entity)) continue;
        found.starts.push_back(*origin);
        found.at_start.push_back(&entity);
    }
    return found;
}

// A draft keeps what is outside.
void check_world(const ModelResult& world, const Inhabitants& inhabitants, const MapEntity& worldspawn,
                 const CompileOptions& options) {
    if (world.leak) {
        const MapEntity& entity = *inhabitants.at_start[world.leak->start];
        const LeakError leak(entity, world.leak->path, is_start_inside(*world.leak, inhabitants.at_start));
        if (!options.is_fast || options.leak_path == nullptr) throw leak;
        *options.leak_path = leak.path;
        if (options.warnings != nullptr)
            options.warnings->add(entity.line, std::string(leak.what()) + "; the draft shows its outside, too");
    }
    if (!has_inside(world.model.tree))
        throw InputError(at_line(worldspawn.line), "the level encloses no space, expected a room around the entities");
}

// The world is first.
std::vector<CompiledModel> compile_models(LevelBrushes& level, const std::vector<MapEntity>& entities,
                                          const CompileOptions& options, const WorkSharing& sharing) {
    const Inhabitants inhabitants = inhabitants_of(entities);
    std::deque<ModelCompiler> compilers;
    for (const std::vector<Brush>& brushes : level.models)
        compilers.emplace_back(brushes, level.planes, level.textures.texinfos(),
                               compilers.empty() ? SealStarts(inhabitants.starts) : std::nullopt, options.is_fast);
    const std::size_t parts = compilers.front().part_count();
    sharing.begin("tree", parts * compilers.size());
    sharing.for_each(parts * compilers.size(), [&](std::size_t i) { compilers[i / parts].do_part(i % parts); });
    check_world(compilers.front().result(), inhabitants, entities.front(), options);
    std::vector<CompiledModel> models;
    for (ModelCompiler& compiler : compilers) models.push_back(std::move(compiler.result().model));
    return models;
}

LightOptions light_options(const CompileOptions& options, const TextureList& textures) {
    LightOptions light{options.is_fast, options.has_dirt, options.has_bounce, options.warnings, options.palette, {}};
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
                      const CompileOptions& options, const WorkSharing& sharing) {
    sharing.begin("tree", 1);
    BspFile bsp = options.former;
    PlaneList planes = brushes.planes;
    BspFile expected;
    expected.textures = bsp.textures;
    check_same_brushes(brushes.textures.names().size() <= bsp.textures.size());
    Emitter(expected, planes).add_texinfos(brushes.textures.texinfos());
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
    add_light(bsp, entities, light_options(options, brushes.textures), sharing);
    return bsp;
}

void check_budget(const BspFile& bsp, int line, Warnings& warnings) {
    const WidestView widest = widest_view(bsp);
    if (widest.faces > kMostInSight)
        warnings.add(line, std::to_string(widest.faces) + " faces may be visible from around " +
                               points_text({widest.place}) + ", expected at most " + std::to_string(kMostInSight) +
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
                     points_text({way_out.front()}) +
                     (is_start_inside ? " is outside of the level, which is sealed around its start: expected it inside"
                                      : " is open to the void, expected brushes all around")),
      path(std::move(way_out)) {}

std::string points_text(const std::vector<Point>& path) {
    std::string text;
    for (const Point& point : path) {
        if (!text.empty()) text += '\n';
        text += number_text(point.x) + ' ' + number_text(point.y) + ' ' + number_text(point.z);
    }
    return text;
}

BspFile compile_map(std::vector<MapEntity> entities, const std::vector<Wad>& wads, const CompileOptions& options) {
    const WorkSharing sharing(options.workers, options.progress);
    assign_switchable_styles(entities);
    set_surface_light(entities);
    bring_world_forward(entities);
    split_off_fences(entities);
    LevelBrushes level = make_brushes(entities, options.warnings, sharing);
    if (options.part == CompilePart::Entities || options.part == CompilePart::Light)
        return changed_level(entities, level, options, sharing);
    BspFile bsp;
    bsp.textures = collect_textures(level.textures.names(), wads, options.warnings);
    const std::vector<CompiledModel> models = compile_models(level, entities, options, sharing);
    const CompiledModel& world = models.front();
    Emitter emitter(bsp, level.planes);
    emitter.add_texinfos(level.textures.texinfos());
    if (options.warnings != nullptr) {
        check_arrivals(world.hulls[0], level.planes, entities, *options.warnings);
        check_models(world.tree, level, entities, *options.warnings);
    }
    const std::vector<int> leaf_indices = emitter.add_model(world);
    for (std::size_t i = 1; i < models.size(); ++i) emitter.add_model(models[i]);
    bsp.entities = entities_text(entities);
    if (bsp.faces.empty())
        throw InputError(at_line(entities.front().line),
                         "no face of the level is drawn, expected a texture other than 'skip' and 'clip'");
    check_size(bsp);
    if (options.warnings != nullptr) {
        find_unused_wads(wads, level.textures.names(), *options.warnings);
        find_level_warnings(bsp, entities, level.textures.names(), *options.warnings);
    }
    if (options.before_long_passes) options.before_long_passes();
    const bool is_open = options.leak_path != nullptr && !options.leak_path->empty();  // all of it is in sight
    if (!is_open) add_visibility(bsp, world, leaf_indices, level.planes, options.is_fast, sharing, options.portals);
    if (options.warnings != nullptr && !is_open) check_budget(bsp, entities.front().line, *options.warnings);
    if (options.part == CompilePart::Visibility)
        take_light(bsp, options.former);
    else
        add_light(bsp, entities, light_options(options, level.textures), sharing);
    return bsp;
}

}  // namespace oblong::map
