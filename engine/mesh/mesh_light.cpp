#include "engine/mesh/mesh_light.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

/// light max(0, cosine).
Light8 lit_by(Light8 light, Sine60 cosine) {
    const std::int64_t cosine_30 = std::clamp(floor_of<30>(cosine), std::int64_t{0}, std::int64_t{1} << 30);
    return static_cast<Light8>(floor_shift(cosine_30 * light, 30));
}

Light8 within_limits(std::int32_t light) {
    return std::clamp(light, 0, MeshLight::kMostLight) * 256;
}

}  // namespace

Light8 diffuse_light(const Vec3<Unit>& normal, const DirectionalLight& light) {
    return lit_by(within_limits(light.strength), dot(normal, light.toward));
}

Light8 diffuse_light(const Vec3<World>& position, const Vec3<Unit>& normal, const MovingLight& light) {
    const Vec3<WorldWide> way = widening_difference(light.position, position);
    const auto radius = convert<WorldWide>(std::clamp(light.radius, World{}, kMostLightRadius));
    if (std::max({absolute(way.x), absolute(way.y), absolute(way.z)}) >= radius) return 0;
    const auto distance = WorldWide::from_raw(static_cast<std::int64_t>(length_of_raw(raw_of(way))));
    if (distance >= radius) return 0;
    const std::int32_t brightness_256 = std::clamp(light.brightness_256, 0, kMostBrightness_256);
    const std::int64_t light_8 = floor_of((radius - distance) * brightness_256);
    return lit_by(static_cast<Light8>(std::min<std::int64_t>(light_8, MeshLight::kMostLight * 256)),
                  dot(normal, normalised(way)));
}

Light8 ambient_and_point_light(const Vec3<World>& position, const Vec3<Unit>& normal, const MeshLight& light) {
    std::int64_t sum = within_limits(light.ambient);
    for (const MovingLight& point : light.points) sum += diffuse_light(position, normal, point);
    return static_cast<Light8>(std::min<std::int64_t>(sum, MeshLight::kMostLight * 256));
}

Light8 light_at(const Vec3<World>& position, const Vec3<Unit>& normal, const MeshLight& light) {
    return ambient_and_point_light(position, normal, light) + diffuse_light(normal, light.directional);
}

HighlightTable make_highlight_table(std::int32_t brightest) {
    HighlightTable table{};
    for (std::int64_t cosine_8 = 0; cosine_8 <= 256; ++cosine_8) {
        std::int64_t power_30 = cosine_8 << 22;
        for (int power = 1; power < kShininess; power *= 2) power_30 = floor_shift(power_30 * power_30, 30);
        item(table, cosine_8) = static_cast<Light8>(floor_shift(power_30 * within_limits(brightest), 30));
    }
    return table;
}

Vec3<Unit> halfway(const Vec3<Unit>& toward_light, const Vec3<Unit>& toward_eye) {
    const auto half = [](Unit a, Unit b) { return a / 2 + b / 2; };
    return normalised(Vec3<Unit>{half(toward_light.x, toward_eye.x), half(toward_light.y, toward_eye.y),
                                 half(toward_light.z, toward_eye.z)});
}

}  // namespace oblong
