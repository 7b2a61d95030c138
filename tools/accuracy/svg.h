#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace oblong {

/// Text that is safe between tags and in attributes of HTML and SVG; bytes that are no UTF-8 become question marks.
std::string escaped(std::string_view text);

/// A place of a drawing; y grows downward.
struct DrawingPoint {
    double x = 0, y = 0;
};

/// Writes an SVG picture. Colours come from the page's style, by classes.
class Svg {
  public:
    /// `label`: what it shows, for those who cannot see it.
    Svg(double width, double height, std::string_view css_class, std::string_view label);

    void line(DrawingPoint from, DrawingPoint to, std::string_view css_class);
    void polyline(const std::vector<DrawingPoint>& points, std::string_view css_class);
    void rectangle(DrawingPoint corner, double width, double height, std::string_view css_class);
    /// With a caption that shows while the pointer is on it.
    void circle(DrawingPoint centre, double radius, std::string_view css_class, std::string_view caption);
    /// `anchor`: start, middle or end.
    void text(DrawingPoint at, std::string_view anchor, std::string_view css_class, std::string_view words);

    std::string str() const { return text_ + "</svg>\n"; }

  private:
    std::string text_;
};

/// A logarithmic axis from `least` to `greatest` (above 0), along pixels `from` to `to`.
class LogAxis {
  public:
    LogAxis(double least, double greatest, double from, double to);

    double place(double value) const;  ///< values beyond the ends at the ends
    /// Round values to label: at most about eight.
    std::vector<double> ticks() const;

  private:
    double least_, greatest_, from_, to_;
};

}  // namespace oblong
