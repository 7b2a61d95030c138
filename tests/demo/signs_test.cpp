#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/level/trace.h"
#include "tests/support/folders.h"
#include "tests/support/point.h"

namespace oblong {
namespace {

using Corner = std::array<double, 3>;

/// Where a visitor's eye is when a sign first comes into sight close by: in the door of its room, at a bend of the way.
struct FirstSight {
    const char* sign;
    Corner eye;
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
    static Corner point(const Vec3<World>& at) { return {number_of(at.x), number_of(at.y), number_of(at.z)}; }

    /// The corners of each piece that the tree has cut the sign into.
    std::vector<Corner> corners_of_sign() const {
        std::vector<Corner> corners;
        for (const Face& face : level_.faces) {
            if (level_.texture_of(face).name != GetParam().sign) continue;
            for (const SurfEdge edge : level_.edges_of(face))
                corners.push_back(point(level_.vertices[level_.start_of(edge)]));
        }
        return corners;
    }

    /// Lowest and highest corner; of two signs alike, those of the one that is nearer to the eye.
    std::array<Corner, 2> extent_of_sign() const {
        constexpr double kWiderThanASign = 300;
        const auto far = [](const Corner& a, const Corner& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); };
        const std::vector<Corner> corners = corners_of_sign();
        const auto nearest = std::min_element(corners.begin(), corners.end(), [&](const Corner& a, const Corner& b) {
            return far(a, GetParam().eye) < far(b, GetParam().eye);
        });
        std::array<Corner, 2> extent{Corner{1e9, 1e9, 1e9}, Corner{-1e9, -1e9, -1e9}};
        for (const Corner& corner : corners) {
            if (far(corner, *nearest) > kWiderThanASign) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                extent[0][i] = std::min(extent[0][i], corner[i]);
                extent[1][i] = std::max(extent[1][i], corner[i]);
            }
        }
        return extent;
    }

    bool is_clear(const Corner& from, const Corner& to) const {
        constexpr int kSteps = 400;
        for (int step = 0; step < kSteps; ++step) {
            Vec3<World> place;
            const auto between = [&](std::size_t axis) {
                const double value = from[axis] + (to[axis] - from[axis]) * step / kSteps;
                return World::from_raw(static_cast<std::int32_t>(std::lround(value * (1 << World::kFractionBits))));
            };
            place = {between(0), between(1), between(2)};
            if (hull_contents(level_, level_.world(), Hull::Point, place) == contents::kSolid) return false;
        }
        return true;
    }

    const Level level_ = read_bsp(read_file(test::build_folder() + "/assets/demo.bsp"));
};

/// Letters are seven dots high: three quarters of a pixel a dot make them five pixels high, and still readable.
TEST_P(DemoSigns, CanBeReadAtFirstSight) {
    constexpr double kFocalAcross = 160, kFocalDown = kFocalAcross * 5 / 6;  // of 320x200 at 90 degrees, on 4:3
    const auto& [sign, eye, texels_a_dot] = GetParam();
    const auto [low, high] = extent_of_sign();
    ASSERT_GT(high[2], low[2]) << "no such sign";
    const Corner middle{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
    const double dx = middle[0] - eye[0], dy = middle[1] - eye[1], distance = std::hypot(dx, dy);
    const double incidence = std::abs(high[0] > low[0] ? dy : dx) / distance;
    const auto texture = std::find_if(level_.textures.begin(), level_.textures.end(),
                                      [&](const MipTexture& one) { return one.name == GetParam().sign; });
    const double dot = (high[2] - low[2]) / texture->height * texels_a_dot;
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
}  // namespace oblong
