#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>

#include "engine/files/wad.h"
#include "tools/map/light/face_sampler.h"

namespace oblong::map {
namespace {

// The plane, facing and texinfo of a face, and the first and last vertex of one of its edges: unique to this face.
using EdgeKey = std::array<int, 5>;

std::vector<EdgeKey> edges_of(const BspFile& bsp, const FileFace& face) {
    std::vector<EdgeKey> keys;
    for (int i = 0; i < face.edge_count; ++i) {
        const int edge = item(bsp.surf_edges, face.first_surf_edge + i);
        const auto& ends = item(bsp.edges, std::abs(edge));
        keys.push_back({face.plane, face.is_back, face.texinfo, ends[edge < 0 ? 1 : 0], ends[edge < 0 ? 0 : 1]});
    }
    return keys;
}

}  // namespace

// The name at the beginning of a miptex: 16 bytes, the rest zero.
std::string texture_name(const BspFile& bsp, const FileFace& face) {
    const std::string& miptex = item(bsp.textures, item(bsp.texinfos, face.texinfo).texture);
    return lookup_name(miptex.substr(0, std::min<std::size_t>(miptex.find('\0'), 16)));
}

std::vector<std::vector<int>> whole_surfaces(const BspFile& bsp, const std::function<bool(const FileFace&)>& is_meant) {
    std::vector<int> meant;
    std::map<EdgeKey, int> by_edge;
    for (int i = 0; i < static_cast<int>(bsp.faces.size()); ++i) {
        if (!is_meant(item(bsp.faces, i))) continue;
        meant.push_back(i);
        for (const EdgeKey& key : edges_of(bsp, item(bsp.faces, i))) by_edge.emplace(key, i);
    }
    std::set<int> known;
    std::vector<std::vector<int>> surfaces;
    for (const int first : meant) {
        if (!known.insert(first).second) continue;
        std::vector<int>& surface = surfaces.emplace_back(1, first);
        for (std::size_t next = 0; next < surface.size(); ++next) {
            for (EdgeKey key : edges_of(bsp, item(bsp.faces, surface[next]))) {
                std::swap(key[3], key[4]);  // the neighbour has it in the other direction
                const auto beyond = by_edge.find(key);
                if (beyond != by_edge.end() && known.insert(beyond->second).second) surface.push_back(beyond->second);
            }
        }
    }
    return surfaces;
}

}  // namespace oblong::map
