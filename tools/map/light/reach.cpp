#include "tools/map/light/reach.h"

#include "tools/map/vis/visibility.h"

namespace oblong::map {

namespace {

bool is_sky(const BspFile& bsp, const FileFace& face) {
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    return texinfo.flags != 0 && contents_of_texture(item(bsp.textures, texinfo.texture)) == contents::kSky;
}

}  // namespace

LightReach::LightReach(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources)
    : world_face_count_(static_cast<std::size_t>(bsp.models.front().face_count)) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    for (const LightSource& source : sources) {
        auto& reached = reached_.emplace_back(world_face_count_, false);
        const FileLeaf& home = item(bsp.leaves, tracer.leaf_at(source.origin));
        bool sees_sky = home.contents == contents::kSky;
        const std::vector<bool> seen = unpacked_row(bsp.visibility, home.visibility_offset, leaf_count);
        for (std::size_t leaf = 0; leaf < leaf_count; ++leaf) {
            if (!seen[leaf]) continue;
            const FileLeaf& marks = bsp.leaves[leaf + 1];
            for (int i = 0; i < marks.mark_face_count; ++i) {
                const int face = item(bsp.mark_faces, marks.first_mark_face + i);
                item(reached, face) = true;
                sees_sky = sees_sky || is_sky(bsp, item(bsp.faces, face));
            }
        }
        if (sees_sky) reached.assign(world_face_count_, true);  // faces behind a sky are in no set
    }
}

std::vector<const LightSource*> sources_near(const std::vector<LightSource>& sources, const LightReach& reach,
                                             std::size_t face, const FaceSampler& sampler) {
    std::vector<const LightSource*> near;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const LightSource& source = sources[i];
        const Point towards = source.origin - sampler.centre();
        if (dot(towards, sampler.normal()) <= 0 || length(towards) > source.range() + sampler.radius()) continue;
        if (reach.may_light(i, face)) near.push_back(&source);
    }
    return near;
}

}  // namespace oblong::map
