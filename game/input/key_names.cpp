#include "game/input/key_names.h"

#include <algorithm>
#include <span>
#include <string_view>

namespace oblong {
namespace {

constexpr Input kEscape{Device::Key, 41}, kEnter{Device::Key, 40};

}  // namespace

std::string KeyNames::of(Action action) const {
    if (action == Action::Menu)  // not from the bindings
        return platform_.local_name_of(uses_pad_ ? pad_button(PadButton::Start) : kEscape);
    const std::span<const Input> inputs = bindings_.inputs_of(action);
    if (inputs.empty()) return "none";
    const auto found =
        std::find_if(inputs.begin(), inputs.end(), [&](Input input) { return is_of_pad(input) == uses_pad_; });
    return platform_.local_name_of(found == inputs.end() ? inputs.front() : *found);
}

// Empty if the name is unknown.
std::string KeyNames::of(std::string_view name) const {
    if (name == "choose") return uses_pad_ ? "Stick" : "Arrows";
    if (name == "accept") return platform_.local_name_of(uses_pad_ ? pad_button(PadButton::A) : kEnter);
    const auto actions = all_actions();
    const auto found =
        std::find_if(actions.begin(), actions.end(), [&](const ActionRow& row) { return row.name == name; });
    return found == actions.end() ? "" : of(found->action);
}

std::string KeyNames::in(const std::string& text) const {
    std::string shown;
    std::string_view rest = text;
    for (std::size_t open = 0; (open = rest.find('{')) != std::string_view::npos;) {
        const std::size_t close = rest.find('}', open);
        if (close == std::string_view::npos) break;
        const std::string name = of(rest.substr(open + 1, close - open - 1));
        shown += rest.substr(0, open);
        shown += name.empty() ? std::string(rest.substr(open, close - open + 1)) : name;
        rest.remove_prefix(close + 1);
    }
    return shown + std::string(rest);
}

std::vector<KeyHelp> game_help(const KeyNames& names) {
    std::vector<KeyHelp> help;
    for (const ActionRow& row : all_actions()) {
        if (row.help.empty()) continue;
        if (help.empty() || help.back().label != row.help)
            help.push_back({std::string(row.help), names.of(row.action)});
        else
            help.back().keys += " " + names.of(row.action);
    }
    return help;
}

std::vector<KeyHelp> gallery_help(const KeyNames& names) {
    struct Entry {
        std::string_view label;
        std::vector<Action> actions;
    };
    const std::vector<Entry> entries{
        {"Next row", {Action::PageDown}},
        {"Row before", {Action::PageUp}},
        {"Choose a parameter", {Action::DialUp, Action::DialDown}},
        {"Change it", {Action::DialCoarser, Action::DialFiner}},
        {"All figures", {Action::FrameCost}},
        {"Next accuracy", {Action::AccuracyTier}},
        {"Drawn for: projection", {Action::ProjectionAspect}},
        {"Shown as: display", {Action::DisplayAspect}},
        {"Scaling", {Action::ScalingMode}},
        {"CRT look", {Action::CrtLook}},
        {"Screenshots", {Action::Screenshot}},
        {"Back", {Action::Menu}},
        {"These keys", {Action::ShowHelp}},
    };
    std::vector<KeyHelp> help;
    for (const Entry& entry : entries) {
        std::string keys;
        for (const Action action : entry.actions) keys += (keys.empty() ? "" : " ") + names.of(action);
        help.push_back({std::string(entry.label), std::move(keys)});
    }
    return help;
}

}  // namespace oblong
