#include "tools/accuracy/report_html.h"

#include <algorithm>

#include "tools/accuracy/base64.h"
#include "tools/accuracy/charts.h"
#include "tools/accuracy/heat_map.h"
#include "tools/accuracy/notes.h"
#include "tools/accuracy/numbers.h"
#include "tools/accuracy/page_style.h"
#include "tools/accuracy/svg.h"

namespace oblong {

namespace {

std::string paragraph(const std::string& words, const std::string& css_class = "") {
    return "<p" + (css_class.empty() ? "" : " class=\"" + css_class + "\"") + ">" + escaped(words) + "</p>\n";
}

/// A table; the first cell of a row names it.
class HtmlTable {
  public:
    explicit HtmlTable(const std::vector<std::string>& headings) {
        for (const std::string& heading : headings) text_ += "<th>" + escaped(heading) + "</th>";
        text_ = "<div class=\"scroll\"><table><thead><tr>" + text_ + "</tr></thead><tbody>\n";
    }
    void add(const std::vector<std::string>& cells, bool is_default = false) {
        text_ += is_default ? "<tr class=\"default\">" : "<tr>";
        for (const std::string& cell : cells) text_ += "<td>" + escaped(cell) + "</td>";
        text_ += "</tr>\n";
    }
    std::string str() const { return text_ + "</tbody></table></div>\n"; }

