#include "engine/methods/triangles.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/raster/edge_function.h"
#include "engine/raster/edge_walker.h"

namespace oblong {

namespace {

constexpr auto kHalfPixel = Screen::from_raw(128);

ScreenVertex clamped(ScreenVertex v) {
    return {std::clamp(v.x, -kLargestScreen, kLargestScreen), std::clamp(v.y, -kLargestScreen, kLargestScreen)};
}

ScreenTriangle clamped(const ScreenTriangle& triangle) {
    return {clamped(triangle[0]), clamped(triangle[1]), clamped(triangle[2])};
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
    ScreenTriangle clockwise = clamped(triangle);
    const ScreenArea area = doubled_area(clockwise);
    if (area == ScreenArea{}) return;
    if (area < ScreenArea{}) std::swap(clockwise[1], clockwise[2]);
    if (method_ == TriangleMethod::FlatParts) scan_flat_parts(clockwise, part_, rows_);
    if (method_ == TriangleMethod::EdgeWalking) scan_convex(clockwise, rows_);
    if (method_ == TriangleMethod::EdgeFunctions) scan_edge_functions(clockwise, part_, kernel_, rows_);
    append_rows(spans);
}

void TriangleScanner::append_rows(std::vector<Span>& spans) const {
    for (std::int32_t y = std::max(rows_.first, part_.first_row); y < rows_.end; ++y) {
        const Span span{y, std::max(item(rows_.left, y), part_.first_column),
                        std::min(item(rows_.right, y), part_.end_column)};
        if (span.first < span.end) spans.push_back(span);
    }
}

BarycentricWeights barycentric_weights(const ScreenTriangle& triangle, ScreenVertex place) {
    const ScreenTriangle corners = clamped(triangle);
    const auto& [a, b, c] = corners;
    const ScreenVertex p = clamped(place);
    return {edge_function(b, c, p), edge_function(c, a, p), edge_function(a, b, p), doubled_area(corners)};
}

LinearQuantity<CornerQuantity> quantity_over(const ScreenTriangle& triangle,
                                             const std::array<CornerQuantity, 3>& at_corners) {
    const ScreenTriangle corners = clamped(triangle);
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

}  // namespace oblong
