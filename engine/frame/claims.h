#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/effects/fog.h"
#include "engine/frame/frame_things.h"
#include "engine/scene/level_effects.h"
#include "engine/view/screen.h"
#include "engine/view/texture_gradients.h"
#include "engine/visibility/front_to_back.h"
#include "engine/visibility/span_buffer.h"

namespace oblong {

struct FrameCounts;

/// The lists of claimed faces, one for each pass.
enum class FaceList : std::uint8_t { Walls, Flat, Liquid, Sky, Mirror, SeeThrough };
inline constexpr std::size_t kFaceListCount = 6;

/// Pixels that no face covers because the level lacks a wall's face: behind them is solid all the same (torn_pixels.h).
/// They show the texture and light of the nearest face, continued on the wall's plane.
struct TornSpan {
    Span span;
    PlaneIndex plane;  ///< of the wall
    bool is_back;      ///< the wall faces the plane's back
    FaceIndex face;
    Vec3<World> place;  ///< a point shown by the span
};

/// The side of a plane of the world that the last face is on, with its 1/z.
struct LastPlane {
    PlaneIndex plane = PlaneIndex::none();
    bool is_back = false;
    PlaneInverseZ inverse_z{};
};

/// The pixels that faces and things own in a frame: a list of faces for each pass, front to back
/// (limit_mirrors() appends to the walls).
struct Claims {
    SpanList spans;
    std::array<std::vector<VisibleFace>, kFaceListCount> lists;
    EffectSet effects;             ///< allowed ones that own pixels; passes add those that they find as they draw
    std::vector<TornSpan> torn;    ///< pixels of walls whose faces are missing
    SpanList void_spans;           ///< pixels behind which there is neither face nor wall: the void
    std::vector<FogRun> fog_runs;  ///< pixels in fog
    FrameThings things;            ///< drawn among the faces
    std::size_t walls_drawn = 0;   ///< how many of the list draw_walls() has drawn
    LastPlane last_plane;          ///< of the world's last face: consecutive faces of a node share it

    std::vector<VisibleFace>& list(FaceList which) { return item(lists, which); }
    const std::vector<VisibleFace>& list(FaceList which) const { return item(lists, which); }
    std::span<const Span> spans_of(const VisibleFace& face) const {
        return std::span<const Span>(spans).subspan(face.first_span, face.span_count);
    }
    void clear();
    /// Adds an effect that owns pixels, and counts these.
    void add(Effect effect, std::int64_t pixels, FrameCounts* counts);
};

/// The list of a face that needs these effects. If they are not allowed, it is drawn in one colour or as a wall.
inline FaceList list_for(EffectSet needs, EffectSet allowed) {
    const EffectSet effects = needs & allowed;
    if (needs.has(Effect::Sky)) return effects.has(Effect::Sky) ? FaceList::Sky : FaceList::Flat;
    if (needs.has(Effect::Liquid) && !effects.has(Effect::Liquid)) return FaceList::Flat;
    if (effects.has(Effect::Translucency) || effects.has(Effect::Fence)) return FaceList::SeeThrough;
    if (effects.has(Effect::Liquid)) return FaceList::Liquid;
    return effects.has(Effect::Mirror) ? FaceList::Mirror : FaceList::Walls;
}

/// The pixels of a list's faces.
std::int64_t pixels_of(const Claims& claims, FaceList list);

}  // namespace oblong
