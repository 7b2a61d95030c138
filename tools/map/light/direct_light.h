#pragma once

#include <functional>
#include <map>
#include <vector>

#include "tools/map/light/face_sampler.h"
#include "tools/map/light/sources.h"
#include "tools/map/vis/bit_set.h"
#include "tools/map/work_sharing.h"

namespace oblong::map {

/// The faces that each source may light, by potentially visible sets, which avoids most rays; all faces of brush
/// entities, which move.
std::vector<BitSet> faces_reached(const BspFile& bsp, const Tracer& tracer, const std::vector<LightSource>& sources,
                                  const WorkSharing& sharing);

/// The sources that may light a part of the face. `reached`: their faces_reached().
std::vector<const LightSource*> sources_near(const std::vector<LightSource>& sources,
                                             const std::vector<BitSet>& reached, std::size_t face,
                                             const FaceSampler& sampler);

/// From light (a lamp of 255 at distance 0 is 255) to a level's bytes.
inline constexpr double kRangeScale = 0.5;

/// A face's light by sample, of one style; and of all its styles.
using Samples = std::vector<Light>;
using StyleSamples = std::map<int, Samples>;

/// The light at a face's samples from each source visible there. `is_fast`: one ray a sample and source instead of
/// sixteen. Calls `is_seen` for each source that lights a point by at least one visible shade.
StyleSamples direct_light(const FaceSampler& sampler, const std::vector<const LightSource*>& sources, const Sun& sun,
                          const Tracer& tracer, bool is_fast, const std::function<void(const LightSource&)>& is_seen);

}  // namespace oblong::map
