#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/input_error.h"
#include "engine/programs/arguments.h"
#include "engine/scene/level_effects.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"
#include "tests/support/programs.h"
#include "tests/support/refusal.h"
#include "tools/render/camera_list.h"

namespace oblong::test {
namespace {

// What oblong-render says of its frames.

using Json = nlohmann::json;

const std::string kLevel = test::build_folder() + "/assets/demo.bsp";

class Report : public testing::Test {
  protected:
    /// All of standard output, as JSON.
    Json report(const std::vector<std::string>& more, const std::string& level = kLevel,
                const std::string& cameras = test::source_folder() + "/assets/demo_cameras.csv") {
        std::vector<std::string> words{"oblong-render", level, "--cameras", cameras, "--json", "-"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run_program(words, folder_.path("output"));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        const auto output = read_file_bytes(folder_.path("output"));
        return Json::parse(output.begin(), output.end());
    }
    TemporaryFolder folder_;
};

TEST_F(Report, ThreadsChangeNothingButTheTime) {
    const Json one = report({}), three = report({"--threads", "3"});
    EXPECT_EQ(one.at("threads"), 1);
    EXPECT_EQ(three.at("threads"), 3);
    for (std::size_t i = 0; i < one.at("frames").size(); ++i) {
        EXPECT_EQ(three.at("frames")[i].at("crc32"), one.at("frames")[i].at("crc32"));
        EXPECT_EQ(three.at("frames")[i].at("counts"), one.at("frames")[i].at("counts"));
    }
}

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
    EXPECT_EQ(json.at("allowed_effects"), (std::vector<std::string>(kEffectNames.begin(), kEffectNames.end())));
    EXPECT_EQ(report({}).at("texel_error"), 0.375);
}

// Others draw over them.
constexpr std::array kPassesOfEachPixel{"walls", "flat", "liquid", "sky", "mirror"};

// A model is in the plan once a pixel of the box around it may be seen; all its triangles may be behind something even
// so.
bool owns_pixels(const Json& entry) {
    return entry.at("pixels") > 0 || entry.at("name") == "models";
}

TEST_F(Report, GivesThePassesThatMakeUpAFrame) {
    std::size_t effects = 0;
    const Json json = report({"--repeat", "2"});
    for (const Json& frame : json.at("frames")) {
        EXPECT_GT(frame.at("microseconds"), 0);
        std::int64_t pixels = 0;
        double sum = 0;
        for (const Json& pass : frame.at("passes")) {
            sum += pass.at("microseconds").get<double>();
            EXPECT_LE(pass.at("spread")[0], pass.at("spread")[1]);
            if (pass.at("name") == "walk" || pass.at("name") == "other") continue;
            EXPECT_TRUE(owns_pixels(pass)) << pass.at("name");
            EXPECT_GT(pass.at("microseconds"), 0);
            if (std::count(kPassesOfEachPixel.begin(), kPassesOfEachPixel.end(), pass.at("name").get<std::string>()))
                pixels += pass.at("pixels").get<std::int64_t>();
        }
        EXPECT_EQ(pixels, 320 * 200);
        EXPECT_NEAR(sum, frame.at("microseconds").get<double>(),
                    0.001 * static_cast<double>(frame.at("passes").size()));
        EXPECT_LE(frame.at("spread")[0], frame.at("microseconds"));
        EXPECT_GE(frame.at("spread")[1], frame.at("microseconds"));
        for (const Json& effect : frame.at("effects")) EXPECT_TRUE(owns_pixels(effect)) << effect.at("name");
        effects += frame.at("effects").size();
    }
    EXPECT_GT(effects, 0u);
}

/// With that option a frame reads no clock.
TEST_F(Report, WholeFramesHaveNoTimesOfPasses) {
    const Json json = report({"--repeat", "2", "--whole-frames"});
    for (const Json& frame : json.at("frames"))
        for (const Json& pass : frame.at("passes"))
            EXPECT_EQ(pass.at("microseconds"), pass.at("name") == "other" ? frame.at("microseconds") : Json(0.0));
}

// A brush model of 64 x 64 units squarely before the eye, 64 away. Across, 90 degrees show 128 units there on 320
// pixels, so it is 160 wide; each pixel is 1.2 times as tall as wide, so it reaches from 33.3 to 166.7 down: over 134
// centres.
TEST_F(Report, CountsThePixelsThatBrushModelsOwn) {
    const std::string map = test::level(room({-128, -128, -64}, {256, 128, 192}, 16, "stone_wall"),
                                        entity_at("info_player_start", {0, 0, 64}) +
                                            entity("func_wall", {}, box({64, -32, 32}, {80, 32, 96}, "stone_wall")));
    const std::string source = folder_.write("wall.map", map), level = folder_.path("wall.bsp");
    const Outcome compiled =
        run_program({"oblong-map", source, "-o", level, "--wad", test::build_folder() + "/assets/demo.wad"});
    ASSERT_EQ(compiled.exit_code, 0) << compiled.error;
    const std::string cameras =
        folder_.write("cameras.csv", std::string("x,y,z,yaw,pitch\n0,0,64,0,0\n0,0,64,180,0\n"));
    const Json frames = report({}, level, cameras).at("frames");
    const Json& effects = frames.at(0).at("effects");
    ASSERT_EQ(effects.size(), 1u);
    EXPECT_EQ(effects.at(0).at("name"), "brush_models");
    EXPECT_EQ(effects.at(0).at("pixels"), 160 * 134);
    EXPECT_EQ(frames.at(1).at("effects"), Json::array());
}

Camera camera_at(int x, int y, int z) {
    Camera camera;
    camera.eye = {World::from_int(x), World::from_int(y), World::from_int(z)};
    return camera;
}

ScreenPosition shown(const ViewSpec& view, int x, int y, int z) {
    const ViewContext context = make_view_context(view, {});
    return project(to_view({World::from_int(x), World::from_int(y), World::from_int(z)}, context), context.projection);
}

TEST(ViewOption, PutsEachCamerasPositionInTheMiddle) {
    for (const char* text : {"look-at:distance=100,yaw=30,pitch=-10", "front", "top:width=500", "side:front=-8,back=9",
                             "isometric:width=300,cut=40", "isometric:turn=90", "dimetric", "trimetric:width=64.5",
                             "cavalier:angle=30", "cabinet:base=top,angle=225,width=2000", "vrp", "vrp:parallel=1"}) {
        const ViewSpec view = checked_view(parse_view(text), camera_at(100, -200, 50), {}, "");
        const ScreenPosition middle = shown(view, 100, -200, 50);
        EXPECT_NEAR(std::ldexp(middle.x.raw, -8), 160, 0.05) << text;
        EXPECT_NEAR(std::ldexp(middle.y.raw, -8), 100, 0.05) << text;
    }
}

TEST(ViewOption, GivesTheViewThatItsKeysSay) {
    const Camera camera = camera_at(0, 0, 10);
    const ViewSpec top = parse_view("top:width=640,cut=30,back=90")(camera);
    EXPECT_EQ(shown(top, 320, 0, 0).x, ScreenWide::from_int(320));
    ASSERT_EQ(top.cuts.size(), 2u);  // at z = -80 and 40
    EXPECT_EQ(top.cuts[0].normal.z, Unit::from_int(1));
    EXPECT_EQ(top.cuts[0].distance, PlaneDistance::from_int(-80));
    EXPECT_EQ(top.cuts[1].normal.z, Unit::from_int(-1));
    EXPECT_EQ(top.cuts[1].distance, PlaneDistance::from_int(-40));
    EXPECT_EQ(parse_view("first-person")(camera).axes, first_person_view(camera).axes);
    // Seen from the south through a window whose lower left corner is the position.
    const ViewSpec window = parse_view("vrp:cop=0/-100/0,window=0/80/0/60")(camera);
    EXPECT_EQ(shown(window, 80, 0, 10).x, ScreenWide::from_int(320));
    EXPECT_EQ(shown(window, 0, 0, 70).y, ScreenWide{});
    EXPECT_EQ(shown(window, 0, 0, 10).y, ScreenWide::from_int(200));
}

void expect_refused(const std::string& text, const std::string& words) {
    std::string of_view;
    const std::string of_usage =
        test::refusal<UsageError>([&] { of_view = test::refusal([&] { parse_view(text)(camera_at(0, 0, 0)); }); });
    EXPECT_NE((of_usage + of_view).find(words), std::string::npos) << text << ": " << of_usage << of_view;
}

TEST(ViewOption, SaysWhatIsWrong) {
    expect_refused("isometri", "'isometri', expected NAME");
    expect_refused("", "'', expected NAME");
    expect_refused("top:", "'', expected KEY=VALUE");
    expect_refused("top:width", "'width', expected KEY=VALUE");
    expect_refused("top:width=3,width=4", "each key once");
    expect_refused("top:turn=3", "'top' has no key 'turn'");
    expect_refused("top:width=wide", "--view: width: 'wide', expected a decimal number");
    expect_refused("top:width=70000", "expected up to 65,536 units");
    expect_refused("cavalier:base=back", "base='back', expected front, top or side");
    expect_refused("vrp:vpn=0/1", "vpn='0/1', expected 3 numbers");
    expect_refused("vrp:vup=0/5/0", "VUP: is zero or along the VPN");
    expect_refused("vrp:cop=5/0/0", "COP: is in the view plane");
    expect_refused("vrp:parallel=yes", "parallel='yes', expected 0 or 1");
}

TEST(ViewOption, NamesTheCameraWhoseViewCannotBeDrawn) {
    const auto said_of = [](const std::string& text) {
        return test::refusal<UsageError>(
            [&] { checked_view(parse_view(text), camera_at(0, 0, 0), {}, "--view at camera 7"); });
    };
    EXPECT_TRUE(said_of("top:width=0").starts_with("--view at camera 7: a window without a size"));
    EXPECT_TRUE(said_of("vrp:vpn=0/0/0").starts_with("--view at camera 7: VPN: is zero"));
}

}  // namespace
}  // namespace oblong::test
