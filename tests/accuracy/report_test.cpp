#include "tools/accuracy/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/accuracy/scenes_fixture.h"
#include "tools/accuracy/report_files.h"

namespace oblong::test {
namespace {

using Json = nlohmann::json;

Report measure(const Scenes& scenes) {
    const std::vector<MeasuredPlace> places{scenes.place("rotating sphere")};
    Progress progress(false);
    return measure_all(make_configurations(all_dials()), places, {1, 1, true}, progress);
}

/// A small report: one frame, one round.
Report small_report() {
    return measure(Scenes(1));
}

void expect_setting(const Json& setting) {
    SCOPED_TRACE(setting["name"]);
    for (const char* key : {"unit", "rms", "p99", "max"}) EXPECT_TRUE(setting["error"].contains(key)) << key;
    EXPECT_LE(setting["error"]["rms"], setting["error"]["max"]);
    EXPECT_LE(setting["error"]["p99"], setting["error"]["max"]);
    const Json& cost = setting["cost"];
    EXPECT_GT(cost["operations"]["adds"]["64"], 0);
    EXPECT_GT(cost["stages"]["pixels"], 10000);
    EXPECT_GT(cost["cycles_486"], cost["cycles_pentium"]);
    EXPECT_GT(cost["cycles_386"], cost["cycles_486"]);
    const bool is_measured = setting["time"] == "measured";
    EXPECT_TRUE(is_measured || setting["time"] == "modelled");
    EXPECT_EQ(cost["nanoseconds"].is_number(), is_measured) << "a time of code that does not run is made up";
}

void expect_dial(const Json& found, const Dial& dial) {
    SCOPED_TRACE(dial.name);
    EXPECT_EQ(found["name"], dial.name);
    ASSERT_EQ(found["settings"].size(), dial.settings.size());
    for (std::size_t k = 0; k < dial.settings.size(); ++k) {
        EXPECT_EQ(found["settings"][k]["name"], dial.settings[k].name);
        EXPECT_EQ(found["settings"][k]["time"], dial.changes_work ? "measured" : "modelled");
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

TEST(AccuracyJson, HasEveryDialWithItsSettingsAndTheFiveTiers) {
    const Json json = Json::parse(report_json(small_report()));
    ASSERT_EQ(json["dials"].size(), all_dials().size());
    for (std::size_t i = 0; i < all_dials().size(); ++i) expect_dial(json["dials"][i], all_dials()[i]);
    std::vector<std::string> names;
    for (const Json& tier : json["tiers"]) {
        names.push_back(tier["name"]);
        EXPECT_EQ(tier["time"], "measured");
        EXPECT_EQ(tier["error"]["unit"], "pixels");
        expect_setting(tier);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"1991", "1994", "1996", "bounded", "exact"}));
}

/// What is counted or compared, without times.
Json without_times(const Report& report) {
    Json json = Json::parse(report_json(report));
    Json counted;
    for (const Json& dial : json["dials"])
        for (const Json& setting : dial["settings"])
            counted.push_back({setting["error"], setting["errors"], setting["cost"]["operations"],
                               setting["cost"]["lighting_operations"], setting["cost"]["cycles_486"]});
    return counted;
}

TEST(AccuracyJson, ErrorsAndOperationsAreTheSameOnEveryRun) {
    EXPECT_EQ(without_times(small_report()), without_times(measure(Scenes(1))));
}

/// What the page's script makes of it is tested by page_test.js.
TEST(AccuracyPage, HasTheReportInItWhateverItsNamesAre) {
    const std::string json = R"({"name": "a</script><!--\"b\" REPORT"})", opening = "id=\"report\">";
    const std::string page = report_page(json);
    const std::size_t begin = page.find(opening) + opening.size(), end = page.find("</script>", begin);
    EXPECT_EQ(Json::parse(page.substr(begin, end - begin)), Json::parse(json));
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
}

}  // namespace
}  // namespace oblong::test
