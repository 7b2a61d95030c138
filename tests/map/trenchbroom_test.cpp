#include "tools/map/trenchbroom.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "engine/io/files.h"
#include "engine/level/entity_classes.h"
#include "tests/map/editor_formats.h"
#include "tests/support/patterns.h"
#include "tests/support/programs.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;

// As `oblong-map --install-trenchbroom` writes it.
class TrenchBroom : public testing::Test {
  protected:
    void SetUp() override { ASSERT_EQ(install("games/Oblong").exit_code, 0); }

    Outcome install(const std::string& folder) const {
        return run_program({"oblong-map", "--install-trenchbroom", path(folder)});
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::string installed(const std::string& name) const { return path("games/Oblong/" + name); }
    std::string text(const std::string& name) const { return read_text(installed(name)); }
    bool is_file(const std::string& name) const { return fs::is_regular_file(installed(name)); }

    // As the editor writes the initial map with a layer for its light, which has no brushes.
    std::string exported(const json& task) const {
        const std::string map =
            text("initial_valve.map") +
            "{\n\"classname\" \"func_group\"\n\"_tb_type\" \"_tb_layer\"\n\"_tb_name\" \"lights\"\n}\n";
        if (!task.value("stripTbProperties", false)) return map;
        return with_replaced(map, "\"_tb_[^\\n]*\n", "");
    }

    const TemporaryFolder folder_;
};

TEST_F(TrenchBroom, ItsConfigurationNamesFilesThatAreThere) {
    const json game = read_game_config(text("GameConfig.cfg"));
    EXPECT_EQ(game.at("name"), "Oblong");
    EXPECT_TRUE(is_file(game.at("icon")));
    for (const json& format : game.at("fileformats"))
        EXPECT_TRUE(!format.contains("initialmap") || is_file(format.at("initialmap")));
    EXPECT_EQ(game.at("filesystem").at("packageformat").at("format"), "idpak");
    EXPECT_TRUE(is_file("assets/" + game.at("materials").at("palette").get<std::string>()));
    EXPECT_EQ(game.at("materials").at("attribute"), "wad");
    for (const json& file : game.at("entities").at("definitions")) EXPECT_TRUE(is_file(file));
    EXPECT_EQ(game.at("entities").at("scale").size(), 1u);
}

TEST_F(TrenchBroom, EveryWayToCompileMakesALevel) {
    const json profiles = read_compilation_config(text("CompilationProfiles.cfg"));
    EditorVariables variables{{"MAP_DIR_PATH", path("my maps")}, {"MAP_BASE_NAME", "first room"}};
    fs::create_directories(path("my maps"));
    int count = 0;
    for (const json& profile : profiles.at("profiles")) {
        variables["WORK_DIR_PATH"] = interpolated(profile.at("workdir"), variables);
        const std::string level = path("my maps/first room.bsp");
        for (const json& task : profile.at("tasks")) {
            if (task.at("type") == "export") {
                write_file(interpolated(task.at("target"), variables), exported(task));
                continue;
            }
            const std::string tool = interpolated(task.at("tool"), variables),
                              parameters = interpolated(task.at("parameters"), variables);
            if (tool == build_folder() + "/bin/oblong-map") {
                const Outcome outcome = run_line("'" + tool + "' " + parameters + " --strict");
                EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
            } else {
                EXPECT_EQ(tool, build_folder() + "/bin/oblong");
                EXPECT_TRUE(parameters == "\"" + level + "\"" ||
                            parameters == "--watch \"" + path("my maps/first room.map") + "\"")
                    << parameters;
            }
        }
        EXPECT_TRUE(fs::is_regular_file(level)) << profile.at("name");
        ++count;
    }
    EXPECT_EQ(count, 5) << "draft, normal, full, light only, watch";
}

TEST_F(TrenchBroom, TheGameIsStartedWithTheMapsLevel) {
    const json profiles = read_engine_config(text("GameEngineProfiles.cfg"));
    const EditorVariables variables{{"GAME_DIR_PATH", "/g"}, {"MAP_BASE_NAME", "m"}};
    for (const json& profile : profiles.at("profiles")) {
        EXPECT_FALSE(profile.at("id") == "" && profile.at("name") == "");
        EXPECT_EQ(profile.at("path"), build_folder() + "/bin/oblong");
        EXPECT_EQ(interpolated(profile.at("parameters"), variables), "--error-box \"/g/maps/m.bsp\"");
    }
}

TEST_F(TrenchBroom, AWayToCompileThatWasKeptBeforeIsNotLost) {
    for (const char* const text : {"{ mine }", "{ newer }"}) {
        write_file(installed("CompilationProfiles.cfg"), text);
        ASSERT_EQ(install("games/Oblong").exit_code, 0);
    }
    EXPECT_EQ(text("CompilationProfiles.cfg.old"), "{ mine }");
    EXPECT_EQ(text("CompilationProfiles.cfg.old2"), "{ newer }");
    EXPECT_NO_THROW(read_compilation_config(text("CompilationProfiles.cfg")));
}

// What is there in the place of a folder or of a file of the configuration, and what the error names.
struct InTheWay {
    std::string name, is, where;

