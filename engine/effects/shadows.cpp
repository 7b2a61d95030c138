#include "engine/effects/shadows.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/trig.h"

namespace oblong {

namespace {

constexpr int kCorners = 16;
constexpr World kLargestRadius = World::from_int(4096);

/// The corners of a disc on a floor, clockwise seen from above. Its vertical projection is a circle for any slope.
std::array<Vec3<World>, kCorners> corners_of_disc(const LevelPlane& plane, const Vec3<World>& middle, World radius) {
    std::array<Vec3<World>, kCorners> corners{};
    for (int i = 0; i < kCorners; ++i) {
        const Angle angle = -Angle::from_bam(std::int64_t{i} * 65536 / kCorners);
        const auto x = product<World>(radius, cosine(angle)), y = product<World>(radius, sine(angle));
        const PlaneDistance fall = widening_product(x, plane.normal.x) + widening_product(y, plane.normal.y);
        item(corners, i) = middle + Vec3<World>{x, y, -truncated_quotient<World>(fall, plane.normal.z)};
    }
    return corners;
}

}  // namespace

Shadow make_shadow(const Floor& floor, const Vec3<World>& middle, World radius) {
    constexpr auto kFarthest = convert<WorldWide>(kFarthestShadow);
    const WorldWide distance = std::clamp(widening_difference(middle.z, floor.position.z), WorldWide{}, kFarthest);
    return {floor, product_over<World>(std::min(radius, kLargestRadius), kFarthest - distance, kFarthest)};
}

bool scan_shadow(const Shadow& shadow, std::int32_t share_8, const Level& level, const ViewContext& view,
                 ShadowScratch& scratch) {
    const World radius = product<World>(shadow.radius, Fixed<std::int32_t, 8>::from_raw(share_8));
    if (radius <= World{}) return false;
    const auto corners = corners_of_disc(level.planes[shadow.floor.plane], shadow.floor.position, radius);
    if (!project_polygon(corners, view, scratch.polygon)) return false;
    scan_convex(scratch.polygon.vertices, scratch.rows);
    return true;
}

void darken_spans(std::span<const Span> spans, const ScanlineExtents& rows, const std::uint8_t* shade,
                  Framebuffer out) {
    for (const Span& span : spans) {
        if (span.y < rows.first || span.y >= rows.end) continue;
        const std::int32_t first = std::max(span.first, item(rows.left, span.y));
        const std::int32_t end = std::min(span.end, item(rows.right, span.y));
        std::uint8_t* const row = out.row(span.y);
        for (std::int32_t x = first; x < end; ++x) row[x] = shade[row[x]];
    }
}

}  // namespace oblong
