#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>

#include "engine/level/bsp_read.h"
#include "engine/level/trace.h"
#include "engine/platform/files.h"
#include "game/game_level.h"

namespace oblong {
namespace {

using Corner = std::array<double, 3>;

double units(World value) {
    return static_cast<double>(value.raw) / (1 << World::kFractionBits);
}

class DemoLevel : public testing::Test {
  protected:
    bool has_entity(const std::string& classname) const {
        return std::any_of(level_.entities.begin(), level_.entities.end(),
                           [&](const Entity& entity) { return entity.value("classname") == classname; });
    }
    std::vector<Corner> corners_of(const Face& face) const {
        std::vector<Corner> corners;
        for (const SurfEdge edge : level_.edges_of(face)) {
            const Vec3<World>& vertex = level_.vertices[level_.start_of(edge)];
            corners.push_back({units(vertex.x), units(vertex.y), units(vertex.z)});
        }
        return corners;
    }

    const Level level_ = read_bsp(read_file(OBLONG_BUILD_DIR "/assets/demo.bsp"));
};

TEST_F(DemoLevel, HasABeginningAnEndAndWhatMoves) {
    for (const char* classname : {"info_player_start", "trigger_changelevel", "func_door", "func_plat"}) {
        EXPECT_TRUE(has_entity(classname)) << classname;
    }
}

TEST_F(DemoLevel, ThePlayerStartsInTheOpen) {
    const GameLevel level = make_game_level(level_);
    EXPECT_EQ(hull_contents(level_, level_.world(), Hull::Player, level.player_start), contents::kEmpty);
}

TEST_F(DemoLevel, CallsForSkyWaterLavaAndAnimation) {
    std::set<std::string> names;
    for (const MipTexture& texture : level_.textures) names.insert(texture.name);
    for (const char* name : {"sky_night", "*water", "*lava", "+0exit", "+1exit"})
        EXPECT_TRUE(names.contains(name)) << name;
    for (const MipTexture& texture : level_.textures) EXPECT_FALSE(texture.is_missing) << texture.name;
}

TEST_F(DemoLevel, EveryCameraOfTheListStandsInTheOpen) {
    std::ifstream cameras(OBLONG_SOURCE_DIR "/assets/demo_cameras.csv");
    std::string line;
    std::getline(cameras, line);
    EXPECT_EQ(line, "x,y,z,yaw,pitch");
    int count = 0;
    while (std::getline(cameras, line)) {
        int x = 0, y = 0, z = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%d", &x, &y, &z), 3) << line;
        const Position eye{World::from_int(x), World::from_int(y), World::from_int(z)};
        EXPECT_NE(hull_contents(level_, level_.world(), Hull::Point, eye), contents::kSolid) << line;
        ++count;
    }
    EXPECT_GE(count, 14);
}

TEST_F(DemoLevel, IsDarkButReadable) {
    // Of all light samples: some pools near full light, most below half, hardly any quite black.
    ASSERT_FALSE(level_.lighting.empty());
    const auto count = [&](int low, int high) {
        return std::count_if(level_.lighting.begin(), level_.lighting.end(),
                             [&](std::uint8_t light) { return light >= low && light <= high; });
    };
    const auto all = static_cast<std::ptrdiff_t>(level_.lighting.size());
    EXPECT_GT(count(176, 255), all / 50);
    EXPECT_GT(count(0, 128), all / 2);
    EXPECT_LT(count(0, 4), all / 100);
}

double along(const Corner& from, const Corner& direction, const Corner& point) {
    double product = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) product += (point[axis] - from[axis]) * direction[axis];
    return product;
}

/// True if `point` lies on the line between the two, and not at its ends.
bool splits(const Corner& point, const Corner& from, const Corner& to) {
    Corner edge{};
    for (std::size_t axis = 0; axis < 3; ++axis) edge[axis] = to[axis] - from[axis];
    const double square = along({}, edge, edge), share = along(from, edge, point) / square;
    constexpr double kNearEnd = 0.25, kOnLine = 0.02;
    if (share * std::sqrt(square) < kNearEnd || (1 - share) * std::sqrt(square) < kNearEnd) return false;
    double distance_squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double off = point[axis] - from[axis] - share * edge[axis];
        distance_squared += off * off;
    }
    return distance_squared < kOnLine * kOnLine;
}

TEST_F(DemoLevel, NoCornerOfAWallLiesWithinTheEdgeOfAnother) {
    std::set<Corner> corners;
    std::set<std::pair<Corner, Corner>> edges;
    for (const FaceIndex face : level_.world().faces) {
        const auto outline = corners_of(level_.faces[face]);
        for (std::size_t at = 0; at < outline.size(); ++at) {
            corners.insert(outline[at]);
            edges.emplace(std::minmax(outline[at], outline[(at + 1) % outline.size()]));
        }
    }
    ASSERT_GT(edges.size(), 5000u);
    // Corners come sorted by x: only those between an edge's ends can split it.
    constexpr double kSlack = 0.1;
    for (const auto& [from, to] : edges) {
        auto corner = corners.lower_bound({from[0] - kSlack, -1e9, -1e9});
        for (; corner != corners.end() && (*corner)[0] <= to[0] + kSlack; ++corner) {
            ASSERT_FALSE(splits(*corner, from, to)) << (*corner)[0] << ' ' << (*corner)[1] << ' ' << (*corner)[2];
        }
    }
}

TEST_F(DemoLevel, ItsSphereIsAsWideAsItIsHigh) {
    // The faces with one of the sphere's two textures, which nothing else has; they reach its outline on every side.
    Corner low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (const Face& face : level_.faces) {
        if (level_.texture_of(face).name != "plaster_red") continue;
        for (const Corner& corner : corners_of(face)) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], corner[axis]);
                high[axis] = std::max(high[axis], corner[axis]);
            }
        }
    }
    const Corner size{112, 112, 111};  // its lower pole is a unit deep in the pedestal
    for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(high[axis] - low[axis], size[axis], 0.01) << "axis " << axis;
}

}  // namespace
}  // namespace oblong
