#include "tools/accuracy/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "engine/base/table.h"
#include "engine/frame/frame_record.h"

namespace oblong {

namespace {

float distance(const reference::Rgb& a, const reference::Rgb& b) {
    const double red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return static_cast<float>(std::sqrt(red * red + green * green + blue * blue));
}

float light_error(const DrawnFrame& frame, const PixelRecord& pixel, std::uint8_t shown) {
    if (pixel.face.is_none() || pixel.mip != 0) return -1;
    const reference::Level& level = frame.level.exact;
    const reference::Rgb truth =
        true_colour(level, level.face(pixel.face.number()), number_of(pixel.u), number_of(pixel.v), frame.palette);
    return distance(frame.palette[shown], truth);
}

/// For each pixel of the camera's frame, whether any setting of a measure's dials changes it.
std::vector<bool> changes_by(Measure measure, LevelFrames& frames, const Camera& camera) {
    frames.draw(camera, Accuracy{});
    const std::vector<std::uint8_t> usual(frames.pixels().begin(), frames.pixels().end());
    std::vector<bool> changes(usual.size());
    for (const Dial& dial : all_dials())
        for (const DialSetting& setting : dial.settings) {
            if (measure_of(dial) != measure) continue;
            Accuracy accuracy;
            dial.set(accuracy, setting.value);
            frames.draw(camera, accuracy);
            for (std::size_t i = 0; i < usual.size(); ++i)
                if (frames.pixels()[i] != usual[i]) changes[i] = true;
        }
    return changes;
}

void append_measured(const std::vector<float>& values, std::vector<float>& all) {
    std::copy_if(values.begin(), values.end(), std::back_inserter(all), [](float value) { return value >= 0; });
}

/// The pixels of those measured that have the value 1, per mille.
float per_mille_of(const std::vector<float>& values) {
    const auto whole = std::count_if(values.begin(), values.end(), [](float value) { return value >= 0; });
    const double part = 1000.0 * static_cast<double>(std::count(values.begin(), values.end(), 1.f));
    return whole == 0 ? 0 : static_cast<float>(part / static_cast<double>(whole));
}

constexpr HeatScale kFaceHeat{0.5, 1, "same face", "another face"}, kColourHeat{1, 256, "1", "256"};

/// In the order of Measure.
constexpr std::array<MeasureRow, kMeasureCount> kMeasures{{
    {"displacement", "pixels", "How far from its place on the screen a texel is shown, in pixels."},
    {"texels", "texels", "How far from the texel that belongs there the one shown is, in texels of mip level 0."},
    {"wrong_pixels", "wrong pixels per mille of a frame",
     "The share of pixels that show another face than the exact one, close calls (an edge within 1/512 pixel of the "
     "centre) counted apart; rms, 99th percentile and largest are over frames.",
     true, kFaceHeat},
    {"edge_pixels", "pixels changed per mille of a frame",
     "The share of pixels that show another face than with exact edges between the same corners, close calls among "
     "them; rms, 99th percentile and largest are over frames.",
     true, kFaceHeat},
    {"close_calls", "close calls of another face per mille of a frame",
     "The share of pixels that are close calls and show another face than the exact one.", true, kFaceHeat},
    {"free_pixels", "pixels without a face per mille of a frame",
     "The share of pixels that no face covers: cracks between faces, filled with the colour beside them; rms, 99th "
     "percentile and largest are over frames.",
     true, HeatScale{0.5, 1, "a face", "no face"}},
    {"light_colour", "RGB distance, 0 to 442",
     "How far a pixel's colour is from that of the texel it shows times the exact light there, where mip level 0 is "
     "drawn and a dial of light changes the pixel. The 256 colours of the palette are part of it.",
     false, kColourHeat},
    {"pixel_colour", "RGB distance, 0 to 442",
     "How far a pixel's colour is from the mean colour of all that it covers, found by many rays a pixel, where that "
     "is one face and a dial of mip levels changes the pixel.",
     false, kColourHeat},
}};

constexpr int kFirstHeat = 1;  // 0: no value

/// Colours of rising brightness, so that they differ without hues, too.
constexpr std::array<Rgb8, 6> kSteps{
    {{8, 8, 40}, {60, 20, 110}, {150, 40, 110}, {220, 80, 60}, {250, 160, 30}, {255, 250, 160}}};

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double part) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * part));
}

}  // namespace

