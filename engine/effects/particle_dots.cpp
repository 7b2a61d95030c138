#include "engine/effects/particle_dots.h"

#include <algorithm>
#include <optional>

namespace oblong {

namespace {

constexpr View kNearestDot = View::from_int(16);

/// Half the size of a particle, units.
struct HalfSize {
    View across, up;
};

HalfSize half_size_of(ParticleKind kind, bool is_streak) {
    const auto quarters = [](std::int64_t count) { return View::from_raw(count * (1 << 14)); };
    if (is_streak) return {quarters(1), quarters(28)};
    switch (kind) {
        case ParticleKind::Rain:
        case ParticleKind::Dust:
            return {quarters(1), quarters(1)};
        case ParticleKind::Sparks:
            return {quarters(2), quarters(2)};
        case ParticleKind::Bubbles:
            break;
    }
    return {quarters(4), quarters(4)};
}

/// One axis of the projection for points inside the view, with one reciprocal of z for both axes and 64-bit products. A
/// position is within 1/16 pixel of the exact one.
class DotAxis {
  public:
    DotAxis(const ProjectionAxis& axis, std::int32_t size_px, std::int32_t share_of_screen)
        : multiplier_16_(floor_of<16>(axis.coarse)),
          size_px_(size_px),
          most_px_(std::max(size_px / share_of_screen, 1)),
          slope_16_((std::int64_t{size_px} << 31) / floor_of<16>(axis.coarse) + 1) {}

    bool is_outside(View position, View z, View half) const {
        return absolute(position) > floor_shift(z * slope_16_, 16) + half;
    }
    /// The pixels of [position - half, position + half], at least one; then clipped to the screen, perhaps none.
    /// `inverse_32` is 1/z.
    PixelRange range(View position, View half, std::int64_t inverse_32) const {
        const std::int64_t wide_px = floor_shift(2 * pixels_8(half, inverse_32) + 128, 8);
        const auto width_px = static_cast<std::int32_t>(std::clamp<std::int64_t>(wide_px, 1, most_px_));
        const std::int64_t left_8 = pixels_8(position, inverse_32) + (size_px_ - width_px + 1) * 128;
        const auto first_px = static_cast<std::int32_t>(floor_shift(left_8, 8));
        return {std::max(first_px, 0), std::min(first_px + width_px, size_px_)};
    }

  private:
    std::int64_t pixels_8(View length, std::int64_t inverse_32) const {
        return floor_shift(floor_shift(floor_of<16>(length) * inverse_32, 24) * multiplier_16_, 32);
    }

    std::int64_t multiplier_16_;
    std::int32_t size_px_, most_px_;
    std::int64_t slope_16_;  ///< of the screen's borders
};

class DotProjection {
  public:
    explicit DotProjection(const ViewContext& view)
        : view_(view),
          x_(view.projection.x, view.projection.width_px, 16),
          y_(view.projection.y, view.projection.height_px, 4) {}

    std::optional<ParticleDot> dot(const Particle& particle, const HalfSize& half) const {
        const auto from_eye = widening_difference(particle.position, view_.eye);
        const View z = view_coordinate(from_eye, view_.axes.forward);
        if (z < kNearestDot) return std::nullopt;
        const View x = view_coordinate(from_eye, view_.axes.right), y = view_coordinate(from_eye, view_.axes.up);
        if (x_.is_outside(x, z, half.across) || y_.is_outside(y, z, half.up)) return std::nullopt;
        const std::int64_t inverse_32 = View::from_raw(std::int64_t{1} << 48) / z;
        const PixelRange columns = x_.range(x, half.across, inverse_32), rows = y_.range(-y, half.up, inverse_32);
        if (columns.first >= columns.end || rows.first >= rows.end) return std::nullopt;
        const auto narrow = [](std::int32_t px) { return static_cast<std::int16_t>(px); };
        return ParticleDot{narrow(columns.first),
                           narrow(columns.end),
                           narrow(rows.first),
                           narrow(rows.end),
                           static_cast<InverseDepth>(inverse_32),
                           particle.colour};
    }

  private:
    const ViewContext& view_;
    DotAxis x_, y_;
};

/// A block of pixels, without its corners if it is at least three pixels in each direction, so that it looks round.
void draw_dot(const ParticleDot& dot, DepthBuffer& depth, Framebuffer out) {
    const std::int32_t width_px = dot.end_column - dot.first_column, height_px = dot.end_row - dot.first_row;
    const std::int32_t corner_px = std::min(width_px, height_px) < 3 ? 0 : (width_px + 3) / 6;
    for (std::int32_t y = dot.first_row; y < dot.end_row; ++y) {
        const std::int32_t inset_px = y == dot.first_row || y + 1 == dot.end_row ? corner_px : 0;
        InverseDepth* const depths = depth.row(y);
        std::uint8_t* const pixels = out.row(y);
        for (std::int32_t x = dot.first_column + inset_px; x < dot.end_column - inset_px; ++x) {
            if (depths[x] > dot.inverse_depth) continue;
            depths[x] = dot.inverse_depth;
            pixels[x] = dot.colour;
        }
    }
}

}  // namespace

void append_dots(const ParticleEmitter& emitter, std::int64_t time_ms, const ViewContext& view,
                 std::vector<ParticleDot>& dots) {
    const DotProjection projection(view);
    const HalfSize dot_size = half_size_of(emitter.kind, false), streak_size = half_size_of(emitter.kind, true);
    const std::uint32_t phase = phase_at(emitter, time_ms);
    for (std::int32_t i = 0; i < emitter.count; ++i) {
        const Particle particle = particle_at(emitter, i, phase);
        const auto dot = projection.dot(particle, particle.is_streak ? streak_size : dot_size);
        if (dot) dots.push_back(*dot);
    }
}

ScreenRectangle rectangle_around(std::span<const ParticleDot> dots) {
    if (dots.empty()) return {0, 0, 0, 0};
    ScreenRectangle around{dots[0].first_column, dots[0].end_column, dots[0].first_row, dots[0].end_row};
    for (const ParticleDot& dot : dots) {
        around.first_column = std::min<std::int32_t>(around.first_column, dot.first_column);
        around.end_column = std::max<std::int32_t>(around.end_column, dot.end_column);
        around.first_row = std::min<std::int32_t>(around.first_row, dot.first_row);
        around.end_row = std::max<std::int32_t>(around.end_row, dot.end_row);
    }
    return around;
}

void draw_dots(std::span<const ParticleDot> dots, DepthBuffer& depth, Framebuffer out) {
    for (const ParticleDot& dot : dots) draw_dot(dot, depth, out);
}

}  // namespace oblong
