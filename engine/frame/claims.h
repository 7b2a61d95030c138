#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/effects/fog.h"
#include "engine/frame/frame_things.h"
#include "engine/scene/effects.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"
#include "engine/visibility/front_to_back.h"
#include "engine/visibility/span_list.h"

namespace oblong {

struct FrameContext;
class FrameWorkspace;

/// The passes that draw faces, each the faces of one list.
enum class FaceList : std::uint8_t { Walls, Flat, Liquid, Sky, Mirror, SeeThrough };
inline constexpr std::size_t kFaceListCount = 6;

/// A face that owns pixels of a frame, or sees through to those behind it.
struct ClaimedFace {
    VisibleFace visible;
    std::uint32_t first_span = 0, span_count = 0;  ///< in Claims
    View nearest_z, farthest_z;                    ///< of the face's part in view
};

/// Pixels that no face covers, of a wall that has none there: the texture and the light of a face go on to them.
struct TornSpan {
    Span span;
    PlaneIndex plane;  ///< of the wall
    bool is_back;      ///< the wall faces the plane's back
    FaceIndex face;
    Vec3<World> place;  ///< one that the span shows
};

/// What the faces, and the things among them, own of a frame: each has a place in the list of the pass that draws it,
/// front to back.
struct Claims {
    SpanList spans;
    std::array<std::vector<ClaimedFace>, kFaceListCount> lists;
    EffectSet effects;             ///< that these faces need and the settings allow
    std::vector<TornSpan> torn;    ///< pixels that no face covers, but walls without one
    SpanList left_free;            ///< pixels that nothing owns: the void
    std::vector<FogRun> fog_runs;  ///< pixels in fog
    FrameThings things;            ///< what is among the faces
    bool is_under_liquid = false;  ///< the eye is in a liquid

    std::vector<ClaimedFace>& list(FaceList which) { return lists[static_cast<std::size_t>(which)]; }
    const std::vector<ClaimedFace>& list(FaceList which) const { return lists[static_cast<std::size_t>(which)]; }
    std::span<const Span> spans_of(const ClaimedFace& face) const {
        return std::span<const Span>(spans).subspan(face.first_span, face.span_count);
    }
    void clear();
    /// Adds a face whose spans are the last ones, from `first_span` on.
    void add(FaceList which, ClaimedFace face, std::size_t first_span) {
        face.first_span = static_cast<std::uint32_t>(first_span);
        face.span_count = static_cast<std::uint32_t>(spans.size() - first_span);
        list(which).push_back(face);
    }
};

/// The list of a face that calls for these effects. What is not allowed is drawn in one colour, or as a wall.
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

/// Takes the faces front to back and lets each claim its pixels; draws nothing. Faces that are seen through get the
/// pixels that were free when the walk came to them, and leave them free.
void claim_faces(const FrameContext& frame, FrameWorkspace& work);

}  // namespace oblong
