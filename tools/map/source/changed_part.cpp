#include "tools/map/source/changed_part.h"

#include <algorithm>
#include <utility>

namespace oblong::map {
namespace {

// Pairs of brush entities that move vertices or normals or add faces, pairs that name files or textures, and all of an
// entity that places another map's brushes.
bool decides_brushes(const MapPair& pair, const MapEntity& of) {
    return pair.key == "wad" || pair.key == "texture" || of.has("_external_map") ||
           (!of.brushes.empty() &&
            (pair.key == "classname" || pair.key == "_mirrorinside" || pair.key.starts_with("_phong")));
}

// Any named entity may be the target of a spotlight.
bool decides_light(const MapPair&, const MapEntity& of) {
    const std::string its_class = of.value("classname");
    return its_class.starts_with("light") || its_class == "worldspawn" ||
           std::any_of(of.pairs.begin(), of.pairs.end(), [](const MapPair& pair) {
               return pair.key == "light" || pair.key == "targetname" || pair.key.starts_with('_');
           });
}

// Of each entity the pairs that decide something.
template <class Decides>
std::vector<std::vector<std::pair<std::string, std::string>>> pairs_of(const std::vector<MapEntity>& entities,
                                                                       Decides decides) {
    std::vector<std::vector<std::pair<std::string, std::string>>> all;
    for (const MapEntity& entity : entities) {
        auto& pairs = all.emplace_back();
        for (const MapPair& pair : entity.pairs)
            if (decides(pair, entity)) pairs.emplace_back(pair.key, pair.value);
        if (pairs.empty()) all.pop_back();
    }
    return all;
}

// Of each entity that has brushes their sides, whatever lines they stand in.
std::vector<std::vector<std::vector<MapSide>>> sides_of(const std::vector<MapEntity>& entities) {
    std::vector<std::vector<std::vector<MapSide>>> all;
    for (const MapEntity& entity : entities) {
        if (entity.brushes.empty()) continue;
        auto& brushes = all.emplace_back();
        for (const MapBrush& brush : entity.brushes) {
            brushes.push_back(brush.sides);
            for (MapSide& side : brushes.back()) side.line = 0;
        }
    }
    return all;
}

}  // namespace

CompilePart changed_part(const std::vector<MapEntity>& before, const std::vector<MapEntity>& now) {
    if (sides_of(before) != sides_of(now) || pairs_of(before, decides_brushes) != pairs_of(now, decides_brushes))
        return CompilePart::All;
    return pairs_of(before, decides_light) == pairs_of(now, decides_light) ? CompilePart::Entities : CompilePart::Light;
}

}  // namespace oblong::map
