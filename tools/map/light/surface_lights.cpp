#include "tools/map/light/surface_lights.h"

#include <cmath>

#include "engine/files/wad.h"
#include "tools/map/light/face_sampler.h"

namespace oblong::map {
namespace {

// Cut in halves until none is wider than a piece.
void add_pieces(const Winding& winding, std::vector<Winding>& pieces) {
    const Box box = box_of(winding);
    for (int axis = 0; axis < 3; ++axis) {
        if (box.maxs[axis] - box.mins[axis] <= kSurfacePiece) continue;
        const Point normal = axis_vector(axis);
        const SplitWinding halves = split(winding, {normal, (box.mins[axis] + box.maxs[axis]) / 2});
        add_pieces(halves.front, pieces);
        return add_pieces(halves.back, pieces);
    }
    pieces.push_back(winding);
}

// The name at the beginning of a miptex: 16 bytes, the rest zero.
std::string texture_name(const BspFile& bsp, const FileFace& face) {
    const std::string& miptex = item(bsp.textures, item(bsp.texinfos, face.texinfo).texture);
    return lookup_name(miptex.substr(0, std::min<std::size_t>(miptex.find('\0'), 16)));
}

void add_lights_of_face(std::vector<LightSource>& sources, const LightSource& pattern, const BspFile& bsp,
                        const FileFace& face) {
    Winding winding;
    for (const Floats& corner : face_corners(bsp, face)) winding.push_back(to_point(corner));
    std::vector<Winding> pieces;
    add_pieces(winding, pieces);
    for (const Winding& piece : pieces) {
        LightSource& source = sources.emplace_back(pattern);
        const Point normal = face_normal(bsp, face);
        source.origin = middle(piece) + normal * pattern.surface_offset;
        if (!pattern.is_surface_spotlight) continue;
        source.direction = normal;
        if (source.cone_cosine < 0) source.cone_cosine = 0;
    }
}

}  // namespace

void spread_surface_lights(std::vector<LightSource>& sources, const BspFile& bsp) {
    std::vector<LightSource> spread;
    for (const LightSource& source : sources) {
        if (source.surface.empty()) {
            spread.push_back(source);
            continue;
        }
        for (const FileFace& face : bsp.faces)
            if (texture_name(bsp, face) == source.surface) add_lights_of_face(spread, source, bsp, face);
    }
    sources = std::move(spread);
}

}  // namespace oblong::map
