#include "tests/pages/tables.h"

#include "engine/accuracy/dials.h"
#include "engine/files/game_definition.h"
#include "game/input/actions.h"
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

}  // namespace oblong::test
