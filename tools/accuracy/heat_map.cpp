#include "tools/accuracy/heat_map.h"

#include <algorithm>
#include <cmath>

namespace oblong {

namespace {

constexpr int kFirstHeat = 1;  // 0: no value

/// Colours of rising brightness, as they are also told apart without seeing hues.
constexpr std::array<Rgb8, 6> kSteps{
    {{8, 8, 40}, {60, 20, 110}, {150, 40, 110}, {220, 80, 60}, {250, 160, 30}, {255, 250, 160}}};

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double part) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * part));
}

}  // namespace

HeatScale heat_scale(Measure measure) {
    switch (measure) {
        case Measure::WrongPixels:
        case Measure::EdgePixels:
            return {0.5, 1, "same face", "another face"};
        case Measure::FreePixels:
            return {0.5, 1, "a face", "no face"};
        case Measure::LightColour:
        case Measure::PixelColour:
            return {1, 256, "1", "256"};
        case Measure::Displacement:
            break;
    }
    return {1.0 / 256, 64, "1/256 pixel", "64 pixels"};
}

Palette heat_palette() {
    Palette palette;
    palette.colours[0] = {110, 110, 110};
    for (int i = kFirstHeat; i < 256; ++i) {
        const double place = (i - kFirstHeat) / (255.0 - kFirstHeat) * (kSteps.size() - 1);
        const auto step = std::min(static_cast<std::size_t>(place), kSteps.size() - 2);
        const double part = place - static_cast<double>(step);
        const Rgb8 &from = kSteps[step], &to = kSteps[step + 1];
        palette.colours[static_cast<std::size_t>(i)] = {
            mixed(from.red, to.red, part), mixed(from.green, to.green, part), mixed(from.blue, to.blue, part)};
    }
    return palette;
}

std::vector<std::uint8_t> heat_pixels(const std::vector<float>& values, Measure measure) {
    const HeatScale scale = heat_scale(measure);
    std::vector<std::uint8_t> pixels;
    for (const float value : values) {
        const double part =
            std::log(std::max<double>(value, scale.least) / scale.least) / std::log(scale.greatest / scale.least);
        const double index = kFirstHeat + std::clamp(part, 0.0, 1.0) * (255 - kFirstHeat);
        pixels.push_back(value < 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(index));
    }
    return pixels;
}

}  // namespace oblong
