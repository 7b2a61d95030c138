#include <gtest/gtest.h>

#include "engine/io/files.h"
#include "tests/library/hall.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

std::string gate_of_hall() {
    return entity("func_door", {{"targetname", "gate"}}, box({50, -100, 1}, {60, 100, 200}, "other"));
}

TEST(LibraryEntities, RayEndsWhereSomethingIsSolid) {
    Hall hall("", gate_of_hall());
    const std::int32_t gate = hall.level.find_entity("targetname", "gate");
    const Hit door = hall.level.ray(pose_at(0, 0, 100), 1000), beside_it = hall.level.ray(pose_at(0, 150, 100), 1000),
              down = hall.level.ray(pose_at(-50, 0, 100, 0, 45), 1000),
              short_of_it = hall.level.ray(pose_at(0, 0, 100), 40);
    EXPECT_TRUE(door.is_hit && beside_it.is_hit && down.is_hit);
    EXPECT_EQ(door.entity, gate);
    EXPECT_NEAR(units(door.place.x_256), 50, 0.1);
    EXPECT_EQ(beside_it.entity, -1);
    EXPECT_NEAR(units(beside_it.place.x_256), 256, 0.1);
    EXPECT_NEAR(units(down.place.x_256), 50, 0.2);
    EXPECT_NEAR(units(down.place.z_256), 0, 0.2);
    EXPECT_FALSE(short_of_it.is_hit);
    EXPECT_NEAR(units(short_of_it.place.x_256), 40, 0.1);
    hall.level.move_entity(gate, 0, 0, 200 * 256);
    EXPECT_EQ(hall.level.ray(pose_at(0, 0, 100), 1000).entity, -1);
}

TEST(LibraryEntities, WhatIsHiddenIsNeitherSeenNorInTheWay) {
    Hall hall("", gate_of_hall() + entity_at("light", {0, 0, 100}));
    const std::int32_t gate = hall.level.find_entity("targetname", "gate");
    const auto shown = [&] { return hall.picture(pose_at(0, 0, 100)); };
    const auto before = shown();
    const auto reached = [&] { return units(hall.walk_east(hall.level.start(), 60).x_256); };
    EXPECT_LT(reached(), 40);
    hall.level.hide_entity(gate);
    EXPECT_NE(shown(), before);
    EXPECT_NEAR(reached(), kStop, 0.1);
    EXPECT_EQ(hall.level.ray(pose_at(0, 0, 100), 1000).entity, -1);
    hall.level.hide_entity(gate, false);
    EXPECT_EQ(shown(), before);
    EXPECT_LT(reached(), 40);
    EXPECT_THROW(hall.level.hide_entity(hall.level.find_entity("classname", "light")), std::runtime_error);
    for (const std::int32_t missing : {-1, 1000}) EXPECT_THROW(hall.level.hide_entity(missing), std::runtime_error);
}

// A model of the hall's folder that is hidden, as an item that was taken.
TEST(LibraryEntities, AModelIsHiddenToo) {
    Hall hall;
    hall.folder.write("cube.obj", std::string("v -20 0 0\nv 20 0 0\nv 0 40 0\nf 1 2 3\nf 1 3 2\n"));
    const std::string file = hall.folder.write(
        "shown.bsp", bytes_of(::oblong::test::hall("", entities_of("misc_model 100 0 40 model=cube.obj"))));
    LevelScene level(file, red_palette());
    const std::int32_t model = level.find_entity("classname", "misc_model");
    const auto sum = [&] {
        Picture picture = Picture::of_size(320, 200);
        level.draw(pose_at(0, 0, 60), 0, picture.canvas());
        return checksum(picture.canvas());
    };
    const std::uint32_t shown = sum();
    level.hide_entity(model);
    EXPECT_NE(sum(), shown);
    level.hide_entity(model, false);
    EXPECT_EQ(sum(), shown);
}

TEST(LibraryEntities, BoxesMoveWithTheirBrushesAndTellWhoIsInThem) {
    Hall hall("", gate_of_hall() +
                      entities_of("trigger_once -60 -60 0 -20 -20 64 targetname=spot + item_key1 100 40 24 angle=45"));
    LevelScene& level = hall.level;
    const std::int32_t gate = level.find_entity("targetname", "gate"), spot = level.find_entity("targetname", "spot"),
                       key = level.find_entity("classname", "item_key1");
    EXPECT_EQ(level.entity_bounds(gate), (Bounds{pose_at(50, -100, 1), pose_at(60, 100, 200)}));
    level.move_entity(gate, 0, 256, 3 * 256);
    EXPECT_EQ(level.entity_bounds(gate), (Bounds{pose_at(50, -99, 4), pose_at(60, 101, 203)}));
    EXPECT_EQ(level.entity_pose(gate), (Pose{55 * 256, 256, 103 * 256 + 128, 0, 0, 0}));
    EXPECT_EQ(level.entity_pose(key), pose_at(100, 40, 24, 45));
    EXPECT_EQ(level.entity_bounds(key), (Bounds{pose_at(84, 24, 0), pose_at(116, 56, 56)}));
    // A body is 32 units wide, from 46 below the eye to 10 above.
    EXPECT_TRUE(level.touches(pose_at(-5, -40, 46), spot));
    EXPECT_FALSE(level.touches(pose_at(-3, -40, 46), spot));
    EXPECT_TRUE(level.touches(pose_at(-40, -40, 109), spot));
    EXPECT_FALSE(level.touches(pose_at(-40, -40, 111), spot));
    EXPECT_TRUE(level.touches(pose_at(131, 40, 46), key));
    EXPECT_FALSE(level.touches(pose_at(133, 40, 46), key));
}

TEST(LibraryEntities, LevelMovesAndChangesItsMode) {
    Hall hall;
    const std::vector<std::uint8_t> bytes = read_file(hall.file);
    LevelScene other(File("hall", bytes), red_palette(), {640, 400, {4, 3}});
    LevelScene moved_level = std::move(hall.level);
    moved_level.set_mode({640, 400, {4, 3}});
    Picture first = Picture::of_size(640, 400), second = first;
    moved_level.draw(moved_level.start(), 0, first.canvas());
    other.draw(other.start(), 0, second.canvas());
    EXPECT_EQ(first.pixels, second.pixels);
    const std::string said =
        refusal<std::runtime_error>([&] { LevelScene(File("in memory", std::span(bytes).first(100)), red_palette()); });
    EXPECT_TRUE(said.starts_with("in memory: ")) << said;
}

// The front of a sprite is seen from any side.
TEST(LibraryEntities, SpriteTurnsToTheEyeInALevel) {
    Hall hall;
    Picture picture = Picture::of_size(20, 20);
    picture.pixels.assign(400, 3);
    const Model sprite = Model::sprite(picture, 512);
    for (const int yaw : {0, 90, 200}) {
        const Pose eye = moved(pose_at(0, 0, 60, yaw), -100 * 256, 0);
        const auto without = hall.picture(eye);
        hall.level.show(sprite, pose_at(0, 0, 40));
        const auto shown = hall.picture(eye);
        std::int64_t changed = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) changed += shown[i] != without[i];
        EXPECT_NEAR(double(changed), 64 * 64 / 1.2, 200) << yaw;
    }
}

}  // namespace
}  // namespace oblong::test
