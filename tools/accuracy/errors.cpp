#include "tools/accuracy/errors.h"

#include <algorithm>
#include <iterator>

namespace oblong {

namespace {

void append_measured(const std::vector<float>& values, std::vector<float>& all) {
    std::copy_if(values.begin(), values.end(), std::back_inserter(all), [](float value) { return value >= 0; });
}

float per_mille(std::int64_t part, std::size_t whole) {
    return whole == 0 ? 0 : static_cast<float>(1000.0 * static_cast<double>(part) / static_cast<double>(whole));
}

}  // namespace

const ErrorSummary& summary_of(const ErrorSummaries& errors, Measure measure) {
    switch (measure) {
        case Measure::WrongPixels:
            return errors.wrong;
        case Measure::EdgePixels:
            return errors.edges;
        case Measure::FreePixels:
            return errors.free_pixels;
        case Measure::LightColour:
            return errors.light;
        case Measure::PixelColour:
            return errors.colour;
        case Measure::Displacement:
            break;
    }
    return errors.displacement;
}

std::string_view unit_of(Measure measure) {
    switch (measure) {
        case Measure::WrongPixels:
            return "wrong pixels per mille of a frame";
        case Measure::EdgePixels:
            return "pixels changed per mille of a frame";
        case Measure::FreePixels:
            return "pixels without a face per mille of a frame";
        case Measure::LightColour:
        case Measure::PixelColour:
            return "RGB distance, 0 to 442";
        case Measure::Displacement:
            break;
    }
    return "pixels";
}

std::string_view about(Measure measure) {
    switch (measure) {
        case Measure::WrongPixels:
            return "The share of pixels that show another face than the exact one, close calls (an edge within "
                   "1/512 pixel of the centre) counted apart; rms, 99th percentile and largest are over frames.";
        case Measure::EdgePixels:
            return "The share of pixels that show another face than with exact edges between the same corners, close "
                   "calls among them; rms, 99th percentile and largest are over frames.";
        case Measure::FreePixels:
            return "The share of pixels that no face covers: cracks between faces, filled with the colour beside them; "
                   "rms, 99th percentile and largest are over frames.";
        case Measure::LightColour:
            return "How far a pixel's colour is from that of the texel it shows times the exact light there, where mip "
                   "level 0 is drawn. The 256 colours of the palette are part of it.";
        case Measure::PixelColour:
            return "How far a pixel's colour is from the mean colour of all that it covers, found by many rays a "
                   "pixel.";
        case Measure::Displacement:
            break;
    }
    return "How far from its place on the screen a texel is shown, in pixels.";
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
    switch (measure) {
        case Measure::WrongPixels:
            return errors.wrong;
        case Measure::EdgePixels:
            return errors.edges;
        case Measure::FreePixels:
            return errors.free;
        case Measure::LightColour:
            return errors.light;
        case Measure::PixelColour:
            return errors.colour;
        case Measure::Displacement:
            break;
    }
    return errors.displacement;
}

double rms_of(const std::vector<float>& values) {
    std::vector<float> measured;
    append_measured(values, measured);
    return summarize_errors(std::move(measured)).rms;
}

}  // namespace oblong
