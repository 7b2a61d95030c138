#pragma once

#include <span>

#include "engine/frame/claims.h"
#include "engine/visibility/front_to_back.h"

namespace oblong {

struct ClaimScratch;
struct CornerScratch;
struct FrameContext;
struct ViewScratch;

/// The corners of a face in the world, with those at T-junctions if the dial mends them; in `scratch.world`.
std::span<const Vec3<World>> world_corners(const VisibleFace& face, const FrameContext& frame, CornerScratch& scratch);

/// The faces in view, front to back. next() finds a face, projects it to `polygon` of the view's ClaimScratch and scans
/// it to `rows`; claim_face() uses these.
class FacesInView {
  public:
    /// The arguments must outlive it.
    FacesInView(const FrameContext& frame, ViewScratch& scratch);
    FacesInView(const FacesInView&) = delete;
    ~FacesInView();

    /// Sets `face` and `fragment` of the next face that may cover free pixels. False if there is none.
    bool next(VisibleFace& found);
    /// Whether this is the second walk (FrontToBackWalk).
    bool is_second_walk() const { return walk_.is_second_walk(); }

  private:
    const FrameContext& frame_;
    ClaimScratch& scratch_;
    FrontToBackWalk walk_;
};

/// Claims the free pixels of the last face of FacesInView, and adds the face to its list. See-through faces get these
/// pixels too, but leave them free for what is behind; in a second walk they are ignored.
void claim_face(VisibleFace& face, bool is_second_walk, const FrameContext& frame, ViewScratch& scratch);

/// Adds a face to its list, with its 1/z if something may need it. Its spans are those of `claims` from `first_span`
/// on; without spans it is not added.
void add_claimed(const VisibleFace& face, std::size_t first_span, const FrameContext& frame, Claims& claims);

/// Claims the pixels of all faces, front to back; draws nothing.
void claim_faces(const FrameContext& frame, ViewScratch& scratch);

/// Another method for hidden surfaces, in place of claim_faces(); engine/methods has some, to compare.
class FaceClaimer {
  public:
    virtual ~FaceClaimer() = default;
    virtual void claim(const FrameContext& frame, ViewScratch& scratch) = 0;
};

}  // namespace oblong
