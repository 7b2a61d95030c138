#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/input_error.h"
#include "engine/files/arguments.h"
#include "tests/support/refusal.h"
#include "tools/render/camera_list.h"

namespace oblong {
namespace {

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
    EXPECT_EQ(test::place_of_refusal(
                  [] { checked_view(parse_view("top:width=0"), camera_at(0, 0, 0), {}, "--view at camera 7"); }),
              "--view at camera 7");
}

}  // namespace
}  // namespace oblong