  private:
    std::string text_;
};

const SettingResult& result_of(const Report& report, const Configurations::Row& row) {
    return report.results[row.index];
}

/// "412 (405-420)": microseconds with quartiles.
std::string time_text(const std::optional<TimeSpread>& time) {
    if (!time) return "modelled";
    return number_text(time->median / 1000) + " (" + number_text(time->low / 1000) + "\u2013" +
           number_text(time->high / 1000) + ")";
}

std::string rate_text(Processor processor, double cycles) {
    return number_text(frame_rate(processor, cycles));
}

const Configurations::Row& preset(const Report& report, std::string_view name) {
    const auto& presets = report.configurations.presets;
    return *std::find_if(presets.begin(), presets.end(), [&](const auto& row) { return row.name == name; });
}

double preset_time(const Report& report, std::string_view name) {
    return report.times.settings[preset(report, name).index]->frame.median;
}

/// The answer of the first screen, in words.
std::string answer(const Report& report) {
    const auto rms = [&](std::string_view name) {
        return number_text(result_of(report, preset(report, name)).errors.displacement.rms);
    };
    const double bound = Accuracy{}.pixel_bound_256 / 256.0;
    const double furthest = result_of(report, preset(report, "bounded")).errors.displacement.max;
    return "A texel is out of its place by " + rms("1994") +
           " pixels (rms) where spans are drawn without perspective, " + rms("1996") +
           " with a division every 16 pixels, " + rms("bounded") + " where the error is bounded, and " + rms("exact") +
           " with a division a pixel. On this machine a frame takes " + microseconds_text(preset_time(report, "1994")) +
           ", " + microseconds_text(preset_time(report, "1996")) + ", " +
           microseconds_text(preset_time(report, "bounded")) + " and " +
           microseconds_text(preset_time(report, "exact")) + ": to bound the error costs " +
           number_text(preset_time(report, "bounded") / preset_time(report, "1996")) +
           " times a division every 16, to leave none " +
           number_text(preset_time(report, "exact") / preset_time(report, "1996")) +
           " times. The default is bounded: no further off than " + number_text(bound) +
           " pixel by its rule, and by measurement " + number_text(furthest) + " at most" +
           (furthest <= bound + 1.0 / 256 ? "." : ", which is more than the rule allows.");
}

std::string first_screen(const Report& report) {
    std::string page = "<header>\n<h1>What does accuracy cost?</h1>\n" + paragraph(answer(report)) + "</header>\n";
    page += "<figure>\n" + tradeoff_chart(report, CostAxis::Here, 760, "wide") +
            tradeoff_chart(report, CostAxis::Here, 380, "narrow") +
            "<figcaption>Each dot is a setting in all frames of this report: large and named, the presets; small, the "
            "default with one dial turned. Below and left is better. No setting is both closer and faster than those "
            "on the dashed line. Both scales are logarithmic.</figcaption>\n</figure>\n";
    return page;
}

std::string preset_table(const Report& report) {
    HtmlTable table({"preset", "rms, pixels", "99th percentile", "largest", "wrong pixels, \u2030",
                     "\u00b5s here (quartiles)", "frames/s: 386", "486", "Pentium"});
    for (const Configurations::Row& row : report.configurations.presets) {
        const SettingResult& result = result_of(report, row);
        const ErrorSummary& error = result.errors.displacement;
        std::vector<std::string> cells{row.name,
                                       number_text(error.rms),
                                       number_text(error.p99),
                                       number_text(error.max),
                                       number_text(result.errors.wrong.rms),
                                       time_text(report.times.settings[row.index]->frame)};
        for (std::size_t i = 0; i < kProcessors.size(); ++i)
            cells.push_back(rate_text(kProcessors[i], result.cost.cycles[i]));
        table.add(cells, row.index == report.configurations.default_index);
    }
    return table.str();
}

std::string level_table(const Report& report) {
    std::vector<std::string> headings{"frames of"};
    for (const Configurations::Row& row : report.configurations.presets) headings.push_back(row.name);
    HtmlTable table(headings);
    for (std::size_t i = 0; i < report.levels.size(); ++i) {
        std::vector<std::string> cells{report.levels[i].name};
        for (const Configurations::Row& row : report.configurations.presets) {
            const ErrorSummary& error = result_of(report, row).by_level[i].displacement;
            cells.push_back(number_text(error.rms) + " / " + number_text(error.max));
        }
        table.add(cells);
    }
    return table.str();
}

std::string presets_section(const Report& report) {
    std::string page = "<h2 id=\"presets\">The presets, here and on processors of their time</h2>\n";
    page += paragraph(
        "Frames a second on a 386 at 33 MHz, a 486 at 66 and a Pentium at 90 are modelled: the operations of each "
        "stage are counted by the code that does them and weighed by the processors' published instruction times, "
        "without jumps, waiting for memory or a Pentium's two pipelines.");
    page += preset_table(report);
    for (const std::string& note : notes_on_presets(report)) page += paragraph(note, "note");
    page += "<figure>\n" + tradeoff_chart(report, CostAxis::I486, 760, "wide") +
            tradeoff_chart(report, CostAxis::I486, 380, "narrow") +
            "<figcaption>The same settings by what they would cost on a 486 at 66 MHz (modelled).</figcaption>\n"
            "</figure>\n";
    page += paragraph("How far texels are out of place in each level, rms / largest, pixels:");
    return page + level_table(report);
}

std::string dial_table(const Report& report, const Configurations::DialRows& dial) {
    std::vector<std::string> headings{"setting", "rms", "99th percentile", "largest"};
    if (dial.measure == Measure::Displacement) headings.push_back("rms, texels");
    if (dial.is_below_bound) headings.insert(headings.end(), {"alone: rms", "alone: largest"});
    if (dial.measure == Measure::WrongPixels) headings.push_back("close calls, \u2030");
    headings.insert(headings.end(), {"\u00b5s (quartiles)", "486, ms", "multiplications", "divisions", "look-ups"});
    HtmlTable table(headings);
    for (const Configurations::Row& row : dial.rows) {
        const SettingResult& result = result_of(report, row);
        const ErrorSummary& error = summary_of(result.errors, dial.measure);
        std::vector<std::string> cells{row.name, number_text(error.rms), number_text(error.p99),
                                       number_text(error.max)};
        if (dial.measure == Measure::Displacement) cells.push_back(number_text(result.errors.texels.rms));
        const ErrorSummary& alone = summary_of(report.results[row.alone].errors, dial.measure);
        if (dial.is_below_bound) cells.insert(cells.end(), {number_text(alone.rms), number_text(alone.max)});
        if (dial.measure == Measure::WrongPixels) cells.push_back(number_text(result.errors.close_calls.rms));
        const Operations& operations = is_about_surfaces(dial.measure) ? result.cost.lighting : result.cost.operations;
        cells.insert(cells.end(),
                     {time_text(time_of(report, dial, row)), number_text(milliseconds_of(report, dial, row)),
                      number_text(static_cast<double>(operations.multiplications.total())),
                      number_text(static_cast<double>(operations.divisions.total())),
                      number_text(static_cast<double>(operations.lookups))});
        table.add(cells, row.index == report.configurations.default_index);
    }
    return table.str();
}

std::string heat_map(const HeatMap& map) {
    const std::string words =
        map.setting + ", " + map.level + ", camera " + std::to_string(map.camera + 1) + ": rms " + number_text(map.rms);
    return "<figure><img alt=\"" + escaped("Errors of " + words) + "\" src=\"data:image/png;base64," + base64(map.png) +
           "\"><figcaption>" + escaped(words) + "</figcaption></figure>\n";
}

std::string heat_maps(const std::vector<HeatMap>& maps, Measure measure) {
    if (maps.front().rms == 0) return paragraph("No pixel of any frame is off by this measure: no map.", "soft");
    const HeatScale scale = heat_scale(measure);
    std::string page = "<div class=\"maps\">\n";
    for (const HeatMap& map : maps) page += heat_map(map);
    return page + "</div>\n<div class=\"heat\"><span>" + escaped(scale.least_text) +
           "</span><span class=\"bar\"></span><span>" + escaped(scale.greatest_text) +
           "</span><span class=\"none\"></span><span>not measured</span></div>\n";
}

std::string kind_of_time(const Configurations::DialRows& dial) {
    if (!dial.dial->changes_work)
        return "Its settings round to fewer bits in a wide type: their errors are real, what narrow types would cost "
               "is "
               "modelled from counted operations, and there is no time to measure.";
    if (is_about_surfaces(dial.measure))
        return "Its settings run other code. Time and operations are of frames that build all their lit surfaces anew: "
               "that is where they differ.";
    return "Its settings run other code: times are measured, of frames whose lit surfaces are built already.";
}

std::string dial_section(const Report& report, std::size_t index) {
    const Configurations::DialRows& rows = report.configurations.dials[index];
    const Dial& dial = *rows.dial;
    std::string page = "<h3 id=\"" + escaped(dial.name) + "\"><code>" + escaped(dial.name) + "</code></h3>\n";
    page += paragraph(std::string(dial.about) + " " + summary_of_dial(report, rows) + " " + kind_of_time(rows));
    page += paragraph("Error: " + std::string(about(rows.measure)) + " Other dials: " + rows.base + ". Read in " +
                          std::string(dial.read_in) + ".",
                      "soft");
    if (const std::string note = note_on_floor(report, rows); !note.empty()) page += paragraph(note, "note");
    for (const std::string& note : notes_on_order(report, rows)) page += paragraph(note, "note");
    page += "<figure>\n" + dial_chart(report, rows) + "</figure>\n" + dial_table(report, rows);
    return page + heat_maps(report.heat_maps[index], rows.measure);
}

std::string dials_section(const Report& report) {
    std::string page = "<h2 id=\"dials\">Each dial</h2>\n<nav>\n";
    for (const Configurations::DialRows& dial : report.configurations.dials)
        page += "<a href=\"#" + escaped(dial.dial->name) + "\">" + escaped(dial.dial->name) + "</a>\n";
    page += "</nav>\n" + paragraph(
                             "Turned alone, the others as the default has them, from the coarsest setting to the most "
                             "exact. The default's row "
                             "is bold. A black line on a bar of time spans the quartiles.");
    for (std::size_t i = 0; i < report.configurations.dials.size(); ++i) page += dial_section(report, i);
    return page;
}

/// What the sky and the building of surfaces take, which the other times leave out or hide.
std::string apart_text(const Report& report) {
    const SettingTimes& plain = *report.times.settings[report.configurations.default_index];
    const SkyTimes& sky = report.times.sky;
    std::string text = "Apart: a frame of the default takes " + microseconds_text(plain.frame.median) +
                       "; if it has to build all its lit surfaces, " + microseconds_text(plain.unlit->median) + ".";
    if (sky.frames == 0) return text + " No frame shows a sky.";
    return text + " In the " + std::to_string(sky.frames) + " frames that show a sky, it takes " +
           microseconds_text(sky.with_sky - sky.without) + " of " + microseconds_text(sky.with_sky) + ".";
}

std::string run_section(const Report& report) {
    const bool counts_instructions =
        report.times.settings[report.configurations.default_index]->instructions.has_value();
    std::string page = "<h2 id=\"run\">What ran</h2>\n";
    page +=
        paragraph(std::to_string(report.frames) + " frames of 320x200 for 4:3, each by " +
                  std::to_string(report.results.size()) + " settings. Times: " + std::to_string(report.times.rounds) +
                  " rounds, in each of which every setting draws every frame once, in turn, after an untimed drawing "
                  "that warms the caches; the median of each frame's times, then the mean over frames; quartiles "
                  "likewise. Nothing is counted or recorded while a time is taken. " +
                  (report.is_quick ? "This was a quick run: fewer cameras, fewer rounds." : ""));
    page += paragraph("Machine: " + report.machine + ". Compiler: " + report.compiler + ". Instructions: " +
                      (counts_instructions ? "counted (accuracy.json)" : "not counted here, for want of a counter") +
                      ". The whole took " + number_text(report.seconds) + " seconds.");
    page += paragraph(apart_text(report));
    page += paragraph(
        "Errors are measured against a reference renderer in double precision with exact coverage, which shares no "
        "arithmetic with the engine. Pixels in which an edge passes within 1/512 pixel of the centre are close calls "
        "and "
        "not counted as wrong. Mean colours are of " +
        std::to_string(report.samples_per_axis * report.samples_per_axis) + " rays a pixel.");
    HtmlTable table({"level", "cameras", "faces", "close calls, \u2030"});
    for (const LevelSummary& level : report.levels)
        table.add({level.name, std::to_string(level.cameras), std::to_string(level.faces),
                   number_text(level.close_calls_per_mille)});
    page += table.str();
    page += "<ul>\n";
    for (const LevelSummary& level : report.levels)
        if (!level.about.empty()) page += "<li>" + escaped(level.name + ": " + level.about) + "</li>\n";
    return page + "</ul>\n";
}

}  // namespace

std::string report_html(const Report& report) {
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>What does accuracy cost?</title>\n<style>";
    page.append(kPageStyle).append("</style>\n</head>\n<body>\n");
    page += first_screen(report) + presets_section(report) + dials_section(report) + run_section(report);
    return page + "</body>\n</html>\n";
}

}  // namespace oblong
