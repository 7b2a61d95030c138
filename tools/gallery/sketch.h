#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "engine/draw/drawing.h"
#include "engine/math/matrix.h"
#include "engine/view/view_context.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/row.h"

namespace oblong {

/// Where a sketch is seen from.
struct SketchEye {
    Vec3<World> eye, target;
    int field_of_view = 60;
};

/// Lines and polygons in space, by the engine's stages: view matrix, canonical volume, six planes, perspective divide,
/// scan converter. Nothing is hidden: what is drawn last is in front.
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
    /// A line of text beside a point.
    void label(const Vec3<World>& at, std::string_view text, std::uint8_t colour);
    /// Where a point is in the area, pixels; none outside of the view.
    std::optional<PlanePoint> place_of(const Vec3<World>& point) const;

  private:
    std::vector<ScreenVertex> clipped(std::span<const Vec3<World>> corners) const;

    Framebuffer part_;
    TextColours text_;
    ViewContext view_;
    Matrix4 world_to_volume_;
};

/// The canvas between the gallery's header and footer, its left part `width` of 320 wide; and what is right of it.
Area scene_area(Framebuffer canvas, std::int32_t width_of_320 = 320);

/// Lines of text from a place down to the gallery's footer; where there is no room for all, the last one says how many
/// more there are.
void draw_column(Framebuffer canvas, std::int32_t x, std::int32_t y, std::span<const std::string> lines,
                 TextColours colours);

}  // namespace oblong
