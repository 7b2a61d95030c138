// Three planks, each over the next: no order of whole faces draws them (seed 3: the painter's known failure).

#include <tuple>

#include "engine/level/side.h"
#include "engine/methods/pixel_owners.h"
#include "engine/raster/scan.h"
#include "engine/view/screen_polygon.h"
#include "engine/view/texture_gradients.h"
#include "engine/visibility/fragments.h"
#include "tools/gallery/sketch.h"

namespace oblong {

namespace {

constexpr int kPlanks = 3;
constexpr double kDistance = 260;  // of the planks' middle from the eye, units

/// A plank or a part of it.
struct Piece {
    int plank = 0;
    LevelPlane plane;
    std::vector<Vec3<World>> corners;
};

/// A plank along one side of a triangle and beyond both its corners. Its end is farther away than its start by `rise`,
/// so that it is over the plank that ends at its start, and under the one that starts at its end.
Piece make_plank(int number, double rise) {
    constexpr double kRadius = 48, kOverhang = 0.3, kHalfWidth = 9;
    const auto corner = [](int i) {  // the eye looks along +y
        const double angle = std::numbers::pi / 2 + 2 * std::numbers::pi * i / kPlanks;
        return Vec{kRadius * std::cos(angle), 0, kRadius * std::sin(angle)};
    };
    const Vec from = corner(number), way = corner(number + 1) - from;
    const Vec across = Vec{-way.z, 0, way.x} * (kHalfWidth / std::hypot(way.x, way.z));
    const auto end = [&](double along, double side) {
        return world_point(from + way * along + across * side + Vec{0, kDistance + rise * (along - 0.5)});
    };
    Piece plank{number, {}, {end(-kOverhang, 1), end(1 + kOverhang, 1), end(1 + kOverhang, -1), end(-kOverhang, -1)}};
    const Vec3<World> edge = plank.corners[1] - plank.corners[0], other = plank.corners[2] - plank.corners[0];
    plank.plane.normal = normalised(cross(other, edge));
    if (plank.plane.normal.y > Unit{}) {  // make it face the eye, with the corners clockwise from there
        plank.plane.normal = -plank.plane.normal;
        std::reverse(plank.corners.begin(), plank.corners.end());
    }
    plank.plane.distance = dot(plank.corners[0], plank.plane.normal);
    return plank;
}

/// The pieces front to back: the first one's plane cuts the others, and the parts on the eye's side of it come first
/// (Fuchs, Kedem and Naylor 1980).
std::vector<Piece> front_to_back(const std::vector<Piece>& pieces, const Vec3<World>& eye) {
    if (pieces.size() < 2) return pieces;
    const Piece& root = pieces.front();
    std::array<std::vector<Piece>, 2> sides;  // back, front
    std::vector<PlaneDistance> distances;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const PolygonSide side = polygon_side(root.plane, {}, pieces[i].corners, distances);
        for (const bool in_front : {false, true}) {
            if (side == (in_front ? PolygonSide::Back : PolygonSide::Front)) continue;
            if (side == PolygonSide::On && in_front) continue;
            Piece part = pieces[i];
            if (side == PolygonSide::Both) {
                append_part(part.corners, 0, distances, in_front);
                part.corners.erase(part.corners.begin(), part.corners.begin() + std::ssize(pieces[i].corners));
            }
            sides[in_front].push_back(part);
        }
    }
    const bool is_before = plane_distance(root.plane, eye) > PlaneDistance{};
    std::vector<Piece> order = front_to_back(sides[is_before], eye);
    order.push_back(root);
    const std::vector<Piece> far_side = front_to_back(sides[!is_before], eye);
    order.insert(order.end(), far_side.begin(), far_side.end());
    return order;
}

ScannedFaces scan(std::span<const Piece> pieces, const ViewContext& view, const ScreenMode& mode) {
    ScannedFaces scanned;
    ScreenPolygon polygon;
    ScanlineExtents rows(mode.height_px);
    const InverseProjection inverse = make_inverse_projection(view.projection);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!project_polygon(pieces[i].corners, view, polygon)) continue;
        scan_convex(polygon.vertices, rows);
        ScannedFace face;
        face.face = FaceIndex(static_cast<std::int32_t>(i));
        std::tie(face.nearest_z, face.farthest_z) = polygon.z_range();
        face.normal = pieces[i].plane.normal;
        face.eye_distance = plane_distance(pieces[i].plane, view.eye);
        face.inverse_z = make_inverse_z(face.normal, face.eye_distance, view.axes, inverse);
        add_face(face, rows, mode.width_px, pieces[i].corners, view.eye, scanned);
    }
    return scanned;
}

enum class Method { SortedByFarthest, SortedByMean, Tree, ZBuffer, Rays };

PixelOwners owners_by(Method method, const ScannedFaces& scanned, const ViewContext& view, const ScreenMode& mode) {
    PixelOwners owners;
    owners.start(mode.width_px, mode.height_px);
    std::vector<InverseZ> depths;
    RayTargets targets;
    if (method == Method::ZBuffer)
        find_owners_by_z_buffer(scanned, depths, owners);
    else if (method == Method::Rays)
        find_owners_by_rays(scanned, make_view_directions(view.rays, view.projection), targets, owners);
    else if (method == Method::Tree)
        find_owners_by_painting(scanned, back_to_front_by_tree(scanned), owners);
    else
        find_owners_by_painting(
            scanned,
            back_to_front_by_depth(scanned, method == Method::SortedByMean ? SortDepth::Mean : SortDepth::Farthest,
                                   owners.counts.order_comparisons),
            owners);
    return owners;
}

