#pragma once

#include "tools/map/light/face_sampler.h"
#include "tools/map/light/sources.h"
#include "tools/map/vis/bit_set.h"
#include "tools/map/work_sharing.h"

namespace oblong::map {

/// The faces of the world that each source may light, by potentially visible sets: avoids most rays.
class LightReach {
  public:
    LightReach(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources,
               const WorkSharing& sharing);

    /// Always true for faces of brush entities, which move.
    bool may_light(std::size_t source, std::size_t face) const {
        return face >= world_face_count_ || reached_[source].has(face);
    }

  private:
    std::size_t world_face_count_;
    std::vector<BitSet> reached_;  // by each source
};

/// The sources that may light a part of the face.
std::vector<const LightSource*> sources_near(const std::vector<LightSource>& sources, const LightReach& reach,
                                             std::size_t face, const FaceSampler& sampler);

}  // namespace oblong::map
