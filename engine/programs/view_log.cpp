// The log's lines of the view: matrices, clipping, spans.

#include <algorithm>
#include <array>
#include <cstdio>

#include "engine/io/doubles.h"
#include "engine/math/matrix.h"
#include "engine/programs/frame_log.h"
#include "engine/view/screen_polygon.h"
#include "engine/visibility/eye.h"

namespace oblong {

namespace {

constexpr std::array<const char*, 5> kSideNames{"left", "right", "bottom", "top", "behind"};
constexpr std::array<const char*, kFaceListCount> kListNames{"walls", "flat", "liquid", "sky", "mirror", "see-through"};

template <class Int, int Frac>
std::string text_of(Fixed<Int, Frac> value) {
    char text[48];
    std::snprintf(text, sizeof text, "%.4f", number_of(value));
    return text;
}

template <class T>
std::string text_of(const Vec3<T>& v) {
    return "(" + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ")";
}

/// "left, top"; "none" without a bit.
std::string sides_of(unsigned outcode) {
    std::string names;
    for (std::size_t side = 0; side < kSideNames.size(); ++side)
        if (outcode >> side & 1) names += (names.empty() ? "" : ", ") + std::string(kSideNames[side]);
    return names.empty() ? "none" : names;
}

std::string row_text(const std::array<Entry, 4>& row) {
    std::string text;
    for (const Entry entry : row) text += (text.empty() ? "" : " ") + text_of(entry);
    return text;
}

/// A face that owns pixels, and its list.
struct ListedFace {
    VisibleFace face;
    std::size_t list;
};

template <class Take>
void for_claimed_faces(const Claims& claims, Take take) {
    for (std::size_t list = 0; list < kFaceListCount; ++list)
        for (const VisibleFace& face : claims.lists[list]) take(ListedFace{face, list});
}

std::vector<Vec3<World>> world_corners(const VisibleFace& visible, const LoggedFrame& frame) {
    if (visible.fragment) {
        const auto corners = frame.work.cache.brush_models.corners_of(*visible.fragment);
        return {corners.begin(), corners.end()};
    }
    std::vector<Vec3<World>> corners;
    for (const VertexIndex corner : frame.work.cache.faces.corners_of(visible.face))
        corners.push_back(frame.scene.level.vertices[corner]);
    return corners;
}

std::vector<Vec3<View>> view_corners(const VisibleFace& visible, const LoggedFrame& frame, const ViewContext& view) {
    std::vector<Vec3<View>> corners;
    for (const Vec3<World>& corner : world_corners(visible, frame)) corners.push_back(to_view(corner, view));
    return corners;
}

/// A span of a row, with its face.
struct RowSpan {
    Span span;
    ListedFace face;
};

std::vector<RowSpan> spans_of_row(const Claims& claims, std::int32_t row) {
    std::vector<RowSpan> found;
    for_claimed_faces(claims, [&](const ListedFace& listed) {
        for (const Span& span : claims.spans_of(listed.face))
            if (span.y == row) found.push_back({span, listed});
    });
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.span.first < b.span.first; });
    return found;
}

std::string face_text(const ListedFace& listed, const Level& level) {
    const FaceIndex face = listed.face.face;
    return "face " + std::to_string(face.number()) + " (" + item(kListNames, listed.list) + ", " +
           level.texture_of(level.faces[face]).name + ")";
}

/// The corners of a face, before and after clipping.
LogLines lines_of_face(const ListedFace& listed, const LoggedFrame& frame, const ViewContext& view) {
    const std::vector<Vec3<View>> corners = view_corners(listed.face, frame, view);
    LogLines lines{face_text(listed, frame.scene.level) +
                   " in the middle of the picture: " + std::to_string(corners.size()) + " corners"};
    ClipScratch scratch;
    unsigned crossed = 0;
    for (const Vec3<View>& corner : corners) {
        const std::uint8_t outcode = outcode_of(view.frustum, corner);
        crossed |= outcode;
        lines.push_back("corner " + text_of(corner) + " outside of " + sides_of(outcode));
        scratch.polygon.push_back({corner, 0, outcode, 0});
    }
    if (crossed != 0) clip_polygon(view.frustum, crossed, scratch);
    for (const ClipVertex& vertex : scratch.polygon) {
        const ScreenVertex screen = to_screen_border(to_screen_vertex(vertex.position, view.projection, view.grid),
                                                     vertex.borders, view.projection);
        lines.push_back("drawn corner " + text_of(vertex.position) + " on screen (" + text_of(screen.x) + ", " +
                        text_of(screen.y) + ")" + (vertex.borders ? " on the border " + sides_of(vertex.borders) : ""));
    }
    return lines;
}

}  // namespace

