#include "tools/accuracy/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "engine/base/table.h"

namespace oblong {

namespace {

void append_measured(const std::vector<float>& values, std::vector<float>& all) {
    std::copy_if(values.begin(), values.end(), std::back_inserter(all), [](float value) { return value >= 0; });
}

float per_mille(std::int64_t part, std::size_t whole) {
    return whole == 0 ? 0 : static_cast<float>(1000.0 * static_cast<double>(part) / static_cast<double>(whole));
}

struct MeasureEntry {
    ErrorSummary ErrorSummaries::*summary;
    std::vector<float> PixelErrors::*pixels;
    std::string_view unit, about;
};

/// In the order of Measure.
constexpr std::array<MeasureEntry, kMeasureCount> kMeasures{{
    {&ErrorSummaries::displacement, &PixelErrors::displacement, "pixels",
     "How far from its place on the screen a texel is shown, in pixels."},
    {&ErrorSummaries::wrong, &PixelErrors::wrong, "wrong pixels per mille of a frame",
     "The share of pixels that show another face than the exact one, close calls (an edge within 1/512 pixel of the "
     "centre) counted apart; rms, 99th percentile and largest are over frames."},
    {&ErrorSummaries::edges, &PixelErrors::edges, "pixels changed per mille of a frame",
     "The share of pixels that show another face than with exact edges between the same corners, close calls among "
     "them; "
     "rms, 99th percentile and largest are over frames."},
    {&ErrorSummaries::free_pixels, &PixelErrors::free, "pixels without a face per mille of a frame",
     "The share of pixels that no face covers: cracks between faces, filled with the colour beside them; rms, 99th "
     "percentile and largest are over frames."},
    {&ErrorSummaries::light, &PixelErrors::light, "RGB distance, 0 to 442",
     "How far a pixel's colour is from that of the texel it shows times the exact light there, where mip level 0 is "
     "drawn and a dial of light changes the pixel. The 256 colours of the palette are part of it."},
    {&ErrorSummaries::colour, &PixelErrors::colour, "RGB distance, 0 to 442",
     "How far a pixel's colour is from the mean colour of all that it covers, found by many rays a pixel, where that "
     "is one face and a dial of mip levels changes the pixel."},
}};

constexpr int kFirstHeat = 1;  // 0: no value

/// Colours of rising brightness, so that they differ without hues, too.
constexpr std::array<Rgb8, 6> kSteps{
    {{8, 8, 40}, {60, 20, 110}, {150, 40, 110}, {220, 80, 60}, {250, 160, 30}, {255, 250, 160}}};

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double part) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * part));
}

}  // namespace

const ErrorSummary& summary_of(const ErrorSummaries& errors, Measure measure) {
    return errors.*item(kMeasures, measure).summary;
}

std::string_view unit_of(Measure measure) {
    return item(kMeasures, measure).unit;
}

std::string_view about(Measure measure) {
    return item(kMeasures, measure).about;
}

void ErrorCollector::add(const PixelErrors& frame) {
    append_measured(frame.displacement, displacement_);
    append_measured(frame.texels, texels_);
    append_measured(frame.light, light_);
    append_measured(frame.colour, colour_);
    std::vector<float> known;
    append_measured(frame.wrong, known);
    wrong_.push_back(per_mille(std::count(known.begin(), known.end(), 1.f), known.size()));
    edges_.push_back(per_mille(std::count(frame.edges.begin(), frame.edges.end(), 1.f), frame.edges.size()));
    close_calls_.push_back(per_mille(frame.wrong_close_calls, frame.wrong.size()));
    free_.push_back(per_mille(std::count(frame.free.begin(), frame.free.end(), 1.f), frame.free.size()));
}

ErrorSummaries ErrorCollector::summarize() const {
    return {summarize_errors(displacement_), summarize_errors(texels_),      summarize_errors(wrong_),
            summarize_errors(edges_),        summarize_errors(close_calls_), summarize_errors(free_),
            summarize_errors(light_),        summarize_errors(colour_)};
}

const std::vector<float>& pixels_by(const PixelErrors& errors, Measure measure) {
    return errors.*item(kMeasures, measure).pixels;
}

double rms_of(const std::vector<float>& values) {
    std::vector<float> measured;
    append_measured(values, measured);
    return summarize_errors(std::move(measured)).rms;
}

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
        const auto step = std::min(as_size(place), kSteps.size() - 2);
        const double part = place - static_cast<double>(step);
        const Rgb8 &from = kSteps[step], &to = kSteps[step + 1];
        item(palette.colours, i) = {mixed(from.red, to.red, part), mixed(from.green, to.green, part),
                                    mixed(from.blue, to.blue, part)};
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
