#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "tools/accuracy/errors.h"
#include "tools/accuracy/page.h"
#include "tools/accuracy/report.h"

namespace oblong {

namespace {

using Json = nlohmann::ordered_json;

/// Rounded to six significant digits.
double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return std::atof(text);
}

Json error_json(const ErrorSummaries& errors, Measure measure) {
    const ErrorSummary& error = item(errors, measure);
    return {{"unit", row_of(measure).unit},
            {"rms", rounded(error.rms)},
            {"p99", rounded(error.p99)},
            {"max", rounded(error.max)}};
}

Json errors_json(const ErrorSummaries& errors) {
    Json json;
    for (std::size_t i = 0; i < kMeasureCount; ++i)
        json[std::string(row_of(Measure(i)).name)] = error_json(errors, Measure(i));
    return json;
}

/// Frames a second.
double frame_rate(Processor processor, const CountedCost& cost) {
    return static_cast<double>(megahertz_of(processor)) * 1e6 / cost.mean(cycles_on(processor, cost.drawing));
}

/// The events of a mean frame and their prices.
void add_events(const CountedCost& counted, const Events& events, const std::string& prefix, Json& cost) {
    Json& operations = cost[prefix + "operations"];
    for (std::size_t i = 0; i < kEventCount; ++i)
        operations[std::string(event_name(i))] = std::round(counted.mean(events[i]));
    constexpr std::array<const char*, kCurrencyCount> kNames{"instructions", "instructions_486", "cycles_386",
                                                             "cycles_486", "cycles_pentium"};
    for (std::size_t i = 0; i < kCurrencyCount; ++i)
        cost[prefix + kNames[i]] = std::round(counted.mean(cost_of(events, Currency(i))));
}

Json spread_json(const TimeSpread& times) {
    return {{"median", std::round(times.median)},
            {"lower_quartile", std::round(times.low)},
            {"upper_quartile", std::round(times.high)}};
}

void add_times(const SettingTimes& times, Json& cost) {
    cost["nanoseconds"] = std::round(times.frame.median);
    cost["nanoseconds_spread"] = spread_json(times.frame);
    if (times.unlit) cost["nanoseconds_all_surfaces_built"] = spread_json(*times.unlit);
}

Json cost_json(const Report& report, std::size_t index) {
    const CountedCost& counted = report.results[index].cost;
    Json cost;
    add_events(counted, counted.drawing, "", cost);
    add_events(counted, counted.lighting, "lighting_", cost);
    constexpr std::array kNames{"386", "486", "pentium"};
    for (std::size_t i = 0; i < kProcessors.size(); ++i)
        cost[std::string("frames_per_second_") + kNames[i]] = rounded(frame_rate(kProcessors[i], counted));
    cost["nanoseconds"] = nullptr;
    if (report.times.settings[index]) add_times(*report.times.settings[index], cost);
    return cost;
}

Json levels_json(const Report& report, std::size_t index, Measure measure) {
    Json levels = Json::array();
    for (std::size_t i = 0; i < report.levels.size(); ++i)
        levels.push_back(
            {{"name", report.levels[i].name}, {"error", error_json(report.results[index].by_level[i], measure)}});
    return levels;
}

Json setting_json(const Report& report, const Configurations::Row& row, Measure measure) {
    const ErrorSummaries& errors = report.results[row.index].errors;
    return {{"name", row.name},
            {"configuration", row.index},
            {"textures_floors", report.configurations.accuracies[row.index].textures_floors},
            {"error", error_json(errors, measure)},
            {"alone", error_json(report.results[row.alone].errors, measure)},
            {"cost", cost_json(report, row.index)},
            {"time", "measured"},
            {"errors", errors_json(errors)},
            {"levels", levels_json(report, row.index, measure)}};
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

Json heat_maps_json(const std::vector<HeatMap>& maps, Measure measure) {
    const HeatScale& scale = row_of(measure).heat;
    Json pictures = Json::array();
    for (const HeatMap& map : maps)
        pictures.push_back({{"setting", map.setting},
                            {"level", map.level},
                            {"camera", map.camera + 1},
                            {"rms", rounded(map.rms)},
                            {"png", hexadecimal(map.png)}});
    return {{"least", scale.least_text}, {"greatest", scale.greatest_text}, {"pictures", pictures}};
}

Json dial_json(const Report& report, std::size_t index) {
    const Configurations::DialRows& rows = report.configurations.dials[index];
    const Dial& dial = *rows.dial;
    Json settings = Json::array();
    for (const Configurations::Row& row : rows.rows) settings.push_back(setting_json(report, row, rows.measure));
    return {{"name", dial.name},
            {"about", dial.about},
            {"unit", dial.unit},
            {"read_in", dial.read_in},
            {"others_stand_at", rows.base},
            {"alone_stands_at", rows.is_below_bound ? "default with perspective=exact" : rows.base},
            {"floor", error_json(floor_of(report, rows), rows.measure)},
            {"settings", settings},
            {"notes", notes_on_order(report, rows)},
            {"error_is", row_of(rows.measure).about},
            {"is_below_bound", rows.is_below_bound},
            {"is_of_surfaces", rows.measure == Measure::LightColour || rows.measure == Measure::PixelColour},
            {"heat_maps", heat_maps_json(report.heat_maps[index], rows.measure)}};
}

Json run_json(const Report& report) {
    Json levels = Json::array();
    for (const LevelSummary& level : report.levels)
        levels.push_back({{"name", level.name},
                          {"about", level.about},
                          {"cameras", level.cameras},
                          {"faces", level.faces},
                          {"close_calls_per_mille", rounded(level.close_calls_per_mille)}});
    const SkyTimes& sky = report.times.sky;
    return {{"levels", levels},
            {"frames", report.frames},
            {"configurations", report.results.size()},
            {"default_configuration", report.configurations.default_index},
            {"pixel_bound", Accuracy{}.pixel_bound_256 / 256.0},
            {"mode", std::to_string(kMeasuredMode.width_px) + "x" + std::to_string(kMeasuredMode.height_px)},
            {"rounds", report.times.rounds},
            {"share_of_processor", rounded(report.times.share_of_processor)},
            {"rays_a_pixel", report.samples_per_axis * report.samples_per_axis},
            {"quick", report.is_quick},
            {"machine", report.machine},
            {"compiler", report.compiler},
            {"seconds", rounded(report.seconds)},
            {"sky",
             {{"frames", sky.frames},
              {"nanoseconds_with", std::round(sky.with_sky)},
              {"nanoseconds_without", std::round(sky.without)}}}};
}

}  // namespace

std::string report_json(const Report& report) {
    Json json{{"dials", Json::array()}, {"tiers", Json::array()}, {"frontier", Json::array()}};
    for (std::size_t i = 0; i < report.configurations.dials.size(); ++i) json["dials"].push_back(dial_json(report, i));
    for (const Configurations::Row& preset : report.configurations.presets)
        json["tiers"].push_back(setting_json(report, preset, Measure::Displacement));
    for (const Configurations::Row& combination : report.configurations.frontier)
        json["frontier"].push_back(setting_json(report, combination, Measure::Displacement));
    json["notes"] = notes_on_presets(report);
    json["run"] = run_json(report);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";  // a file's name may be invalid UTF-8
}

std::string report_page(std::string json) {
    for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;)
        json.replace(at, 1, "\\u003c");  // or "</script>" in a name would end the script
    std::string page(kPage);
    constexpr std::string_view kPlace = "REPORT";
    return page.replace(page.find(kPlace), kPlace.size(), json);
}

