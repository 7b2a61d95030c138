#include "engine/effects/sky.h"

#include <algorithm>
#include <array>

#include "engine/fixed/root.h"

namespace oblong {

namespace {

constexpr std::int32_t kStep_px = 8;  ///< Quake's: 32
/// Texels from the zenith to the horizon of a dome of a 128-texel sky: Quake's 6 * (128 / 2 - 1).
constexpr std::int64_t kDomeRadius_texels = 378;

/// Texels of one layer, 16.16, from the zenith.
struct SkyPosition {
    std::int32_t u_16, v_16;
};

/// Directions of view in the world, of any length: linear on the screen. Column and row are those of pixel centres.
class DirectionField {
  public:
    DirectionField(const Basis& axes, const Projection& projection) {
        const std::int64_t half_width_1 = projection.width_px, half_height_1 = projection.height_px;
        const std::array<const Unit*, 3> right{&axes.right.x, &axes.right.y, &axes.right.z};
        const std::array<const Unit*, 3> up{&axes.up.x, &axes.up.y, &axes.up.z};
        const std::array<const Unit*, 3> forward{&axes.forward.x, &axes.forward.y, &axes.forward.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            per_column_30_[axis] =
                mul_div(right[axis]->raw, std::int64_t{1} << 32, projection.x.multiplier.raw, Rounding::Floor);
            per_row_30_[axis] =
                -mul_div(up[axis]->raw, std::int64_t{1} << 32, projection.y.multiplier.raw, Rounding::Floor);
            origin_30_[axis] = forward[axis]->raw + floor_shift(per_column_30_[axis] * (1 - half_width_1), 1) +
                               floor_shift(per_row_30_[axis] * (1 - half_height_1), 1);
        }
    }

    SkyPosition at(std::int32_t column, std::int32_t row, std::int32_t size) const {
        std::array<std::int64_t, 3> direction_16{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            direction_16[axis] =
                floor_shift(origin_30_[axis] + per_column_30_[axis] * column + per_row_30_[axis] * row, 14);
        direction_16[2] *= 3;
        const std::int64_t length_16 = std::max<std::int64_t>(length(direction_16), 1);
        const std::int64_t radius_16 = kDomeRadius_texels * size / 128 * 65536;
        return {static_cast<std::int32_t>(direction_16[0] * radius_16 / length_16),
                static_cast<std::int32_t>(direction_16[1] * radius_16 / length_16)};
    }

  private:
    static std::int64_t length(const std::array<std::int64_t, 3>& v) {
        return static_cast<std::int64_t>(
            integer_root(static_cast<std::uint64_t>(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])));
    }

    std::array<std::int64_t, 3> origin_30_{}, per_column_30_{}, per_row_30_{};
};

std::uint8_t sky_texel(const SkyTexture& sky, std::int32_t u_16, std::int32_t v_16) {
    const std::int32_t u = floor_shift(u_16, 16) & (sky.size - 1), v = floor_shift(v_16, 16) & (sky.size - 1);
    const std::uint8_t* row = sky.texels + v * sky.stride;
    const std::uint8_t cloud = row[u];
    return cloud != 0 ? cloud : row[u + sky.size];
}

/// In 64 bits: the domes of large skies are 2^31 steps wide and more.
std::int32_t step_between(std::int32_t from_16, std::int32_t to_16, std::int32_t count) {
    return static_cast<std::int32_t>((std::int64_t{to_16} - from_16) / count);
}

void draw_sky_span(const Span& span, const SkyTexture& sky, const DirectionField& field, std::uint8_t* row) {
    SkyPosition from = field.at(span.first, span.y, sky.size);
    for (std::int32_t column = span.first; column < span.end;) {
        const std::int32_t count = std::min(kStep_px, span.end - column);
        const SkyPosition to = field.at(column + count, span.y, sky.size);
        const std::int32_t u_step_16 = step_between(from.u_16, to.u_16, count);
        const std::int32_t v_step_16 = step_between(from.v_16, to.v_16, count);
        for (std::int32_t i = 0; i < count; ++i)
            row[column + i] = sky_texel(sky, from.u_16 + u_step_16 * i, from.v_16 + v_step_16 * i);
        column += count;
        from = to;
    }
}

}  // namespace

void draw_sky(std::span<const Span> spans, const SkyTexture& sky, const Basis& axes, const Projection& projection,
              Framebuffer out) {
    const DirectionField field(axes, projection);
    for (const Span& span : spans) draw_sky_span(span, sky, field, out.row(span.y));
}

}  // namespace oblong
