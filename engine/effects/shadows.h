#pragma once

#include <cstdint>
#include <span>

#include "engine/level/floor.h"
#include "engine/raster/scan.h"
#include "engine/view/screen.h"
#include "engine/view/screen_polygon.h"

namespace oblong {

/// The farthest floor that a shadow falls on, below the middle of what throws it.
inline constexpr World kFarthestShadow = World::from_int(128);

/// A round shadow straight below something. It becomes smaller with the distance, and is a point at kFarthestShadow.
struct Shadow {
    Floor floor;
    World radius;  ///< on the floor; 0 to 4,096
};
/// `radius` is that of a shadow right below `middle`.
Shadow make_shadow(const Floor& floor, const Vec3<World>& middle, World radius);

/// Scratch of the shadow pass.
struct ShadowScratch {
    ScreenPolygon polygon;
    ScanlineExtents rows;

    explicit ShadowScratch(std::int32_t height_px) : rows(height_px) {}
};

/// Finds the pixels of a shadow, in scratch.rows: as a polygon of 16 corners, as if nothing hid it. False if nothing of
/// it is in view. `share_8` scales its radius, 256: all of it.
bool scan_shadow(const Shadow& shadow, std::int32_t share_8, const Level& level, const ViewContext& view,
                 ShadowScratch& scratch);

/// Replaces colours by `shade[colour]` where spans cover the scanned pixels: those of the faces on the floor's plane,
/// so that no depth is needed.
void darken_spans(std::span<const Span> spans, const ScanlineExtents& rows, const std::uint8_t* shade, Framebuffer out);

}  // namespace oblong
