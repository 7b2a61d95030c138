#include "game/view/sign_colours.h"

#include "engine/base/table.h"

namespace oblong {
namespace {

// From cold to hot, in colours that are also in Quake's palette. All but the first, for tiny errors, are bright.
constexpr SignColours kStandard{
    {232, 224, 200},
    {160, 128, 88},
    {248, 176, 48},
    {88, 92, 104},
    {120, 248, 120},
    {160, 224, 255},
    {255, 232, 96},
    {{{90, 90, 90}, {40, 60, 220}, {150, 200, 250}, {250, 230, 40}, {240, 130, 30}, {230, 20, 20}, {255, 250, 250}}}};

// Blue to yellow through grey, as in maps for readers who confuse red and green; each band is brighter than the one
// before.
constexpr SignColours kRedGreen{
    {240, 240, 240},
    {150, 150, 150},
    {255, 200, 40},
    {70, 76, 96},
    {110, 170, 255},
    {255, 255, 255},
    {255, 232, 96},
    {{{50, 50, 60}, {20, 40, 170}, {70, 90, 190}, {120, 130, 150}, {180, 165, 110}, {230, 205, 70}, {255, 250, 200}}}};

// Dark red to cyan and white: each band is brighter than the one before.
constexpr SignColours kBlueYellow{
    {240, 240, 240},
    {150, 150, 150},
    {255, 110, 110},
    {76, 76, 80},
    {80, 240, 240},
    {255, 255, 255},
    {255, 255, 255},
    {{{60, 50, 50}, {130, 10, 20}, {200, 40, 50}, {230, 110, 110}, {140, 190, 190}, {70, 230, 230}, {245, 255, 255}}}};

constexpr std::array kSchemes{kStandard, kRedGreen, kBlueYellow};
static_assert(kSchemes.size() == kColourSchemeCount);

}  // namespace

const SignColours& sign_colours_of(ColourScheme scheme) {
    return item(kSchemes, scheme);
}

}  // namespace oblong
