#include "tools/gallery/row.h"

#include <cmath>
#include <cstdio>

#include "tools/common/nearest_colour.h"

namespace oblong {

namespace {

std::string with_decimals(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

}  // namespace

Figure number_figure(std::string name, double expected, double found, double tolerance, int decimals) {
    return {std::move(name), with_decimals(expected, decimals), with_decimals(found, decimals),
            std::abs(expected - found) <= tolerance};
}

Figure count_figure(std::string name, std::int64_t expected, std::int64_t found) {
    return {std::move(name), std::to_string(expected), std::to_string(found), expected == found};
}

Figure measured(std::string name, std::string found) {
    return {std::move(name), "", std::move(found), true};
}

Parameter choice_parameter(std::string name, std::vector<std::string> choices, std::int64_t start) {
    const auto most = static_cast<std::int64_t>(choices.size()) - 1;
    return {std::move(name), 0, most, 1, start, std::move(choices)};
}

std::uint8_t GalleryAssets::colour(int red, int green, int blue) const {
    const Rgb8 wanted{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                      static_cast<std::uint8_t>(blue)};
    return nearest_colour(colormap.palette, wanted);
}

}  // namespace oblong
