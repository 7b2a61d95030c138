#include "tools/map/tree_choose.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace oblong::map {
namespace {

constexpr std::size_t kMaxCandidates = 96;
constexpr long kCutCost = 6;

Side side_of_reach(double lowest, double highest) {
    const bool is_front = highest > kOnEpsilon, is_back = lowest < -kOnEpsilon;
    if (is_front && is_back) return Side::kBoth;
    if (is_front) return Side::kFront;
    return is_back ? Side::kBack : Side::kOn;
}

// Every plane of the pieces, or an even selection of them if they are many, the axial ones first.
std::vector<int> candidates_of(const std::vector<BoundaryPiece>& pieces, const PlaneList& planes) {
    std::vector<int> all;
    const bool takes_detail = has_only_detail(pieces);
    for (const BoundaryPiece& piece : pieces) {
        if (takes_detail || !piece.is_detail) all.push_back(piece.plane.plane);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (all.size() <= kMaxCandidates) return all;
    const auto slanted =
        std::stable_partition(all.begin(), all.end(), [&](int plane) { return is_axial(planes[plane]); });
    const auto axial_count = static_cast<std::size_t>(slanted - all.begin());
    if (axial_count >= kMaxCandidates / 4) all.resize(axial_count);
    std::vector<int> some;
    const std::size_t step = (all.size() + kMaxCandidates - 1) / kMaxCandidates;
    for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
    return some;
}

long cost_of(int plane, const std::vector<BoundaryPiece>& pieces, const PlaneList& planes) {
    long front = 0, back = 0, cuts = 0;
    for (const BoundaryPiece& piece : pieces) {
        const Side side = side_of(piece, plane, planes);
        if (side == Side::kOn) continue;
        if (side != Side::kBack) ++front;
        if (side != Side::kFront) ++back;
        if (side == Side::kBoth) ++cuts;
    }
    const long cost = kCutCost * cuts + std::labs(front - back);
    return is_axial(planes[plane]) ? 2 * cost : 3 * cost + 4;
}

}  // namespace

Side side_of(const BoundaryPiece& piece, int plane_index, const PlaneList& planes) {
    if (piece.plane.plane == plane_index) return Side::kOn;
    const Plane& plane = planes[plane_index];
    const int type = plane_type(plane);
    if (type < 3)
        return side_of_reach(component(piece.box.mins, type) - plane.distance,
                             component(piece.box.maxs, type) - plane.distance);
    const Reach far = reach(piece.winding, plane);
    return side_of_reach(-far.back, far.front);
}

bool has_only_detail(const std::vector<BoundaryPiece>& pieces) {
    return std::all_of(pieces.begin(), pieces.end(), [](const BoundaryPiece& piece) { return piece.is_detail; });
}

int choose_plane(const std::vector<BoundaryPiece>& pieces, const PlaneList& planes) {
    int best = pieces.front().plane.plane;
    long best_cost = std::numeric_limits<long>::max();
    for (const int plane : candidates_of(pieces, planes)) {
        const long cost = cost_of(plane, pieces, planes);
        if (cost >= best_cost) continue;
        best = plane;
        best_cost = cost;
    }
    return best;
}

}  // namespace oblong::map
