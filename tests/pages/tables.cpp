#include "tests/pages/tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/level/entity_classes.h"
#include "engine/level/left_out.h"
#include "engine/programs/game_definition.h"
#include "game/input/bindings.h"
#include "game/options/preference_table.h"

namespace oblong::test {
namespace {

/// "W Up Page-Down" as "W, Up, Page Down".
std::string listed(std::string_view inputs) {
    std::string text;
    for (const char letter : inputs) text += letter == ' ' ? ", " : letter == '-' ? " " : std::string(1, letter);
    return text;
}

/// Of one hand alone, where that is something else.
std::string of_hand(std::string_view hand, std::string_view both) {
    return hand == both ? "" : listed(hand);
}

std::string shape_of(const EntityClass& row) {
    const std::array names{"the world", "point", "brushes", "any"};
    return names.at(static_cast<std::size_t>(row.shape));
}

std::string name_of(const EntityClass& row) {
    return code(row.is_family() ? std::string(row.name.substr(0, row.name.size() - 1)) + "..." : std::string(row.name));
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
    return names.at(static_cast<std::size_t>(key.kind)) + (key.range ? ", " + range_text(*key.range) : "");
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

}  // namespace

std::string action_table() {
    std::string text = "| does | name | keys | mouse, gamepad | left hand | right hand |\n|---|---|---|---|---|---|\n";
    for (const ActionRow& row : all_actions())
        text += "| " + std::string(row.label) + " | " + code(row.name) + " | " + listed(row.keys) + " | " +
                listed(row.others) + " | " + of_hand(row.left_hand, row.keys) + " | " +
                of_hand(row.right_hand, row.keys) + " |\n";
    return text;
}

std::string option_table() {
    std::string text = "| option | values (default) | meaning |\n|---|---|---|\n";
    const Preferences usual;
    for (const Preference& row : all_preferences()) {
        if (row.name.starts_with("dial-")) continue;
        text += "| " + code(row.name) + " | " + row.values + " (" + row.text(usual) + ") | " + row.help + " |\n";
    }
    return text;
}

std::string dial_table() {
    std::string text = "| dial | settings, the coarsest first | is |\n|---|---|---|\n";
    const Accuracy usual;
    for (const Dial& dial : all_dials()) {
        std::string settings;
        for (const DialSetting& setting : dial.settings) {
            const std::string name = code(setting.name);
            settings += (settings.empty() ? "" : ", ") + (setting.value == dial.get(usual) ? "**" + name + "**" : name);
        }
        if (!dial.unit.empty()) settings += " " + std::string(dial.unit);
        text += "| " + code(dial.name) + " | " + settings + " | " + std::string(dial.about) + " |\n";
    }
    return text;
}

std::string game_member_table() {
    std::string text = "| member | is |\n|---|---|\n";
    for (const GameMember& member : game_members())
        text += "| " + code(member.name) + " | " + std::string(member.does) + " |\n";
    return text;
}

// Classes of the same meaning are one row.
std::string class_table() {
    std::vector<std::array<std::string, 2>> rows;  // names, and what they are
    std::string others;
    for (const EntityClass& row : entity_classes()) {
        if (row.does.empty()) {
            others += (others.empty() ? "" : ", ") + name_of(row);
            continue;
        }
        const std::string meaning = " | " + shape_of(row) + " | " + std::string(row.does) + since_text(row.since) +
                                    " | " + list_of_keys(row) + " |\n";
        if (rows.empty() || rows.back()[1] != meaning)
            rows.push_back({name_of(row), meaning});
        else
            rows.back()[0] += ", " + name_of(row);
    }
    std::string text = "| class | kind | does | keys (their defaults) |\n|---|---|---|---|\n";
    for (const auto& [names, meaning] : rows) text.append("| ").append(names).append(meaning);
    return text + "\nKnown, and without effect: " + others + ".\n";
}

// Keys of the same meaning are one row. Whose it is stands there only where a key has several meanings: what most
// classes mean by it goes without.
std::string entity_key_table() {
    struct Row {
        std::array<std::string, 3> meaning;  // name, kind, what it does
        std::vector<std::string> owners;
    };
    std::vector<Row> rows;
    const auto add = [&](const EntityKey& key, const std::string& owner) {
        if (key.does.empty()) return;
        const std::array meaning{code(key.name), kind_of(key), std::string(key.does) + since_text(key.since)};
        const auto found =
            std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.meaning == meaning; });
        (found == rows.end() ? rows.emplace_back(Row{meaning, {}}) : *found).owners.push_back(owner);
    };
    for (const EntityKey& key : keys_of_all()) add(key, "all");
    for (const EntityClass& row : entity_classes()) {
        if (row.does.empty()) continue;
        for (const auto& group : row.keys)
            for (const EntityKey& key : group) add(key, name_of(row));
    }
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.meaning < b.meaning; });
    const auto is_usual = [&](const Row& row) {
        return std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
            return other.meaning[0] == row.meaning[0] && &other != &row && other.owners.size() >= row.owners.size();
        });
    };
    std::string text = "| key | value | is |\n|---|---|---|\n";
    for (const Row& row : rows) {
        text += "| " + row.meaning[0] + " | " + row.meaning[1] + " | " + row.meaning[2];
        for (std::size_t i = 0; i < row.owners.size() && !is_usual(row); ++i)
            text += (i == 0 ? " (" : ", ") + row.owners[i] + (i + 1 == row.owners.size() ? ")" : "");
        text += " |\n";
    }
    return text;
}

std::string left_out_table() {
    std::string text = "| left out | as |\n|---|---|\n";
    for (const LeftOut& row : kLeftOut) text += "| " + code(row.name) + " | " + std::string(row.reason) + " |\n";
    return text;
}

}  // namespace oblong::test
