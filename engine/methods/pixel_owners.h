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

}  // namespace oblong
