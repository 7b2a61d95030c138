#include "engine/reference/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace oblong::reference {
namespace {

/// Two faces whose 1/z differ by less than this fraction are equally near: the file's floats do not decide.
constexpr double kEqualDepth = 1e-6;
/// Units in front of an eye on the wrong side of a face: more than corners are off their planes.
constexpr double kClearlyBehind = 1;

/// A face that may be in view.
struct Candidate {
    int face = 0, model = 0;
    PlaneView plane;
    std::vector<RayTriangle> fan;
    int first_row = 0, end_row = 0;
    double least_inverse_z = 0, most_inverse_z = 0;  ///< of its corners

    /// Clamped to the corners' range: the depth of a plane seen almost edge-on is unreliable.
    double inverse_z(ScreenPoint at) const { return std::clamp(plane.inverse_z(at), least_inverse_z, most_inverse_z); }
};

/// Whether all corners are behind the eye or beyond one side of the picture.
bool is_out_of_view(const std::vector<RayCorner>& corners, const View& view) {
    const auto all = [&](auto is_outside) { return std::all_of(corners.begin(), corners.end(), is_outside); };
    const std::int64_t width = view.width_px, height = view.height_px;
    return all([](const RayCorner& c) { return c.z <= 0; }) ||
           all([&](const RayCorner& c) { return c.x * 2 < -c.z * width; }) ||
           all([&](const RayCorner& c) { return c.x * 2 > c.z * width; }) ||
           all([&](const RayCorner& c) { return c.y * 2 < -c.z * height; }) ||
           all([&](const RayCorner& c) { return c.y * 2 > c.z * height; });
}

/// The rows and depths of the corners; if the eye's plane cuts the face, all rows, and all depths up to the farthest
/// corner.
void set_bounds(const std::vector<RayCorner>& corners, const View& view, Candidate& candidate) {
    double top = view.height_px, bottom = 0, nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const RayCorner& corner : corners) {
        const auto z = static_cast<double>(corner.z), y = static_cast<double>(corner.y) / z + view.height_px / 2.0;
        top = std::min(top, corner.z > 0 ? y : 0);
        bottom = std::max(bottom, corner.z > 0 ? y : view.height_px);
        nearest = std::min(nearest, std::max(std::ldexp(z, -20), 0.0));
        farthest = std::max(farthest, std::ldexp(z, -20));
    }
    candidate.first_row = static_cast<int>(std::clamp(top - 1, 0.0, double(view.height_px)));
    candidate.end_row = static_cast<int>(std::clamp(bottom + 2, 0.0, double(view.height_px)));
    candidate.least_inverse_z = 1 / farthest;
    candidate.most_inverse_z = 1 / nearest;
}

/// The candidates of one view.
class CandidateList {
  public:
    CandidateList(const Level& level, const View& view) : level_(level), view_(view), camera_(make_camera(view)) {}

    void add_model(const PlacedModel& placed) {
        const Model& model = level_.models.at(static_cast<std::size_t>(placed.model));
        for (int face = model.first_face; face < model.first_face + model.face_count; ++face) add_face(face, placed);
    }
    const std::vector<Candidate>& all() const { return candidates_; }

  private:
    void add_face(int index, const PlacedModel& placed) {
        const Face& face = level_.face(index);
        if (dot(face.plane.normal, camera_.eye - placed.offset) < face.plane.offset - kClearlyBehind) return;
        corners_.clear();
        for (const int corner : face.corners)
            corners_.push_back(make_ray_corner(level_.vertex(corner) + placed.offset, camera_));
        if (is_out_of_view(corners_, view_)) return;
        Candidate candidate{index, placed.model, PlaneView(level_, face, placed.offset, camera_),
                            make_ray_fan(corners_)};
        set_bounds(corners_, view_, candidate);
        candidates_.push_back(std::move(candidate));
    }

    const Level& level_;
    const View& view_;
    Camera camera_;
    std::vector<RayCorner> corners_;
    std::vector<Candidate> candidates_;
};

CandidateList make_candidates(const Level& level, std::span<const PlacedModel> models, const View& view) {
    CandidateList list(level, view);
    list.add_model({});
    for (const PlacedModel& placed : models) list.add_model(placed);
    return list;
}

/// The candidate that each ray hits first.
class DepthBuffer {
  public:
    struct Nearest {
        int candidate = -1;
        double inverse_z = 0;
        bool is_shared = false;  ///< another one is equally near
    };

