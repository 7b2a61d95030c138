#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fixed/fixed.h"
#include "engine/view/gradients.h"
#include "engine/view/screen.h"
#include "engine/visibility/front_to_back.h"

namespace oblong {

/// A face that was scanned before anything hides it. Its spans are all pixels that it covers, in ScannedFaces::spans.
struct ScannedFace : VisibleFace {
    bool is_seen_through = false;                      ///< hides nothing, but may be hidden
    Vec3<Unit> normal;                                 ///< of its plane, toward its front
    PlaneDistance eye_distance;                        ///< of the eye in front of it; 0 or less: it faces away
    std::uint32_t first_corner = 0, corner_count = 0;  ///< in ScannedFaces::from_eye
};

/// The faces of a view, in the order of FrontToBackWalk: nearest first.
struct ScannedFaces {
    std::vector<ScannedFace> faces;
    std::vector<Span> spans;
    std::vector<Vec3<WorldWide>> from_eye;  ///< the faces' corners, relative to the eye

    std::span<const Span> spans_of(const ScannedFace& face) const {
        return std::span(spans).subspan(face.first_span, face.span_count);
    }
    std::span<const Vec3<WorldWide>> corners_of(const ScannedFace& face) const {
        return std::span(from_eye).subspan(face.first_corner, face.corner_count);
    }
    void clear() {
        faces.clear();
        spans.clear();
        from_eye.clear();
    }
};

/// The work of determining the face of each pixel.
struct HiddenSurfaceCounts {
    std::int64_t faces_scanned = 0;      ///< for rays: the faces tested by them
    std::int64_t pixels_tested = 0;      ///< depths compared
    std::int64_t pixels_written = 0;     ///< owners set, also repeatedly for a pixel
    std::int64_t order_comparisons = 0;  ///< of two faces, to sort them
    std::int64_t ray_face_tests = 0;
};

/// Pixels [first, end) of a row that a face owns, or shows as a transparent face.
struct OwnedRun {
    std::int32_t face;  ///< in ScannedFaces::faces
    Span span;
};

/// The owner face of each pixel: the result of a hidden-surface method other than the span buffer.
struct PixelOwners {
    static constexpr std::int32_t kNone = -1;

    std::int32_t width_px = 0, height_px = 0;
    std::vector<std::int32_t> faces;  ///< of each pixel: in ScannedFaces::faces, or kNone
    std::vector<OwnedRun> seen;       ///< pixels of transparent faces that no nearer face owns
    HiddenSurfaceCounts counts;

    /// Starts with no owners.
    void start(std::int32_t width, std::int32_t height);
    std::int32_t* row(std::int32_t y) { return faces.data() + std::int64_t{y} * width_px; }
    const std::int32_t* row(std::int32_t y) const { return faces.data() + std::int64_t{y} * width_px; }
};

/// Adds a face with the spans of scanned rows, clipped to a screen of this width, and its corners.
void add_face(ScannedFace face, const ScanlineExtents& rows, std::int32_t width_px,
              std::span<const Vec3<World>> corners, const Vec3<World>& eye, ScannedFaces& scanned);

/// Adds a pixel to a face's runs: extends the last run or appends a new one.
void append_pixel(std::int32_t face, std::int32_t column, std::int32_t row, std::vector<OwnedRun>& runs);

/// The runs of all pixels that have an owner, and of those seen through: by face, then by row, then by column.
std::vector<OwnedRun> owned_runs(const PixelOwners& owners);

/// The depth by which the painter sorts faces.
enum class SortDepth {
    Farthest,  ///< of the face's part in view (Newell, Newell and Sancha 1972, before their tests)
    Mean       ///< of its nearest and farthest (course notes: "the average")
};

/// An order of faces, farthest first: the reverse of the BSP tree's, which is right for every scene, since the tree
/// splits faces that are both in front of and behind another.
std::vector<std::int32_t> back_to_front_by_tree(const ScannedFaces& scanned);

/// The same by depth, with ties in the tree's order. Wrong where a large face is behind a small one at its farthest
/// point, but in front of it where they overlap; no order is right for faces that overlap in a cycle. Adds to
/// `comparisons`.
std::vector<std::int32_t> back_to_front_by_depth(const ScannedFaces& scanned, SortDepth depth,
                                                 std::int64_t& comparisons);

/// The painter's algorithm: faces back to front, each over the ones before. No depth is stored or compared for pixels,
/// but all pixels of all faces are written. Transparent faces get the pixels that no later face paints over.
void find_owners_by_painting(const ScannedFaces& scanned, std::span<const std::int32_t> back_to_front,
                             PixelOwners& owners);

/// The z-buffer (Catmull 1974; course notes, "Z-buffering"): faces come in any order, here that of the level's file;
/// each pixel stores the depth of the nearest face so far, and a face takes the pixels at which it is nearer.
///
/// Depths are 1/z at the pixel's centre, from the plane and in steps of 2^-44, not interpolated between corners: faces
/// in one plane have the same depth, bit for bit, and the first of them keeps the pixel. They are clamped to the face's
/// range of z: rounding on the screen extends a face by up to 1/256 pixel, where the depth of a plane seen almost
/// edge-on is arbitrary. `depths` is scratch.
void find_owners_by_z_buffer(const ScannedFaces& scanned, std::vector<InverseZ>& depths, PixelOwners& owners);

/// 1/z of a face at the centre of a pixel, clamped to the face's range.
class FaceDepth {
  public:
    explicit FaceDepth(const ScannedFace& face);
    InverseZ at(std::int32_t column, std::int32_t row) const;

  private:
    LinearQuantity<InverseZ> inverse_z_;
    InverseZ farthest_, nearest_;
};

/// A face as a target of rays: its plane, and the planes through the eye and each of its edges.
struct RayTarget {
    std::int32_t face;  ///< in ScannedFaces::faces
    Vec3<Unit> normal;
    PlaneDistance eye_distance;  ///< above 0
    std::uint32_t first_edge, edge_count;
};

/// The faces that rays from one eye may hit.
struct RayTargets {
    std::vector<RayTarget> opaque, seen_through;
    std::vector<Vec3<Unit>> edges;  ///< normals of the planes through eye and edge, inward

    void clear() {
        opaque.clear();
        seen_through.clear();
        edges.clear();
    }
};

/// Ray casting, the naive method (Princeton, "Ray casting revisited"): a ray from the eye through the centre of each
/// pixel is tested against every face; the nearest hit owns the pixel. No face is clipped, projected or scanned, and
/// pixels share no work.
///
/// A ray p(t) = eye + t d meets a plane at t = distance / -(N . d), and hits the face if the point is on the inner side
/// of each edge's plane or on it. Values of t are compared exactly, without a division. d and the edges' normals are
/// rounded to 2^-30, a millionth of a pixel; corners are not rounded, so pixels may differ from those of a projecting
/// method where the ray passes within 1/256 pixel of an edge. `targets` is scratch.
void find_owners_by_rays(const ScannedFaces& scanned, const ViewDirections& directions, RayTargets& targets,
                         PixelOwners& owners);

}  // namespace oblong
