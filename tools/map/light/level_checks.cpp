#include "tools/map/light/level_checks.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tools/map/light/face_sampler.h"
#include "tools/map/source/entities.h"

namespace oblong::map {
namespace {

// About the initial size of an engine's cache of lit surfaces.
constexpr double kMostTexels = 2048.0 * 2048;
// A level may have a quarter more light samples than needed.
constexpr int kSpareShare = 4, kFewSamples = 64;

bool is_lit(const BspFile& bsp, const FileFace& face) {
    return item(bsp.texinfos, face.texinfo).flags == 0;
}

bool contains(const MapBrush& brush, const Point& point) {
    constexpr double kSlack = 1.0 / 8;
    return std::all_of(brush.sides.begin(), brush.sides.end(),
                       [&](const MapSide& side) { return plane_of(side).height_of(point) <= kSlack; });
}

bool faces_as(const MapSide& side, const Point& normal, const Point& point) {
    constexpr double kLeastCosine = 1 - 1e-4, kSlack = 1.0 / 8;
    const Plane plane = plane_of(side);
    return dot(plane.normal, normal) > kLeastCosine && std::abs(plane.height_of(point)) < kSlack;
}

// The line of a face's side; the world's if none is found (a sliver).
int line_of(const BspFile& bsp, const std::vector<MapEntity>& entities, const FileFace& face) {
    const Point normal = face_normal(bsp, face), point = middle(face_corners(bsp, face));
    const std::string texture = texture_name(bsp, face);
    for (const MapEntity& entity : entities)
        for (const MapBrush& brush : entity.brushes)
            for (const MapSide& side : brush.sides)
                if (side.texture.name == texture && faces_as(side, normal, point) && contains(brush, point))
                    return side.line;
    return entities.front().line;
}

class LevelChecker {
  public:
    LevelChecker(const BspFile& bsp, const std::vector<MapEntity>& entities, Warnings& warnings)
        : bsp_(bsp), entities_(entities), warnings_(warnings) {}

    void check_counts() {
        for (const LumpCount& lump : lump_counts(bsp_)) {
            if (lump.count <= lump.most / 10 * 9) continue;
            const bool is_past = lump.count > lump.most;
            warnings_.add(entities_.front().line,
                          std::to_string(lump.count) + " of " + std::to_string(lump.most) + " " + lump.name +
                              (is_past ? ": the level is written as BSP2, which fewer programs read"
                                       : ": with more the level would be BSP2") +
                              "; reduce them " + lump.cure);
        }
    }

    void check_large_surfaces() {
        std::vector<double> texels_of_texinfo(bsp_.texinfos.size(), 0);
        for (const FileFace& face : bsp_.faces)
            if (is_lit(bsp_, face)) item(texels_of_texinfo, face.texinfo) += texels_of(face);
        const auto may_be_large = [&](const FileFace& face) {
            return is_lit(bsp_, face) && item(texels_of_texinfo, face.texinfo) > kMostTexels;
        };
        for (const auto& faces : whole_surfaces(bsp_, may_be_large)) {
            double texels = 0;
            for (const int face : faces) texels += texels_of(item(bsp_.faces, face));
            if (texels <= kMostTexels) continue;
            const FileFace& first = item(bsp_.faces, faces.front());
            warnings_.add(line_of(bsp_, entities_, first),
                          "a surface of '" + texture_name(bsp_, first) + "' has " +
                              std::to_string(static_cast<long>(texels)) + " texels in " + std::to_string(faces.size()) +
                              " faces, more than an engine's surface cache holds (" +
                              std::to_string(static_cast<long>(kMostTexels)) + "): expected texture scales " +
                              std::to_string(static_cast<int>(std::ceil(std::sqrt(texels / kMostTexels)))) +
                              " times as large, or a smaller surface");
        }
    }

    // Lightmaps have samples at multiples of 16 texels; a face whose edges are between them has more samples than
    // needed.
    void check_light_grid() {
        long samples = 0, needed = 0;
        int most = 0;
        const FileFace* worst = nullptr;
        for (const FileFace& face : bsp_.faces) {
            if (!is_lit(bsp_, face)) continue;
            const LightGrid grid = light_grid(bsp_, face);
            const int own = grid.count[0] * grid.count[1], least = least_samples(face);
            samples += own;
            needed += least;
            if (own - least <= most) continue;
            most = own - least;
            worst = &face;
        }
        const long spare = samples - needed;
        if (worst == nullptr || spare < kFewSamples || spare * kSpareShare < needed) return;
        warnings_.add(
            line_of(bsp_, entities_, *worst),
            std::to_string(spare) + " of " + std::to_string(samples) +
                " light samples are outside of their faces, most of them for the face here: expected texture offsets "
                "that put the edges of faces on multiples of 16 texels");
    }

    void check_textures(const std::vector<TextureUse>& names) {
        std::set<int> shown;
        for (const FileFace& face : bsp_.faces) shown.insert(item(bsp_.texinfos, face.texinfo).texture);
        std::set<std::string> by_entities;
        for (const TextureUse& use : shown_textures(entities_)) by_entities.insert(use.name);
        for (std::size_t i = 0; i < names.size(); ++i)
            if (!shown.contains(static_cast<int>(i)) && !by_entities.contains(names[i].name))
                warnings_.add(names[i].line, "no visible face has the texture '" + names[i].name + "', which is " +
                                                 std::to_string(bsp_.textures[i].size()) +
                                                 " bytes of the level: expected 'skip' on its sides");
    }

  private:
    double texels_of(const FileFace& face) const {
        const FileTexInfo& texinfo = item(bsp_.texinfos, face.texinfo);
        const Point u = to_point(texinfo.axes[0].direction), v = to_point(texinfo.axes[1].direction);
        return std::abs(dot(cross(u, v), area_vector(face_corners(bsp_, face)))) / 2;
    }

    int least_samples(const FileFace& face) const {
        constexpr double kSlack = 1.0 / 64;  // of a step
        const FileTexInfo& texinfo = item(bsp_.texinfos, face.texinfo);
        const Winding corners = face_corners(bsp_, face);
        int count = 1;
        for (const FileTexAxis& axis : texinfo.axes) {
            const auto [low, high] =
                range_of(corners, [&](const Point& corner) { return dot(to_point(axis.direction), corner); });
            count *= static_cast<int>(std::ceil((high - low) / LightGrid::kStep - kSlack)) + 1;
        }
        return count;
    }

    const BspFile& bsp_;
    const std::vector<MapEntity>& entities_;
    Warnings& warnings_;
};

}  // namespace

void find_level_warnings(const BspFile& bsp, const std::vector<MapEntity>& entities,
                         const std::vector<TextureUse>& names, Warnings& warnings) {
    LevelChecker checker(bsp, entities, warnings);
    checker.check_counts();
    checker.check_large_surfaces();
    checker.check_light_grid();
    checker.check_textures(names);
}

void find_unused_wads(const std::vector<Wad>& wads, const std::vector<TextureUse>& names, Warnings& warnings) {
    std::set<const Wad*> used;
    for (const TextureUse& use : names) {
        const auto from = std::find_if(wads.begin(), wads.end(), [&](const Wad& wad) { return wad.find(use.name); });
        if (from != wads.end()) used.insert(&*from);
    }
    for (const Wad& wad : wads)
        if (wad.line > 0 && !used.contains(&wad))
            warnings.add(wad.line, "no texture of '" + wad.source + "' is used: remove it from \"wad\"");
}

}  // namespace oblong::map
