#pragma once

#include "tools/map/light/face_sampler.h"
#include "tools/map/light/sources.h"

namespace oblong::map {

/// Which faces of the world each source may light, by the sets of potentially visible leaves: spares most rays.
class LightReach {
  public:
    LightReach(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources);

    /// True for faces of brush entities always: they move.
    bool may_light(std::size_t source, std::size_t face) const {
        return face >= world_face_count_ || reached_[source][face];
    }

  private:
    std::size_t world_face_count_;
    std::vector<std::vector<bool>> reached_;  // of each source, by face
};

/// Sources that may light some of the face.
std::vector<const LightSource*> sources_near(const std::vector<LightSource>& sources, const LightReach& reach,
                                             std::size_t face, const FaceSampler& sampler);

}  // namespace oblong::map
