#include "tools/map/source/external_maps.h"

#include <gtest/gtest.h>

#include <map>

#include "engine/base/input_error.h"
#include "engine/io/files.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tests/support/refusal.h"
#include "tools/map/source/brush.h"

namespace oblong::test {
namespace {

using Sources = std::map<std::string, std::string>;

std::string external(Keys pairs, const std::string& name = "part.map") {
    pairs.push_back({"_external_map", name});
    return entity("misc_external_map", pairs);
}

std::vector<map::MapEntity> included(const std::string& source, const Sources& others) {
    auto entities = map::parse_map(source);
    const auto read = [&](const std::string& name, const std::string&, int line) {
        const auto found = others.find(name);
        if (found == others.end()) throw InputError("line " + std::to_string(line), "'" + name + "' is not there");
        return map::ExternalSource{name, found->second};
    };
    map::Warnings unheard;
    map::include_external_maps(entities, "main.map", read, unheard);
    return entities;
}

std::string complaint(const std::string& source, const Sources& others) {
    std::string of_line;
    const std::string of_file = refusal<FileError>([&] { of_line = refusal([&] { included(source, others); }); });
    return of_file + of_line;
}

map::BspFile compiled(const std::string& source, const Sources& others) {
    const std::vector<map::Wad> wads{map::Wad(wad_bytes(std::vector<std::string>{"wall", "other"}))};
    map::CompileOptions options;
    options.is_fast = true;
    return map::compile_map(included(source, others), wads, options);
}

const std::string kRoom = room({0, 0, 0}, {512, 512, 256}), kStart = entity_at("info_player_start", {480, 480, 28});
const std::string kBrick = box({0, 0, 0}, {64, 32, 16}, "other");

map::Box box_of_others(const map::BspFile& bsp) {
    map::Box box;
    for (const auto& face : bsp.faces) {
        const auto& texinfo = bsp.texinfos.at(static_cast<std::size_t>(face.texinfo));
        if (!bsp.textures.at(static_cast<std::size_t>(texinfo.texture)).starts_with("other")) continue;
        for (const Point& corner : corners_of(bsp, face)) box.add(corner);
    }
    return box;
}

// To the byte, light and visibility too.
TEST(ExternalMaps, AreAsIfTheyWereDrawnThere) {
    const std::string lamp = entity_at("light", {128, 128, 100});
    const auto there = compiled(level(kRoom, external({}) + kStart + lamp), {{"part.map", level(kBrick)}});
    const auto by_hand = compiled(level(kRoom, entity("func_group", {}, kBrick) + kStart + lamp), {});
    EXPECT_TRUE(map::to_bytes(there) == map::to_bytes(by_hand));
}

// Of each kind of placement: where the brick of 64 x 32 x 16 units is then.
TEST(ExternalMaps, AreScaledTurnedAndMoved) {
    const auto placed = [&](Keys pairs) {
        pairs.push_back({"origin", "200 200 100"});
        return box_of_others(compiled(level(kRoom, external(pairs) + kStart), {{"part.map", level(kBrick)}}));
    };
    const auto expect_box = [](const map::Box& box, const Whole& mins, const Whole& maxs) {
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(box.mins[axis], 200.0 - (axis == 2 ? 100 : 0) + mins[static_cast<std::size_t>(axis)]) << axis;
            EXPECT_EQ(box.maxs[axis], 200.0 - (axis == 2 ? 100 : 0) + maxs[static_cast<std::size_t>(axis)]) << axis;
        }
    };
    expect_box(placed({}), {0, 0, 0}, {64, 32, 16});
    expect_box(placed({{"_external_map_scale", "2"}}), {0, 0, 0}, {128, 64, 32});
    expect_box(placed({{"_external_map_scale", "0.5 1 3"}}), {0, 0, 0}, {32, 32, 48});
    expect_box(placed({{"_external_map_angle", "90"}}), {-32, 0, 0}, {0, 64, 16});
    expect_box(placed({{"_external_map_angles", "0 180 0"}}), {-64, -32, 0}, {0, 0, 16});
    expect_box(placed({{"_external_map_angles", "90 0 0"}}), {0, 0, -64}, {16, 32, 0});    // positive pitch is down
    expect_box(placed({{"_external_map_angles", "0 0 90"}}), {0, -16, 0}, {64, 0, 32});    // the left side goes up
    expect_box(placed({{"_external_map_angles", "90 90 0"}}), {-32, 0, -64}, {0, 16, 0});  // pitch before yaw
    expect_box(placed({{"_external_map_angle", "450"}, {"_external_map_scale", "2 1 1"}}), {-32, 0, 0}, {0, 128, 16});
}

// A texel stays at its point of the brush: u and v of the point that a corner went to are those of the corner.
TEST(ExternalMaps, TakeTheirTexturesAlong) {
    for (const std::string_view tail : {kStandardTail, kValveTail}) {
        const TurnedBox brick{{40, 8, 24}, {32, 16, 8}, {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}};
        const std::string text =
            replaced(replaced(brick.text(tail), "wall 0 0 0 1 1", "wall 3 5 30 0.5 2"), "] 0 1 1", "] 0 0.5 2");
        const auto before = map::parse_map(level(text)).front().brushes.front();
        const auto after = included(level(kRoom, external({{"origin", "7 11 13"},
                                                           {"_external_map_angles", "20 30 40"},
                                                           {"_external_map_scale", "2 3 0.5"}})),
                                    {{"part.map", level(text)}})[1]
                               .brushes.front();
        const auto texels = [](const map::MapBrush& brush, std::size_t side, std::size_t corner) {
            map::PlaneList planes;
            map::TextureList textures;
            const auto built = map::make_brush(brush, planes, textures);
            const auto& texinfo = textures.texinfos().at(static_cast<std::size_t>(built.sides.at(side).texinfo));
            const Point& point = brush.sides.at(side).points.at(corner);
            return std::array{texinfo.texel(0, point), texinfo.texel(1, point)};
        };
        for (std::size_t side = 0; side < 6; ++side)
            for (std::size_t corner = 0; corner < 3; ++corner)
                for (std::size_t axis = 0; axis < 2; ++axis)
                    EXPECT_NEAR(texels(before, side, corner)[axis], texels(after, side, corner)[axis], 1e-6);
    }
}

TEST(ExternalMaps, BecomeAnEntityOfTheirClass) {
    const auto entities =
        included(level(kRoom, external({{"origin", "8 8 8"},
                                        {"_external_map_classname", "func_door"},
                                        {"_external_map_scale", "1"},
                                        {"targetname", "gate"}})),
                 {{"part.map", level(kBrick, entity("func_detail", {}, kBrick) + entity_at("light", {0, 0, 0}))}});
    ASSERT_EQ(entities.size(), 2u) << "the light stays out";
    EXPECT_EQ(entities[1].value("classname"), "func_door");
    EXPECT_EQ(entities[1].value("targetname"), "gate");
    EXPECT_EQ(entities[1].pairs.size(), 2u);
    ASSERT_EQ(entities[1].brushes.size(), 2u) << "those of all entities";
    EXPECT_EQ(entities[1].brushes[1].sides[0].line, entities[1].line);
    EXPECT_EQ(included(level(kRoom, external({})), {{"part.map", level(kBrick)}})[1].value("classname"), "func_group");
}

TEST(ExternalMaps, MayIncludeOthers) {
    const Sources sources{{"part.map", level("", external({{"origin", "32 0 0"}}, "inner.map"))},
                          {"inner.map", level(kBrick)}};
    const auto entities =
        included(level(kRoom, external({{"origin", "0 0 64"}, {"_external_map_angle", "90"}})), sources);
    ASSERT_EQ(entities[1].brushes.size(), 1u);
    const auto bsp =
        compiled(level(kRoom, external({{"origin", "100 0 64"}, {"_external_map_angle", "90"}}) + kStart), sources);
    EXPECT_EQ(box_of_others(bsp).mins.y, 32);
    EXPECT_EQ(box_of_others(bsp).maxs.y, 96);
}

TEST(ExternalMaps, SayWhatIsWrongAndWhere) {
    const std::string source = level(kRoom, external({}));
    const std::string at = "line " + std::to_string(map::parse_map(source)[1].line) + ": ";
    EXPECT_EQ(complaint(source, {}), at + "'part.map' is not there");
    EXPECT_EQ(complaint(source, {{"part.map", "{"}}).find("part.map: line 1: "), 0u);
    EXPECT_EQ(complaint(source, {{"part.map", level("")}}), "part.map: line 1: no brushes, expected some to include");
    const std::string flat = replaced(kBrick, "64", "0");
    EXPECT_EQ(complaint(source, {{"part.map", level(flat)}}).find("part.map: line "), 0u);
    EXPECT_EQ(complaint(source, {{"part.map", source}}).find("part.map: "), 0u) << "itself";
    EXPECT_NE(complaint(source, {{"part.map", source}}).find("'part.map' includes itself"), std::string::npos);
    const Sources round{{"part.map", level("", external({}, "b.map"))}, {"b.map", level("", external({}, "part.map"))}};
    EXPECT_EQ(complaint(source, round).find("b.map: "), 0u) << complaint(source, round);
    EXPECT_NE(complaint(source, round).find("'part.map' includes itself"), std::string::npos);
    const auto of_key = [&](const std::string& key, const std::string& value) {
        return complaint(level(kRoom, external({{key, value}})), {{"part.map", level(kBrick)}});
    };
    for (const char* scale : {"0", "-1", "1e9", "1 1 0"})
        EXPECT_NE(of_key("_external_map_scale", scale).find("\"_external_map_scale\" is "), std::string::npos) << scale;
    for (const std::array<std::string, 2>& pair : {std::array<std::string, 2>{"_external_map_angles", "1 2"},
                                                   {"_external_map_scale", "nan"},
                                                   {"_external_map_angle", "x"}}) {
        auto entities = map::parse_map(level(kRoom, external({pair})));
        map::Warnings warnings;
        map::include_external_maps(
            entities, "whole.map",
            [&](const std::string& name, const std::string&, int) {
                return map::ExternalSource{name, level(kBrick)};
            },
            warnings);
        const auto said = warnings.take();
        ASSERT_EQ(said.size(), 1u) << pair[0];
        EXPECT_TRUE(said[0].what.starts_with("'" + pair[0] + "' is '" + pair[1] + "', expected ")) << said[0].what;
    }
    EXPECT_NE(of_key("origin", "1e9 0 0").find("\"origin\""), std::string::npos);
    EXPECT_EQ(of_key("origin", "65530 0 0").find("part.map: line "), 0u) << "its brush is beyond all levels";
    EXPECT_NE(complaint(level(kRoom, entity("misc_external_map", {})), {}).find("without '_external_map'"),
              std::string::npos);
}

// Each includes the next one twice: 2^30 in all.
TEST(ExternalMaps, AreNotManyWithoutEnd) {
    Sources sources{{"part.map", level("", external({}, "1") + external({}, "1"))}};
    for (int i = 1; i < 30; ++i) {
        const std::string next = std::to_string(i + 1);
        sources[std::to_string(i)] = level("", external({}, next) + external({}, next));
    }
    sources["30"] = level(kBrick);
    EXPECT_NE(complaint(level(kRoom, external({})), sources).find("more than 4096 map sources are included"),
              std::string::npos);
}

}  // namespace
}  // namespace oblong::test
