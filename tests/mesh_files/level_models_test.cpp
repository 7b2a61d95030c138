#include "engine/models/level_models.h"

#include <gtest/gtest.h>

#include "engine/io/files.h"
#include "engine/level/entities.h"
#include "engine/level/entity_classes.h"
#include "engine/level/trace.h"
#include "tests/mesh_files/mdl_writer.h"
#include "tests/support/levels.h"
#include "tests/support/script.h"

namespace oblong::test {
namespace {

/// A folder with maps/level.bsp beside progs/ and models/; the level's floor is at z = 8.
class ModelFolder : public ::testing::Test {
  protected:
    ModelFolder() {
        for (const char* below : {"maps", "progs", "models", "elsewhere"}) make_folder(path(below));
    }

    std::string path(const std::string& name) const { return folder_.path(name); }
    void write_model(const std::string& name, std::int32_t flags = 0) const {
        MdlFile file = write_mdl(tetrahedron_model());
        put_number(file, kMdlFrames + 8, 4, flags);
        write_file(path(name), file);
    }
    LevelModels read(const std::string& entities, const std::string& named = "") const {
        Level level = tiny_level();
        for (int i = 0; i < 2; ++i) level.models.push_back(SubModel(level.world()));  // "*1" and "*2"
        level.entities = parse_entities("{ \"classname\" \"worldspawn\" }" + entities, "test");
        return read_level_models(level, {}, {path("maps/level.bsp"), named, path("elsewhere")});
    }
    static PlacedMesh at(const LevelModels& models, std::int64_t time_ms, std::size_t number = 0) {
        std::vector<PlacedMesh> placed;
        place_models(models, time_ms, {}, placed);
        EXPECT_EQ(placed.size(), models.models.size());
        return placed.at(number);
    }

