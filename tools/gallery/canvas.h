#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/draw/drawing.h"
#include "tools/gallery/row.h"

namespace oblong {

/// The rows' colours; a canvas shows the palette's nearest ones.
inline constexpr Rgb8 kBlack{0, 0, 0}, kNight{16, 18, 28}, kGround{20, 24, 36}, kSlate{30, 36, 52}, kShadow{44, 54, 76},
    kDusk{52, 62, 88}, kSteel{70, 80, 104}, kDim{80, 88, 110}, kFaint{90, 98, 124}, kGrey{110, 118, 140},
    kPale{150, 160, 180}, kBone{220, 220, 210}, kWhite{235, 235, 225}, kBright{255, 255, 255}, kCream{240, 230, 200},
    kGold{250, 225, 150}, kLemon{250, 230, 120}, kYellow{240, 220, 90}, kOrange{240, 190, 90}, kAmber{220, 150, 60},
    kRust{200, 120, 48}, kRed{220, 80, 70}, kScarlet{220, 60, 50}, kMauve{220, 120, 220}, kBlue{90, 130, 220},
    kSky{110, 160, 230}, kGreen{110, 220, 120}, kLeaf{90, 170, 80};

/// A point where something is drawn: of a plane (x right, y up), of the world, or another of a canvas's own.
struct DrawnPoint : Vec {
    constexpr DrawnPoint(double px, double py, double pz = 0) : Vec{px, py, pz} {}
    constexpr DrawnPoint(const Vec& point) : Vec(point) {}
    template <class Int, int Frac>
    DrawnPoint(const Vec3<Fixed<Int, Frac>>& point) : Vec(vec_of(point)) {}
};

/// The pixels that a row draws, with the row's input. Points are columns and rows with fractions, or what a derived
/// canvas projects. Later drawing is in front; what is outside is cut off.
class Canvas : public Framebuffer {
  public:
    Canvas(const RowInput& row_input, Framebuffer pixels_of) : Framebuffer(pixels_of), input(row_input) {}
    virtual ~Canvas() = default;

    Canvas part(const Area& area) const { return {input, part_of(*this, area)}; }
    /// The area between the gallery's header and footer, its left `width_of_320` / 320.
    Area scene(std::int32_t width_of_320 = 320) const;

    void fill(Rgb8 colour) { box({0, 0, width_px, height_px}, colour); }
    void box(const Area& area, Rgb8 colour) { fill_area(*this, area, input.colour(colour)); }
    /// Each pixel has the colour that colour_at(column, row) gives, by its index.
    template <class ColourAt>
    void paint(const ColourAt& colour_at) {
        for (std::int32_t y = 0; y < height_px; ++y)
            for (std::int32_t x = 0; x < width_px; ++x) row(y)[x] = colour_at(x, y);
    }
    /// Enlarges a picture of another size to the whole canvas.
    void enlarge(Framebuffer picture);

    /// A line of text with its upper left corner at a pixel.
    void write(std::int32_t x, std::int32_t y, std::string_view line, Rgb8 colour = kBright);
    /// Lines of text from `below_px` below the gallery's header down to its footer; if they do not fit, the last one
    /// says how many are left out.
    void column(std::int32_t x, std::int32_t below_px, std::span<const std::string> lines);
    /// Lines of text on a dark ground in the upper left corner; nothing in narrow canvases.
    void note(std::span<const std::string> lines);

    /// The column and row of a point.
    virtual Vec pixel_of(const Vec& point) const { return point; }
    virtual void line(const DrawnPoint& from, const DrawnPoint& to, Rgb8 colour);
    /// Lines from at(0) to at(1) and on to at(parts).
    template <class At>
    void curve(int parts, const At& at, Rgb8 colour) {
        for (int i = 0; i < parts; ++i) line(at(i), at(i + 1), colour);
    }
    /// Lines between corners; the last one leads back.
    template <class Points>
    void outline(const Points& corners, Rgb8 colour) {
        const auto count = static_cast<int>(std::size(corners));
        curve(
            count, [&](int i) { return DrawnPoint(item(corners, i % count)); }, colour);
    }
    /// An ellipse around a middle, through middle + one and middle + other.
    void ellipse(const Vec& middle, const Vec& one, const Vec& other, int parts, Rgb8 colour);
    /// Three pixels a side.
    void dot(const DrawnPoint& at, Rgb8 colour);
    /// Text whose upper left corner is `right_px` right of and `below_px` below the point.
    void label(const DrawnPoint& at, std::string_view line, Rgb8 colour, std::int32_t right_px = 3,
               std::int32_t below_px = -4);

    const RowInput& input;
};

/// A picture beside the canvas.
struct SidePicture : Framebuffer {
    SidePicture(std::int32_t wide, std::int32_t high, std::uint8_t colour = 0)
        : Framebuffer{nullptr, wide, high, wide}, indices(pixel_count(wide, high), colour) {
        pixels = indices.data();
    }
    SidePicture(const SidePicture&) = delete;

    /// The colour at a place, 0 outside.
    std::uint8_t at(const Vec& place) const {
        const bool is_inside = place.x >= 0 && place.x < width_px && place.y >= 0 && place.y < height_px;
        return is_inside ? row(static_cast<std::int32_t>(place.y))[static_cast<std::int32_t>(place.x)] : std::uint8_t{};
    }

    std::vector<std::uint8_t> indices;
};

/// The corners of a rectangle in a plane.
constexpr std::array<Vec, 4> box_of(const Vec& lowest, const Vec& highest) {
    return {lowest, {highest.x, lowest.y}, highest, {lowest.x, highest.y}};
}

/// Draws in a plane with equal units along both axes on the mode's display, so that circles are round.
class Diagram : public Canvas {
  public:
    /// `centre` is in the middle of the canvas between the gallery's header and footer, which are `units_high` apart.
    Diagram(const Canvas& canvas, Vec centre, double units_high);

    void arrow(const Vec& from, const Vec& to, Rgb8 colour);
    /// With a label at its point.
    void arrow(const Vec& from, const Vec& to, Rgb8 colour, std::string_view name, std::int32_t right_px,
               std::int32_t below_px) {
        arrow(from, to, colour);
        label(to, name, colour, right_px, below_px);
    }
    void circle(const Vec& centre, double radius, Rgb8 colour) {
        ellipse(centre, {radius, 0}, {0, radius}, 96, colour);
    }
    void disc(const Vec& centre, double radius, Rgb8 colour);
    void rectangle(const Vec& lowest, const Vec& highest, Rgb8 colour);

    Vec pixel_of(const Vec& point) const override;

  private:
    Vec centre_, middle_px_;
    double px_per_unit_x_, px_per_unit_y_;
};

/// A small picture whose pixels are shown as blocks, square on the mode's display. Points are columns and rows of the
/// picture, pixel centres at +0.5.
class PixelGrid : public Canvas {
  public:
    /// In the middle of the area `place`, as large as fits.
    PixelGrid(const Canvas& canvas, const Area& place, std::int32_t columns, std::int32_t rows, Rgb8 background);

    /// Draws the blocks, with lines between them.
    void show();
    Vec pixel_of(const Vec& point) const override;

    SidePicture picture;

  private:
    std::int32_t block_width_ = 1, block_height_ = 1;
    Area area_;
};

}  // namespace oblong
