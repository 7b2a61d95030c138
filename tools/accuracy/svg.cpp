#include "tools/accuracy/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace oblong {

namespace {

std::string pixels(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// Bytes of the character that begins here: 0 if there is none in UTF-8.
std::size_t character_size(std::string_view text) {
    const auto first = static_cast<std::uint8_t>(text[0]);
    const std::size_t size = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
    if (size == 0 || size > text.size() || first == 0xc0 || first == 0xc1) return 0;
    const auto continues = [](char byte) { return (static_cast<std::uint8_t>(byte) & 0xc0) == 0x80; };
    return std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(size), continues) ? size : 0;
}

std::string escaped_character(std::string_view character) {
    switch (character[0]) {
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '&':
            return "&amp;";
        case '"':
            return "&quot;";
        default:
            break;
    }
    return character[0] >= 0 && character[0] < ' ' ? " " : std::string(character);
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        safe += size == 0 ? "?" : escaped_character(text.substr(0, size));
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return safe;
}

Svg::Svg(double width, double height, std::string_view css_class, std::string_view label)
    : text_("<svg class=\"" + std::string(css_class) + "\" viewBox=\"0 0 " + pixels(width) + " " + pixels(height) +
            "\" role=\"img\" aria-label=\"" + escaped(label) + "\">\n") {}

void Svg::line(DrawingPoint from, DrawingPoint to, std::string_view css_class) {
    polyline({from, to}, css_class);
}

void Svg::polyline(const std::vector<DrawingPoint>& points, std::string_view css_class) {
    text_ += "<polyline class=\"" + std::string(css_class) + "\" points=\"";
    for (const DrawingPoint& point : points) text_ += pixels(point.x) + "," + pixels(point.y) + " ";
    text_ += "\"/>\n";
}

void Svg::rectangle(DrawingPoint corner, double width, double height, std::string_view css_class) {
    text_ += "<rect class=\"" + std::string(css_class) + "\" x=\"" + pixels(corner.x) + "\" y=\"" + pixels(corner.y) +
             "\" width=\"" + pixels(width) + "\" height=\"" + pixels(height) + "\"/>\n";
}

void Svg::circle(DrawingPoint centre, double radius, std::string_view css_class, std::string_view caption) {
    text_ += "<circle class=\"" + std::string(css_class) + "\" cx=\"" + pixels(centre.x) + "\" cy=\"" +
             pixels(centre.y) + "\" r=\"" + pixels(radius) + "\"><title>" + escaped(caption) + "</title></circle>\n";
}

void Svg::text(DrawingPoint at, std::string_view anchor, std::string_view css_class, std::string_view words) {
    text_ += "<text class=\"" + std::string(css_class) + "\" x=\"" + pixels(at.x) + "\" y=\"" + pixels(at.y) +
             "\" text-anchor=\"" + std::string(anchor) + "\">" + escaped(words) + "</text>\n";
}

LogAxis::LogAxis(double least, double greatest, double from, double to)
    : least_(least), greatest_(std::max(greatest, least * 1.01)), from_(from), to_(to) {}

double LogAxis::place(double value) const {
    const double part = std::log(std::clamp(value, least_, greatest_) / least_) / std::log(greatest_ / least_);
    return from_ + part * (to_ - from_);
}

std::vector<double> LogAxis::ticks() const {
    const double decades = std::log10(greatest_ / least_);
    std::vector<double> found;
    if (decades < 0.7) {  // evenly, by 1, 2 or 5 times a power of ten
        const double rough = (greatest_ - least_) / 6, unit = std::pow(10, std::floor(std::log10(rough)));
        const double step = unit * (rough / unit > 5 ? 10 : rough / unit > 2 ? 5 : rough / unit > 1 ? 2 : 1);
        for (double tick = std::ceil(least_ / step) * step; tick <= greatest_; tick += step) found.push_back(tick);
        return found;
    }
    const int stride = decades > 8 ? 2 : 1;
    for (int power = static_cast<int>(std::floor(std::log10(least_))); std::pow(10, power) <= greatest_;
         power += stride)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double tick = factor * std::pow(10, power);
            const bool is_wanted = factor == 1 || decades < 2.5;
            if (is_wanted && tick >= least_ && tick <= greatest_) found.push_back(tick);
        }
    return found;
}

}  // namespace oblong