reference::Palette reference_palette(const Palette& palette) {
    reference::Palette converted;
    for (std::size_t i = 0; i < converted.size(); ++i) {
        const Rgb8 colour = palette.colours[i];
        converted[i] = {double(colour.red), double(colour.green), double(colour.blue)};
    }
    return converted;
}

FrameTruth make_frame_truth(LevelFrames& frames, const Camera& camera, const reference::Palette& palette,
                            int samples_per_axis) {
    const MeasuredLevel& level = frames.level();
    const reference::View view = reference_view(camera, kMeasuredMode);
    const std::vector<reference::PlacedModel> models = reference_models(level.models);
    FrameTruth truth;
    for (const reference::Pixel& pixel : draw_with_close_calls(level.exact, models, view).pixels) {
        truth.faces.push_back(pixel.face);
        truth.is_close_call.push_back(pixel.is_close_call);
    }
    for (const PixelRecord& pixel : frames.record(camera, Accuracy{}).pixels)
        truth.exact_edges.push_back(pixel.face.number());
    truth.colours = draw_colours(level.exact, models, view, palette, samples_per_axis);
    truth.light_changes = changes_by(Measure::LightColour, frames, camera);
    truth.mip_changes = changes_by(Measure::PixelColour, frames, camera);
    return truth;
}

PixelErrors measure_frame(const DrawnFrame& frame) {
    TexelErrorMeter meter(frame.level.exact, frame.level.models, frame.camera, kMeasuredMode);
    const std::vector<TexelError> texels = meter.measure(frame.record);
    PixelErrors errors;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const PixelRecord& pixel = frame.record.pixels[i];
        const std::int32_t true_face = frame.truth.faces[i];
        const bool is_close = frame.truth.is_close_call[i], is_wrong = true_face != pixel.face.number();
        const reference::ColourPixel& colour = frame.truth.colours[i];
        const auto add = [&](Measure measure, float value) { item(errors, measure).push_back(value); };
        add(Measure::Displacement, texels[i].pixels);
        add(Measure::Texels, texels[i].texels);
        add(Measure::WrongPixels, true_face < 0 || is_close ? -1.f : is_wrong ? 1.f : 0.f);
        add(Measure::EdgePixels, frame.truth.exact_edges[i] != pixel.face.number() ? 1.f : 0.f);
        add(Measure::CloseCalls, is_close && is_wrong ? 1.f : 0.f);
        add(Measure::FreePixels, pixel.face.is_none() ? 1.f : 0.f);
        add(Measure::LightColour, frame.truth.light_changes[i] ? light_error(frame, pixel, frame.pixels[i]) : -1);
        const bool has_colour = frame.truth.mip_changes[i] && !colour.is_excluded && !colour.is_border;
        add(Measure::PixelColour, has_colour ? distance(frame.palette[frame.pixels[i]], colour.colour) : -1);
    }
    return errors;
}

const MeasureRow& row_of(Measure measure) {
    return item(kMeasures, measure);
}

void ErrorCollector::add(const PixelErrors& frame) {
    for (std::size_t i = 0; i < kMeasureCount; ++i)
        if (kMeasures[i].is_share)
            values_[i].push_back(per_mille_of(frame[i]));
        else
            append_measured(frame[i], values_[i]);
}

ErrorSummaries ErrorCollector::summarize() const {
    ErrorSummaries summaries;
    std::transform(values_.begin(), values_.end(), summaries.begin(), summarize_errors);
    return summaries;
}

double rms_of(const std::vector<float>& values) {
    std::vector<float> measured;
    append_measured(values, measured);
    return summarize_errors(std::move(measured)).rms;
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
    const HeatScale& scale = row_of(measure).heat;
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
