#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/math/matrix.h"
#include "engine/raster/scan.h"
#include "engine/view/screen_polygon.h"
#include "engine/view/view_context.h"
#include "engine/view/views.h"
#include "tools/gallery/canvas.h"

namespace oblong {

/// The mode of a part of a picture, with pixels of the same shape.
inline ScreenMode mode_of_part(const ScreenMode& mode, Framebuffer part) {
    return {part.width_px, part.height_px, mode.pixel() * Ratio{part.width_px, part.height_px}};
}

/// The view of a sketch.
struct SketchEye {
    Vec eye, target;
    int field_of_view = 60;
};

/// Lines and polygons in space, by the engine's stages: view matrix, canonical volume, six planes, perspective divide,
/// scan converter. Without hidden surfaces: later drawing is in front.
class Sketch : public Canvas {
  public:
    /// The picture fills an area of the canvas, in the pixels' right shape.
    Sketch(const Canvas& canvas, const Area& area, const SketchEye& from);

    const ViewContext& view() const { return view_; }
    /// World to the canonical volume.
    const Matrix4& world_to_volume() const { return world_to_volume_; }

    void line(const DrawnPoint& from, const DrawnPoint& to, Rgb8 colour) override;
    template <class Points>
    void polygon(const Points& corners, Rgb8 colour) {
        fill_polygon({std::begin(corners), std::end(corners)}, colour);
    }
    /// Lines from the world's origin to the ends of three axes, x, y and z.
    void axes(const std::array<DrawnPoint, 3>& ends);
    /// A line of text beside a point, if that is in view.
    void label(const DrawnPoint& at, std::string_view text, Rgb8 colour);
    /// A point's position in the area, in pixels; (-1, -1) outside of the view.
    Vec pixel_of(const Vec& point) const override;

  private:
    std::vector<ScreenVertex> clipped(std::span<const DrawnPoint> corners) const;
    void fill_polygon(const std::vector<DrawnPoint>& corners, Rgb8 colour);

    ViewContext view_;
    Matrix4 world_to_volume_;
};

/// The engine's column and row of a point, with fractions.
Vec shown(const Vec& place, const ViewContext& view);
/// The columns between two points.
double across(const Vec& from, const Vec& to, const ViewContext& view);

/// A cube's corner: bit 0 of its number is x, bit 1 y, bit 2 z.
struct Cube {
    Vec low;
    double size = 100;

    Vec corner(int number) const {
        return {low.x + (number & 1 ? size : 0), low.y + (number & 2 ? size : 0), low.z + (number & 4 ? size : 0)};
    }
};

/// The lab's window of `size` in a plane at (0.5, 0.5, -2), with a COP `distance` before it, moved by `moved`; its cube
/// has its low corner at 0 and sides of 1.
WindowView lab_window(double distance, double size, double moved = 0);

/// Draws a cube's twelve edges; place_of(number) is where a corner is.
template <class PlaceOf>
void draw_edges(Canvas& canvas, const PlaceOf& place_of, Rgb8 colour) {
    for (int corner = 0; corner < 8; ++corner)
        for (const int axis : {1, 2, 4})
            if ((corner & axis) == 0) canvas.line(place_of(corner), place_of(corner | axis), colour);
}

/// Lines and polygons of the world as the engine projects them in any view.
class WireScene : public Canvas {
  public:
    WireScene(const Canvas& canvas, const ViewSpec& spec);

    const ViewContext& view() const { return view_; }

    /// Draws a polygon if it is seen from its front, clockwise; returns whether it was drawn.
    bool polygon(std::span<const Vec> corners, Rgb8 colour);
    /// A cube's faces with a circle in each, then its edges; those behind are dim.
    void cube(const Cube& cube);
    /// Three lines of a length along x, y and z, with their names.
    void axes(const Vec& origin, double length);

    Vec pixel_of(const Vec& point) const override { return shown(point, view_); }

  private:
    ScreenPolygon polygon_;
    ScanlineExtents rows_;
    ViewContext view_;
};

/// The middle of the demo level.
Vec3<World> middle_of_demo_level();

/// A camera in the demo level: whole world units, whole degrees (pitch positive looks down).
Camera camera_at(std::int32_t x, std::int32_t y, std::int32_t z, std::int64_t yaw, std::int64_t pitch,
                 int field_of_view = 90);

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
