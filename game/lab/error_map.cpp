#include "game/lab/error_map.h"

#include <algorithm>
#include <string_view>

#include "engine/base/table.h"
#include "engine/draw/text.h"
#include "engine/surface/palette.h"

namespace oblong {
namespace {

constexpr std::array<std::string_view, ErrorMap::kBands> kLabels{"0", "1/8", "1/4", "1/2", "1", "2", "4px"};
constexpr std::int32_t kSwatch_px = 4;

// A band's colour at 3/4 to all of its brightness, by the brightness of the picture's colour.
Rgb8 tinted(Rgb8 band, Rgb8 picture) {
    const std::int32_t weight = 192 + luminance_1000(picture) / 4000;
    const auto scaled = [&](std::uint8_t channel) { return static_cast<std::uint8_t>(channel * weight / 256); };
    return {scaled(band.red), scaled(band.green), scaled(band.blue)};
}

}  // namespace

ErrorMap::ErrorMap(const Palette& palette, ColourScheme scheme) {
    const std::array<Rgb8, kBands>& colours = sign_colours_of(scheme).errors;
    for (std::size_t band = 0; band < kBands; ++band) {
        swatches_[band] = nearest_colour(palette, tinted(colours[band], {128, 128, 128}));
        for (std::size_t i = 0; i < palette.colours.size(); ++i)
            tints_[band][i] = nearest_colour(palette, tinted(colours[band], palette.colours[i]));
    }
}

std::size_t ErrorMap::band_of(float pixels) {
    const auto is_reached = [pixels](int step_256) { return pixels * 256 >= static_cast<float>(step_256); };
    return as_size(std::count_if(kSteps_256.begin(), kSteps_256.end(), is_reached));
}

void ErrorMap::draw(std::span<const TexelError> errors, Framebuffer canvas) const {
    if (errors.size() != pixel_count(canvas.width_px, canvas.height_px)) return;
    auto error = errors.begin();
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        for (std::int32_t x = 0; x < canvas.width_px; ++x, ++error)
            canvas.row(y)[x] = tints_[band_of(error->pixels)][canvas.row(y)[x]];
}

std::int32_t ErrorMap::draw_legend(std::int32_t bottom, TextColours colours, Framebuffer canvas) const {
    const std::int32_t line_px = kLineHeight_px * colours.scale, swatch_px = kSwatch_px * colours.scale;
    const std::int32_t top = bottom - line_px - swatch_px - kTextMargin_px;
    const std::int32_t width = (canvas.width_px - 2 * kTextMargin_px) / static_cast<std::int32_t>(kBands);
    for (std::size_t band = 0; band < kBands; ++band) {
        const std::int32_t x = kTextMargin_px + static_cast<std::int32_t>(band) * width;
        draw_text(canvas, x, top, kLabels[band], colours);
        fill_area(canvas, {x, top + line_px, width, swatch_px}, swatches_[band]);
    }
    return top;
}

}  // namespace oblong
