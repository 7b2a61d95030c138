// Triangles that tile a region cover each of its pixels once, whatever their order, winding and first corner. Meshes of
// one grid: HardCaseE1, HardCaseE10; these are cut again and again at random corners, down to slivers.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "engine/raster/scan.h"
#include "tests/properties/mesh.h"

namespace oblong::test {
namespace {

constexpr std::int32_t kWidth = 64, kHeight = 40;
/// Of each pixel the triangles that cover it, by their number in the mesh.
using Owners = std::vector<std::vector<std::size_t>>;

rc::Gen<Cut> any_cut() {
    const auto weight = rc::gen::inRange<std::int64_t>(1, 64);
    const auto off = rc::gen::inRange<std::int32_t>(-300, 300);
    return rc::gen::build<Cut>(rc::gen::set(&Cut::is_inside), rc::gen::set(&Cut::triangle), rc::gen::set(&Cut::edge),
                               rc::gen::set(&Cut::weight_a, weight), rc::gen::set(&Cut::weight_b, weight),
                               rc::gen::set(&Cut::weight_c, weight), rc::gen::set(&Cut::off_edge_x_8, off),
                               rc::gen::set(&Cut::off_edge_y_8, off),
                               rc::gen::set(&Cut::grid_8, rc::gen::element(1, 128)));
}

Rectangle any_rectangle() {
    const std::int32_t grid_8 = *rc::gen::element(1, 128);
    const auto side = [grid_8](std::int32_t low, std::int32_t high) {
        return *rc::gen::inRange(low * 256, high * 256) / grid_8 * grid_8;
    };
    return {side(-10, 20), side(-10, 15), side(40, 80), side(20, 60)};
}

void add_triangle(Mesh::Triangle triangle, std::size_t number, Owners& owners) {
    if (doubled_area(triangle).raw < 0) std::reverse(triangle.begin(), triangle.end());
    ScanlineExtents rows(kHeight);
    scan_convex(triangle, rows);
    for (std::int32_t row = rows.first; row < rows.end; ++row) {
        const std::int32_t end = std::min(rows.right[static_cast<std::size_t>(row)], kWidth);
        for (std::int32_t column = std::max(rows.left[static_cast<std::size_t>(row)], 0); column < end; ++column)
            owners[static_cast<std::size_t>(row * kWidth + column)].push_back(number);
    }
}

Owners owners_of(const std::vector<Mesh::Triangle>& triangles) {
    Owners owners(static_cast<std::size_t>(kWidth * kHeight));
    for (std::size_t i = 0; i < triangles.size(); ++i) add_triangle(triangles[i], i, owners);
    return owners;
}

bool holds_centre(const Rectangle& r, std::int32_t column, std::int32_t row) {
    const std::int32_t x_8 = column * 256 + 128, y_8 = row * 256 + 128;
    return r.left_8 <= x_8 && x_8 < r.right_8 && r.top_8 <= y_8 && y_8 < r.bottom_8;
}

RC_GTEST_PROP(PropertyTiling, EachPixelIsCoveredOnceWhateverTheWinding, ()) {
    const Rectangle rectangle = any_rectangle();
    Mesh mesh(rectangle);
    for (const Cut& cut : *rc::gen::container<std::vector<Cut>>(any_cut())) mesh.cut(cut);

    std::vector<Mesh::Triangle> triangles = mesh.triangles();
    const Owners owners = owners_of(triangles);
    for (std::int32_t row = 0; row < kHeight; ++row)
        for (std::int32_t column = 0; column < kWidth; ++column)
            RC_ASSERT(owners[static_cast<std::size_t>(row * kWidth + column)].size() ==
                      std::size_t{holds_centre(rectangle, column, row)});

    for (Mesh::Triangle& triangle : triangles) {
        std::rotate(triangle.begin(), triangle.begin() + *rc::gen::inRange(0, 3), triangle.end());
        if (*rc::gen::arbitrary<bool>()) std::reverse(triangle.begin(), triangle.end());
    }
    RC_ASSERT(owners_of(triangles) == owners);
}

}  // namespace
}  // namespace oblong::test