ViewContext view_of(const LoggedFrame& frame) {
    const Accuracy& accuracy = frame.settings.accuracy;
    ViewSpec spec = frame.view;
    if (!spec.is_parallel) spec.eye = place_eye(frame.scene.level, spec.eye).position;
    return make_view_context(
        spec, frame.mode,
        {accuracy.matrix_bits, accuracy.view_bits, accuracy.subpixel_bits, frame.settings.correct_aspect});
}

LogLines matrix_lines(const LoggedFrame& frame) {
    const ViewContext view = view_of(frame);
    const Matrix4 matrix = view_matrix(view.axes, view.eye);
    LogLines lines{"eye " + text_of(view.eye)};
    constexpr std::array<const char*, 4> kRows{"right", "up", "forward", "last"};
    for (std::size_t i = 0; i < kRows.size(); ++i)
        lines.push_back(std::string("view matrix, row ") + kRows[i] + ": " + row_text(matrix.rows[i]));
    lines.push_back("projection: multipliers " + text_of(view.projection.x.multiplier) + " " +
                    text_of(view.projection.y.multiplier) + " pixels, centre " + text_of(view.projection.x.centre) +
                    " " + text_of(view.projection.y.centre));
    for (std::size_t i = 0; i < view.frustum.clip_planes.size(); ++i)
        lines.push_back(std::string("frustum, ") + kSideNames[i] + ": inside if " +
                        text_of(view.frustum.clip_planes[i].normal) +
                        " . p >= " + text_of(view.frustum.clip_planes[i].offset) + " in viewspace (not of length 1)");
    return lines;
}

LogLines clip_lines(const LoggedFrame& frame) {
    const ViewContext view = view_of(frame);
    std::array<int, kClipPlaneCount> crossing{};
    int faces = 0, inside = 0;
    for_claimed_faces(frame.work.view.claims, [&](const ListedFace& listed) {
        unsigned crossed = 0;
        for (const Vec3<View>& corner : view_corners(listed.face, frame, view))
            crossed |= outcode_of(view.frustum, corner);
        ++faces;
        inside += (crossed & 15) == 0;
        for (std::size_t side = 0; side < crossing.size(); ++side) crossing[side] += crossed >> side & 1;
    });
    std::string sides;
    for (std::size_t side = 0; side < crossing.size(); ++side)
        sides += std::string(side == 0 ? "" : ", ") + kSideNames[side] + " " + std::to_string(crossing[side]);
    LogLines lines{std::to_string(faces) + " faces own pixels: " + std::to_string(inside) +
                   " inside the view, the others cross " + sides};
    const std::int32_t column = frame.mode.width_px / 2;
    for (const RowSpan& found : spans_of_row(frame.work.view.claims, frame.mode.height_px / 2)) {
        if (found.span.first > column || found.span.end <= column) continue;
        for (std::string& line : lines_of_face(found.face, frame, view)) lines.push_back(std::move(line));
        break;
    }
    return lines;
}

LogLines span_lines(const LoggedFrame& frame) {
    const Claims& claims = frame.work.view.claims;
    LogLines lines;
    for (std::size_t list = 0; list < kFaceListCount; ++list) {
        std::size_t spans = 0;
        for (const VisibleFace& face : claims.lists[list]) spans += face.span_count;
        lines.push_back(std::string(kListNames[list]) + ": " + std::to_string(claims.lists[list].size()) + " faces, " +
                        std::to_string(spans) + " spans, " +
                        std::to_string(pixels_of(claims, static_cast<FaceList>(list))) + " pixels");
    }
    std::int64_t torn_px = 0;
    for (const TornSpan& torn : claims.torn) torn_px += torn.span.end - torn.span.first;
    lines.push_back("torn: " + std::to_string(torn_px) + " pixels");
    lines.push_back("void: " + std::to_string(pixels_of(claims.void_spans)) + " pixels");
    for (const RowSpan& found : spans_of_row(claims, frame.mode.height_px / 2))
        lines.push_back("row " + std::to_string(found.span.y) + ", columns " + std::to_string(found.span.first) +
                        " to " + std::to_string(found.span.end - 1) + ": " + face_text(found.face, frame.scene.level));
    return lines;
}

}  // namespace oblong
