#include "game/input/key_names.h"

#include <algorithm>
#include <span>
#include <string_view>

namespace oblong {
namespace {

constexpr Input kEscape{Device::Key, 41}, kEnter{Device::Key, 40};

struct Entry {
    std::string_view label;
    std::vector<Action> actions;
};

std::vector<KeyHelp> help_of(std::span<const Entry> entries, const KeyNames& names) {
    std::vector<KeyHelp> help;
    for (const Entry& entry : entries) {
        std::string keys;
        for (const Action action : entry.actions) keys += (keys.empty() ? "" : " ") + names.of(action);
        help.push_back({std::string(entry.label), std::move(keys)});
    }
    return help;
}

}  // namespace

std::string KeyNames::of(Action action) const {
    if (action == Action(Command::Menu))  // whatever else is bound to it
        return platform_.local_name_of(uses_pad_ ? pad_button(PadButton::Start) : kEscape);
    const std::span<const Input> inputs = bindings_.inputs_of(action);
    if (inputs.empty()) return "none";
    const auto found =
        std::find_if(inputs.begin(), inputs.end(), [&](Input input) { return is_of_pad(input) == uses_pad_; });
    return platform_.local_name_of(found == inputs.end() ? inputs.front() : *found);
}

// Empty where it names nothing.
std::string KeyNames::of(std::string_view name) const {
    if (name == "choose") return uses_pad_ ? "Stick" : "Arrows";
    if (name == "accept") return platform_.local_name_of(uses_pad_ ? pad_button(PadButton::A) : kEnter);
    const auto actions = all_actions();
    const auto found =
        std::find_if(actions.begin(), actions.end(), [&](const ActionNames& row) { return row.name == name; });
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
    const std::vector<Entry> entries{
        {"Walk", {Move::Forward, Move::Left, Move::Back, Move::Right}},
        {"Turn; or by the mouse", {Move::TurnLeft, Move::TurnRight}},
        {"Jump, swim up", {Move::Jump}},
        {"Walk slowly", {Move::WalkSlowly}},
        {"Map", {Command::Automap}},
        {"Torch", {Command::Torch}},
        {"Menu", {Command::Menu}},
        {"Quick save", {Command::QuickSave}},
        {"Quick load", {Command::QuickLoad}},
        {"Back to the way in", {Command::Respawn}},
        {"Restart the level", {Command::Restart}},
        {"Drawn for: projection", {Command::ProjectionAspect}},
        {"Shown as: display", {Command::DisplayAspect}},
        {"Next accuracy", {Command::AccuracyTier}},
        {"Scaling", {Command::ScalingMode}},
        {"Cost of a frame", {Command::FrameCost}},
        {"Lab: dials", {Command::LabPanel}},
        {"Map of the error", {Command::ErrorMap}},
        {"Split: now and exact", {Command::SplitView}},
        {"Flip: now and before", {Command::FlipSettings}},
        {"Circle and square", {Command::AspectGuide}},
        {"Screenshots", {Command::Screenshot}},
        {"Four aspects", {Command::FourAspects}},
        {"Edges of faces", {Command::Wireframe}},
        {"From outside", {Command::Isometric}},
        {"What is ahead", {Command::Inspect}},
        {"Zoom and dolly", {Command::ZoomIn, Command::ZoomOut}},
        {"Look of a tube", {Command::CrtLook}},
        {"Brightness", {Command::Darker, Command::Brighter}},
        {"Log", {Command::Log}},
        {"These keys", {Command::ShowHelp}},
    };
    return help_of(entries, names);
}

std::vector<KeyHelp> gallery_help(const KeyNames& names) {
    const std::vector<Entry> entries{
        {"Next row", {Command::PageDown}},
        {"Row before", {Command::PageUp}},
        {"Choose a parameter", {Command::DialUp, Command::DialDown}},
        {"Change it", {Command::DialCoarser, Command::DialFiner}},
        {"All figures", {Command::FrameCost}},
        {"Next accuracy", {Command::AccuracyTier}},
        {"Drawn for: projection", {Command::ProjectionAspect}},
        {"Shown as: display", {Command::DisplayAspect}},
        {"Scaling", {Command::ScalingMode}},
        {"Look of a tube", {Command::CrtLook}},
        {"Screenshots", {Command::Screenshot}},
        {"Back", {Command::Menu}},
        {"These keys", {Command::ShowHelp}},
    };
    return help_of(entries, names);
}

}  // namespace oblong
