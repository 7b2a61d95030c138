#include "engine/methods/triangles.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/math/soft_float.h"
#include "engine/math/vec.h"
#include "engine/mesh/mesh_pixels.h"
#include "engine/raster/edges.h"

namespace oblong {
namespace {

ScreenTriangle clamped_vertices(const ScreenTriangle& triangle) {
    return {clamped_vertex(triangle[0]), clamped_vertex(triangle[1]), clamped_vertex(triangle[2])};
}

/// The rows of a part whose centres are in [top, bottom).
PixelRange rows_of(Screen top, Screen bottom, const ScreenRectangle& part) {
    return {std::max(first_centre_from(top), part.first_row), std::min(first_centre_from(bottom), part.end_row)};
}

struct TriangleEdge {
    ScreenVertex top, bottom;
};

/// Scans a part with a flat top or bottom: two edges, and the rows between the heights that they share.
void scan_flat_part(const TriangleEdge& left, const TriangleEdge& right, PixelRange between, ScanlineExtents& rows) {
    if (between.first >= between.end) return;
    ExactWalker from(left.top, left.bottom, between.first), to(right.top, right.bottom, between.first);
    for (std::int32_t row = between.first; row < between.end; ++row, from.next_row(), to.next_row()) {
        item(rows.left, row) = from.column();
        item(rows.right, row) = to.column();
    }
}

/// The long edge is not cut at the middle's height: the cut would be rounded, and bend the edge.
void scan_flat_parts(ScreenTriangle triangle, const ScreenRectangle& part, ScanlineExtents& rows) {
    std::sort(triangle.begin(), triangle.end(), [](ScreenVertex a, ScreenVertex b) { return a.y < b.y; });
    const auto& [top, middle, bottom] = triangle;
    const TriangleEdge whole{top, bottom}, upper{top, middle}, lower{middle, bottom};
    const bool bends_right = doubled_area(triangle) > ScreenArea{};
    const PixelRange above = rows_of(top.y, middle.y, part), below = rows_of(middle.y, bottom.y, part);
    scan_flat_part(bends_right ? whole : upper, bends_right ? upper : whole, above, rows);
    scan_flat_part(bends_right ? whole : lower, bends_right ? lower : whole, below, rows);
    const PixelRange all = rows_of(top.y, bottom.y, part);
    rows.first = all.first;
    rows.end = all.end;
}

using EdgesOverPixels = std::array<LinearQuantity<ScreenWide>, 3>;

/// Whether edge functions fit 32 bits in a box of this size: they are linear, so its corners decide.
bool fit_32_bits(const EdgesOverPixels& edges, std::int32_t width, std::int32_t height) {
    const auto fits = [](ScreenWide value) { return absolute(value) <= convert<ScreenWide>(Screen::highest()); };
    return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
        return fits(edge.origin) && fits(edge.at(width, 0)) && fits(edge.at(0, height)) && fits(edge.at(width, height));
    });
}

void scan_edge_functions(const ScreenTriangle& triangle, const ScreenRectangle& part, EdgeRowKernel kernel,
                         ScanlineExtents& rows) {
    const ScreenRectangle box = box_around(triangle, part);
    rows.first = rows.end = box.first_row;
    if (box.first_row >= box.end_row || box.first_column >= box.end_column) return;
    rows.end = box.end_row;
    const auto& [a, b, c] = triangle;
    const EdgesOverPixels edges{edge_over_pixels(a, b, box), edge_over_pixels(b, c, box), edge_over_pixels(c, a, box)};
    const std::int32_t width = box.end_column - box.first_column;
    if (!fit_32_bits(edges, width, box.end_row - box.first_row)) kernel = inside_edges_plain;
    EdgeRow row{};
    for (int i = 0; i < 3; ++i) {
        item(row.value, i) = item(edges, i).origin.raw;
        item(row.step, i) = item(edges, i).per_column.raw;
    }
    for (std::int32_t y = box.first_row; y < box.end_row; ++y) {
        const PixelRange inside = kernel(row, width);
        item(rows.left, y) = box.first_column + inside.first;
        item(rows.right, y) = box.first_column + inside.end;
        for (int i = 0; i < 3; ++i) item(row.value, i) += item(edges, i).per_row.raw;
    }
}

}  // namespace

const char* name_of(TriangleMethod method) {
    constexpr std::array<const char*, kTriangleMethodCount> kNames{"flat parts", "edge walking", "edge functions"};
    return item(kNames, method);
}

TriangleScanner::TriangleScanner(TriangleMethod method, const ScreenRectangle& part, EdgeRowKernel kernel)
    : method_(method), part_(part), kernel_(kernel), rows_(part.end_row) {}

void TriangleScanner::scan(const ScreenTriangle& triangle, std::vector<Span>& spans) {
    ScreenTriangle clockwise = clamped_vertices(triangle);
    const ScreenArea area = doubled_area(clockwise);
    if (area == ScreenArea{}) return;
    if (area < ScreenArea{}) std::swap(clockwise[1], clockwise[2]);
    if (method_ == TriangleMethod::FlatParts) scan_flat_parts(clockwise, part_, rows_);
    if (method_ == TriangleMethod::EdgeWalking) scan_convex(clockwise, rows_);
    if (method_ == TriangleMethod::EdgeFunctions) scan_edge_functions(clockwise, part_, kernel_, rows_);
    append_spans(rows_, part_, spans);
}

BarycentricWeights barycentric_weights(const ScreenTriangle& triangle, ScreenVertex place) {
    const ScreenTriangle corners = clamped_vertices(triangle);
    const auto& [a, b, c] = corners;
    const ScreenVertex p = clamped_vertex(place);
    return {edge_function(b, c, p), edge_function(c, a, p), edge_function(a, b, p), doubled_area(corners)};
}

