#include "tools/map/light_reach.h"

#include "tools/map/vis_rows.h"

namespace oblong::map {

LightReach::LightReach(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources)
    : world_face_count_(static_cast<std::size_t>(bsp.models.front().face_count)) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    for (const LightSource& source : sources) {
        auto& reached = reached_.emplace_back(world_face_count_, false);
        const FileLeaf& home = bsp.leaves[static_cast<std::size_t>(tracer.leaf_at(source.origin))];
        const std::vector<bool> seen = unpacked_row(bsp.visibility, home.visibility_offset, leaf_count);
        for (std::size_t leaf = 0; leaf < leaf_count; ++leaf) {
            if (!seen[leaf]) continue;
            const FileLeaf& marks = bsp.leaves[leaf + 1];
            for (int i = 0; i < marks.mark_face_count; ++i) {
                const int face = bsp.mark_faces[static_cast<std::size_t>(marks.first_mark_face + i)];
                reached[static_cast<std::size_t>(face)] = true;
            }
        }
    }
}

}  // namespace oblong::map