  private:
    const TemporaryFolder folder_;
};

/// The text of an entity at 5 6 70, "CLASS KEY=VALUE ...".
std::string entity(const std::string& text) {
    const Words words = words_of(text);
    std::string keys = "{ \"classname\" \"" + words[0] + "\" \"origin\" \"5 6 70\"";
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t equals = words[i].find('=');
        keys += " \"" + words[i].substr(0, equals) + "\" \"" + words[i].substr(equals + 1) + "\"";
    }
    return keys + " }";
}
std::string thing(const std::string& keys = "") {
    return entity("misc_model model=thing.mdl " + keys);
}

TEST_F(ModelFolder, AMiscModelShowsAFileAtItsPlace) {
    write_model("models/thing.mdl");
    const LevelModels models = read(entity("misc_model model=models/thing.mdl angle=90 skin=1 scale=0.5"));
    ASSERT_EQ(models.models.size(), 1u);
    EXPECT_TRUE(models.warnings.empty());
    const PlacedMesh placed = at(models, 0);
    EXPECT_EQ(placed.position, point_at(5, 6, 70));
    EXPECT_EQ(placed.yaw, kQuarterTurn);
    EXPECT_EQ(placed.skin, 1u);
    EXPECT_EQ(placed.mesh->frames[0].maxs, point_at(50, 50, 50));
    EXPECT_EQ(at(models, 600).skin, 2u) << "skins of a group take turns: 0.5 s, 0.25 s";
    EXPECT_EQ(at(models, 750).skin, 1u);
    EXPECT_EQ(at(models, 123456).yaw, kQuarterTurn);
}

TEST_F(ModelFolder, AnglesAreThoseOfACamera) {
    write_model("models/thing.mdl");
    const PlacedMesh placed = at(read(thing("angles=\"90 180 -90\" shading=phong highlight=200")), 0);
    EXPECT_EQ(placed.pitch, kQuarterTurn);
    EXPECT_EQ(placed.yaw, kHalfTurn);
    EXPECT_EQ(placed.roll, -kQuarterTurn);
    EXPECT_EQ(placed.shading, Shading::Phong);
    EXPECT_EQ(placed.highlight, 200);
}

TEST_F(ModelFolder, FramesGoByTimeAlone) {
    write_model("models/thing.mdl");
    const LevelModels still = read(thing()), group = read(thing("frame=1")), separate = read(thing("frames=2"));
    for (const std::int64_t turn_ms : {0, 300 * 1000}) {
        EXPECT_EQ(at(still, turn_ms + 250).frame, 0u);
        EXPECT_EQ(at(group, turn_ms + 99).frame, 1u);
        EXPECT_EQ(at(group, turn_ms + 100).frame, 2u);
        EXPECT_EQ(at(separate, turn_ms + 99).frame, 0u);
        EXPECT_EQ(at(separate, turn_ms + 100).frame, 2u) << "the second, which is a group 100 ms after its start";
    }
}

TEST_F(ModelFolder, OneFileIsReadOnce) {
    write_model("models/thing.mdl");
    const LevelModels models = read(thing() + thing() + thing("scale=2") + thing());
    EXPECT_EQ(models.models.size(), 4u);
    EXPECT_EQ(models.meshes.size(), 2u);
    EXPECT_EQ(at(models, 0, 3).mesh, at(models, 0, 0).mesh);
}

TEST_F(ModelFolder, WhatTurnsTurnsByTime) {
    write_model("models/thing.mdl", 8);
    write_model("models/other.mdl", 0x10);
    const LevelModels models =
        read(thing() + entity("misc_model model=other.mdl") + entity("misc_model model=other.mdl period=8"));
    EXPECT_EQ(at(models, 900, 0).yaw, kQuarterTurn) << "100 degrees a second";
    EXPECT_EQ(at(models, 3600 * 1000, 0).yaw, Angle{});
    EXPECT_EQ(at(models, 900, 1).yaw, Angle{});
    EXPECT_EQ(at(models, 4000, 2).yaw, kHalfTurn);
}

TEST_F(ModelFolder, ItemsOfQuakeStandOnTheFloor) {
    write_model("progs/armor.mdl", 8);
    write_model("progs/b_g_key.mdl");
    write_model("progs/flame.mdl");
    const LevelModels models =
        read(entity("item_armor2") + entity("light_torch_small_walltorch") + entity("monster_ogre"), path("progs"));
    ASSERT_EQ(models.models.size(), 2u);
    EXPECT_EQ(at(models, 0, 0).position, point_at(5, 6, 8));
    EXPECT_EQ(at(models, 0, 0).skin, 1u);
    EXPECT_EQ(at(models, 0, 1).position, point_at(5, 6, 70));
}

TEST_F(ModelFolder, KeysAreThoseOfTheWorldsKind) {
    const auto file = [](const std::string& name, std::int32_t flags, std::int32_t world_type) {
        const ClassModel* model = find_class_model(*find_entity_class(name), flags, world_type);
        return model ? std::string(model->file) : "";
    };
    EXPECT_EQ(file("item_key2", 0, 0), "progs/w_g_key.mdl");
    EXPECT_EQ(file("item_key2", 0, 2), "progs/b_g_key.mdl");
    EXPECT_EQ(file("item_cells", 1, 0), "maps/b_batt1.bsp");
    EXPECT_EQ(file("item_cells", 0, 0), "maps/b_batt0.bsp");
    EXPECT_EQ(file("item_sigil", 4, 0), "progs/end3.mdl");
    EXPECT_EQ(file("monster_knight", 0, 0), "");
}

TEST_F(ModelFolder, AMissingFileIsOneWarning) {
    const std::string armor = entity("item_armor1"), cells = entity("item_cells"), shells = entity("item_shells");
    EXPECT_TRUE(read(armor + cells).warnings.empty()) << "nobody said where Quake's models are";
    const LevelModels models = read(armor + armor + cells + cells + shells, path("elsewhere"));
    EXPECT_TRUE(models.models.empty());
    ASSERT_EQ(models.warnings.size(), 2u);
    EXPECT_NE(models.warnings[0].find("entity 1 (item_armor1): at 5 6 70: there is no file progs/armor.mdl"),
              std::string::npos)
        << models.warnings[0];
    EXPECT_NE(models.warnings[1].find("maps/b_batt0.bsp is made of brushes"), std::string::npos) << models.warnings[1];
    const LevelModels own = read(entity("misc_model model=models/none.obj"));
    ASSERT_EQ(own.warnings.size(), 1u);
    EXPECT_NE(own.warnings[0].find("there is no file models/none.obj for the model at 5 6 70"), std::string::npos);
}

TEST_F(ModelFolder, TheNamedFolderComesFirst) {
    write_model("progs/armor.mdl", 8);
    const std::string armor = entity("item_armor1");
    EXPECT_TRUE(read(armor, path("elsewhere")).meshes.at(0)->turns) << "else beside the level";
    write_model("elsewhere/armor.mdl");
    EXPECT_FALSE(read(armor, path("elsewhere")).meshes.at(0)->turns);
}

// That of --game, when a level is watched while it is drawn elsewhere.
TEST_F(ModelFolder, TheGamesFoldersAreSearched) {
    for (const char* below : {"game", "game/models"}) make_folder(path(below));
    write_model("game/models/chair.mdl");
    Level level = tiny_level();
    level.entities = parse_entities(entity("misc_model model=models/chair.mdl"), "test");
    ModelFolders folders{path("drafts/level.bsp"), ""};
    EXPECT_EQ(read_level_models(level, {}, folders).meshes.size(), 0u);
    folders.games = {path("game")};
    EXPECT_EQ(read_level_models(level, {}, folders).meshes.size(), 1u);
}

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(ModelFolder, LensesAndKeysHaveModelsOfTheirOwn) {
    const std::string lens = entity("item_lens"), key = entity("item_key1");
    EXPECT_TRUE(read(lens + key).models.empty());
    EXPECT_TRUE(read(lens + key).warnings.empty()) << "as for Quake's classes, nobody named a file";
    for (const char* name : {"elsewhere/lens.obj", "elsewhere/key_silver.obj"}) write_file(path(name), kTriangle);
    const LevelModels models = read(lens + key);
    ASSERT_EQ(models.models.size(), 2u);
    EXPECT_EQ(at(models, 0).position, point_at(5, 6, 70)) << "where the level has it";
    EXPECT_EQ(at(models, 0, 1).position, point_at(5, 6, 8 + 28)) << "over the floor";
    EXPECT_NE(at(models, 900).yaw, at(models, 0).yaw) << "they turn";
    EXPECT_EQ(models.models[1].entity, 2u);
    EXPECT_EQ(models.meshes.at(0)->frames[0].maxs.z, World::from_int(9)) << "y of the file is up; lenses are enlarged";
    EXPECT_EQ(models.meshes.at(1)->frames[0].maxs.z, World::from_int(12));
    const LevelModels small = read(entity("item_lens scale=1.5"));
    EXPECT_EQ(small.meshes.at(0)->frames[0].maxs.z, World::from_raw(3 * 2048));
    write_model("progs/w_s_key.mdl");
    EXPECT_EQ(read(key, path("progs")).meshes.at(0)->frames[0].maxs, point_at(100, 100, 100))
        << "Quake's own comes first";
}

TEST_F(ModelFolder, WhatIsGoneIsNotPlaced) {
    write_model("models/thing.mdl");
    const LevelModels models = read(thing() + thing("angle=90"));
    const std::vector<std::uint8_t> is_gone{1, 0};
    std::vector<PlacedMesh> placed;
    place_models(models, 0, {is_gone}, placed);
    ASSERT_EQ(placed.size(), 1u);
    EXPECT_EQ(placed[0].yaw, kQuarterTurn);
}

TEST_F(ModelFolder, DoorsThatTurnAreShownOnlyAtTheAnglesOfAGame) {
    const LevelModels models = read(
        "{ \"classname\" \"func_door_rotating\" \"model\" \"*1\" \"origin\" \"1 2 3\" \"spawnflags\" \"128\" }"
        "{ \"classname\" \"func_rotating\" \"model\" \"*2\" \"speed\" \"-36\" }");
    ASSERT_EQ(models.models.size(), 2u);
    std::vector<PlacedMesh> placed;
    place_models(models, 2500, {}, placed);
    ASSERT_EQ(placed.size(), 1u) << "the door is a brush";
    EXPECT_EQ(placed[0].yaw, -kQuarterTurn) << "2.5 s of 36 degrees, clockwise";
    const std::vector<Angle> turned{kQuarterTurn, kHalfTurn};
    place_models(models, 2500, {{}, turned}, placed);
    ASSERT_EQ(placed.size(), 2u);
    EXPECT_EQ(placed[0].position, point_at(1, 2, 3));
    EXPECT_EQ(placed[0].pitch, kQuarterTurn);
    EXPECT_EQ(placed[0].yaw, Angle{});
    EXPECT_EQ(placed[1].yaw, -kQuarterTurn) << "no door";
}

TEST_F(ModelFolder, BrushesThatCannotTurnAsTheyShouldAreReported) {
    const LevelModels models = read(
        "{ \"classname\" \"func_door_rotating\" \"model\" \"*1\" }"
        "{ \"classname\" \"func_rotating\" \"model\" \"*1\" }"
        "{ \"classname\" \"func_rotating\" \"model\" \"*2\" \"origin\" \"0 0 40000\" }");
    ASSERT_EQ(models.models.size(), 2u);
    EXPECT_EQ(
        models.warnings,
        (std::vector<std::string>{
            "entity 1 (func_door_rotating): origin is \"\", expected x y z near its brushes: it turns about their "
            "middle",
            "entity 2 (func_rotating): another entity has the same brush model: it is left out",
            "entity 3 (func_rotating): origin is \"0 0 40000\", expected x y z near its brushes: it turns about "
            "their middle"}));
}

TEST_F(ModelFolder, BadValuesAreReplacedAndReported) {
    write_model("models/thing.mdl");
    for (const std::string key : {"frame=2", "skin=-1", "scale=0", "scale=x", "up=x", "shading=toon", "angles=\"1 2\"",
                                  "frames=3", "highlight=256"}) {
        const LevelModels models = read(thing(key));
        EXPECT_EQ(models.warnings.size(), 1u) << key;
        EXPECT_EQ(models.models.size(), 1u) << key;
    }
    for (const std::string model : {"", "../maps/level.bsp", "/etc/passwd"}) {
        const LevelModels models = read(entity("misc_model model=" + model));
        EXPECT_EQ(models.warnings.size(), 1u) << model;
        EXPECT_TRUE(models.models.empty()) << model;
    }
    EXPECT_EQ(read("{ \"classname\" \"misc_model\" \"model\" \"thing.mdl\" }").warnings.size(), 1u) << "no place";
}

TEST_F(ModelFolder, ABrokenFileIsAnErrorThatNamesIt) {
    write_file(path("models/bad.mdl"), std::string("IDPO"));
    write_file(path("models/bad.obj"), std::string("v 1 2 x\n"));
    for (const std::string name : {"bad.mdl", "bad.obj"}) {
        const std::string said = refusal<FileError>([&] { read(entity("misc_model model=" + name)); });
        EXPECT_NE(said.find("models/" + name + ": "), std::string::npos) << said;
    }
}

TEST_F(ModelFolder, AnObjFileIsScaledWhereItIsRead) {
    write_file(path("models/lens.obj"), std::string("v 0 0 0\nv 0.001 0 0\nv 0 0.002 0\nf 1 2 3\n"));
    const LevelModels y_up = read(entity("misc_model model=lens.obj scale=1000")),
                      z_up = read(entity("misc_model model=lens.obj scale=1000 up=z"));
    EXPECT_EQ(at(y_up, 0).mesh->frames[0].maxs, point_at(0, 1, 2));
    EXPECT_EQ(at(z_up, 0).mesh->frames[0].maxs, point_at(1, 2, 0));
}

// 64 MB at each of three scales: a level's models have 128 MB or less, whatever it names.
TEST_F(ModelFolder, ALargeFileIsNotReadAgainAtEveryScale) {
    write_model("models/large.mdl");
    std::filesystem::resize_file(path("models/large.mdl"), std::uintmax_t{1} << 26);
    std::string entities;
    for (const char* scale : {"1", "2", "3", "2"})
        entities += entity(std::string("misc_model model=large.mdl scale=") + scale);
    const LevelModels models = read(entities);
    EXPECT_EQ(models.meshes.size(), 2u);
    EXPECT_EQ(models.models.size(), 3u);
    ASSERT_EQ(models.warnings.size(), 1u);
    EXPECT_NE(models.warnings[0].find("have more than 134217728 bytes: "), std::string::npos) << models.warnings[0];
}

/// Armour and batteries of the real levels, by their entities.
TEST(RealLevelModels, ShowTheModelsThatThereAre) {
    OBLONG_NEEDS_SHARED_LEVELS();
    const std::string folder = (find_shared_folder() / "levels").string();
    const std::array<std::size_t, 3> expected{
        5, 0, 1};  // armour, and cells without the flag of large ones, of dm4, e1m7 and end
    for (std::size_t i = 0; i < kRealLevels.size(); ++i) {
        const Level level = read_bsp(read_shared_file(std::string(kRealLevels[i]) + ".bsp"));
        const LevelModels models =
            read_level_models(level, {}, {folder + "/" + kRealLevels[i] + ".bsp", folder + "/models"});
        EXPECT_EQ(models.models.size(), expected[i]) << kRealLevels[i];
        EXPECT_LE(models.meshes.size(), 2u);
        for (const LevelModel& model : models.models) {
            const Vec3<World>& at = model.placed.position;
            EXPECT_TRUE(find_floor(level, at + Vec3<World>{{}, {}, World::from_int(1)}, World::from_int(2)).has_value())
                << kRealLevels[i];
        }
    }
}

}  // namespace
}  // namespace oblong::test