LinearQuantity<CornerQuantity> quantity_over(const ScreenTriangle& triangle,
                                             const std::array<CornerQuantity, 3>& at_corners) {
    const ScreenTriangle corners = clamped_vertices(triangle);
    // Near a corner weights are small; the steps from there to pixel (0, 0) and back may wrap.
    const std::int32_t column = floor_of(corners[0].x), row = floor_of(corners[0].y);
    const BarycentricWeights near =
        barycentric_weights(corners, {Screen::from_int(column) + kHalfPixel, Screen::from_int(row) + kHalfPixel});
    if (near.whole == ScreenArea{}) return {};
    const std::array<ScreenArea, 3> weights{near.a, near.b, near.c};
    LinearQuantity<CornerQuantity> quantity;
    for (int corner = 0; corner < 3; ++corner) {
        const ScreenVertex from = item(corners, (corner + 1) % 3), to = item(corners, (corner + 2) % 3);
        const auto add = [&](CornerQuantity& sum, ScreenArea weight) {
            sum = stepped(sum, product_over<CornerQuantity>(weight, item(at_corners, corner), near.whole), 1);
        };
        add(quantity.origin, item(weights, corner));
        add(quantity.per_column, convert<ScreenArea>(widening_difference(from.y, to.y)));
        add(quantity.per_row, convert<ScreenArea>(widening_difference(to.x, from.x)));
    }
    quantity.origin = quantity.at(-column, -row);
    return quantity;
}

namespace {

using Corner = Vec3<Fixed<std::int32_t, 14>>;
/// B x C, C x A, A x B, 28 fraction bits: components below 2^59.
using CornerNormals = std::array<Vec3<Fixed<std::int64_t, 28>>, 3>;

/// View rays: (x, y, 1) through the centre of the anchor, and its change per pixel.
struct PixelRay {
    SoftFloat x, y, x_per_column, y_per_row;
    PixelPosition anchor;

    PixelRay(const Projection& projection, PixelPosition pixel) : anchor(pixel) {
        const SoftFloat one = SoftFloat::from(1, 0);
        x_per_column = one / SoftFloat::from(projection.x.multiplier);
        y_per_row = -(one / SoftFloat::from(projection.y.multiplier));
        x = SoftFloat::from(2 * std::int64_t{pixel.column} + 1 - projection.width_px, -1) * x_per_column;
        y = SoftFloat::from(2 * std::int64_t{pixel.row} + 1 - projection.height_px, -1) * y_per_row;
    }
};

/// The sum of the three normals, each times its weight.
template <int Frac>
Vec3<SoftFloat> weighted_sum(const CornerNormals& normals, const std::array<Fixed<std::int64_t, Frac>, 3>& weights) {
    WideSum x, y, z;
    for (std::size_t i = 0; i < 3; ++i) {
        x.add_product(normals[i].x, weights[i]);
        y.add_product(normals[i].y, weights[i]);
        z.add_product(normals[i].z, weights[i]);
    }
    constexpr int kExponent = -(28 + Frac);
    return {x.scaled(kExponent), y.scaled(kExponent), z.scaled(kExponent)};
}

SoftFloat determinant(const Corner& a, const CornerNormals& normals) {
    WideSum sum;
    sum.add_product(a.x, normals[0].x);
    sum.add_product(a.y, normals[0].y);
    sum.add_product(a.z, normals[0].z);
    return sum.scaled(-42);
}

/// Converts to the format. A slope beyond its range changes by more than the whole texture from pixel to pixel, so that
/// its low bits do not matter.
template <class Value>
Value step_of(const SoftFloat& value) {
    constexpr auto kSteepest = Value::from_raw(std::int64_t{1} << 62);
    return fixed_of<Value>(value).value_or(value.mantissa < 0 ? -kSteepest : kSteepest);
}

template <class Value>
LinearQuantity<Value> quantity_of(const Vec3<SoftFloat>& slope, const SoftFloat& whole, const PixelRay& ray) {
    LinearQuantity<Value> quantity;
    quantity.per_column = step_of<Value>(slope.x * ray.x_per_column / whole);
    quantity.per_row = step_of<Value>(slope.y * ray.y_per_row / whole);
    const auto at_anchor = step_of<Value>((slope.x * ray.x + slope.y * ray.y + slope.z) / whole);
    quantity.origin = stepped(stepped(at_anchor, quantity.per_column, -std::int64_t{ray.anchor.column}),
                              quantity.per_row, -std::int64_t{ray.anchor.row});
    return quantity;
}

}  // namespace

std::optional<TextureGradients> make_triangle_gradients(const std::array<TexturedCorner, 3>& corners,
                                                        const Projection& projection, PixelPosition anchor) {
    const auto& [a, b, c] = corners;
    const CornerNormals normals{cross(b.position, c.position), cross(c.position, a.position),
                                cross(a.position, b.position)};
    const SoftFloat whole = determinant(a.position, normals);
    constexpr Multiplier kNone{};
    if (whole.is_zero() || projection.x.multiplier <= kNone || projection.y.multiplier <= kNone) return std::nullopt;

    const PixelRay ray(projection, anchor);
    constexpr auto kOne = Fixed<std::int64_t, 0>::from_int(1);
    return TextureGradients{quantity_of<InverseZ>(weighted_sum(normals, std::array{kOne, kOne, kOne}), whole, ray),
                            quantity_of<TexelOverZ>(weighted_sum(normals, std::array{a.u, b.u, c.u}), whole, ray),
                            quantity_of<TexelOverZ>(weighted_sum(normals, std::array{a.v, b.v, c.v}), whole, ray)};
}

}  // namespace oblong
