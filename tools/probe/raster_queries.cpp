#include <array>

#include "engine/base/table.h"
#include "engine/raster/scan.h"
#include "tools/probe/probe.h"

namespace oblong {

namespace {

constexpr std::int32_t kWidth_px = 320, kHeight_px = 200;
using Triangle = std::array<ScreenVertex, 3>;

/// The factor from coordinates in 1/S pixel to the engine's 1/256.
std::int32_t read_scale(Fields& fields) {
    const std::int64_t steps = fields.integer(16, 256);
    if (steps != 16 && steps != 256) throw Unsupported{};
    return static_cast<std::int32_t>(256 / steps);
}

Screen read_coordinate(Fields& fields, std::int32_t scale) {
    const std::int64_t limit = kLargestScreen.raw / scale;
    return Screen::from_raw(static_cast<std::int32_t>(fields.integer(-limit, limit)) * scale);
}

ScreenVertex read_vertex(Fields& fields, std::int32_t scale) {
    const Screen x = read_coordinate(fields, scale), y = read_coordinate(fields, scale);
    return {x, y};
}

/// The rows of a triangle of either winding, its columns cut to the raster. False if it has no area.
bool scan_triangle(Triangle triangle, EdgeStepping edges, ScanlineExtents& rows) {
    const ScreenArea area = doubled_area(triangle);
    if (area == ScreenArea{}) return false;
    if (area < ScreenArea{}) std::swap(triangle[1], triangle[2]);
    scan_convex(triangle, rows, edges);
    return true;
}

/// Calls visit(row, first, end) for each row that has pixels on the raster.
template <class Visit>
void for_each_covered_row(const Triangle& triangle, EdgeStepping edges, ScanlineExtents& rows, Visit visit) {
    if (!scan_triangle(triangle, edges, rows)) return;
    for (std::int32_t row = rows.first; row < rows.end; ++row) {
        const std::int32_t first = std::max(item(rows.left, row), 0);
        const std::int32_t end = std::min(item(rows.right, row), kWidth_px);
        if (first < end) visit(row, first, end);
    }
}

/// The number of triangles that cover each pixel, stored as changes from column to column, so that a triangle costs two
/// changes a row.
class OverlapCounter {
  public:
    OverlapCounter() : changes_(as_size(kHeight_px * kPitch)) {}

    void add_row(std::int32_t row, std::int32_t first, std::int32_t end) {
        ++item(changes_, row * kPitch + first);
        --item(changes_, row * kPitch + end);
    }

    /// Pixels covered by no, one, and more triangles.
    std::array<std::int32_t, 3> count() const {
        std::array<std::int32_t, 3> counts{};
        for (std::int32_t row = 0; row < kHeight_px; ++row) {
            std::int32_t triangles = 0;
            for (std::int32_t column = 0; column < kWidth_px; ++column) {
                triangles += item(changes_, row * kPitch + column);
                ++item(counts, std::min(triangles, 2));
            }
        }
        return counts;
    }

  private:
    static constexpr std::int32_t kPitch = kWidth_px + 1;
    std::vector<std::int32_t> changes_;
};

std::vector<ScreenVertex> read_vertices(Fields& fields, std::int32_t scale) {
    const std::int64_t count = fields.integer(0, static_cast<std::int64_t>(fields.left()) / 2);
    std::vector<ScreenVertex> vertices;
    for (std::int64_t i = 0; i < count; ++i) vertices.push_back(read_vertex(fields, scale));
    return vertices;
}

std::vector<Triangle> read_triangles(Fields& fields, const std::vector<ScreenVertex>& vertices) {
    const std::int64_t count = fields.integer(0, static_cast<std::int64_t>(fields.left()) / 3);
    const auto corner = [&] {
        const std::int64_t index = fields.integer(0, static_cast<std::int64_t>(vertices.size()) - 1);
        return item(vertices, index);
    };
    std::vector<Triangle> triangles;
    for (std::int64_t i = 0; i < count; ++i) {
        const ScreenVertex a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return triangles;
}

}  // namespace

std::string answer_coverage(Fields& fields, const Accuracy& accuracy) {
    const std::int32_t scale = read_scale(fields);
    const ScreenVertex a = read_vertex(fields, scale), b = read_vertex(fields, scale), c = read_vertex(fields, scale);
    fields.expect_end();

    ScanlineExtents rows(kHeight_px);
    std::int32_t row_count = 0;
    std::string text;
    for_each_covered_row({a, b, c}, accuracy.edges, rows, [&](std::int32_t row, std::int32_t first, std::int32_t end) {
        ++row_count;
        text += ' ' + std::to_string(row) + ' ' + std::to_string(first) + ' ' + std::to_string(end);
    });
    return std::to_string(row_count) + text;
}

std::string answer_mesh(Fields& fields, const Accuracy& accuracy) {
    const std::int32_t scale = read_scale(fields);
    const std::vector<ScreenVertex> vertices = read_vertices(fields, scale);
    const std::vector<Triangle> triangles = read_triangles(fields, vertices);
    fields.expect_end();

    ScanlineExtents rows(kHeight_px);
    OverlapCounter counter;
    for (const Triangle& triangle : triangles)
        for_each_covered_row(
            triangle, accuracy.edges, rows,
            [&](std::int32_t row, std::int32_t first, std::int32_t end) { counter.add_row(row, first, end); });
    const std::array<std::int32_t, 3> counts = counter.count();
    return std::to_string(counts[0]) + ' ' + std::to_string(counts[1]) + ' ' + std::to_string(counts[2]);
}

}  // namespace oblong
