#include "tools/accuracy/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/accuracy/scenes_fixture.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/programs.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/errors.h"

namespace oblong::test {

namespace {

using Json = nlohmann::json;

/// A small report: one frame, one round.
Report small_report() {
    const Scenes scenes(1);
    const std::vector<MeasuredPlace> places{scenes.place("rotating sphere")};
    return measure_all(make_configurations(all_dials()), places, {1, 1, true});
}

/// Comparing them as numbers takes less of the compiler than as JSON.
double number(const Json& json) {
    return json.get<double>();
}

void expect_setting(const Json& setting) {
    SCOPED_TRACE(setting["name"]);
    for (const char* key : {"unit", "rms", "p99", "max"}) EXPECT_TRUE(setting["error"].contains(key)) << key;
    EXPECT_LE(number(setting["error"]["rms"]), number(setting["error"]["max"]));
    EXPECT_LE(number(setting["error"]["p99"]), number(setting["error"]["max"]));
    const Json& cost = setting["cost"];
    EXPECT_GT(number(cost["operations"]["textured pixels"]) + number(cost["operations"]["exact pixels"]), 10000);
    EXPECT_GT(number(cost["instructions"]), 64000) << "one a pixel at least";
    EXPECT_GT(number(cost["instructions_486"]), number(cost["instructions"]));
    EXPECT_GT(number(cost["cycles_486"]), number(cost["instructions_486"]));
    EXPECT_GT(number(cost["cycles_486"]), number(cost["cycles_pentium"]));
    EXPECT_GT(number(cost["cycles_386"]), number(cost["cycles_486"]));
    EXPECT_EQ(setting["time"], "measured");
    EXPECT_GT(number(cost["nanoseconds"]), 0);
}

void expect_dial(const Json& found, const Dial& dial) {
    SCOPED_TRACE(dial.name);
    EXPECT_EQ(found["name"], dial.name);
    ASSERT_EQ(found["settings"].size(), dial.settings.size());
    for (std::size_t k = 0; k < dial.settings.size(); ++k) {
        EXPECT_EQ(found["settings"][k]["name"], dial.settings[k].name);
        expect_setting(found["settings"][k]);
        EXPECT_TRUE(found["settings"][k]["alone"].contains("rms"));
    }
    // The most exact setting alone is what no setting goes below.
    const Json& floor = found["floor"];
    const bool has_own = floor["unit"] == "pixels" && dial.name.find("bound") == std::string_view::npos;
    if (has_own) {
        EXPECT_EQ(found["settings"].back()["alone"], floor);
    }
}

void expect_every_dial_and_tier(const Json& json) {
    ASSERT_EQ(json["dials"].size(), all_dials().size());
    for (std::size_t i = 0; i < all_dials().size(); ++i) expect_dial(json["dials"][i], all_dials()[i]);
    std::vector<std::string> names;
    for (const Json& tier : json["tiers"]) {
        names.push_back(tier["name"]);
        EXPECT_EQ(tier["error"]["unit"], "pixels");
        expect_setting(tier);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"1991", "1994", "1996", "pixel", "bounded", "exact"}));
}

/// What is counted or compared, without times.
Json without_times(const Json& report) {
    Json counted;
    for (const Json& dial : report["dials"])
        for (const Json& setting : dial["settings"])
            counted.push_back({setting["error"], setting["errors"], setting["cost"]["operations"],
                               setting["cost"]["lighting_operations"], setting["cost"]["cycles_486"]});
    return counted;
}

/// By the page's own script; false without a program that runs it.
bool expect_page(const std::string& json) {
    if (std::system("command -v node >/dev/null") != 0) return false;
    const TemporaryFolder folder;
    folder.write("accuracy.json", json);
    folder.write("accuracy.html", report_page(json));
    const std::string command = "node '" + source_folder() + "/tests/accuracy/page_test.js' '" + folder.path() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return true;
}

TEST(AccuracyReport, HasEveryDialAndTierInItsFileAndOnItsPageAndTheSameCountsOnEveryRun) {
    const std::string text = report_json(small_report());
    const Json json = Json::parse(text);
    expect_every_dial_and_tier(json);
    EXPECT_EQ(without_times(json), without_times(Json::parse(report_json(small_report()))));
    if (!expect_page(text)) GTEST_SKIP() << "no node: the page is not tested";
}

TEST(AccuracyPage, HasTheReportInItWhateverItsNamesAre) {
    const std::string json = R"({"name": "a</script><!--\"b\" REPORT"})", opening = "id=\"report\">";
    const std::string page = report_page(json);
    const std::size_t begin = page.find(opening) + opening.size(), end = page.find("</script>", begin);
    EXPECT_EQ(Json::parse(page.substr(begin, end - begin)), Json::parse(json));
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
}

// The report's parts, each alone.

TEST(Configurations, AreAllDialsAloneAroundTheDefaultAndThePresets) {
    const Configurations all = make_configurations(all_dials());
    EXPECT_EQ(all.accuracies[all.default_index], Accuracy{});
    EXPECT_EQ(all.presets.size(), kPresets.size());
    for (const Configurations::DialRows& rows : all.dials)
        for (std::size_t i = 0; i < rows.rows.size(); ++i) {
            Accuracy expected;
            if (rows.dial->name == "texel-bound") expected.texturing = Texturing::BoundedTexels;
            rows.dial->set(expected, rows.dial->settings[i].value);
            EXPECT_EQ(all.accuracies[rows.rows[i].index], expected) << rows.dial->name << '=' << rows.rows[i].name;
            EXPECT_TRUE(all.has_cost[rows.rows[i].index]);
            if (rows.is_below_bound) expected.texturing = Texturing::Exact;
            EXPECT_EQ(all.accuracies[rows.rows[i].alone], expected) << rows.dial->name << '=' << rows.rows[i].name;
        }
}

