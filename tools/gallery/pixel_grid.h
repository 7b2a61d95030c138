#pragma once

#include <vector>

#include "engine/draw/drawing.h"
#include "tools/gallery/diagram.h"

namespace oblong {

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
