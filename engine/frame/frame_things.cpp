#include "engine/frame/frame_things.h"

namespace oblong {

void FrameThings::clear() {
    in_view.clear();
    visible.clear();
    shadows.clear();
    meshes.clear();
    mesh_parts.clear();
}

}  // namespace oblong