/// A report of one dial whose settings have these errors.
Report report_with(std::vector<ErrorSummaries> errors) {
    Report report;
    report.configurations = make_configurations(std::span(dial_named("sine"), 1));
    report.results.resize(report.configurations.accuracies.size());
    for (std::size_t i = 0; i < errors.size(); ++i)
        report.results[report.configurations.dials[0].rows[i].alone].errors = errors[i];
    return report;
}

ErrorSummaries displaced(double rms, double max, double texels = 1) {
    ErrorSummaries errors;
    item(errors, Measure::Displacement) = {1, rms, rms, max};
    item(errors, Measure::Texels) = {1, texels, texels, texels};
    return errors;
}

TEST(Notes, SayWhereMoreAccuracyIsFurtherOffAndWhy) {
    const Report report = report_with({displaced(2, 3), displaced(1, 4), displaced(1.01, 5), displaced(1.5, 6, 0.5),
                                       displaced(1.8, 5), displaced(0.1, 0.2)});
    const std::vector<std::string> notes = notes_on_order(report, report.configurations.dials[0]);
    ASSERT_EQ(notes.size(), 2u) << "one for 1.01 to 1.5, one for 1.5 to 1.8; 1 per cent is none";
    EXPECT_NE(notes[0].find("quarter1024 is further off than cordic16"), std::string::npos) << notes[0];
    EXPECT_NE(notes[0].find("By texels it is closer"), std::string::npos) << notes[0];
    EXPECT_NE(notes[1].find("Its largest error is smaller"), std::string::npos) << notes[1];
}

TEST(Numbers, HaveThreeDigits) {
    for (const auto& [number, text] : {std::pair{0.0, "0"},
                                       {0.0213456, "0.0213"},
                                       {0.1, "0.100"},
                                       {375.4, "375"},
                                       {12446, "12,400"},
                                       {-12446789, "-12,400,000"},
                                       {0.000001, "below 0.00001"},
                                       {9.999, "10.0"},
                                       {999.7, "1,000"}})
        EXPECT_EQ(number_text(number), text);
}

TEST(HeatMap, BrightensWithTheLogarithmOfTheError) {
    const std::vector<std::uint8_t> pixels = heat_pixels({-1, 0, 1.0F / 256, 0.5F, 64, 1000}, Measure::Displacement);
    EXPECT_EQ(pixels, (std::vector<std::uint8_t>{0, 1, 1, 128, 255, 255}));
    const Palette palette = heat_palette();
    int before = -1;
    for (std::size_t i = 1; i < 256; ++i) {
        EXPECT_GE(luminance_1000(palette.colours[i]), before) << i;
        before = luminance_1000(palette.colours[i]);
    }
}

// The program's answers to wrong usage and bad input, all before it measures anything.

TEST(AccuracyProgram, RefusesALevelWithoutCamerasAndCamerasWithoutALevel) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"oblong-accuracy", "level.bsp"},
                                                  {"oblong-accuracy", "--cameras", "cameras.csv"},
                                                  {"oblong-accuracy", "--palette", "palette.lmp"},
                                                  {"oblong-accuracy", "--out", ""},
                                                  {"oblong-accuracy", "--slow"}}) {
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.exit_code, 2) << words.back();
        EXPECT_NE(outcome.error, "");
    }
}

/// The tiny level's floor is at z = 8, solid below.
TEST(AccuracyProgram, NamesTheFileTheCameraAndTheFolderThatItCannotUse) {
    const TemporaryFolder folder;
    const std::string text = folder.write("no_level.bsp", std::string("text")), missing = folder.path("missing.bsp"),
                      tiny = folder.write("tiny.bsp", join_lumps(29, make_tiny_lumps())), out = folder.path("out"),
                      cameras = folder.write("cameras.csv", std::string("x,y,z,yaw,pitch\n9,9,50,0,0\n9,9,0,0,0\n"));
    for (const auto& [level, to, named] : {std::array{text, out, text + ": "},
                                           {missing, out, missing + ": "},
                                           {tiny, out, tiny + ": camera 2: in a wall"},
                                           {tiny, text + "/out", text}}) {
        const Outcome outcome = run_program({"oblong-accuracy", "--quick", "--out", to, level, "--cameras", cameras});
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_EQ(outcome.error.find("oblong-accuracy: " + named), 0u) << outcome.error;
    }
}

/// Beside a palette that cannot be read, as the first thing that is measured would need it.
TEST(AccuracyProgram, NamesTheFileThatItCannotWriteBeforeItMeasures) {
    const TemporaryFolder folder;
    for (const char* name : {"bin", "assets", "out/accuracy.html"})
        std::filesystem::create_directories(folder.path(name));
    std::filesystem::copy_file(build_folder() + "/bin/oblong-accuracy", folder.path("bin/oblong-accuracy"));
    folder.write("assets/palette.lmp", std::string("text"));
    const std::string missing = folder.path("none/page.md"), page = folder.write("page.md", std::string("no table"));
    const auto run = [&](const std::string& words) { return run_line(folder.path("bin/oblong-accuracy") + words); };
    EXPECT_TRUE(names_fault(run(" --page " + missing), "oblong-accuracy", missing, "open: "));
    EXPECT_TRUE(names_fault(run(" --page " + page), "oblong-accuracy", page, "<!-- oblong-accuracy -->"));
    EXPECT_TRUE(names_fault(run(" --quick --out " + folder.path("out")), "oblong-accuracy",
                            folder.path("out/accuracy.html"), "is a folder"));
}

}  // namespace
}  // namespace oblong::test
