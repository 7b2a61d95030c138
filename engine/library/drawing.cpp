#include "engine/draw/drawing.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/fixed/root.h"
#include "engine/fixed/trig.h"
#include "engine/library/conversions.h"
#include "engine/library/oblong.h"
#include "engine/raster/lines.h"
#include "engine/raster/scan.h"

namespace oblong {
namespace {

bool is_in(Framebuffer canvas, std::int64_t x, std::int64_t y) {
    return x >= 0 && y >= 0 && x < canvas.width_px && y < canvas.height_px;
}

// Without the part that is so far off the canvas that sums would not fit.
Area area_of(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height) {
    const auto bounded = [](std::int64_t at) {
        constexpr std::int64_t kFarthest = 1 << 28;
        return static_cast<std::int32_t>(std::clamp(at, -kFarthest, kFarthest));
    };
    const std::int32_t left = bounded(x), top = bounded(y);
    return {left, top, bounded(std::int64_t{x} + std::max(width, 0)) - left,
            bounded(std::int64_t{y} + std::max(height, 0)) - top};
}

/// A circle on the display, half a pixel larger so that its extreme sides look round, too: (across x)^2 + (down y)^2 =
/// (across (radius + 1/2))^2, x in columns, y in rows.
struct Circle {
    Circle(const ScreenMode& mode, std::int32_t radius_px) {
        const Ratio pixel = checked(mode).pixel();
        across = pixel.numerator;
        down = pixel.denominator;
        for (; std::max(across, down) > 65'536; across /= 2, down /= 2) {
        }
        across = std::max(across, std::int64_t{1});
        down = std::max(down, std::int64_t{1});
        doubled_radius = across * (2 * std::clamp(radius_px, 0, 2 * kLargestMode_px) + 1);
    }
    std::int32_t height() const { return static_cast<std::int32_t>(doubled_radius / (2 * down)); }
    /// Columns on each side of the middle one that are inside; -1 above the top.
    std::int32_t half_width(std::int64_t rows) const {
        const std::int64_t at = 2 * down * rows, rest = doubled_radius * doubled_radius - at * at;
        if (rest < 0) return -1;
        return static_cast<std::int32_t>(integer_root(static_cast<std::uint64_t>(rest)) / (2 * across));
    }

    std::int64_t across = 1, down = 1, doubled_radius = 1;
};

std::uint8_t as_index(std::int32_t colour) {
    return static_cast<std::uint8_t>(colour);
}

void fill_row(Framebuffer canvas, std::int64_t first, std::int64_t last, std::int64_t y, std::int32_t colour) {
    if (y < 0 || y >= canvas.height_px) return;
    first = std::max(first, std::int64_t{0});
    last = std::min(last, std::int64_t{canvas.width_px} - 1);
    if (first <= last)
        std::fill_n(canvas.row(static_cast<std::int32_t>(y)) + first, last - first + 1, as_index(colour));
}

// The middle of a pixel in 24.8, clamped to 2^20 pixels.
ScreenVertex middle_of_pixel(PixelPosition pixel) {
    const auto middle = [](std::int32_t at) {
        return Screen::from_raw(std::clamp(at, -(1 << 20), 1 << 20) * 256 + 128);
    };
    return {middle(pixel.column), middle(pixel.row)};
}

}  // namespace

void clear(Framebuffer canvas, std::int32_t colour) {
    fill_area(canvas, {0, 0, canvas.width_px, canvas.height_px}, as_index(colour));
}

void set_pixel(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t colour) {
    if (is_in(canvas, x, y)) canvas.row(y)[x] = as_index(colour);
}

std::uint8_t pixel_at(Framebuffer canvas, std::int32_t x, std::int32_t y) {
    return is_in(canvas, x, y) ? canvas.row(y)[x] : std::uint8_t{0};
}

void draw_line(Framebuffer canvas, std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
               std::int32_t colour) {
    draw_line(PixelPosition{x0, y0}, PixelPosition{x1, y1}, LineStyle{LineMethod::Bresenham, as_index(colour), nullptr},
              canvas);
}

void fill_rectangle(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
                    std::int32_t colour) {
    fill_area(canvas, area_of(x, y, width, height), as_index(colour));
}

void draw_rectangle(Framebuffer canvas, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
                    std::int32_t colour) {
    draw_border(canvas, area_of(x, y, width, height), as_index(colour));
}

void fill_circle(Framebuffer canvas, const ScreenMode& mode, std::int32_t x, std::int32_t y, std::int32_t radius_px,
                 std::int32_t colour) {
    const Circle circle(mode, radius_px);
    const std::int64_t height = circle.height();
    for (std::int64_t row = std::max(y - height, std::int64_t{0}); row <= y + height && row < canvas.height_px; ++row) {
        const std::int64_t half = circle.half_width(row - y);
        fill_row(canvas, x - half, x + half, row, colour);
    }
}

void draw_circle(Framebuffer canvas, const ScreenMode& mode, std::int32_t x, std::int32_t y, std::int32_t radius_px,
                 std::int32_t colour) {
    const Circle circle(mode, radius_px);
    const std::int64_t height = circle.height();
    for (std::int64_t row = std::max(y - height, std::int64_t{0}); row <= y + height && row < canvas.height_px; ++row) {
        // Inwards to where the next row begins, so that the line has no gap.
        const std::int64_t rows = std::abs(row - y), outer = circle.half_width(rows),
                           inner = std::min<std::int64_t>(outer, circle.half_width(rows + 1) + 1);
        fill_row(canvas, x - outer, x - inner, row, colour);
        fill_row(canvas, x + inner, x + outer, row, colour);
    }
}

void fill_triangle(Framebuffer canvas, PixelPosition a, PixelPosition b, PixelPosition c, std::int32_t colour) {
    std::array<ScreenVertex, 3> corners{middle_of_pixel(a), middle_of_pixel(b), middle_of_pixel(c)};
    if (doubled_area(corners) < ScreenArea{}) std::swap(corners[1], corners[2]);
    ScanlineExtents rows(canvas.height_px);
    scan_convex(corners, rows);
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        fill_row(canvas, item(rows.left, y), std::int64_t{item(rows.right, y)} - 1, y, colour);
}

void draw_picture(Framebuffer canvas, const Picture& picture, std::int32_t x, std::int32_t y) {
    draw_part(canvas, picture, {0, 0, picture.width_px, picture.height_px}, x, y);
}

namespace {

/// The way through a picture's rows or columns from one canvas pixel to the next, without a division for each.
class PartSteps {
  public:
    /// `beside`: of the first canvas pixel, from the part's corner.
    PartSteps(std::int64_t beside, std::int32_t first, std::int32_t side_px, bool is_backwards, std::int32_t scale)
        : at_(is_backwards ? std::int64_t{first} + side_px - 1 - beside / scale : first + beside / scale),
          step_(is_backwards ? -1 : 1),
          left_(scale - static_cast<std::int32_t>(beside % scale)),
          scale_(scale) {}

