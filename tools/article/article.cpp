#include "tools/article/article.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/table.h"
#include "engine/io/doubles.h"
#include "engine/visibility/eye.h"

namespace oblong {
namespace {

using Json = nlohmann::ordered_json;

/// Rays along each axis of a pixel whose mean colour is exact: more take longer, and change no digit that is shown
/// much.
constexpr int kArticleRaysPerAxis = 2;

std::uint32_t shown_colour(double red, double green, double blue) {
    const auto channel = [](double value) {
        return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    };
    return 0xFF000000 | channel(blue) << 16 | channel(green) << 8 | channel(red);
}

Angle shown_angle(double degrees) {
    return Angle::from_bam(std::lround(degrees * 65536 / 360));
}

Camera camera_from(const ArticleEye& eye) {
    Camera camera;
    camera.eye = {fixed_of<World>(eye.x), fixed_of<World>(eye.y), fixed_of<World>(eye.z)};
    camera.yaw = shown_angle(eye.yaw);
    camera.pitch = shown_angle(eye.pitch);
    camera.roll = shown_angle(eye.roll);
    camera.field_of_view = fixed_of<Degrees>(eye.field_of_view);
    return camera;
}

Json values_of(const Accuracy& accuracy) {
    Json values;
    for (const Dial& dial : all_dials()) values.push_back(dial.get(accuracy));
    return values;
}

Json choices_of(const Dial& dial) {
    Json settings;
    for (const DialSetting& setting : dial.settings)
        settings.push_back({{"name", setting.name}, {"value", setting.value}});
    return {{"name", dial.name}, {"caption", dial.caption}, {"about", dial.about},
            {"unit", dial.unit}, {"settings", settings},    {"measure", static_cast<int>(measure_of(dial))}};
}

}  // namespace

Article::Article(std::span<const std::uint8_t> level, std::span<const std::uint8_t> palette)
    : palette_(read_palette(palette)),
      exact_palette_(reference_palette(palette_)),
      colormap_(make_colormap(palette_)),
      level_(make_measured_level("article", "", level, {})) {}

void Article::set_dial(std::size_t dial, std::int32_t value) {
    all_dials()[dial].set(accuracy_, value);
}

void Article::correct_aspect(bool corrects) {
    corrects_aspect_ = corrects;
    frames_.correct_aspect(corrects);
}

bool Article::look_from(const ArticleEye& eye) {
    Camera camera = camera_from(eye);
    const PlacedEye placed = place_eye(level_.level, camera.eye);
    if (level_.level.leaves[placed.leaf].contents == contents::kSolid) return false;
    camera.eye = placed.position;
    camera_ = camera;
    truth_.reset();
    return true;
}

void Article::paint(std::span<const std::uint8_t> pixels, const Palette& palette) {
    std::array<std::uint32_t, 256> colours{};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const Rgb8 colour = palette.colours[i];
        colours[i] = shown_colour(colour.red, colour.green, colour.blue);
    }
    shown_.clear();
    for (const std::uint8_t pixel : pixels) shown_.push_back(colours[pixel]);
}

const std::vector<std::uint32_t>& Article::draw() {
    frames_.draw(camera_, accuracy_);  // lights its surfaces
    events_ = events_of(frames_.count(camera_, accuracy_), accuracy_);
    paint(frames_.pixels(), palette_);
    return shown_;
}

const std::vector<std::uint32_t>& Article::draw_reference() {
    const std::vector<reference::PlacedModel> models = reference_models(level_.models);
    shown_.clear();
    for (const reference::ColourPixel& pixel :
         draw_colours(level_.exact, models, reference_view(camera_, kMeasuredMode, corrects_aspect_), exact_palette_))
        shown_.push_back(shown_colour(pixel.colour.red, pixel.colour.green, pixel.colour.blue));
    return shown_;
}

const FrameTruth& Article::truth() {
    if (!truth_) truth_ = make_frame_truth(frames_, camera_, exact_palette_, kArticleRaysPerAxis);
    return *truth_;
}

const std::vector<std::uint32_t>& Article::draw_errors(Measure measure) {
    PixelErrors errors;
    if (measure == Measure::Displacement) {  // the only one that needs no truth: it follows a moving view
        TexelErrorMeter meter(level_.exact, level_.models, camera_, kMeasuredMode, corrects_aspect_);
        for (const TexelError& error : meter.measure(frames_.record(camera_, accuracy_)))
            item(errors, measure).push_back(error.pixels);
    } else {
        const FrameTruth& exact = truth();
        const FrameRecord& record = frames_.record(camera_, accuracy_);
        errors = measure_frame({level_, camera_, exact, exact_palette_, record, frames_.pixels()});
    }
    ErrorCollector collector;
    collector.add(errors);
    errors_ = collector.summarize()[static_cast<std::size_t>(measure)];
    paint(heat_pixels(item(errors, measure), measure), heat_palette());
    return shown_;
}

std::string Article::figures() const {
    Json cycles;
    for (const Processor processor : kProcessors) cycles.push_back(cycles_on(processor, events_));
    return Json{{"instructions", cost_of(events_, Currency::Instructions)},
                {"instructions486", cost_of(events_, Currency::Instructions486)},
                {"cycles", cycles},
                {"rms", errors_.rms},
                {"p99", errors_.p99},
                {"max", errors_.max}}
        .dump();
}

std::string Article::choices() {
    Json dials, presets, measures, processors;
    for (const Dial& dial : all_dials()) dials.push_back(choices_of(dial));
    for (const Preset preset : kPresets)
        presets.push_back({{"name", name_of(preset)}, {"values", values_of(accuracy_of(preset))}});
    for (std::size_t i = 0; i < kMeasureCount; ++i) {
        const MeasureRow& row = row_of(static_cast<Measure>(i));
        measures.push_back({{"name", row.name},
                            {"unit", row.unit},
                            {"share", row.is_share},
                            {"least", row.heat.least_text},
                            {"greatest", row.heat.greatest_text}});
    }
    for (const Processor processor : kProcessors)
        processors.push_back({{"name", name_of(processor)}, {"megahertz", megahertz_of(processor)}});
    return Json{{"dials", dials},
                {"presets", presets},
                {"usual", values_of({})},
                {"measures", measures},
                {"processors", processors},
                {"width", kMeasuredMode.width_px},
                {"height", kMeasuredMode.height_px}}
        .dump();
}

}  // namespace oblong
