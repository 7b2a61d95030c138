#pragma once

#include <cstdint>
#include <span>

#include "engine/level/trace.h"
#include "engine/raster/scan.h"
#include "engine/view/screen.h"
#include "engine/view/screen_polygon.h"

namespace oblong {

/// The largest distance of the floor below the middle of what casts a shadow.
inline constexpr World kFarthestShadow = World::from_int(128);

/// A round shadow straight below something. It shrinks with the distance, to a point at kFarthestShadow.
struct Shadow {
    Floor floor;
    World radius;  ///< on the floor; 0 to 4,096
};
/// `radius` is that of a shadow at distance 0.
Shadow make_shadow(const Floor& floor, const Vec3<World>& middle, World radius);

/// Scratch of the shadow pass.
struct ShadowScratch {
    ScreenPolygon polygon;
    ScanlineExtents rows;

    explicit ShadowScratch(std::int32_t height_px) : rows(height_px) {}
};

/// Scans a shadow, a polygon of 16 corners, into scratch.rows, hidden or not. False if it is out of view. `share_8`
/// scales its radius; 256 is 1.
bool scan_shadow(const Shadow& shadow, std::int32_t share_8, const Level& level, const ViewContext& view,
                 ShadowScratch& scratch);

/// Replaces colours by `shade[colour]` where the spans overlap the scanned pixels. `spans` are of the faces on the
/// floor's plane, so no depth is needed.
void darken_spans(std::span<const Span> spans, const ScanlineExtents& rows, const std::uint8_t* shade, Framebuffer out);

}  // namespace oblong
