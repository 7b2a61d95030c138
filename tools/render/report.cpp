#include "tools/render/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

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

Json frame_json(std::size_t camera, const FrameReport& frame) {
    Json effects = Json::array();
    for (const EffectReport& effect : frame.effects)
        effects.push_back({{"name", kEffectNames[effect.effect]},
                           {"pixels", effect.pixels},
                           {"microseconds", rounded(effect.microseconds)}});
    return {{"camera", camera},
            {"crc32", hexadecimal(frame.crc32)},
            {"microseconds", rounded(frame.microseconds)},
            {"pixels", {{"once", frame.pixels_once}, {"twice", frame.pixels_twice}, {"never", frame.pixels_never}}},
            {"counts",
             {{"faces_visited", frame.faces_visited},
              {"faces_drawn", frame.faces_drawn},
              {"spans", frame.spans},
              {"divisions", frame.divisions}}},
            {"effects", effects}};
}

}  // namespace

TimeSummary summarize_times(const std::vector<FrameReport>& frames) {
    std::vector<double> times;
    for (const FrameReport& frame : frames) times.push_back(frame.microseconds);
    std::sort(times.begin(), times.end());
    const std::size_t middle = times.size() / 2;
    const double median = times.size() % 2 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
    return {median, times[(times.size() * 99 + 99) / 100 - 1]};
}

std::string report_json(const ReportHead& head, const std::vector<FrameReport>& frames) {
    const TimeSummary times = summarize_times(frames);
    Json report{{"level", head.level},
                {"mode", std::to_string(head.mode.width_px) + "x" + std::to_string(head.mode.height_px)},
                {"accuracy", head.accuracy},
                {"threads", head.threads},
                {"load_milliseconds", rounded(head.load_milliseconds)},
                {"microseconds", {{"median", rounded(times.median)}, {"p99", rounded(times.p99)}}},
                {"frames", Json::array()}};
    for (std::size_t i = 0; i < frames.size(); ++i) report["frames"].push_back(frame_json(i, frames[i]));
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";  // a file's name may be no UTF-8
}

}  // namespace oblong
