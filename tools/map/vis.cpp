#include "tools/map/vis.h"

namespace oblong::map {

void add_visibility(BspFile&, const CompiledModel&, const std::vector<int>&, const PlaneList&, bool) {}

}  // namespace oblong::map
