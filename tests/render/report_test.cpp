#include <nlohmann/json.hpp>

#include "tests/bad_input/run_program.h"

// What oblong-render says of its frames.
namespace oblong::test {
namespace {

using Json = nlohmann::json;

const std::string kLevel = OBLONG_BUILD_DIR "/assets/demo.bsp";

class Report : public testing::Test {
  protected:
    /// All of standard output, as JSON.
    Json report(const std::vector<std::string>& more) {
        std::vector<std::string> words{
            "oblong-render", kLevel, "--cameras", OBLONG_SOURCE_DIR "/assets/demo_cameras.csv", "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run_program(words, folder_.path("output"));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        const Bytes output = read_file_bytes(folder_.path("output"));
        return Json::parse(output.begin(), output.end());
    }
    TemporaryFolder folder_;
};

TEST_F(Report, SaysWhatWasAskedFor) {
    const Json json = report({"--display", "16:9", "--fov", "72.5", "--texel-error", "0.5", "--effects", "sky,liquid"});
    EXPECT_EQ(json.at("mode"), "320x200");
    EXPECT_EQ(json.at("display"), "16:9");
    EXPECT_EQ(json.at("field_of_view"), 72.5);
    EXPECT_EQ(json.at("accuracy"), "bounded");
    EXPECT_EQ(json.at("texel_error"), 0.5);
    EXPECT_EQ(json.at("allowed_effects"), (std::vector<std::string>{"sky", "liquid"}));
}

TEST_F(Report, SaysTheDefaults) {
    const Json json = report({"--accuracy", "1996"});
    EXPECT_EQ(json.at("display"), "4:3");
    EXPECT_EQ(json.at("field_of_view"), 90);
    EXPECT_EQ(json.at("texel_error"), nullptr);
    EXPECT_EQ(json.at("allowed_effects"), (std::vector<std::string>{"sky", "liquid", "brush_models"}));
    EXPECT_EQ(report({}).at("texel_error"), 0.375);
}

TEST_F(Report, GivesNoTimeThatWasNotMeasured) {
    std::size_t effects = 0;
    for (const Json& frame : report({"--repeat", "2"}).at("frames")) {
        EXPECT_GT(frame.at("microseconds"), 0);
        for (const Json& effect : frame.at("effects")) EXPECT_EQ(effect.at("microseconds"), nullptr);
        effects += frame.at("effects").size();
    }
    EXPECT_GT(effects, 0u);
}

}  // namespace
}  // namespace oblong::test
