#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <tuple>

#include "engine/io/files.h"
#include "engine/level/trace.h"
#include "tests/demo/demo_level.h"
#include "tools/map/compile.h"
#include "tools/map/source/entities.h"

namespace oblong::test {
namespace {

class DemoLevel : public testing::Test {
  protected:
    const Level level_ = read_level("demo");
};

/// This build has compiled it (assets/CMakeLists.txt); tools/play takes the committed one.
TEST(CommittedLevel, IsWhatTheMapCompilerMakesOfItsSources) {
    const std::string committed = source_folder() + "/assets/", build = build_folder();
    const char* const cure = "cmake --build build --target update_demo_level";
    EXPECT_TRUE(read_file(committed + "demo.bsp") == read_file(build + "/assets/demo.bsp")) << cure;
    EXPECT_TRUE(read_file(committed + "demo.sha256") == read_file(build + "/demo.sha256")) << cure;
}

TEST_F(DemoLevel, CallsForEveryEffectByWhatMappersUse) {
    std::set<std::string> names;
    for (const MipTexture& texture : level_.textures) {
        names.insert(texture.name);
        EXPECT_FALSE(texture.is_missing) << texture.name;
    }
    for (const char* name : {"sky_night", "*water", "*lava", "*teleport", "mirror_hall", "{grate", "{fern", "{lantern",
                             "+0exit", "+1exit", "+2exit", "+3exit", "+0volt", "+3volt"})
        EXPECT_TRUE(names.contains(name)) << name;
    for (const char* classname : {"misc_rain", "misc_dust", "misc_sparks", "misc_sprite", "misc_lantern",
                                  "trigger_teleport", "info_teleport_destination"})
        EXPECT_TRUE(std::ranges::any_of(level_.entities, [&](const auto& e) {
            return e.value("classname") == classname;
        })) << classname;
    for (const char* key : {"fog", "wateralpha", "palette_cycle"})
        EXPECT_NE(level_.entities.front().value(key), "") << key;
    std::set<int> styles;
    for (const Face& face : level_.faces) styles.insert(face.styles.begin(), face.styles.end());
    for (const int style : {2, 3, 4, 6, 7, 10, 32}) EXPECT_TRUE(styles.contains(style)) << style;
}

TEST_F(DemoLevel, CyclesColoursOfTheNeonSignAlone) {
    int first = 0, last = 0, steps = 0;
    const std::string cycle = level_.entities.front().value("palette_cycle");
    ASSERT_EQ(std::sscanf(cycle.c_str(), "%d %d %d", &first, &last, &steps), 3) << cycle;
    for (const MipTexture& texture : level_.textures) {
        const std::set<int> colours(texture.mips[0].begin(), texture.mips[0].end());
        for (int colour = first; colour <= last; ++colour)
            EXPECT_EQ(colours.contains(colour), texture.name == "neon") << texture.name << ' ' << colour;
    }
}

TEST_F(DemoLevel, ItsFogLiesBelowAllRoomsButTheGarden) {
    const std::string fog = level_.entities.front().value("fog");
    double top = 0;
    ASSERT_EQ(std::sscanf(fog.c_str(), "%*f %*f %*f %*f %*f %*f %*f %lf", &top), 1) << fog;
    int in_fog = 0;
    for (const FaceIndex face : level_.world().faces)
        for (const auto& [x, y, z] : corners_of(level_, level_.faces[face])) {
            const bool is_in_garden = x >= 1184 && x <= 1600 && y >= 1856 && y <= 2528;
            ASSERT_TRUE(is_in_garden || z >= top) << x << ' ' << y;
            in_fog += z < top;
        }
    EXPECT_GT(in_fog, 100);
}

TEST_F(DemoLevel, EveryCameraOfTheListStandsInTheOpen) {
    std::ifstream cameras(source_folder() + "/assets/demo_cameras.csv");
    std::string line;
    std::getline(cameras, line);
    EXPECT_EQ(line, "x,y,z,yaw,pitch");
    int count = 0;
    while (std::getline(cameras, line)) {
        int x = 0, y = 0, z = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%d", &x, &y, &z), 3) << line;
        EXPECT_NE(hull_contents(level_, level_.world(), Hull::Point, point_at(x, y, z)), contents::kSolid) << line;
        ++count;
    }
    EXPECT_GE(count, 14);
}

/// The light of each sample of each face, all styles at their steady strength.
std::vector<int> light_samples(const Level& level) {
    std::vector<int> lights;
    for (const Face& face : level.faces) {
        if (face.light_offset < 0) continue;
        const auto count = static_cast<std::size_t>((face.texel_extent_u / 16 + 1) * (face.texel_extent_v / 16 + 1));
        std::vector<int> sums(count, 0);
        auto next = static_cast<std::size_t>(face.light_offset);
        for (const std::uint8_t style : face.styles) {
            if (style == 255) break;
            for (int& sum : sums) sum += level.lighting.at(next++);
        }
        lights.insert(lights.end(), sums.begin(), sums.end());
    }
    return lights;
}

TEST_F(DemoLevel, IsDarkButReadable) {
    // Of all light samples: some pools near full light, most below half, hardly any quite black.
    const std::vector<int> lights = light_samples(level_);
    ASSERT_FALSE(lights.empty());
    const auto count = [&](int low, int high) {
        return std::count_if(lights.begin(), lights.end(), [&](int light) { return light >= low && light <= high; });
    };
    const auto all = static_cast<std::ptrdiff_t>(lights.size());
    EXPECT_GT(count(160, 1000), all / 50);
    EXPECT_LT(count(160, 1000), all / 5) << "washed out: from 128 on light brightens a texture's own colour";
    EXPECT_LT(count(192, 1000), all / 10);
    EXPECT_GT(count(0, 128), all / 2);
    EXPECT_LT(count(0, 4), all / 100);
}

/// True if `point` lies on the line between the two, and not at its ends.
bool splits(const Point& point, const Point& from, const Point& to) {
    const double size = length(to - from), way = dot(point - from, to - from) / size;
    constexpr double kNearEnd = 0.25, kOnLine = 0.02;
    return way >= kNearEnd && size - way >= kNearEnd && length(point - along(from, to, way / size)) < kOnLine;
}

TEST_F(DemoLevel, NoCornerOfAWallLiesWithinTheEdgeOfAnother) {
    constexpr auto kByX = [](const Point& a, const Point& b) {
        return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
    };
    std::set<Point, decltype(kByX)> corners;
    std::set<std::array<double, 6>> edges;
    for (const FaceIndex face : level_.world().faces) {
        const auto outline = corners_of(level_, level_.faces[face]);
        for (std::size_t at = 0; at < outline.size(); ++at) {
            corners.insert(outline[at]);
            const auto& [from, to] = std::minmax(outline[at], outline[(at + 1) % outline.size()], kByX);
            edges.insert({from.x, from.y, from.z, to.x, to.y, to.z});
        }
    }
    ASSERT_GT(edges.size(), 5000u);
    // Corners come sorted by x: only those between an edge's ends can split it.
    constexpr double kSlack = 0.1;
    for (const auto& [x, y, z, to_x, to_y, to_z] : edges)
        for (auto corner = corners.lower_bound({x - kSlack, -1e9, -1e9});
             corner != corners.end() && corner->x <= to_x + kSlack; ++corner)
            ASSERT_FALSE(splits(*corner, {x, y, z}, {to_x, to_y, to_z}))
                << corner->x << ' ' << corner->y << ' ' << corner->z;
}

TEST_F(DemoLevel, ItsSphereIsAsWideAsItIsHigh) {
    // The faces with one of the sphere's two textures, which nothing else has; they reach its outline on every side.
    Extent sphere;
    for (const Face& face : level_.faces)
        if (level_.texture_of(face).name == "plaster_red")
            for (const Point& corner : corners_of(level_, face)) sphere.add(corner);
    const Point size = sphere.high - sphere.low,
                wanted{112, 112, 111};  // its lower pole is a unit deep in the pedestal
    for (const int axis : {0, 1, 2}) EXPECT_NEAR(size[axis], wanted[axis], 0.01) << "axis " << axis;
}

using map::MapBrush;
using map::MapEntity;

std::vector<MapEntity> demo_source() {
    return map::parse_map(read_text(source_folder() + "/assets/demo.map"));
}

/// Whether a light that stands at most 16 units before the body has all of it within its radius.
bool is_free_of(const MapBrush& body, const MapEntity& light) {
    if (!light.has("radius")) return false;
    const map::Point at = map::origin_of(light).value();
    double nearest = 1e9, farthest = 0;
    for (const map::MapSide& side : body.sides)
        for (const map::Point& corner : side.points) {
            nearest = std::min(nearest, length(corner - at));
            farthest = std::max(farthest, length(corner - at));
        }
    return nearest < 16 && farthest < map::number_of(light, "radius", 0);
}

TEST(DemoSource, NoLampDarkensTheWallAroundItByItsOwnShadow) {
    const std::vector<MapEntity> entities = demo_source();
    std::vector<MapEntity> lights;
    for (const MapEntity& entity : entities)
        if (entity.value("classname") == "light") lights.push_back(entity);
    int lamps = 0;
    for (const MapEntity& entity : entities)
        for (const MapBrush& brush : entity.brushes) {
            if (brush.sides[0].texture.name != "lamp" && brush.sides[0].texture.name != "lantern") continue;
            ++lamps;
            EXPECT_TRUE(std::ranges::any_of(lights, [&](const MapEntity& light) { return is_free_of(brush, light); }))
                << "line " << brush.line;
        }
    EXPECT_GT(lamps, 30);
}

TEST(DemoSource, HasNothingThatTheCompilerWarnsOf) {
    map::Warnings warnings;
    map::find_warnings(demo_source(), warnings);
    for (const map::Warning& warning : warnings.take()) ADD_FAILURE() << warning.line << ": " << warning.what;
}

/// TrenchBroom shows places as layers; what is in one names it by its number.
TEST(DemoSource, EveryEntityIsInALayerWithAName) {
    std::set<std::string> names, numbers;
    const std::string text = read_text(source_folder() + "/assets/demo.map");
    const std::vector<MapEntity> entities = demo_source();
    for (const MapEntity& entity : entities) {
        if (entity.value("_tb_type") != "_tb_layer") continue;
        EXPECT_TRUE(names.insert(entity.value("_tb_name")).second) << entity.value("_tb_name");
        EXPECT_TRUE(numbers.insert(entity.value("_tb_id")).second) << entity.value("_tb_id");
        EXPECT_NE(text.find("\n// " + entity.value("_tb_name") + ": "), std::string::npos) << "what it shows";
    }
    EXPECT_TRUE(names.contains("tower"));
    EXPECT_TRUE(entities.front().brushes.empty());
    for (std::size_t i = 1; i < entities.size(); ++i)
        EXPECT_TRUE(entities[i].has("_tb_id") || numbers.contains(entities[i].value("_tb_layer")))
            << "line " << entities[i].line;
}

}  // namespace
}  // namespace oblong::test
