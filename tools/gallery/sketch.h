#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/draw/drawing.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/math/matrix.h"
#include "engine/raster/scan.h"
#include "engine/view/screen_polygon.h"
#include "engine/view/view_context.h"
#include "engine/view/views.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/row.h"

namespace oblong {

/// The mode of a part of a picture, with pixels of the same shape.
inline ScreenMode mode_of_part(const ScreenMode& mode, Framebuffer part) {
    return {part.width_px, part.height_px, mode.pixel() * Ratio{part.width_px, part.height_px}};
}

/// The view of a sketch.
struct SketchEye {
    Vec3<World> eye, target;
    int field_of_view = 60;
};

/// Lines and polygons in space, by the engine's stages: view matrix, canonical volume, six planes, perspective divide,
/// scan converter. Without hidden surfaces: later drawing is in front.
class Sketch {
  public:
    /// The picture fills an area of the canvas, in the pixels' right shape.
    Sketch(const RowInput& input, Framebuffer canvas, const Area& area, const SketchEye& from);

    const ViewContext& view() const { return view_; }
    /// World to the canonical volume.
    const Matrix4& world_to_volume() const { return world_to_volume_; }

    void line(const Vec3<World>& from, const Vec3<World>& to, std::uint8_t colour);
    void outline(std::span<const Vec3<World>> corners, std::uint8_t colour);
    void polygon(std::span<const Vec3<World>> corners, std::uint8_t colour);
    /// Lines from the world's origin to the ends of three axes, x, y and z.
    void axes(const std::array<Vec3<World>, 3>& ends, const GalleryAssets& assets);
    /// A line of text beside a point.
    void label(const Vec3<World>& at, std::string_view text, std::uint8_t colour);
    /// A point's position in the area, in pixels; none outside of the view.
    std::optional<PlanePoint> place_of(const Vec3<World>& point) const;

  private:
    std::vector<ScreenVertex> clipped(std::span<const Vec3<World>> corners) const;

    Framebuffer part_;
    TextColours text_;
    ViewContext view_;
    Matrix4 world_to_volume_;
};

/// The canvas between the gallery's header and footer, its left `width_of_320` / 320.
Area scene_area(Framebuffer canvas, std::int32_t width_of_320 = 320);

/// Lines of text down to the gallery's footer; if they do not fit, the last one says how many are left out.
void draw_column(Framebuffer canvas, std::int32_t x, std::int32_t y, std::span<const std::string> lines,
                 TextColours colours);

/// Lines of text on a dark ground in the scene's upper left corner; nothing in narrow canvases.
void draw_note(Framebuffer canvas, std::span<const std::string> lines, TextColours colours);

/// The engine's column and row of a point, with fractions.
PlanePoint shown(const Vec& place, const ViewContext& view);
/// The columns between two points.
double across(const Vec& from, const Vec& to, const ViewContext& view);

/// Lines and polygons of the world as the engine projects them in any view.
class WireScene {
  public:
    WireScene(const RowInput& input, const ViewSpec& spec, Framebuffer canvas);

    const ViewContext& view() const { return view_; }

    void fill_background();
    void line(const Vec& from, const Vec& to, std::uint8_t colour);
    void line(const PlanePoint& from, const PlanePoint& to, std::uint8_t colour);
    /// Draws a polygon if it is seen from its front, clockwise; returns whether it was drawn.
    bool polygon(std::span<const Vec> corners, std::uint8_t colour);
    void circle(const Vec& middle, const Vec& one, const Vec& other, std::uint8_t colour);
    void label(const Vec& place, std::string_view text);

  private:
    const GalleryAssets& assets_;
    Framebuffer canvas_;
    ScreenPolygon polygon_;
    ScanlineExtents rows_;
    ViewContext view_;
};

/// A cube's corner: bit 0 of its number is x, bit 1 y, bit 2 z.
struct Cube {
    Vec low;
    double size = 100;

    Vec corner(int number) const {
        return {low.x + (number & 1 ? size : 0), low.y + (number & 2 ? size : 0), low.z + (number & 4 ? size : 0)};
    }
};

/// The cube's faces with a circle in each, then its edges; those behind are dim.
void draw_cube(const Cube& cube, const GalleryAssets& assets, WireScene& scene);
/// Three lines of a length along x, y and z, with their names.
void draw_axes(const Vec& origin, double length, const GalleryAssets& assets, WireScene& scene);

/// The middle of the demo level.
Vec3<World> middle_of_demo_level();

/// A camera in the demo level: whole world units, whole degrees (pitch positive looks down).
Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, int yaw, int pitch, int field_of_view = 90);

/// Enlarges a picture of another mode to the whole canvas.
void enlarge(std::span<const std::uint8_t> pixels, const ScreenMode& mode, Framebuffer canvas);

/// The demo level at the input's time, drawn into canvases of the mode's size.
struct DemoFrame {
    DemoFrame(const RowInput& input, const ScreenMode& mode);
    DemoFrame(const DemoFrame&) = delete;

    void draw(const ViewSpec& view, Framebuffer canvas);
    void draw(const Camera& camera, Framebuffer canvas);

    const Settings& settings;
    ScreenMode mode;
    std::vector<PlacedModel> models;
    Scene scene;
    FrameWorkspace work;
};

}  // namespace oblong
