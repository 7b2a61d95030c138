#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/table.h"
#include "engine/effects/fog.h"
#include "engine/frame/frame_things.h"
#include "engine/scene/effects.h"
#include "engine/view/screen.h"
#include "engine/view/view_context.h"
#include "engine/visibility/front_to_back.h"
#include "engine/visibility/span_list.h"

namespace oblong {

struct ClaimScratch;
struct CornerScratch;
struct FrameContext;
struct ViewScratch;

/// The lists of claimed faces, one for each pass that draws faces.
enum class FaceList : std::uint8_t { Walls, Flat, Liquid, Sky, Mirror, SeeThrough };
inline constexpr std::size_t kFaceListCount = 6;

/// Pixels that no face covers, because a wall's face is missing: the nearest face's texture and light go on there.
struct TornSpan {
    Span span;
    PlaneIndex plane;  ///< of the wall
    bool is_back;      ///< the wall faces the plane's back
    FaceIndex face;
    Vec3<World> place;  ///< one that the span shows
};

/// 1/z of one side of a plane of the world.
struct SeenPlane {
    PlaneIndex plane = PlaneIndex::none();
    bool is_back = false;
    PlaneInverseZ inverse_z{};
};

/// Which pixels of a frame each face, and each thing among the faces, owns: in a list for each pass, front to back.
struct Claims {
    SpanList spans;
    std::array<std::vector<VisibleFace>, kFaceListCount> lists;
    EffectSet effects;             ///< that own pixels: those that the faces need and the settings allow, and others
    std::vector<TornSpan> torn;    ///< pixels of walls whose faces are missing
    SpanList left_free;            ///< pixels that nothing owns: the void
    std::vector<FogRun> fog_runs;  ///< pixels in fog
    FrameThings things;            ///< what is among the faces
    std::size_t walls_drawn = 0;   ///< by draw_walls() so far: the first ones of their list
    SeenPlane last_plane;          ///< of the world's last face: those of one node, which follow each other, share it

    std::vector<VisibleFace>& list(FaceList which) { return item(lists, which); }
    const std::vector<VisibleFace>& list(FaceList which) const { return item(lists, which); }
    std::span<const Span> spans_of(const VisibleFace& face) const {
        return std::span<const Span>(spans).subspan(face.first_span, face.span_count);
    }
    void clear();
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

/// The corners of a face in the world, those at T-junctions only if the settings mend them: in `scratch.world`.
std::span<const Vec3<World>> world_corners(const VisibleFace& face, const FrameContext& frame, CornerScratch& scratch);

/// The faces in view, front to back: next() finds one, projects it into `polygon` of the view's ClaimScratch and scans
/// it into its `rows`, for claim_face() to go on with.
class FacesInView {
  public:
    /// The arguments outlive it.
    FacesInView(const FrameContext& frame, ViewScratch& scratch);
    FacesInView(const FacesInView&) = delete;
    ~FacesInView();

    /// Sets `found` to the next face that covers pixels which may be free: its face and fragment, and nothing else.
    /// False if there is no other.
    bool next(VisibleFace& found);
    /// Whether the walk comes to all faces for the second time (FrontToBackWalk).
    bool is_second_walk() const { return walk_.takes_all_faces(); }

  private:
    const FrameContext& frame_;
    ClaimScratch& scratch_;
    FrontToBackWalk walk_;
};

/// Lets the face that FacesInView has found last claim the free pixels of its rows, and adds it to its list. One that
/// is seen through gets these pixels too, but leaves them free for what is behind; a second walk comes to it again and
/// has nothing to add.
void claim_face(VisibleFace& face, bool is_second_walk, const FrameContext& frame, ViewScratch& scratch);

/// Adds a face to its list, with its 1/z where anything may need that. Its spans are those of `claims` from
/// `first_span` on: without any it is not added.
void add_claimed(VisibleFace& face, std::size_t first_span, const FrameContext& frame, Claims& claims);

/// Takes the faces front to back and lets each claim its pixels; draws nothing.
void claim_faces(const FrameContext& frame, ViewScratch& scratch);

/// Another way to find out which face owns which pixel, in place of claim_faces(): engine/methods has some, to compare.
class FaceClaimer {
  public:
    virtual ~FaceClaimer() = default;
    virtual void claim(const FrameContext& frame, ViewScratch& scratch) = 0;
};

}  // namespace oblong
