#pragma once

#include <functional>
#include <map>
#include <vector>

#include "tools/map/light/face_sampler.h"
#include "tools/map/light/sources.h"

namespace oblong::map {

/// From light, of which a lamp of 255 is 255 at no distance, to the bytes of a level.
inline constexpr double kRangeScale = 0.5;

/// A face's light, sample by sample, of one style; and of all styles that shine on it.
using Samples = std::vector<double>;
using StyleSamples = std::map<int, Samples>;

/// What arrives at the samples of a face from each source that they see. `is_fast`: one ray a sample and source instead
/// of sixteen. `is_seen` is told of each source that lights some point by a shade that can be seen.
StyleSamples direct_light(const FaceSampler& sampler, const std::vector<const LightSource*>& sources, const Sun& sun,
                          const Tracer& tracer, bool is_fast, const std::function<void(const LightSource&)>& is_seen);

}  // namespace oblong::map
