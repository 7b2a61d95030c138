#include "tools/accuracy/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/accuracy/scenes_fixture.h"
#include "tools/accuracy/report_html.h"
#include "tools/accuracy/report_json.h"

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

/// Follows tags; those that HTML leaves without an end are skipped.
class TagChecker {
  public:
    explicit TagChecker(const std::string& page) : page_(page) {}

    std::string first_fault() {
        for (std::size_t at = page_.find('<'); at != std::string::npos; at = page_.find('<', at + 1)) {
            const std::size_t end = page_.find('>', at);
            if (end == std::string::npos) return "a tag without an end";
            const std::string fault = follow(page_.substr(at + 1, end - at - 1));
            if (!fault.empty()) return fault;
        }
        return open_.empty() ? "" : "never closed: " + open_.back();
    }

  private:
    std::string follow(const std::string& tag) {
        const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
        if (tag[0] == '!' || tag.back() == '/' || name == "meta" || name == "img") return "";
        if (tag[0] != '/') {
            open_.push_back(name);
            return "";
        }
        if (open_.empty() || "/" + open_.back() != tag)
            return "<" + tag + "> closes <" + (open_.empty() ? "" : open_.back()) + ">";
        open_.pop_back();
        return "";
    }

    const std::string& page_;
    std::vector<std::string> open_;
};

/// The values of an attribute.
std::vector<std::string> values_of(const std::string& attribute, const std::string& page) {
    std::vector<std::string> values;
    const std::string opening = " " + attribute + "=\"";
    for (std::size_t at = page.find(opening); at != std::string::npos; at = page.find(opening, at + 1)) {
        const std::size_t start = at + opening.size();
        values.push_back(page.substr(start, page.find('"', start) - start));
    }
    return values;
}

void expect_no_other_file(const std::string& page) {
    const std::vector<std::string> ids = values_of("id", page), sources = values_of("src", page);
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
    EXPECT_GE(sources.size(), 20u);
    for (const std::string& source : sources) EXPECT_TRUE(source.starts_with("data:image/png;base64,iVBORw0KGgo"));
    for (const std::string& link : values_of("href", page)) {
        ASSERT_TRUE(link.starts_with("#")) << link;
        EXPECT_TRUE(std::count(ids.begin(), ids.end(), link.substr(1))) << link;
    }
    for (const char* outside : {"http", "url(", "@import", "<script", "<link"})
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

void expect_section(const Dial& dial, const std::string& page) {
    const std::size_t section = page.find("<h3 id=\"" + std::string(dial.name) + "\"");
    ASSERT_NE(section, std::string::npos) << dial.name;
    const std::string text = page.substr(section, page.find("<h3", section + 1) - section);
    EXPECT_EQ(text.find("<td>modelled</td>") != std::string::npos, !dial.changes_work) << dial.name;
    EXPECT_NE(text.find("<svg class=\"dial\""), std::string::npos) << dial.name;
    const bool has_map = text.find("<img") != std::string::npos;
    EXPECT_NE(has_map, text.find("off by this measure: no map") != std::string::npos) << dial.name;
}

TEST(AccuracyHtml, IsOneWholePageWithEveryDialThatSaysWhatIsModelled) {
    const std::string page = report_html(small_report());
    EXPECT_EQ(TagChecker(page).first_fault(), "");
    expect_no_other_file(page);
    for (const Dial& dial : all_dials()) expect_section(dial, page);
}

}  // namespace
}  // namespace oblong::test
