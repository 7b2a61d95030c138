#include "tools/demo_level/art/ramps.h"

namespace oblong::art {
namespace {

/// The brightest step of a ramp, and a tint that is strongest in its middle: shadows of stone lean to blue, those of
/// brass to red.
struct RampDesign {
    Rgb8 brightest;
    int tint_red, tint_green, tint_blue;
};

constexpr std::array<RampDesign, kOrdinaryRamps> kDesigns{{{{238, 238, 238}, 0, 0, 0},
                                                           {{186, 200, 222}, -8, -2, 22},
                                                           {{236, 208, 160}, 6, -8, -10},
                                                           {{204, 148, 92}, 10, -14, -24},
                                                           {{255, 226, 120}, 16, -46, -62},
                                                           {{150, 220, 186}, -44, -8, 8},
                                                           {{128, 158, 246}, -44, -34, 26},
                                                           {{130, 222, 224}, -66, -10, 20},
                                                           {{232, 84, 66}, 30, -34, -18},
                                                           {{236, 150, 100}, 22, -26, -22},
                                                           {{250, 240, 212}, 10, 2, -10},
                                                           {{178, 128, 214}, -10, -34, 20},
                                                           {{170, 180, 96}, -20, 4, -24}}};

/// Brightness of each step, of 256: even ratios in the dark, where eyes (and a museum at night) need them most.
constexpr std::array<int, kRampSteps> kBrightness{8,   16,  25,  35,  46,  58,  71,  85,
                                                  100, 116, 133, 151, 171, 193, 219, 250};

constexpr std::array<Rgb8, 32> kGlowing{
    {{96, 24, 8},     {160, 48, 10},   {216, 88, 18},   {246, 136, 34},  {254, 184, 66}, {255, 220, 114},
     {255, 240, 178}, {255, 252, 234}, {22, 30, 66},    {46, 62, 114},   {78, 104, 170}, {120, 152, 218},
     {160, 192, 242}, {196, 220, 254}, {226, 240, 255}, {255, 255, 255}, {112, 16, 80},  {184, 32, 128},
     {240, 72, 184},  {255, 160, 224}, {16, 96, 48},    {32, 168, 80},   {88, 232, 128}, {184, 255, 200},
     {8, 80, 104},    {16, 152, 184},  {72, 224, 240},  {184, 255, 254}, {66, 40, 12},   {130, 84, 20},
     {210, 204, 180}, {142, 84, 100}}};

std::uint8_t shade(int brightest, int tint, int brightness) {
    const int value = (brightest * brightness + tint * brightness * (256 - brightness) / 128) / 256;
    return static_cast<std::uint8_t>(value < 0 ? 0 : value > 255 ? 255 : value);
}

Rgb8 step_colour(const RampDesign& design, int brightness) {
    return {shade(design.brightest.red, design.tint_red, brightness),
            shade(design.brightest.green, design.tint_green, brightness),
            shade(design.brightest.blue, design.tint_blue, brightness)};
}

}  // namespace

Palette design_palette() {
    Palette palette;
    std::size_t index = 0;
    for (const RampDesign& design : kDesigns) {
        for (const int brightness : kBrightness) palette.colours[index++] = step_colour(design, brightness);
    }
    for (const HalfSteps& half : kHalfSteps)
        for (std::size_t step = 0; step < static_cast<std::size_t>(half.count); ++step) {
            const std::size_t below = static_cast<std::size_t>(half.first) + step;
            palette.colours[index++] =
                step_colour(at(kDesigns, half.ramp), (kBrightness.at(below) + kBrightness.at(below + 1)) / 2);
        }
    for (const Rgb8 colour : kGlowing) palette.colours[index++] = colour;
    palette.colours[0] = {0, 0, 0};
    return palette;
}

}  // namespace oblong::art
