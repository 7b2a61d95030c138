#include "game/level/level_search.h"

#include <gtest/gtest.h>

#include "game/level/load.h"
#include "tests/mesh_files/mdl_writer.h"
#include "tests/paks/pak_writer.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"

namespace oblong {
namespace {

using test::Bytes;

Bytes level_with(const std::string& entities) {
    test::Lumps lumps = test::make_tiny_lumps();
    Bytes& text = test::lump_of(lumps, Lump::Entities);
    const std::string whole = "{ \"classname\" \"worldspawn\" }" + entities;
    text.assign(whole.begin(), whole.end());
    text.push_back(0);
    return test::join_lumps(29, lumps);
}

Bytes palette_of(std::uint8_t grey) {
    return Bytes(768, grey);
}

// A game with two pak files; a level, e1m2, stands beside them too.
class Game : public ::testing::Test {
  protected:
    Game() {
        for (const char* below : {"game", "game/maps", "game/gfx", "mine"}) make_folder(folder_.path(below));
        folder_.write("game/pak0.pak", test::write_pak({{"gfx/palette.lmp", palette_of(40)},
                                                        {"maps/b_shell0.bsp", level_with("")},
                                                        {"maps/e1m1.bsp", level_with("{ \"zero\" \"\" }")},
                                                        {"maps/e1m2.bsp", level_with("")},
                                                        {"maps/e1m3.bsp", level_with("{ \"old\" \"\" }")},
                                                        {"progs/w_s_key.mdl", model()}}));
        folder_.write("game/pak1.pak", test::write_pak({{"maps/e1m3.bsp", level_with("{ \"new\" \"\" }")}}));
        folder_.write("game/maps/e1m2.bsp", level_with("{ \"loose\" \"\" }"));
        folder_.write("mine/e1m9.bsp", level_with(""));
        places_.game_folders = {folder_.path("game")};
    }
    static Bytes model() { return test::write_mdl(test::tetrahedron_model()); }

    test::TemporaryFolder folder_;
    LevelPlaces places_;
};

TEST_F(Game, ALevelIsFoundBesideThenInMapsThenInTheLastPakFile) {
    EXPECT_EQ(find_level("e1m1", places_), folder_.path("game/pak0.pak/maps/e1m1.bsp"));
    EXPECT_EQ(find_level("e1m2", places_), folder_.path("game/maps/e1m2.bsp"));
    EXPECT_EQ(find_level("e1m3", places_), folder_.path("game/pak1.pak/maps/e1m3.bsp"));
    EXPECT_EQ(find_level("e1m9", places_), std::nullopt);
    places_.beside = folder_.path("mine/start.bsp");
    EXPECT_EQ(find_level("e1m9", places_), folder_.path("mine/e1m9.bsp"));
    places_.beside = folder_.path("game/pak0.pak/maps/e1m1.bsp");
    EXPECT_EQ(find_level("e1m3", places_), folder_.path("game/pak1.pak/maps/e1m3.bsp"));
}

TEST_F(Game, ANameLeadsToNoOtherFolder) {
    for (const char* name : {"", "../mine/e1m9", "maps/e1m1", "..", ".hidden", "a\\b"})
        EXPECT_EQ(find_level(name, places_), std::nullopt) << name;
    EXPECT_THROW(find_named_level("../mine/e1m9", places_), FileError);
}

TEST_F(Game, AMissingLevelIsNamedWithAllPlacesWhereItWasLookedFor) {
    places_.beside = folder_.path("mine/start.bsp");
    const std::string text = test::refusal<FileError>([&] { find_named_level("e1m8", places_); });
    for (const std::string& part : {std::string("e1m8.bsp: "), folder_.path("mine"), std::string(" maps,"),
                                    folder_.path("game/maps"), "pak files in " + folder_.path("game")})
        EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(Game, AllLevelsAreListedOnceTheDemoLevelFirst) {
    const LevelList list = list_levels(places_);
    EXPECT_TRUE(list.problems.empty());
    ASSERT_GE(list.levels.size(), 4u);
    EXPECT_EQ(list.levels[0].name, "demo");
    EXPECT_EQ(list.levels[0].file, "");
    std::vector<ListedLevel> others;
    for (const ListedLevel& level : list.levels)
        if (level.file.starts_with(folder_.path())) others.push_back(level);
    ASSERT_EQ(others.size(), 3u) << "no boxes of ammunition";
    EXPECT_EQ(others[0].file, folder_.path("game/maps/e1m2.bsp"));
    EXPECT_EQ(others[1].file, folder_.path("game/pak0.pak/maps/e1m1.bsp"));
    EXPECT_EQ(others[2].file, folder_.path("game/pak1.pak/maps/e1m3.bsp"));
    EXPECT_EQ(others[2].name, "e1m3");
}

TEST_F(Game, ABrokenPakFileIsNamedAndItsLevelsAreNotListed) {
    const std::string broken = folder_.write("game/pak1.pak", "PACK");
    const LevelList list = list_levels(places_);
    ASSERT_EQ(list.problems.size(), 1u);
    EXPECT_TRUE(list.problems[0].starts_with(broken + ": offset 0: ")) << list.problems[0];
    EXPECT_EQ(find_level("e1m2", places_), folder_.path("game/maps/e1m2.bsp")) << "not looked into";
    EXPECT_THROW(find_level("e1m1", places_), FileError);
}

TEST_F(Game, ALevelOutOfAPakFileComesWithPaletteAndModels) {
    folder_.write("game/pak1.pak",
                  test::write_pak({{"maps/e1m4.bsp", level_with("{ \"classname\" \"item_key1\" \"origin\" \"9 9 40\" }"
                                                                "{ \"classname\" \"item_key1\" \"origin\" \"5 5 40\" "
                                                                "\"spawnflags\" \"512\" }")}}));
    const std::string file = find_named_level("e1m4", places_);
    const GameData data = load_game({file, "", folder_.path("mine"), ""});
    EXPECT_EQ(data.level_file, file);
    EXPECT_EQ(data.level.entities.size(), 3u);
    EXPECT_EQ(data.palette.colours[7].green, 40);
    ASSERT_EQ(data.models.models.size(), 1u) << "the other is not there at normal skill";
    EXPECT_EQ(data.models.models[0].entity, 1u);
}

TEST_F(Game, ALoosePaletteComesBeforeThoseOfPakFiles) {
    folder_.write("game/gfx/palette.lmp", palette_of(9));
    EXPECT_EQ(load_game({find_named_level("e1m1", places_), "", folder_.path("mine"), ""}).palette.colours[7].green, 9);
    EXPECT_EQ(load_game({find_named_level("e1m2", places_), "", folder_.path("mine"), ""}).palette.colours[7].green, 9)
        << "in the folder above";
}

TEST_F(Game, AFaultInALevelOfAPakFileIsNamedByItsPath) {
    const Bytes broken(40, 7);
    folder_.write("game/pak0.pak", test::write_pak({{"maps/bad.bsp", broken}}));
    const std::string file = find_named_level("bad", places_);
    const std::string said = test::refusal<FileError>([&] { load_game({file, "", folder_.path("mine"), ""}); });
    EXPECT_TRUE(said.starts_with(file + ": ")) << said;
    EXPECT_THROW(read_game_file(folder_.path("game/pak0.pak/maps/none.bsp")), FileError);
}

}  // namespace
}  // namespace oblong
