#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/level/bsp_read.h"
#include "engine/level/trace.h"
#include "game/stage.h"
#include "tools/texture/texture_files.h"

namespace oblong {
namespace {

class DemoLevel : public testing::Test {
  protected:
    bool has_entity(const std::string& classname) const {
        return std::any_of(level_.entities.begin(), level_.entities.end(),
                           [&](const Entity& entity) { return entity.value("classname") == classname; });
    }
    std::array<std::vector<double>, 3> corners_of(const Face& face) const {
        std::array<std::vector<double>, 3> corners;
        for (std::int32_t i = 0; i < face.edge_count; ++i) {
            const std::int32_t surf_edge = level_.surf_edges[static_cast<std::size_t>(face.first_surfedge + i)];
            const EdgeIndices& edge = level_.edges[static_cast<std::size_t>(std::abs(surf_edge))];
            const auto& vertex = level_.vertices[static_cast<std::size_t>(surf_edge < 0 ? edge.to : edge.from)];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::int32_t raw = axis == 0 ? vertex.x.raw : axis == 1 ? vertex.y.raw : vertex.z.raw;
                corners[axis].push_back(static_cast<double>(raw) / (1 << World::kFractionBits));
            }
        }
        return corners;
    }

    const Level level_ = read_bsp(read_whole_file(OBLONG_BUILD_DIR "/assets/demo.bsp"));
};

TEST_F(DemoLevel, HasABeginningAnEndAndWhatMoves) {
    for (const char* classname : {"info_player_start", "trigger_changelevel", "func_door", "func_plat"}) {
        EXPECT_TRUE(has_entity(classname)) << classname;
    }
}

TEST_F(DemoLevel, ThePlayerStartsInTheOpen) {
    const Stage stage = make_stage(level_);
    EXPECT_EQ(hull_contents(level_, level_.models[0], Hull::Player, stage.player_start), contents::kEmpty);
}

TEST_F(DemoLevel, CallsForSkyWaterLavaAndAnimation) {
    std::set<std::string> names;
    for (const MipTexture& texture : level_.textures) names.insert(texture.name);
    for (const char* name : {"sky_night", "*water", "*lava", "+0exit", "+1exit"})
        EXPECT_TRUE(names.contains(name)) << name;
    for (const MipTexture& texture : level_.textures) EXPECT_FALSE(texture.is_missing) << texture.name;
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

TEST_F(DemoLevel, ItsSphereIsAsWideAsItIsHigh) {
    // All faces with the sphere's textures near its middle; the facets are cut exactly on its outline.
    std::array<double, 3> low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (const Face& face : level_.faces) {
        const auto& texinfo = level_.texinfos[static_cast<std::size_t>(face.texinfo)];
        if (level_.textures[static_cast<std::size_t>(texinfo.miptex)].name != "cube_red") continue;
        const auto corners = corners_of(face);
        if (corners[0][0] > 0) continue;  // the cubes of another room
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], *std::min_element(corners[axis].begin(), corners[axis].end()));
            high[axis] = std::max(high[axis], *std::max_element(corners[axis].begin(), corners[axis].end()));
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(high[axis] - low[axis], 112, 1) << "axis " << axis;
}

}  // namespace
}  // namespace oblong