    std::int64_t at() const { return at_; }
    void advance() {
        if (--left_ > 0) return;
        left_ = scale_;
        at_ += step_;
    }

  private:
    std::int64_t at_;
    std::int32_t step_, left_, scale_;
};

}  // namespace

void draw_part(Framebuffer canvas, const Picture& picture, const PicturePart& part, std::int32_t x, std::int32_t y) {
    checked(picture);
    const std::int32_t scale = std::clamp(part.scale, 1, kLargestMode_px);
    const auto scaled = [&](std::int32_t side_px) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(std::int64_t{side_px} * scale, 0, 1 << 28));
    };
    const Area shown = clipped(area_of(x, y, scaled(part.width_px), scaled(part.height_px)), canvas);
    if (shown.width <= 0 || shown.height <= 0) return;
    PartSteps v(std::int64_t{shown.y} - y, part.y, part.height_px, part.is_upside_down, scale);
    for (std::int32_t row = shown.y; row < shown.y + shown.height; ++row, v.advance()) {
        if (v.at() < 0 || v.at() >= picture.height_px) continue;
        const std::uint8_t* const from = picture.pixels.data() + v.at() * picture.width_px;
        std::uint8_t* to = canvas.row(row) + shown.x;
        PartSteps u(std::int64_t{shown.x} - x, part.x, part.width_px, part.is_mirrored, scale);
        for (std::int32_t i = 0; i < shown.width; ++i, ++to, u.advance()) {
            if (u.at() < 0 || u.at() >= picture.width_px) continue;
            if (part.is_opaque || from[u.at()] != kTransparent) *to = from[u.at()];
        }
    }
}

void draw_turned(Framebuffer canvas, const Picture& picture, std::int32_t x, std::int32_t y, std::int32_t degrees_256,
                 std::int32_t scale_256) {
    checked(picture);
    if (scale_256 < 1) return;
    // Of the picture, for each column and each row of the canvas, 16 fraction bits.
    const std::int64_t sine = std::int64_t{sine_65536(degrees_256)} * 256 / scale_256,
                       cosine = std::int64_t{sine_65536(std::int64_t{degrees_256} + 90 * 256)} * 256 / scale_256;
    // No corner is farther from the middle than half the width plus half the height.
    const std::int64_t reach = (std::int64_t{picture.width_px} + picture.height_px) * scale_256 / 512 + 1;
    const auto from = [&](std::int32_t middle) { return std::max<std::int64_t>(middle - reach, 0); };
    const auto to = [&](std::int32_t middle, std::int32_t end) { return std::min<std::int64_t>(middle + reach, end); };
    for (std::int64_t row = from(y); row < to(y, canvas.height_px); ++row)
        for (std::int64_t column = from(x); column < to(x, canvas.width_px); ++column) {
            const std::int64_t right = column - x, down = row - y;
            const std::int64_t u = (right * cosine - down * sine + picture.width_px * std::int64_t{32'768}) >> 16,
                               v = (right * sine + down * cosine + picture.height_px * std::int64_t{32'768}) >> 16;
            if (u < 0 || v < 0 || u >= picture.width_px || v >= picture.height_px) continue;
            const std::uint8_t colour = item(picture.pixels, v * picture.width_px + u);
            if (colour != kTransparent) canvas.row(static_cast<std::int32_t>(row))[column] = colour;
        }
}

void draw_label(Framebuffer canvas, std::int32_t x, std::int32_t y, std::string_view text, std::int32_t colour,
                std::int32_t scale) {
    scale = std::clamp(scale, 1, 256);
    for_each_dot(text, [&](std::int64_t column, std::int64_t row) {
        const std::int64_t left = x + column * scale;
        for (int line = 0; line < scale; ++line)
            fill_row(canvas, left, left + scale - 1, y + row * scale + line, colour);
    });
}

std::vector<std::string> wrapped(std::string_view text, std::int32_t width_px) {
    const std::vector<std::string_view> lines = lines_of(text, width_px);
    return {lines.begin(), lines.end()};
}

}  // namespace oblong
