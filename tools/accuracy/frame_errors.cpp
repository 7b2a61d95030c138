#include "tools/accuracy/frame_errors.h"

#include <cmath>

#include "tools/accuracy/configurations.h"
#include "tools/measure/texel_error.h"

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
        errors.displacement.push_back(texels[i].pixels);
        errors.texels.push_back(texels[i].texels);
        errors.wrong.push_back(true_face < 0 || is_close ? -1.f : is_wrong ? 1.f : 0.f);
        errors.edges.push_back(frame.truth.exact_edges[i] != pixel.face.number() ? 1.f : 0.f);
        errors.wrong_close_calls += is_close && is_wrong;
        errors.light.push_back(frame.truth.light_changes[i] ? light_error(frame, pixel, frame.pixels[i]) : -1);
        const bool has_colour = frame.truth.mip_changes[i] && !colour.is_excluded && !colour.is_border;
        errors.colour.push_back(has_colour ? distance(frame.palette[frame.pixels[i]], colour.colour) : -1);
        errors.free.push_back(pixel.face.is_none() ? 1.f : 0.f);
    }
    return errors;
}

}  // namespace oblong