std::string preset_table(const Report& report) {
    std::string table =
        "| preset | texels out of place, pixels: rms | largest | pixels of a wrong face, of 1,000 | 386 at 33 | 486 at "
        "66 | Pentium at 90 MHz |\n|---|---|---|---|---|---|---|\n";
    for (const Configurations::Row& preset : report.configurations.presets) {
        const SettingResult& result = report.results[preset.index];
        const bool is_default = preset.index == report.configurations.default_index;
        table += is_default ? "| **" + preset.name + "** |" : "| " + preset.name + " |";
        const auto add = [&](double value) { table += " " + number_text(value) + " |"; };
        add(item(result.errors, Measure::Displacement).rms);
        add(item(result.errors, Measure::Displacement).max);
        add(item(result.errors, Measure::WrongPixels).rms);
        for (const Processor processor : kProcessors) add(frame_rate(processor, result.cost));
        table += "\n";
    }
    return table;
}

std::string with_table(const std::string& page, const std::string& file, const std::string& table) {
    const std::string begin = "<!-- oblong-accuracy -->\n", end = "<!-- end -->";
    const std::size_t first = page.find(begin), last = page.find(end, first);
    if (first == std::string::npos || last == std::string::npos)
        throw InputError(
            file, "lines '<!-- oblong-accuracy -->' and '<!-- end -->' are missing, expected a table between them");
    return page.substr(0, first + begin.size()) + table + page.substr(last);
}

}  // namespace oblong
