#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "engine/files/files.h"
#include "engine/level/entity_classes.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

std::string code(std::string_view text) {
    return "`" + std::string(text) + "`";
}

std::string shape_of(const EntityClass& row) {
    const std::array names{"the world", "point", "brushes", "any"};
    return names.at(static_cast<std::size_t>(row.shape));
}

std::string name_of(const EntityClass& row) {
    return code(row.name.ends_with('_') ? std::string(row.name) + "..." : std::string(row.name));
}

std::string kind_of(const EntityKey& key) {
    if (key.kind == KeyKind::Choice || key.kind == KeyKind::Flags) {
        std::string text;
        for (const KeyValue& value : key.values)
            text += (text.empty() ? "" : ", ") + std::string(value.value) +
                    (value.value == value.does ? "" : ": " + std::string(value.does));
        return text;
    }
    const std::string least = std::to_string(key.least), most = std::to_string(key.most);
    const std::array names{
        std::string("text"),
        least == most ? (most == "1" ? "number" : most + " numbers") : least + " to " + most + " numbers",
        std::string("whole number"),
        std::string(),
        std::string(),
        std::string("name"),
        std::string("name of others"),
        std::string("name of a place"),
        std::string("texture with holes")};
    return names.at(static_cast<std::size_t>(key.kind));
}

std::string list_of_keys(const EntityClass& row) {
    std::string text;
    std::map<std::string_view, int> seen;
    for (const auto& group : row.keys)
        for (const EntityKey& key : group) {
            if (seen[key.name]++ > 0 || key.does.empty()) continue;
            text += (text.empty() ? "" : ", ") + code(key.name) +
                    (key.usual.empty() ? "" : " (" + std::string(key.usual) + ")");
        }
    return text;
}

std::string class_table() {
    std::string text = "| class | is | does | keys (what they usually are) |\n|---|---|---|---|\n", others;
    for (const EntityClass& row : entity_classes()) {
        if (row.does.empty())
            others += (others.empty() ? "" : ", ") + name_of(row);
        else
            text += "| " + name_of(row) + " | " + shape_of(row) + " | " + std::string(row.does) + " | " +
                    list_of_keys(row) + " |\n";
    }
    return text + "\nKnown, and without effect: " + others + ".\n";
}

// Keys of the same meaning in one row.
std::string key_table() {
    using Meaning = std::array<std::string, 3>;  // name, kind, what it does
    std::vector<std::pair<Meaning, std::string>> rows;
    const auto add = [&](const EntityKey& key, const std::string& owner) {
        if (key.does.empty()) return;
        const Meaning meaning{code(key.name), kind_of(key), std::string(key.does)};
        const auto found =
            std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.first == meaning; });
        if (found == rows.end())
            rows.emplace_back(meaning, owner);
        else
            found->second += ", " + owner;
    };
    for (const EntityKey& key : keys_of_all()) add(key, "all");
    for (const EntityClass& row : entity_classes()) {
        if (row.does.empty()) continue;
        for (const auto& group : row.keys)
            for (const EntityKey& key : group) add(key, name_of(row));
    }
    std::sort(rows.begin(), rows.end());
    std::string text = "| key | value | is | of |\n|---|---|---|---|\n";
    for (const auto& [meaning, owners] : rows)
        text += "| " + meaning[0] + " | " + meaning[1] + " | " + meaning[2] + " | " + owners + " |\n";
    return text;
}

TEST(ClassPages, AreTheTable) {
    const std::string page = read_text(source_folder() + "/tools/map/README.md");
    for (const std::string& table : {class_table(), key_table()})
        EXPECT_NE(page.find(table), std::string::npos) << "tools/map/README.md should have\n" << table;
}

}  // namespace
}  // namespace oblong::test
