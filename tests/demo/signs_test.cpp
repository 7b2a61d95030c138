#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/level/trace.h"
#include "tests/demo/demo_level.h"

namespace oblong::test {
namespace {

/// Where a visitor's eye is when a sign first comes into sight close by: in the door of its room, at a bend of the way.
struct FirstSight {
    const char* sign;
    Point eye;
    int texels_a_dot = 2;  ///< of the font's dots
};

constexpr std::array kFirstSights{
    FirstSight{"title", {0, -368, 46}, 3},         FirstSight{"sign_museum", {0, -368, 46}},
    FirstSight{"sign_machines", {0, -330, 46}},    FirstSight{"sign_aspect", {0, 10, 46}},
    FirstSight{"sign_vanish", {0, 10, 46}},        FirstSight{"sign_axono", {300, 416, 46}},
    FirstSight{"sign_light", {736, 470, 46}},      FirstSight{"sign_dust", {736, 270, 46}},
    FirstSight{"sign_sparks", {736, 270, 46}},     FirstSight{"sign_planes", {1360, 416, 46}},
    FirstSight{"sign_fov", {1488, 680, 46}},       FirstSight{"sign_forced", {512, 1320, 78}},
    FirstSight{"sign_rain", {512, 1390, 46}},      FirstSight{"sign_fog", {1224, 1640, 46}},
    FirstSight{"sign_accuracy", {-792, 2100, 94}}, FirstSight{"sign_distance", {-784, 2200, 94}},
    FirstSight{"+0exit", {512, 2330, 94}},
};

class DemoSigns : public testing::TestWithParam<FirstSight> {
  protected:
    /// Of two signs alike, the extent of the one that is nearer to the eye, of all pieces that the tree has cut it
    /// into.
    Extent extent_of_sign() const {
        constexpr double kWiderThanASign = 300;
        const auto across = [](const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); };
        std::vector<Point> corners;
        for (const Face& face : level_.faces)
            if (level_.texture_of(face).name == GetParam().sign)
                for (const Point& corner : corners_of(level_, face)) corners.push_back(corner);
        const auto far = [&](const Point& corner) { return across(corner, GetParam().eye); };
        const auto nearest = std::ranges::min_element(corners, {}, far);
        Extent extent;
        for (const Point& corner : corners)
            if (across(corner, *nearest) <= kWiderThanASign) extent.add(corner);
        return extent;
    }

    bool is_clear(const Point& from, const Point& to) const {
        constexpr int kSteps = 400;
        for (int step = 0; step < kSteps; ++step) {
            const Vec3<World> place = to_world(along(from, to, 1.0 * step / kSteps));
            if (hull_contents(level_, level_.world(), Hull::Point, place) == contents::kSolid) return false;
        }
        return true;
    }

    const Level level_ = read_level("demo");
};

/// Letters are seven dots high: three quarters of a pixel a dot make them five pixels high, and still readable.
TEST_P(DemoSigns, CanBeReadAtFirstSight) {
    constexpr double kFocalAcross = 160, kFocalDown = kFocalAcross * 5 / 6;  // of 320x200 at 90 degrees, on 4:3
    const auto& [sign, eye, texels_a_dot] = GetParam();
    const auto [low, high] = extent_of_sign();
    ASSERT_GT(high.z, low.z) << "no such sign";
    const Point middle = along(low, high, 0.5), way = middle - eye;
    const double distance = std::hypot(way.x, way.y);
    const double incidence = std::abs(high.x > low.x ? way.y : way.x) / distance;
    const auto texture = std::ranges::find(level_.textures, sign, &MipTexture::name);
    const double dot = (high.z - low.z) / texture->height * texels_a_dot;
    EXPECT_GE(dot * kFocalDown / distance, 0.75) << "high";
    EXPECT_GE(dot * kFocalAcross / distance * incidence, 0.75) << "wide";
    EXPECT_TRUE(is_clear(eye, middle)) << "in sight";
}

INSTANTIATE_TEST_SUITE_P(All, DemoSigns, testing::ValuesIn(kFirstSights), [](const auto& sight) {
    std::string name = sight.param.sign;
    std::erase(name, '+');
    return name;
});

}  // namespace
}  // namespace oblong::test
