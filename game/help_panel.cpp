#include "game/help_panel.h"

#include <algorithm>
#include <span>
#include <string_view>

namespace oblong {
namespace {

constexpr std::size_t kKeyColumns = 10, kEntryColumns = 25;

struct Entry {
    std::vector<Action> actions;
    std::string_view label;  // at most 14 columns
};

// The first keys of all actions.
std::string keys_of(const Entry& entry, const Bindings& bindings, const Platform& platform) {
    std::string keys;
    for (const Action action : entry.actions)
        keys += (keys.empty() ? "" : " ") + key_name_of(action, bindings, platform);
    return keys;
}

std::string line_of(const Entry& entry, const Bindings& bindings, const Platform& platform) {
    std::string line = keys_of(entry, bindings, platform).substr(0, kKeyColumns);
    line.resize(kKeyColumns + 1, ' ');
    line += entry.label;
    return line;
}

// Two entries a line, in the order of reading.
std::vector<std::string> in_two_columns(std::span<const Entry> entries, const Bindings& bindings,
                                        const Platform& platform) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < entries.size(); i += 2) {
        std::string line = line_of(entries[i], bindings, platform);
        line.resize(kEntryColumns + 1, ' ');
        if (i + 1 < entries.size()) line += line_of(entries[i + 1], bindings, platform);
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace

std::string key_name_of(Action action, const Bindings& bindings, const Platform& platform) {
    if (action == Action(Command::Menu)) return "Esc";  // whatever else is bound to it
    const std::span<const Input> inputs = bindings.inputs_of(action);
    return inputs.empty() ? "none" : platform.local_name_of(inputs.front());
}

std::vector<std::string> game_help(const Bindings& bindings, const Platform& platform) {
    const std::vector<Entry> entries{
        {{Move::Forward, Move::Left, Move::Back, Move::Right}, "walk"},
        {{Command::Menu}, "menu"},
        {{Move::TurnLeft, Move::TurnRight}, "turn; or mouse"},
        {{Command::QuickSave}, "quick save"},
        {{Move::Jump}, "jump, swim up"},
        {{Command::QuickLoad}, "quick load"},
        {{Move::WalkSlowly}, "walk slowly"},
        {{Command::Respawn}, "to the way in"},
        {{Command::Automap}, "map"},
        {{Command::Restart}, "restart level"},
        {{Command::ProjectionAspect}, "drawn for"},
        {{Command::AccuracyTier}, "next accuracy"},
        {{Command::DisplayAspect}, "shown as"},
        {{Command::FrameCost}, "frame's cost"},
        {{Command::ScalingMode}, "scaling"},
        {{Command::LabPanel}, "lab: dials"},
        {{Command::AspectGuide}, "circle, square"},
        {{Command::ErrorMap}, "map of error"},
        {{Command::FourAspects}, "four aspects"},
        {{Command::SplitView}, "split: exact"},
        {{Command::Wireframe}, "edges"},
        {{Command::FlipSettings}, "flip settings"},
        {{Command::Isometric}, "from outside"},
        {{Command::Inspect}, "what is ahead"},
        {{Command::ZoomIn, Command::ZoomOut}, "zoom and dolly"},
        {{Command::CrtLook}, "look of a tube"},
        {{Command::Darker, Command::Brighter}, "brightness"},
        {{Command::Torch}, "torch"},
        {{Command::Screenshot}, "screenshots"},
        {{Command::Log}, "log"},
        {{Command::ShowHelp}, "these keys"},
    };
    return in_two_columns(entries, bindings, platform);
}

std::vector<std::string> gallery_help(const Bindings& bindings, const Platform& platform) {
    const std::vector<Entry> entries{
        {{Command::PageDown}, "next row"},
        {{Command::PageUp}, "row before"},
        {{Command::DialUp, Command::DialDown}, "parameter"},
        {{Command::DialCoarser, Command::DialFiner}, "change it"},
        {{Command::FrameCost}, "all figures"},
        {{Command::AccuracyTier}, "next accuracy"},
        {{Command::ProjectionAspect}, "drawn for"},
        {{Command::DisplayAspect}, "shown as"},
        {{Command::ScalingMode}, "scaling"},
        {{Command::CrtLook}, "look of a tube"},
        {{Command::Screenshot}, "screenshots"},
        {{Command::Menu}, "back"},
        {{Command::ShowHelp}, "these keys"},
    };
    return in_two_columns(entries, bindings, platform);
}

std::string with_key_names(const std::string& text, const Bindings& bindings, const Platform& platform) {
    std::string shown;
    std::string_view rest = text;
    for (std::size_t open = 0; (open = rest.find('{')) != std::string_view::npos;) {
        const std::size_t close = rest.find('}', open);
        if (close == std::string_view::npos) break;
        const std::string_view name = rest.substr(open + 1, close - open - 1);
        const auto actions = all_actions();
        const auto found =
            std::find_if(actions.begin(), actions.end(), [&](const ActionNames& of) { return of.name == name; });
        shown += rest.substr(0, open);
        shown += found == actions.end() ? std::string(rest.substr(open, close - open + 1))
                                        : key_name_of(found->action, bindings, platform);
        rest.remove_prefix(close + 1);
    }
    return shown + std::string(rest);
}

}  // namespace oblong
