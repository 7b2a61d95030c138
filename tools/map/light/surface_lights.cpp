#include <algorithm>

#include "tools/map/light/face_sampler.h"
#include "tools/map/light/sources.h"

namespace oblong::map {
namespace {

using Windings = std::vector<Winding>;

// Twice the area.
double doubled_area(const Winding& winding) {
    return length(area_vector(winding));
}

// The centre of its area.
Point centre_of(const Winding& winding) {
    Point sum;
    double areas = 0;
    for (std::size_t i = 2; i < winding.size(); ++i) {
        const Winding triangle{winding[0], winding[i - 1], winding[i]};
        sum = sum + middle(triangle) * doubled_area(triangle);
        areas += doubled_area(triangle);
    }
    return areas > 0 ? sum * (1 / areas) : middle(winding);
}

// `normal`: the direction that the polygon faces.
bool is_over(const Winding& winding, const Point& normal, const Point& point) {
    for (std::size_t i = 0; i < winding.size(); ++i) {
        const Point along = winding[(i + 1) % winding.size()] - winding[i];
        if (dot(normal, cross(along, point - winding[i])) > kOnEpsilon * length(along)) return false;
    }
    return true;
}

// The centre of all polygons; if it is in none of them (around a hole), that of the largest.
Point place_of_lamp(const Windings& windings, const Point& normal) {
    Point sum;
    double areas = 0;
    const Winding* largest = &windings.front();
    for (const Winding& winding : windings) {
        sum = sum + centre_of(winding) * doubled_area(winding);
        areas += doubled_area(winding);
        if (doubled_area(winding) > doubled_area(*largest)) largest = &winding;
    }
    const Point place = areas > 0 ? sum * (1 / areas) : middle(*largest);
    const bool is_there = std::any_of(windings.begin(), windings.end(),
                                      [&](const Winding& winding) { return is_over(winding, normal, place); });
    return is_there ? place : centre_of(*largest);
}

// Halves the polygons until none is wider than a piece.
void add_pieces(const Windings& windings, std::vector<Windings>& pieces) {
    Box box;
    for (const Winding& winding : windings) box.add(winding);
    for (int axis = 0; axis < 3; ++axis) {
        if (box.maxs[axis] - box.mins[axis] <= kSurfacePiece) continue;
        const Plane plane{axis_vector(axis), (box.mins[axis] + box.maxs[axis]) / 2};
        Windings front, back;
        for (const Winding& winding : windings) {
            SplitWinding halves = split(winding, plane);
            if (!halves.front.empty()) front.push_back(std::move(halves.front));
            if (!halves.back.empty()) back.push_back(std::move(halves.back));
        }
        add_pieces(front, pieces);
        return add_pieces(back, pieces);
    }
    if (!windings.empty()) pieces.push_back(windings);
}

void add_lights_of_surface(std::vector<LightSource>& sources, const LightSource& pattern, const BspFile& bsp,
                           const std::vector<int>& faces) {
    Windings windings;
    for (const int face : faces) windings.push_back(face_corners(bsp, item(bsp.faces, face)));
    const Point normal = face_normal(bsp, item(bsp.faces, faces.front()));
    std::vector<Windings> pieces;
    add_pieces(windings, pieces);
    for (const Windings& piece : pieces) {
        LightSource& source = sources.emplace_back(pattern);
        source.origin = place_of_lamp(piece, normal) + normal * pattern.surface_offset;
        if (pattern.is_surface_spotlight) source.direction = normal;
    }
}

}  // namespace

void spread_surface_lights(std::vector<LightSource>& sources, const BspFile& bsp, Warnings& warnings) {
    std::vector<LightSource> spread;
    for (const LightSource& source : sources) {
        if (source.surface.empty()) {
            spread.push_back(source);
            continue;
        }
        const auto shines = [&](const FileFace& face) { return texture_name(bsp, face) == source.surface; };
        const auto surfaces = whole_surfaces(bsp, shines);
        for (const std::vector<int>& faces : surfaces) add_lights_of_surface(spread, source, bsp, faces);
        if (surfaces.empty())
            warnings.add(source.entity->line,
                         "\"_surface\" is '" + source.surface + "', but no visible face has that texture");
    }
    sources = std::move(spread);
}

}  // namespace oblong::map
