#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "engine/io/files.h"
#include "engine/level/entity_classes.h"
#include "engine/level/left_out.h"
#include "game/sound/sound_table.h"
#include "tests/map/editor_formats.h"
#include "tests/support/folders.h"
#include "tests/support/patterns.h"
#include "tools/map/source/map_file.h"
#include "tools/map/trenchbroom.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// Every row is a class of its own, and no group of keys has one twice: the first would win.
TEST(EntityClasses, AreDifferent) {
    std::set<std::string_view> names;
    for (const EntityClass& row : entity_classes()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(find_entity_class(row.name), &row) << row.name << " is hidden by a family above it";
        for (const auto& group : row.keys) {
            std::set<std::string_view> keys;
            for (const EntityKey& key : group) EXPECT_TRUE(keys.insert(key.name).second) << row.name << ' ' << key.name;
        }
    }
}

TEST(EntityClasses, HaveSoundsAndModelsThatAreThere) {
    int models = 0;
    for (const EntityClass& row : entity_classes()) {
        EXPECT_EQ(find_sound(row.sound).has_value(), !row.sound.empty()) << row.name;
        if (row.own_model.file.empty()) continue;
        EXPECT_TRUE(fs::exists(source_folder() + "/assets/" + std::string(row.own_model.file))) << row.name;
        ++models;
    }
    EXPECT_EQ(models, 5);
}

TEST(EntityClasses, AreNotLeftOutToo) {
    for (const LeftOut& row : kLeftOut) {
        const EntityClass* const its_class = find_entity_class(row.name);
        EXPECT_TRUE(its_class == nullptr || its_class->is_family()) << row.name;
        for (const EntityClass& each : entity_classes())
            EXPECT_EQ(find_entity_key(each, row.name), nullptr) << each.name << ' ' << row.name;
    }
}

/// The sources of the rooms that read entities, without the table itself.
std::vector<std::string> sources_of_readers() {
    std::vector<std::string> texts;
    for (const char* room : {"engine/effects", "engine/scene", "engine/models", "engine/sound", "engine/level",
                             "game/simulation", "game/sound", "game/level", "game/view", "tools/map"})
        for (const auto& file : fs::recursive_directory_iterator(source_folder() + "/" + room)) {
            const std::string name = file.path().filename().string();
            const bool is_table =
                name.starts_with("entity_classes.") || name.starts_with("class_keys.") || name == "left_out.h";
            if (!is_table && (name.ends_with(".cpp") || name.ends_with(".h")))
                texts.push_back(read_text(file.path().string()));
        }
    return texts;
}

/// The first group of each match.
Names names_in(const std::vector<std::string>& texts, const std::string& pattern) {
    Names found;
    for (const std::string& text : texts)
        for (const Groups& match : all_matches(text, pattern)) found.insert(match[1]);
    return found;
}

const EntityKey* key_of_any_class(std::string_view key) {
    for (const EntityClass& row : entity_classes())
        if (const EntityKey* found = find_entity_key(row, key); found && !found->does.empty()) return found;
    return nullptr;
}

TEST(EntityClasses, ReadersNameNoClassThatIsNotInTheTable) {
    const std::string families =
        "worldspawn|light_(?!styles)|func_|trigger_|item_|weapon_|monster_|ambient_|misc_|info_|trap_";
    const Names named = names_in(sources_of_readers(), "\"((?:" + families + ")[a-z0-9_]*)\"");
    for (const std::string& name : named) {
        const EntityClass* const row = find_entity_class(name);
        EXPECT_TRUE(row != nullptr && row->name == name) << name;
    }
    EXPECT_LE(named.size(), 4u) << "what a class is, is its role";
}

TEST(EntityClasses, HaveEachKeyThatIsReadAndNoOther) {
    const std::vector<std::string> texts = sources_of_readers();
    const std::string readers =
        "value|has|number|whole_number|vector|colours|number_of|numbers_of|ticks_of|target_of|"
        "value_of|direction_of_mangle|length";
    const Names read = names_in(texts, "\\b(?:" + readers + R"re()\((?:[*\w]+, )?"([a-z_0-9]+)")re");
    EXPECT_GT(read.size(), 40u);
    for (const std::string& key : read)
        EXPECT_TRUE(key_of_any_class(key) || key.starts_with("_tb_")) << key << " is read";
    const Names literals = names_in(texts, R"re("([a-z_0-9]+)")re");
    const auto expect_read = [&](std::span<const EntityKey> keys) {
        for (const EntityKey& key : keys) {
            const std::string name(key.name.substr(0, key.name.find('#')));
            EXPECT_TRUE(key.does.empty() || literals.contains(name)) << name << " is in the table";
        }
    };
    expect_read(keys_of_all());
    for (const EntityClass& row : entity_classes())
        for (const auto& keys : row.keys) expect_read(keys);
}

TEST(EntityClasses, HaveAllThatTheDemoLevelHas) {
    int pairs = 0;
    for (const map::MapEntity& entity : map::parse_map(read_text(source_folder() + "/assets/demo.map"))) {
        const EntityClass* const row = find_entity_class(entity.value("classname"));
        ASSERT_TRUE(row != nullptr && !row->is_family() && !row->does.empty()) << entity.value("classname");
        for (const map::MapPair& pair : entity.pairs) {
            if (pair.key.starts_with("_tb_")) continue;  // TrenchBroom's own
            EXPECT_NE(find_entity_key(*row, pair.key), nullptr) << row->name << ' ' << pair.key;
            ++pairs;
        }
    }
    EXPECT_GT(pairs, 500);
}

TEST(Fgd, NamesTheClassesAndKeysOfTheTable) {
    std::map<std::string, std::map<std::string, std::string>> classes;  // type by key
    for (const EditorClass& row : read_fgd(map::fgd_text())) classes[row.name] = row.keys;
    std::size_t placed = 0;
    for (const EntityClass& row : entity_classes()) {
        if (row.is_family()) continue;
        ++placed;
        ASSERT_TRUE(classes.contains(std::string(row.name))) << row.name;
        Names wanted, found;
        const auto want = [&](std::span<const EntityKey> keys) {
            for (const EntityKey& key : keys) wanted.insert(std::string(key.name.substr(0, key.name.find('#'))));
        };
        for (const auto& keys : row.keys) want(keys);
        want(keys_of_all());
        wanted.erase("classname");
        wanted.erase("origin");
        for (const auto& [key, type] : classes.at(std::string(row.name))) found.insert(key);
        EXPECT_EQ(found, wanted) << row.name;
    }
    EXPECT_EQ(classes.size(), placed);
    EXPECT_EQ(classes.at("func_door").at("speed"), "float");
    EXPECT_EQ(classes.at("func_door").at("targetname"), "target_source");
    EXPECT_EQ(classes.at("trigger_relay").at("killtarget"), "target_destination");
    EXPECT_EQ(classes.at("misc_model").at("frames"), "integer");
    EXPECT_EQ(classes.at("light").at("delay"), "choices");
    EXPECT_EQ(classes.at("light").at("spawnflags"), "flags");
}

}  // namespace
}  // namespace oblong::test
