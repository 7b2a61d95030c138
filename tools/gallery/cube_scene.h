#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/raster/scan.h"
#include "engine/view/screen_polygon.h"
#include "engine/view/view_spec.h"
#include "tools/gallery/row.h"

namespace oblong {

/// A place in the world, units.
struct Place {
    double x = 0, y = 0, z = 0;
};
Vec3<World> in_world(const Place& place);

/// A place on the screen: column and row, fractions included.
struct PixelPlace {
    double x, y;
};
/// Where the engine shows a place, pixels.
PixelPlace shown(const Place& place, const ViewContext& view);
/// The columns between two places.
double across(const Place& from, const Place& to, const ViewContext& view);

/// Lines and polygons of the world as the engine projects them in any view.
class WireScene {
  public:
    WireScene(const RowInput& input, const ViewSpec& spec, Framebuffer canvas);

    const ViewContext& view() const { return view_; }

    void fill_background();
    void line(const Place& from, const Place& to, std::uint8_t colour);
    void line(const PixelPlace& from, const PixelPlace& to, std::uint8_t colour);
    /// A polygon seen from its front, clockwise: all of it, or nothing from behind. Whether it was drawn.
    bool polygon(std::span<const Place> corners, std::uint8_t colour);
    void circle(const Place& middle, const Place& one, const Place& other, std::uint8_t colour);
    void label(const Place& place, std::string_view text);

  private:
    const GalleryAssets& assets_;
    Framebuffer canvas_;
    ScreenPolygon polygon_;
    ScanlineExtents rows_;
    ViewContext view_;
};

/// A cube's corner: bit 0 of its number is x, bit 1 y, bit 2 z.
struct Cube {
    Place low;
    double size = 100;

    Place corner(int number) const {
        return {low.x + (number & 1 ? size : 0), low.y + (number & 2 ? size : 0), low.z + (number & 4 ? size : 0)};
    }
};

/// The cube's faces with a circle in each, then its edges; those behind are dim.
void draw_cube(const Cube& cube, const GalleryAssets& assets, WireScene& scene);
/// Three lines of a length along x, y and z, with their names.
void draw_axes(const Place& origin, double length, const GalleryAssets& assets, WireScene& scene);

/// The middle of the demo level.
Vec3<World> middle_of_demo_level();

/// A camera in the demo level: whole world units, whole degrees (pitch positive looks down).
Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, int yaw, int pitch, int field_of_view = 90);

/// Draws the demo level in a view as it stands at the input's time, into a canvas of the input's mode.
void draw_demo_level(const RowInput& input, const ViewSpec& view, Framebuffer canvas);

/// Draws the demo level as it stands at the input's time, into a canvas of the mode's size.
void draw_demo_level(const RowInput& input, const Camera& camera, const ScreenMode& mode, Framebuffer canvas);

}  // namespace oblong
