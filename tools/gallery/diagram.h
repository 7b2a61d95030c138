#pragma once

#include <string_view>
#include <vector>

#include "engine/draw/drawing.h"
#include "tools/gallery/row.h"

namespace oblong {

/// A place of a diagram's plane: x right, y up.
struct PlanePoint {
    double x = 0, y = 0;

    constexpr PlanePoint operator+(PlanePoint other) const { return {x + other.x, y + other.y}; }
    constexpr PlanePoint operator*(double factor) const { return {x * factor, y * factor}; }
};

/// Draws in a plane whose unit is as long across as it is down on the mode's display, so that circles are round there.
/// What lies outside the canvas is cut.
class Diagram {
  public:
    /// `centre` is shown in the middle of the canvas between the gallery's header and footer, and `units_high` of the
    /// plane fit there.
    Diagram(const RowInput& input, Framebuffer canvas, PlanePoint centre, double units_high);

    void fill(std::uint8_t colour);  ///< the whole canvas
    void line(PlanePoint from, PlanePoint to, std::uint8_t colour);
    void arrow(PlanePoint from, PlanePoint to, std::uint8_t colour);
    void circle(PlanePoint centre, double radius, std::uint8_t colour);
    void disc(PlanePoint centre, double radius, std::uint8_t colour);
    void rectangle(PlanePoint lowest, PlanePoint highest, std::uint8_t colour);
    void outline(PlanePoint lowest, PlanePoint highest, std::uint8_t colour);
    /// Text whose first line's upper left corner is so many pixels right of and below the place.
    void text(PlanePoint at, std::string_view line, std::uint8_t colour, std::int32_t right_px = 3,
              std::int32_t below_px = -4);

    /// The canvas's column and row of a place, fractions included.
    PlanePoint on_canvas(PlanePoint at) const;
    double units_wide() const;  ///< that fit between the canvas's sides

  private:
    Framebuffer canvas_;
    TextColours text_;
    PlanePoint centre_, middle_px_;
    double px_per_unit_x_, px_per_unit_y_;
};

/// A small picture whose pixels are shown as blocks, square on the mode's display.
class PixelGrid {
  public:
    /// In the middle of `place` of the canvas, as large as it fits there.
    PixelGrid(const RowInput& input, Framebuffer canvas, const Area& place, std::int32_t columns, std::int32_t rows,
              std::uint8_t background);

    Framebuffer picture() { return {pixels_.data(), columns_, rows_, columns_}; }
    /// Draws the blocks, with a line of `gap` between them.
    void show(std::uint8_t gap);
    /// A line over the blocks between two places of the picture: x right, y down, pixel centres at +0.5.
    void line(PlanePoint from, PlanePoint to, std::uint8_t colour) const;
    /// A dot over the blocks.
    void dot(PlanePoint at, std::uint8_t colour) const;
    const Area& area() const { return area_; }  ///< that the blocks cover

  private:
    PixelPosition on_canvas(PlanePoint at) const;

    Framebuffer canvas_;
    std::int32_t columns_, rows_, block_width_ = 1, block_height_ = 1;
    Area area_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace oblong
