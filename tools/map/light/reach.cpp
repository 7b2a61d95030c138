#include "tools/map/light/reach.h"

#include "tools/map/vis/visibility.h"

namespace oblong::map {

namespace {

bool is_sky(const BspFile& bsp, const FileFace& face) {
    const FileTexInfo& texinfo = item(bsp.texinfos, face.texinfo);
    return texinfo.flags != 0 && contents_of_texture(item(bsp.textures, texinfo.texture)) == contents::kSky;
}

}  // namespace

LightReach::LightReach(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources,
                       const WorkSharing& sharing)
    : world_face_count_(static_cast<std::size_t>(bsp.models.front().face_count)),
      reached_(sources.size(), BitSet(world_face_count_)) {
    const auto leaf_count = static_cast<std::size_t>(bsp.models.front().visible_leaf_count);
    sharing.for_each(sources.size(), [&](std::size_t i) {
        const FileLeaf& home = item(bsp.leaves, tracer.leaf_at(sources[i].origin));
        bool sees_sky = home.contents == contents::kSky;
        unpacked_row(bsp.visibility, home.visibility_offset, leaf_count).for_each([&](std::size_t leaf) {
            const FileLeaf& marks = bsp.leaves[leaf + 1];
            for (int k = 0; k < marks.mark_face_count; ++k) {
                const int face = item(bsp.mark_faces, marks.first_mark_face + k);
                reached_[i].add(as_size(face));
                sees_sky = sees_sky || is_sky(bsp, item(bsp.faces, face));
            }
        });
        if (!sees_sky) return;
        for (std::size_t face = 0; face < world_face_count_; ++face)
            reached_[i].add(face);  // faces behind a sky are in no set
    });
}

std::vector<const LightSource*> sources_near(const std::vector<LightSource>& sources, const LightReach& reach,
                                             std::size_t face, const FaceSampler& sampler) {
    std::vector<const LightSource*> near;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (!reach.may_light(i, face)) continue;
        const LightSource& source = sources[i];
        const Point towards = source.origin - sampler.centre();
        if ((sampler.is_smooth() || dot(towards, sampler.normal()) > 0) &&
            length(towards) <= source.range() + sampler.radius())
            near.push_back(&source);
    }
    return near;
}

}  // namespace oblong::map
