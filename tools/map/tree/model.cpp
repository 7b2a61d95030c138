#include "tools/map/tree/model.h"

#include "tools/map/source/brush.h"
#include "tools/map/tree/surfaces.h"

namespace oblong::map {
namespace {

constexpr double kMargin = 128;  // more than the movers' boxes add

struct Partition {
    Tree tree;
    Portals portals;
};

Partition partition_brushes(const std::vector<Brush>& brushes, const PlaneList& planes, const Box& outer) {
    Partition made;
    made.tree = build_tree(outline(brushes, planes), planes);
    made.portals = find_portals(made.tree, planes, outer);
    fill_leaves(made.tree, made.portals, [&](const Point& point) { return contents_at(brushes, planes, point); });
    return made;
}

// The same division into contents by a tree of their boundaries alone: smaller, as the inside of what is solid and
// the outside of the level no longer matter.
Partition refined(const Partition& rough, const PlaneList& planes, const Box& outer) {
    Partition made;
    made.tree = build_tree(boundaries(rough.tree, rough.portals), planes);
    made.portals = find_portals(made.tree, planes, outer);
    fill_leaves(made.tree, made.portals,
                [&](const Point& point) { return rough.tree.leaf(leaf_at(rough.tree, planes, point)).contents; });
    return made;
}

Tree make_hull(const std::vector<Brush>& brushes, const Box& mover, PlaneList& planes, const Box& outer,
               const SealStarts& starts) {
    Partition rough = partition_brushes(hull_brushes(brushes, mover, planes), planes, outer);
    if (starts) fill_outside(rough.tree, planes, rough.portals, *starts);
    return refined(rough, planes, outer).tree;
}

Box box_of_brushes(const std::vector<Brush>& brushes) {
    Box box;
    for (const Brush& brush : brushes) box.add(brush.box);
    return box;
}

void make_mesh(CompiledModel& model) {
    for (const Surface& surface : model.surfaces) {
        Loop loop;
        for (const Point& point : surface.winding) loop.push_back(model.vertices.find_or_add(point));
        model.loops.push_back(std::move(loop));
    }
    fix_t_junctions(model.loops, model.vertices);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < model.loops.size(); ++i) {
        if (model.loops[i].empty()) continue;
        std::swap(model.loops[kept], model.loops[i]);
        std::swap(model.surfaces[kept], model.surfaces[i]);
        ++kept;
    }
    model.loops.resize(kept);
    model.surfaces.resize(kept);
}

}  // namespace

ModelResult compile_model(const std::vector<Brush>& brushes, PlaneList& planes, const std::vector<TexInfo>& texinfos,
                          const SealStarts& starts) {
    ModelResult result;
    CompiledModel& model = result.model;
    model.box = box_of_brushes(brushes);
    const Box outer = model.box.grown(kMargin);
    std::vector<Brush> seen = brushes;
    std::erase_if(seen, [](const Brush& brush) { return brush.is_clip; });
    Partition rough = partition_brushes(seen, planes, outer);
    if (starts) result.leak = fill_outside(rough.tree, planes, rough.portals, *starts);
    if (result.leak) return result;
    Partition fine = refined(rough, planes, outer);
    model.surfaces = subdivided(make_surfaces(fine.tree, planes, fine.portals, seen), texinfos);
    make_mesh(model);
    model.tree = std::move(fine.tree);
    model.portals = std::move(fine.portals);
    model.hulls = {make_hull(brushes, kPlayerBox, planes, outer, starts),
                   make_hull(brushes, kLargeBox, planes, outer, starts)};
    return result;
}

}  // namespace oblong::map