    DepthBuffer(const View& view, RayShift shift)
        : grid_{view.width_px, view.height_px, shift},
          windings_(static_cast<std::size_t>(view.width_px)),
          nearest_(static_cast<std::size_t>(view.width_px) * static_cast<std::size_t>(view.height_px)) {}

    void draw(const std::vector<Candidate>& candidates) {
        for (std::size_t i = 0; i < candidates.size(); ++i)
            for (int row = candidates[i].first_row; row < candidates[i].end_row; ++row)
                draw_row(candidates[i], static_cast<int>(i), row);
    }
    ScreenPoint ray_at(int column, int row) const {
        return {column + 0.5 + double(grid_.shift.x) / kRayUnit, row + 0.5 + double(grid_.shift.y) / kRayUnit};
    }
    const std::vector<Nearest>& nearest() const { return nearest_; }

  private:
    void draw_row(const Candidate& candidate, int index, int row) {
        Interval all{grid_.width_px, 0};
        for (const RayTriangle& triangle : candidate.fan) {
            const Interval inside = triangle.inside(grid_, row);
            for (int column = inside.first; column < inside.end; ++column) winding_at(column) += triangle.winding();
            if (inside.first < inside.end) all = {std::min(all.first, inside.first), std::max(all.end, inside.end)};
        }
        for (int column = all.first; column < all.end; ++column) {
            if (winding_at(column) > 0) offer(column, row, {index, candidate.inverse_z(ray_at(column, row)), false});
            winding_at(column) = 0;
        }
    }
    void offer(int column, int row, const Nearest& offered) {
        Nearest& nearest = nearest_[static_cast<std::size_t>(row * grid_.width_px + column)];
        const bool is_equal = std::abs(offered.inverse_z - nearest.inverse_z) <= offered.inverse_z * kEqualDepth;
        if (nearest.candidate < 0 || offered.inverse_z > nearest.inverse_z)
            nearest = {offered.candidate, offered.inverse_z, nearest.candidate >= 0 && is_equal};
        else if (is_equal)
            nearest.is_shared = true;
    }
    int& winding_at(int column) { return windings_[static_cast<std::size_t>(column)]; }

    RayGrid grid_;
    std::vector<int> windings_;  ///< of the current row
    std::vector<Nearest> nearest_;
};

/// Turns candidates into faces, planes and texels.
Frame resolve(const std::vector<Candidate>& candidates, const DepthBuffer& buffer, const View& view) {
    Frame frame{view.width_px, view.height_px, {}, {}};
    std::vector<int> plane_of(candidates.size(), -1);
    for (int row = 0; row < view.height_px; ++row)
        for (int column = 0; column < view.width_px; ++column) {
            const auto& nearest = buffer.nearest()[frame.pixels.size()];
            Pixel& pixel = frame.pixels.emplace_back();
            if (nearest.candidate < 0) continue;
            const auto index = static_cast<std::size_t>(nearest.candidate);
            const Candidate& candidate = candidates[index];
            if (plane_of[index] < 0) {
                plane_of[index] = static_cast<int>(frame.planes.size());
                frame.planes.push_back(candidate.plane);
            }
            const Texel texel = candidate.plane.texel_at(buffer.ray_at(column, row), nearest.inverse_z);
            pixel = {candidate.face, candidate.model, plane_of[index],  1 / nearest.inverse_z,
                     texel.u,        texel.v,         nearest.is_shared};
        }
    return frame;
}

DepthBuffer draw_candidates(const std::vector<Candidate>& candidates, const View& view, RayShift shift) {
    DepthBuffer buffer(view, shift);
    buffer.draw(candidates);
    return buffer;
}

constexpr int kGridBits = 20;
constexpr double kLargest = 34359738368.0;  ///< 2^35: determinants fit 128 bits

std::int64_t rounded(double value) {
    if (!(std::abs(value) < kLargest)) throw std::range_error("a corner beyond 2^35 units times pixels from the eye");
    return std::llround(std::ldexp(value, kGridBits));
}

/// Floor; the divisor is above 0.
Wide floor_quotient(Wide dividend, Wide divisor) {
    return dividend / divisor - (dividend % divisor < 0 ? 1 : 0);
}

