#include "tools/render/report.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "engine/accuracy/dials.h"

namespace oblong {

namespace {

using Json = nlohmann::ordered_json;

std::string hexadecimal(std::uint32_t value) {
    char text[9];
    std::snprintf(text, sizeof text, "%08x", value);
    return text;
}

double rounded(double value) {
    return std::round(value * 1000) / 1000;
}

double in_microseconds(double ns) {
    return rounded(ns / 1000);
}

/// The quartiles.
Json spread_json(double low_ns, double high_ns) {
    return {in_microseconds(low_ns), in_microseconds(high_ns)};
}

Json lines_json(const std::vector<PlanLine>& lines) {
    Json json = Json::array();
    for (const PlanLine& line : lines)
        json.push_back({{"name", line.name},
                        {"pixels", line.pixels},
                        {"microseconds", in_microseconds(line.nanoseconds)},
                        {"spread", spread_json(line.low_ns, line.high_ns)}});
    return json;
}

Json frame_json(std::size_t camera, const FrameReport& frame) {
    Json counts;
    for (const NamedCount& count : frame.counts) counts[std::string(count.name)] = count.count;
    return {{"camera", camera},
            {"crc32", hexadecimal(frame.crc32)},
            {"microseconds", in_microseconds(frame.frame_ns.median)},
            {"spread", spread_json(frame.frame_ns.low, frame.frame_ns.high)},
            {"pixels", {{"once", frame.pixels_once}, {"twice", frame.pixels_twice}, {"never", frame.pixels_never}}},
            {"counts", counts},
            {"passes", lines_json(frame.passes)},
            {"effects", lines_json(frame.effects)}};
}

std::string joined(std::int64_t first, char between, std::int64_t second) {
    return std::to_string(first) + between + std::to_string(second);
}

double in_degrees(Degrees angle) {
    return std::ldexp(static_cast<double>(angle.raw), -Degrees::kFractionBits);
}

/// The dials that were turned on top of the preset.
Json dials_json(const Accuracy& accuracy, Preset preset) {
    Json json = Json::object();
    for (const Dial& dial : all_dials())
        if (dial.get(accuracy) != dial.get(accuracy_of(preset)))
            json[std::string(dial.name)] = value_text(dial, dial.get(accuracy));
    return json;
}

/// The bound in pixels; no number where the preset has no bound.
Json texel_error_json(const Accuracy& accuracy) {
    if (accuracy.texturing != Texturing::Bounded) return nullptr;
    return accuracy.pixel_bound_256 / 256.0;
}

Json allowed_effects_json(EffectSet allowed) {
    Json names = Json::array();
    for (std::size_t effect = 0; effect < kEffectNames.size(); ++effect)
        if (allowed.has(static_cast<Effect>(effect))) names.push_back(kEffectNames[effect]);
    return names;
}

}  // namespace

TimeSummary summarize_times(const std::vector<FrameReport>& frames) {
    std::vector<double> times;
    for (const FrameReport& frame : frames) times.push_back(frame.frame_ns.median / 1000);
    return summarize_times(std::move(times));
}

std::string plan_text(const std::vector<FrameReport>& frames) {
    std::string text;
    const auto add = [&](const char* kind, const std::vector<PlanLine>& lines) {
        for (const PlanLine& line : lines) {
            char row[112];
            std::snprintf(row, sizeof row, "  %-6s %-18.*s %9lld pixels %9.1f us (%.1f to %.1f)\n", kind,
                          static_cast<int>(line.name.size()), line.name.data(), static_cast<long long>(line.pixels),
                          line.nanoseconds / 1000, line.low_ns / 1000, line.high_ns / 1000);
            text += row;
        }
    };
    for (std::size_t camera = 0; camera < frames.size(); ++camera) {
        const TimeSpread& frame = frames[camera].frame_ns;
        text += "camera " + std::to_string(camera) + "\n";
        const std::int64_t pixels =
            frames[camera].pixels_once + frames[camera].pixels_twice + frames[camera].pixels_never;
        add("frame", {{"", pixels, frame.median, frame.low, frame.high}});
        add("pass", frames[camera].passes);
        add("effect", frames[camera].effects);
    }
    return text;
}

std::string report_json(const ReportHead& head, const std::vector<FrameReport>& frames) {
    const TimeSummary times = summarize_times(frames);
    Json report{{"level", head.level},
                {"mode", joined(head.mode.width_px, 'x', head.mode.height_px)},
                {"display", joined(head.mode.display.numerator, ':', head.mode.display.denominator)},
                {"field_of_view", in_degrees(head.field_of_view)},
                {"accuracy", name_of(head.preset)},
                {"dials", dials_json(head.settings.accuracy, head.preset)},
                {"texel_error", texel_error_json(head.settings.accuracy)},
                {"allowed_effects", allowed_effects_json(head.settings.allowed_effects)},
                {"hidden_surfaces", at(kHiddenSurfaceNames, head.hidden_surfaces)},
                {"threads", head.threads},
                {"load_milliseconds", rounded(head.load_milliseconds)},
                {"microseconds", {{"median", rounded(times.median)}, {"p99", rounded(times.p99)}}},
                {"frames", Json::array()}};
    for (std::size_t i = 0; i < frames.size(); ++i) report["frames"].push_back(frame_json(i, frames[i]));
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";  // a file's name may be no UTF-8
}

}  // namespace oblong
