#include "engine/effects/particles.h"

#include <algorithm>
#include <optional>

#include "engine/fixed/sine_methods.h"

namespace oblong {
namespace {

/// A particle's random numbers, 16 bits each.
struct Chance {
    std::uint64_t bits;

    Chance(std::uint32_t seed, std::int32_t index)
        : bits((std::uint64_t{seed} << 32) + static_cast<std::uint32_t>(index)) {
        // The mixer of SplitMix64 (Steele, Lea and Flood 2014).
        bits = (bits + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
        bits ^= bits >> 31;
    }
    /// 0 to 65,535; `which` 0 to 3.
    std::int32_t share_16(int which) const { return static_cast<std::int32_t>(bits >> (16 * which) & 0xffff); }
    /// The same from -32,768 to 32,767.
    std::int32_t signed_15(int which) const { return share_16(which) - 32768; }
    /// Where in the period it begins; mixed once more, so that it does not depend on the shares.
    std::uint32_t phase() const { return static_cast<std::uint32_t>((bits * 0x9e3779b97f4a7c15) >> 32); }
};

/// size * share / 2^bits, toward minus infinity.
World part_of(World size, std::int64_t share, int bits) {
    return World::from_raw(static_cast<std::int32_t>(floor_shift(floor_of<12>(size) * share, bits)));
}

/// size * sin(phase).
World wave(World size, std::uint32_t phase) {
    const Unit height = sine(Angle{static_cast<std::uint16_t>(phase >> 16)}, SineMethod::Lerp256);
    return part_of(size, floor_of<30>(height), 30);
}

/// The amplitude of the particles' swing along an axis of the box.
World swing_in(World half_size, ParticleKind kind) {
    const std::int32_t most = kind == ParticleKind::Dust ? 16 : kind == ParticleKind::Bubbles ? 2 : 0;
    return std::min(half_size / 8, World::from_int(most));
}

/// Along an axis of the box: a random place that leaves room for the swing, and the swing.
World swinging_place(World half_size, ParticleKind kind, std::int32_t chance_15, std::uint32_t phase) {
    const World swing = swing_in(half_size, kind);
    return part_of(half_size - swing, chance_15, 15) + wave(swing, phase);
}

constexpr World kFarthestSplash = World::from_int(2);

// Places are relative to the middle of the box.

/// A drop falls for this part of the period; then the splash hops toward the middle, so that it stays in the box.
constexpr std::uint32_t kFall_16 = 7 * 8192;

/// A place seen from above.
struct Ground {
    World x, y;
};

Ground rain_at(const Vec3<World>& half_size, const Chance& chance, std::uint32_t phase) {
    const World x = part_of(half_size.x, chance.signed_15(0), 15), y = part_of(half_size.y, chance.signed_15(1), 15);
    const std::uint32_t phase_16 = phase >> 16;
    if (phase_16 < kFall_16) return {x, y};
    const auto inward = [age_13 = std::int64_t{phase_16} - kFall_16](World place, World half) {
        const World way = part_of(std::min(half, kFarthestSplash), age_13, 13);
        return place > World{} ? place - way : place + way;
    };
    return {inward(x, half_size.x), inward(y, half_size.y)};
}

World rain_height(World half_height, std::uint32_t phase) {
    const std::uint32_t phase_16 = phase >> 16;
    const auto half = convert<WorldWide>(half_height), height = half * 2;
    if (phase_16 < kFall_16) return convert<World>(half - height * phase_16 / kFall_16);
    const std::int64_t age_13 = phase_16 - kFall_16, hop_24 = age_13 * (8192 - age_13);
    const World most_hop = convert<World>(std::min(height, WorldWide::from_int(3)));
    return part_of(most_hop, hop_24, 24) - half_height;
}

/// With the age s from 0 to 1, a spark moves sideways at constant speed, and its height is v s - (v + 1) s^2, in half
/// heights of the box: -1 at the end, and at most v^2 / (4 v + 4), which is 4/5 or less for v from 0 to 4.
World spark_height(World half_height, const Chance& chance, std::uint32_t phase) {
    const std::int64_t age_16 = phase >> 16;
    const std::int64_t speed_14 = chance.share_16(2), fall_14 = speed_14 + (1 << 14);
    return part_of(half_height, speed_14 * age_16 - floor_shift(fall_14 * age_16 * age_16, 16), 30);
}

Ground ground_of(const ParticleEmitter& emitter, const Chance& chance, std::uint32_t phase) {
    const Vec3<World>& half = emitter.half_size;
    const auto swinging = [&](std::uint32_t x_phase, std::uint32_t y_phase) {
        return Ground{swinging_place(half.x, emitter.kind, chance.signed_15(0), x_phase),
                      swinging_place(half.y, emitter.kind, chance.signed_15(1), y_phase)};
    };
    const std::int64_t age_16 = phase >> 16;
    switch (emitter.kind) {
        case ParticleKind::Rain:
            return rain_at(half, chance, phase);
        case ParticleKind::Dust:
            return swinging(phase, phase + (static_cast<std::uint32_t>(chance.share_16(0)) << 16));
        case ParticleKind::Sparks:
            return {part_of(half.x, chance.signed_15(0) * age_16, 31),
                    part_of(half.y, chance.signed_15(1) * age_16, 31)};
        case ParticleKind::Bubbles:
            break;
    }
    return swinging(phase * 4, phase * 4 + (1u << 30));
}

World height_of(const ParticleEmitter& emitter, const Chance& chance, std::uint32_t phase) {
    const World half = emitter.half_size.z;
    switch (emitter.kind) {
        case ParticleKind::Rain:
            return rain_height(half, phase);
        case ParticleKind::Dust:
            return swinging_place(half, emitter.kind, chance.signed_15(2), phase * 2);
        case ParticleKind::Sparks:
            return spark_height(half, chance, phase);
        case ParticleKind::Bubbles:
            break;
    }
    return part_of(half, static_cast<std::int64_t>(phase >> 16) - 32768, 15);
}

std::uint8_t colour_of(const ParticleEmitter& emitter, std::int32_t share_16) {
    const std::int32_t ramp = emitter.last_colour - emitter.first_colour, count = (ramp < 0 ? -ramp : ramp) + 1;
    const std::int32_t step = floor_shift(count * share_16, 16);
    return static_cast<std::uint8_t>(emitter.first_colour + (ramp < 0 ? -step : step));
}

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
    const InverseDepth depth_of_dot = dot.inverse_depth | kThingBit;
    for (std::int32_t y = dot.first_row; y < dot.end_row; ++y) {
        const std::int32_t inset_px = y == dot.first_row || y + 1 == dot.end_row ? corner_px : 0;
        InverseDepth* const depths = depth.row(y);
        std::uint8_t* const pixels = out.row(y);
        for (std::int32_t x = dot.first_column + inset_px; x < dot.end_column - inset_px; ++x) {
            if (depths[x] > depth_of_dot) continue;
            depths[x] = depth_of_dot;
            pixels[x] = dot.colour;
        }
    }
}

}  // namespace

std::uint32_t phase_at(const ParticleEmitter& emitter, std::int64_t time_ms) {
    const std::int64_t rest_ms = time_ms % emitter.period_ms;
    return static_cast<std::uint32_t>(rest_ms * (std::int64_t{1} << 32) / emitter.period_ms);
}

std::optional<Particle> particle_at(const ParticleEmitter& emitter, std::int32_t index, std::uint32_t phase,
                                    const ParticleBox& within) {
    const Chance chance(emitter.seed, index);
    const std::uint32_t own_phase = phase + chance.phase();
    Vec3<World> place = emitter.middle;
    place.z += height_of(emitter, chance, own_phase);
    if (place.z < within.mins.z || place.z > within.maxs.z) return std::nullopt;
    const auto [x, y] = ground_of(emitter, chance, own_phase);
    place.x += x;
    place.y += y;
    if (!within.holds(place.x, place.y)) return std::nullopt;
    const std::uint32_t age_16 = own_phase >> 16;
    const auto share_16 = emitter.kind == ParticleKind::Sparks ? static_cast<std::int32_t>(age_16) : chance.share_16(3);
    return Particle{place, colour_of(emitter, share_16), emitter.kind == ParticleKind::Rain && age_16 < kFall_16};
}

std::int32_t append_dots(const ParticleEmitter& emitter, std::int64_t time_ms, const ViewContext& view,
                         const ParticleBox& within, std::vector<ParticleDot>& dots) {
    const DotProjection projection(view);
    const HalfSize dot_size = half_size_of(emitter.kind, false), streak_size = half_size_of(emitter.kind, true);
    const std::uint32_t phase = phase_at(emitter, time_ms);
    std::int32_t computed = 0;
    for (std::int32_t i = 0; i < emitter.count; ++i) {
        const std::optional<Particle> particle = particle_at(emitter, i, phase, within);
        if (!particle) continue;
        ++computed;
        const auto dot = projection.dot(*particle, particle->is_streak ? streak_size : dot_size);
        if (dot) dots.push_back(*dot);
    }
    return computed;
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