int clamped(Wide column, int width_px) {
    return static_cast<int>(std::clamp<Wide>(column, 0, width_px));
}

/// The sign of x a + y b + z c. The left factors have up to 111 bits: so their halves are multiplied separately.
int sign_of_sum(Wide x, Wide y, Wide z, const RayCorner& c) {
    constexpr int kLowBits = 48;
    const auto high = [](Wide value) { return value >> kLowBits; };
    const auto low = [&](Wide value) { return value - (high(value) << kLowBits); };
    const Wide low_sum = low(x) * c.x + low(y) * c.y + low(z) * c.z;
    const Wide high_sum = high(x) * c.x + high(y) * c.y + high(z) * c.z + high(low_sum);
    if (high_sum != 0) return high_sum > 0 ? 1 : -1;
    return low(low_sum) > 0 ? 1 : 0;
}

}  // namespace

RayCorner make_ray_corner(const Vec& world_point, const Camera& camera) {
    const Vec view = to_view(world_point, camera.eye, camera.axes);
    return {rounded(view.x * camera.projection.multiplier_x), rounded(-view.y * camera.projection.multiplier_y),
            rounded(view.z)};
}

RayTriangle::Side RayTriangle::side(const RayCorner& from, const RayCorner& to) {
    return {Wide{from.y} * to.z - Wide{from.z} * to.y, Wide{from.z} * to.x - Wide{from.x} * to.z,
            Wide{from.x} * to.y - Wide{from.y} * to.x};
}

std::optional<RayTriangle> RayTriangle::make(const RayCorner& a, const RayCorner& b, const RayCorner& c) {
    const Side first = side(a, b);
    RayTriangle triangle;
    triangle.winding_ = sign_of_sum(first.x, first.y, first.z, c);
    if (triangle.winding_ == 0) return std::nullopt;
    if (triangle.winding_ > 0)
        triangle.sides_ = {first, side(b, c), side(c, a)};
    else
        triangle.sides_ = {side(b, a), side(a, c), side(c, b)};
    return triangle;
}

void RayTriangle::limit(const Side& side, const RayGrid& grid, int row, Interval& interval) {
    const bool owns_its_rays = side.x > 0 || (side.x == 0 && side.y > 0);  // a left edge, or a top edge
    // Inside: start + column * step >= 0.
    const Wide start = side.x * grid.x(0) + side.y * grid.y(row) + side.z * kRayUnit - (owns_its_rays ? 0 : 1);
    const Wide step = side.x * kRayUnit;
    if (step > 0)
        interval.first = std::max(interval.first, clamped(-floor_quotient(start, step), grid.width_px));
    else if (step < 0)
        interval.end = std::min(interval.end, clamped(floor_quotient(start, -step) + 1, grid.width_px));
    else if (start < 0)
        interval.end = 0;
}

Interval RayTriangle::inside(const RayGrid& grid, int row) const {
    Interval interval{0, grid.width_px};
    for (const Side& side : sides_) limit(side, grid, row, interval);
    return interval;
}

std::vector<RayTriangle> make_ray_fan(std::span<const RayCorner> corners) {
    std::vector<RayTriangle> fan;
    for (std::size_t i = 2; i < corners.size(); ++i)
        if (const auto triangle = RayTriangle::make(corners[0], corners[i - 1], corners[i])) fan.push_back(*triangle);
    return fan;
}

Frame draw(const Level& level, std::span<const PlacedModel> models, const View& view, RayShift shift) {
    const CandidateList list = make_candidates(level, models, view);
    return resolve(list.all(), draw_candidates(list.all(), view, shift), view);
}

Frame draw_with_close_calls(const Level& level, std::span<const PlacedModel> models, const View& view, int distance) {
    const CandidateList list = make_candidates(level, models, view);
    const DepthBuffer centre = draw_candidates(list.all(), view, {});
    Frame frame = resolve(list.all(), centre, view);
    for (const RayShift shift : {RayShift{-distance, -distance}, RayShift{distance, -distance},
                                 RayShift{-distance, distance}, RayShift{distance, distance}}) {
        const DepthBuffer beside = draw_candidates(list.all(), view, shift);
        for (std::size_t i = 0; i < frame.pixels.size(); ++i)
            if (beside.nearest()[i].candidate != centre.nearest()[i].candidate) frame.pixels[i].is_close_call = true;
    }
    return frame;
}

}  // namespace oblong::reference
