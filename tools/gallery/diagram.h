#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "engine/draw/drawing.h"
#include "tools/gallery/row.h"

namespace oblong {

/// A point of a diagram's plane: x right, y up.
struct PlanePoint {
    double x = 0, y = 0;

    constexpr PlanePoint operator+(PlanePoint other) const { return {x + other.x, y + other.y}; }
    constexpr PlanePoint operator*(double factor) const { return {x * factor, y * factor}; }
};

/// Draws in a plane with equal units along both axes on the mode's display, so that circles are round. Clipped to the
/// canvas.
class Diagram {
  public:
    /// `centre` is in the middle of the canvas between the gallery's header and footer, which are `units_high` apart.
    Diagram(const RowInput& input, Framebuffer canvas, PlanePoint centre, double units_high);

    void fill(std::uint8_t colour);  ///< the whole canvas
    void line(PlanePoint from, PlanePoint to, std::uint8_t colour);
    /// Lines from at(0) to at(1) and on to at(parts).
    template <class At>
    void curve(int parts, const At& at, std::uint8_t colour) {
        for (int i = 0; i < parts; ++i) line(at(i), at(i + 1), colour);
    }
    /// Lines between corners; the last one leads back.
    void outline(std::span<const PlanePoint> corners, std::uint8_t colour) {
        curve(
            static_cast<int>(corners.size()), [&](int i) { return corners[as_size(i) % corners.size()]; }, colour);
    }
    void arrow(PlanePoint from, PlanePoint to, std::uint8_t colour);
    void circle(PlanePoint centre, double radius, std::uint8_t colour);
    void disc(PlanePoint centre, double radius, std::uint8_t colour);
    void rectangle(PlanePoint lowest, PlanePoint highest, std::uint8_t colour);
    void outline(PlanePoint lowest, PlanePoint highest, std::uint8_t colour) {
        outline(std::array{lowest, PlanePoint{highest.x, lowest.y}, highest, PlanePoint{lowest.x, highest.y}}, colour);
    }
    /// Text whose upper left corner is `right_px` right of and `below_px` below the point.
    void text(PlanePoint at, std::string_view line, std::uint8_t colour, std::int32_t right_px = 3,
              std::int32_t below_px = -4);

    /// The canvas's column and row of a point, with fractions.
    PlanePoint on_canvas(PlanePoint at) const;

  private:
    Framebuffer canvas_;
    TextColours text_;
    PlanePoint centre_, middle_px_;
    double px_per_unit_x_, px_per_unit_y_;
};

/// A small picture whose pixels are shown as blocks, square on the mode's display.
class PixelGrid {
  public:
    /// In the middle of the area `place`, as large as fits.
    PixelGrid(const RowInput& input, Framebuffer canvas, const Area& place, std::int32_t columns, std::int32_t rows,
              std::uint8_t background);

    Framebuffer picture() { return {pixels_.data(), columns_, rows_, columns_}; }
    /// Draws the blocks, with a line of `gap` between them.
    void show(std::uint8_t gap);
    /// A line over the blocks between two points of the picture: x right, y down, pixel centres at +0.5.
    void line(PlanePoint from, PlanePoint to, std::uint8_t colour) const;
    /// A dot over the blocks.
    void dot(PlanePoint at, std::uint8_t colour) const;
    const Area& area() const { return area_; }  ///< covered by the blocks

  private:
    PixelPosition on_canvas(PlanePoint at) const;

    Framebuffer canvas_;
    std::int32_t columns_, rows_, block_width_ = 1, block_height_ = 1;
    Area area_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace oblong
