#include "engine/frame/claims.h"

#include "engine/frame/frame_counts.h"

namespace oblong {

void Claims::clear() {
    spans.clear();
    for (auto& faces : lists) faces.clear();
    torn.clear();
    void_spans.clear();
    fog_runs.clear();
    things.clear();
    walls_drawn = 0;
    last_plane = {};
    effects = {};
}

void Claims::add(Effect effect, std::int64_t pixels, FrameCounts* counts) {
    effects = effects.with(effect);
    if (counts) counts->of(effect) += pixels;
}

std::int64_t pixels_of(const Claims& claims, FaceList list) {
    std::int64_t pixels = 0;
    for (const VisibleFace& face : claims.list(list)) pixels += pixels_of(claims.spans_of(face));
    return pixels;
}

}  // namespace oblong
