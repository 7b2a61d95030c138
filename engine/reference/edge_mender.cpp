#include "engine/reference/edge_mender.h"

#include <algorithm>
#include <utility>

namespace oblong::reference {

namespace {

constexpr double kTolerance = 1.0 / 512;  ///< units; compilers leave about 1e-5

}  // namespace

EdgeMender::EdgeMender(const std::vector<Vec>& vertices, const std::vector<int>& used)
    : vertices_(vertices), by_x_(used) {
    std::sort(by_x_.begin(), by_x_.end(), [&](int a, int b) { return at(a).x < at(b).x; });
    by_x_.erase(std::unique(by_x_.begin(), by_x_.end()), by_x_.end());
}

std::vector<int> EdgeMender::inside(int from, int to) const {
    const Vec start = at(from), edge = at(to) - start;
    const double length_squared = dot(edge, edge);
    std::vector<std::pair<double, int>> found;  // place on the edge, 0 to 1, and vertex
    const double low = std::min(start.x, at(to).x) - kTolerance, high = std::max(start.x, at(to).x) + kTolerance;
    const auto first = std::partition_point(by_x_.begin(), by_x_.end(), [&](int vertex) { return at(vertex).x < low; });
    for (auto vertex = first; vertex != by_x_.end() && at(*vertex).x <= high; ++vertex) {
        const Vec step = at(*vertex) - start;
        const double place = dot(step, edge) / length_squared;
        const Vec beside = step - edge * place;
        if (place > 0 && place < 1 && dot(beside, beside) < kTolerance * kTolerance && *vertex != from && *vertex != to)
            found.emplace_back(place, *vertex);
    }
    std::sort(found.begin(), found.end());
    std::vector<int> result;
    for (const auto& [place, vertex] : found) result.push_back(vertex);
    return result;
}

std::vector<int> EdgeMender::mended(const std::vector<int>& corners) const {
    std::vector<int> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const int from = corners[i], to = corners[(i + 1) % corners.size()];
        result.push_back(from);
        // From the same end for both faces of an edge, so that both get the same vertices.
        std::vector<int> between = inside(std::min(from, to), std::max(from, to));
        if (from > to) std::reverse(between.begin(), between.end());
        result.insert(result.end(), between.begin(), between.end());
    }
    return result;
}

}  // namespace oblong::reference