/// The line of sight of a pixel's centre, one unit ahead.
Vec ray_through(std::int32_t column, std::int32_t row, const Projection& projection) {
    return {(column + 0.5 - projection.width_px / 2.0) / number_of(projection.x.multiplier), 1,
            (projection.height_px / 2.0 - row - 0.5) / number_of(projection.y.multiplier)};
}

/// Whether a ray from the eye at the origin passes within a piece's outline.
bool hits(const Vec& ray, const Piece& piece) {
    const std::size_t count = piece.corners.size();
    for (std::size_t i = 0; i < count; ++i)
        if (dot(ray, cross(vec_of(piece.corners[i]), vec_of(piece.corners[(i + 1) % count]))) > 0) return false;
    return true;
}

/// The nearest of the planks that cover each pixel, by doubles; -1: none. They cover what was scanned, or what is in
/// their exact outlines.
std::vector<int> nearest_planks(const ScannedFaces& scanned, std::span<const Piece> pieces, const ViewContext& view,
                                bool by_outlines) {
    const Projection& projection = view.projection;
    std::vector<int> nearest(pixel_count(projection.width_px, projection.height_px), -1);
    std::vector<double> depths(nearest.size(), 1e9);
    const auto cover = [&](const Piece& piece, std::int32_t row, std::int32_t first, std::int32_t end) {
        for (std::int32_t column = first; column < end; ++column) {
            const Vec ray = ray_through(column, row, projection);
            if (by_outlines && !hits(ray, piece)) continue;
            const double depth = number_of(piece.plane.distance) / dot(vec_of(piece.plane.normal), ray);
            const auto pixel = as_size(row * projection.width_px + column);
            if (depth >= depths[pixel]) continue;
            depths[pixel] = depth;
            nearest[pixel] = piece.plank;
        }
    };
    if (by_outlines)
        for (const Piece& piece : pieces)
            for (std::int32_t row = 0; row < projection.height_px; ++row) cover(piece, row, 0, projection.width_px);
    else
        for (const ScannedFace& face : scanned.faces)
            for (const Span& span : scanned.spans_of(face))
                cover(pieces[face.face.position()], span.y, span.first, span.end);
    return nearest;
}

/// A shade for each piece of a plank.
std::uint8_t colour_of(const Piece& piece, std::span<const Piece> before, const RowInput& input) {
    constexpr std::array<std::array<int, 3>, kPlanks> kColours{{{214, 150, 70}, {90, 130, 190}, {150, 110, 90}}};
    const auto& [red, green, blue] = item(kColours, piece.plank);
    const auto number =
        std::count_if(before.begin(), before.end(), [&](const Piece& other) { return other.plank == piece.plank; });
    const int percent = 100 - 22 * static_cast<int>(number);
    return input.colour(red * percent / 100, green * percent / 100, blue * percent / 100);
}

Figures draw_cycle(const RowInput& input, Canvas& canvas) {
    const auto method = static_cast<Method>(input.values[0]);
    const Accuracy& accuracy = input.settings.accuracy;
    const ViewContext view =
        make_view_context(first_person_view(camera_at(0, 0, 0, 90, 0, 50)), input.mode,
                          {.subpixel_bits = accuracy.subpixel_bits, .corrects_aspect = input.settings.correct_aspect});
    std::vector<Piece> pieces;
    for (int plank = 0; plank < kPlanks; ++plank) pieces.push_back(make_plank(plank, input.number(1)));
    if (method == Method::Tree) pieces = front_to_back(pieces, view.eye);
    const ScannedFaces scanned = scan(pieces, view, input.mode);
    const PixelOwners owners = owners_by(method, scanned, view, input.mode);
    const std::vector<int> nearest = nearest_planks(scanned, pieces, view, method == Method::Rays);

    std::vector<std::uint8_t> colours;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        colours.push_back(colour_of(pieces[i], std::span(pieces).first(i), input));
    const std::uint8_t warning = input.colour(kGreen), ground = input.colour(kGround);
    std::int64_t wrong = 0, uncovered = 0;
    canvas.paint([&](std::int32_t x, std::int32_t y) {
        const auto pixel = as_size(y * canvas.width_px + x);
        const std::int32_t owner = owners.faces[pixel];
        const auto piece = owner < 0 ? std::size_t{0} : item(scanned.faces, owner).face.position();
        const int plank = owner < 0 ? -1 : pieces[piece].plank;
        const bool is_edge = (plank < 0) != (nearest[pixel] < 0);
        uncovered += is_edge;
        const bool is_wrong = plank != nearest[pixel] && !is_edge;
        wrong += is_wrong;
        return plank < 0 ? ground : is_wrong && (x + y) % 2 == 0 ? warning : colours[piece];
    });
    const bool is_sorted = method == Method::SortedByFarthest || method == Method::SortedByMean;
    return {is_sorted ? Figure{"wrong pixels", "more than 0", std::to_string(wrong), wrong > 0}
                      : Figure{"wrong pixels", 0, wrong},
            {"polygons", std::ssize(pieces)},
            {"pixels at outlines that only one of two methods covers", uncovered}};
}

}  // namespace

std::vector<Row> cyclic_overlap_rows() {
    return {
        {"cyclic-overlap",
         draw_cycle,
         {{"method", {"painter by farthest z", "painter by mean z", "painter by the tree", "z-buffer", "ray casting"}},
          {"rise of a plank, units", 20, 100, 10, 60}}}};
}

}  // namespace oblong
