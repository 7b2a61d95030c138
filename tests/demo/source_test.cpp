#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/files/files.h"
#include "tests/support/folders.h"
#include "tools/map/compile.h"
#include "tools/map/source/entities.h"

namespace oblong {
namespace {

using map::MapBrush;
using map::MapEntity;

std::vector<MapEntity> demo_source() {
    return map::parse_map(read_text(test::source_folder() + "/assets/demo.map"));
}

/// Whether a light that stands at most 16 units before the body has all of it within its radius.
bool is_free_of(const MapBrush& body, const MapEntity& light) {
    if (!light.has("radius")) return false;
    const map::Point at = map::origin_of(light).value();
    double nearest = 1e9, farthest = 0;
    for (const map::MapSide& side : body.sides)
        for (const map::Point& corner : side.points) {
            nearest = std::min(nearest, map::length(corner - at));
            farthest = std::max(farthest, map::length(corner - at));
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
            if (brush.sides[0].texture.name != "lamp") continue;
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
    const std::string text = read_text(test::source_folder() + "/assets/demo.map");
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
}  // namespace oblong
