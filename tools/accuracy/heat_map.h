#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/surface/palette.h"
#include "tools/accuracy/configurations.h"

namespace oblong {

/// The values at the ends of a heat map's colours, and how their captions read.
struct HeatScale {
    double least = 0, greatest = 0;
    std::string least_text, greatest_text;
};
HeatScale heat_scale(Measure measure);

/// Dark blue to yellow, by logarithm from the least value to the greatest; what has no value is grey.
Palette heat_palette();
/// The palette index of each value.
std::vector<std::uint8_t> heat_pixels(const std::vector<float>& values, Measure measure);

}  // namespace oblong