    friend void PrintTo(const InTheWay& row, std::ostream* out) { *out << row.is << " at " << row.name; }
};

class TrenchBroomInstaller : public TrenchBroom, public testing::WithParamInterface<InTheWay> {};

TEST_P(TrenchBroomInstaller, NamesWhatIsInTheWayAndLeavesNothingHalfWritten) {
    const auto& [name, is, where] = GetParam();
    const fs::path in_the_way = path("other/" + name);
    fs::create_directories(in_the_way.parent_path());
    if (is == "a folder") fs::create_directory(in_the_way);
    if (is == "a file") write_file(in_the_way.string(), std::string("mine"));
    if (is == "a full disk") fs::create_symlink("/dev/full", in_the_way);
    EXPECT_TRUE(names_fault(install("other/Oblong"), "oblong-map", path("other/" + where), ""));
    if (is == "a file") {
        EXPECT_EQ(read_text(in_the_way.string()), "mine");
    }
    for (const auto& file : fs::recursive_directory_iterator(path("other"))) {
        const fs::path same = path("games") / fs::relative(file, path("other"));
        if (file.path() == in_the_way || !file.is_regular_file()) continue;
        EXPECT_EQ(read_text(file.path().string()), read_text(same.string())) << file.path();
    }
}

INSTANTIATE_TEST_SUITE_P(Places, TrenchBroomInstaller,
                         testing::Values(InTheWay{"Oblong", "a file", "Oblong/assets/gfx"},
                                         InTheWay{"Oblong/assets", "a file", "Oblong/assets/gfx"},
                                         InTheWay{"Oblong/GameConfig.cfg", "a folder", "Oblong/GameConfig.cfg"},
                                         InTheWay{"Oblong/Oblong.fgd", "a folder", "Oblong/Oblong.fgd"},
                                         InTheWay{"Oblong/Icon.png", "a full disk", "Oblong/Icon.png"},
                                         InTheWay{"Oblong/assets/models", "a file", "Oblong/assets/models"}));

TEST(Fgd, NoFlagIsSetInANewEntity) {
    const std::string text = map::fgd_text();
    const std::vector<Groups> flags = all_matches(text, "\\n\\t\\t[0-9]+ : \"[^\"\\n]*\" : ([0-9]+)");
    for (const Groups& flag : flags) EXPECT_EQ(flag[1], "0") << flag[0];
    EXPECT_GT(flags.size(), 20u);
}

TEST(Fgd, HasAGamesOwnClassesWithTheirValues) {
    const map::OwnClasses own{{"func_slow_door", {"func_door", "takes its time", {{"speed", "30"}}}}};
    std::map<std::string, EditorClass> classes;
    for (const EditorClass& row : read_fgd(map::fgd_text(own))) classes[row.name] = row;
    EXPECT_EQ(classes.at("func_slow_door").keys, classes.at("func_door").keys);
    const std::string text = map::fgd_text(own), added = text.substr(map::fgd_text().size());
    EXPECT_NE(added.find("= func_slow_door : \"takes its time\""), std::string::npos) << added;
    EXPECT_NE(added.find("speed(float) : \"units a second\" : \"30\""), std::string::npos) << added;
    EXPECT_NE(added.find("wait(float) : \"seconds until it closes; -1: never\" : \"3\""), std::string::npos);
}

TEST_F(TrenchBroom, ClassesAreReadWithTheirModels) {
    const std::vector<EditorClass> classes = read_fgd(text("Oblong.fgd"));
    std::set<std::string_view> names, expected;
    for (const EntityClass& row : entity_classes())
        if (!row.is_family()) expected.insert(row.name);
    for (const EditorClass& each : classes) {
        names.insert(each.name);
        if (each.model.empty()) continue;
        const std::string model = model_path(each.model, {{"model", "models/armillary.obj"}, {"spawnflags", "1"}});
        EXPECT_TRUE(!model.ends_with(".obj") || is_file("assets/" + model)) << each.name << ": " << model;
        EXPECT_TRUE(model.ends_with(".obj") || model.ends_with(".mdl") || model.ends_with(".bsp")) << model;
    }
    EXPECT_EQ(names, expected);
}

}  // namespace
}  // namespace oblong::test
