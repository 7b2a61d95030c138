#include "engine/frame/mirror_view.h"

#include "engine/level/side.h"

namespace oblong {

bool is_behind(const MirrorView& mirror, const Vec3<World>& place, const Level& level) {
    const MirrorPlane& plane = mirror.plane;
    return is_behind(level.planes[plane.plane], plane.is_back, place - plane.offset);
}

}  // namespace oblong
