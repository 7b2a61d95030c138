#include "tests/properties/mesh.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "engine/raster/scan.h"

namespace oblong::test {

namespace {

ScreenVertex at(std::int64_t x_8, std::int64_t y_8) {
    return {Screen::from_raw(static_cast<std::int32_t>(x_8)), Screen::from_raw(static_cast<std::int32_t>(y_8))};
}

ScreenVertex mix(const ScreenVertex& a, std::int64_t weight_a, const ScreenVertex& b, std::int64_t weight_b) {
    const std::int64_t sum = weight_a + weight_b;
    return at((a.x.raw * weight_a + b.x.raw * weight_b) / sum, (a.y.raw * weight_a + b.y.raw * weight_b) / sum);
}

ScreenVertex snapped(const ScreenVertex& v, std::int32_t grid_8) {
    return at(v.x.raw / grid_8 * grid_8, v.y.raw / grid_8 * grid_8);
}

/// The triangle with this edge, and which of its edges that is.
struct EdgeOwner {
    std::size_t triangle, edge;
};

std::optional<EdgeOwner> find_edge(const std::vector<Mesh::Triangle>& triangles, const ScreenVertex& from,
                                   const ScreenVertex& to) {
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
        for (std::size_t edge = 0; edge < 3; ++edge)
            if (triangles[triangle][edge] == from && triangles[triangle][(edge + 1) % 3] == to)
                return EdgeOwner{triangle, edge};
    return std::nullopt;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Cut& cut) {
    return out << (cut.is_inside ? "inside " : "edge ") << cut.triangle << ' ' << cut.edge << " by " << cut.weight_a
               << ':' << cut.weight_b << ':' << cut.weight_c << " off " << cut.off_edge_x_8 << ' ' << cut.off_edge_y_8
               << " grid " << cut.grid_8;
}

Mesh::Mesh(const Rectangle& r) {
    const ScreenVertex a = at(r.left_8, r.top_8), b = at(r.right_8, r.top_8), c = at(r.right_8, r.bottom_8),
                       d = at(r.left_8, r.bottom_8);
    triangles_ = {{a, b, c}, {a, c, d}};
}

void Mesh::cut(const Cut& cut) {
    const std::size_t index = cut.triangle % triangles_.size();
    const std::size_t edge = cut.edge % 3;
    const Triangle& triangle = triangles_[index];
    const ScreenVertex on_edge = mix(triangle[edge], cut.weight_a, triangle[(edge + 1) % 3], cut.weight_b);
    const ScreenVertex inside = mix(on_edge, cut.weight_a + cut.weight_b, triangle[(edge + 2) % 3], cut.weight_c);
    if (cut.is_inside)
        cut_inside(index, snapped(inside, cut.grid_8));
    else
        cut_edge(index, edge, on_edge, cut);
}

void Mesh::cut_inside(std::size_t triangle, const ScreenVertex& corner) {
    const auto [a, b, c] = triangles_[triangle];
    replace({triangle}, {{a, b, corner}, {b, c, corner}, {c, a, corner}});
}

void Mesh::cut_edge(std::size_t triangle, std::size_t edge, ScreenVertex corner, const Cut& cut) {
    const ScreenVertex a = triangles_[triangle][edge], b = triangles_[triangle][(edge + 1) % 3],
                       c = triangles_[triangle][(edge + 2) % 3];
    const auto neighbour = find_edge(triangles_, b, a);
    if (!neighbour) {  // the rectangle's border: upright or level, so that the new corner lies on it
        replace({triangle}, {{a, corner, c}, {corner, b, c}});
        return;
    }
    corner = snapped(at(corner.x.raw + cut.off_edge_x_8, corner.y.raw + cut.off_edge_y_8), cut.grid_8);
    const ScreenVertex d = triangles_[neighbour->triangle][(neighbour->edge + 2) % 3];
    replace({triangle, neighbour->triangle}, {{a, corner, c}, {corner, b, c}, {b, corner, d}, {corner, a, d}});
}

void Mesh::replace(std::vector<std::size_t> old, const std::vector<Triangle>& pieces) {
    const auto has_area = [](const Triangle& piece) { return doubled_area(piece).raw > 0; };
    if (!std::all_of(pieces.begin(), pieces.end(), has_area)) return;
    std::sort(old.begin(), old.end(), std::greater<>());
    for (const std::size_t index : old) triangles_.erase(triangles_.begin() + static_cast<std::ptrdiff_t>(index));
    triangles_.insert(triangles_.end(), pieces.begin(), pieces.end());
}

}  // namespace oblong::test
