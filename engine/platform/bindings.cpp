#include "engine/platform/bindings.h"

#include <algorithm>

#include "engine/base/input_error.h"
#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::array<ActionNames, kActionCount> kActions{{
    {Move::Forward, "forward", "Walk ahead"},
    {Move::Back, "back", "Walk back"},
    {Move::Left, "left", "Step left"},
    {Move::Right, "right", "Step right"},
    {Move::TurnLeft, "turn-left", "Turn left"},
    {Move::TurnRight, "turn-right", "Turn right"},
    {Move::LookUp, "look-up", "Look up"},
    {Move::LookDown, "look-down", "Look down"},
    {Move::Jump, "jump", "Jump, swim up"},
    {Move::WalkSlowly, "walk-slowly", "Walk slowly"},
    {Command::Menu, "menu", "Menu, as Esc"},
    {Command::Respawn, "respawn", "Back to the way in"},
    {Command::Restart, "restart", "Restart the level"},
    {Command::QuickSave, "quick-save", "Quick save"},
    {Command::QuickLoad, "quick-load", "Quick load"},
    {Command::Automap, "map", "Map"},
    {Command::ShowHelp, "help", "Keys"},
    {Command::ProjectionAspect, "projection-aspect", "Aspect: projection"},
    {Command::DisplayAspect, "display-aspect", "Aspect: display"},
    {Command::AccuracyTier, "accuracy", "Accuracy"},
    {Command::ScalingMode, "scaling", "Scaling"},
    {Command::FrameCost, "frame-cost", "Cost of a frame"},
    {Command::LabPanel, "lab", "Lab"},
    {Command::ErrorMap, "error-map", "Map of the error"},
    {Command::SplitView, "split", "Split: now and exact"},
    {Command::FlipSettings, "flip", "Flip: now and before"},
    {Command::AspectGuide, "aspect-guide", "Circle and square"},
    {Command::FourAspects, "four-aspects", "Four aspects"},
    {Command::Screenshot, "screenshot", "Screenshots"},
    {Command::Torch, "torch", "Torch"},
    {Command::CrtLook, "crt", "Look of a tube"},
    {Command::Inspect, "inspect", "What is ahead"},
    {Command::Log, "log", "Log channels"},
    {Command::Wireframe, "wireframe", "Edges of faces"},
    {Command::Isometric, "isometric", "From outside"},
    {Command::ZoomIn, "zoom-in", "Zoom in, move back"},
    {Command::ZoomOut, "zoom-out", "Zoom out, move on"},
    {Command::Darker, "darker", "Darker"},
    {Command::Brighter, "brighter", "Brighter"},
    {Command::DialUp, "dial-up", "Panel: row above"},
    {Command::DialDown, "dial-down", "Panel: row below"},
    {Command::DialCoarser, "dial-coarser", "Panel: less"},
    {Command::DialFiner, "dial-finer", "Panel: more"},
    {Command::PageUp, "page-up", "Gallery: row before"},
    {Command::PageDown, "page-down", "Gallery: next row"},
}};

std::size_t index_of(Action action) {
    const Move* move = std::get_if<Move>(&action);
    return move ? as_size(*move) : as_size(kMoveCount) + as_size(std::get<Command>(action));
}

// Works a panel while one is open, and nothing else.
bool is_of_panel(Action action) {
    const Command* command = std::get_if<Command>(&action);
    return command && *command >= Command::DialUp && *command <= Command::PageDown;
}

bool is_apart(Action a, Action b) {
    const auto is_move = [](Action action) { return std::holds_alternative<Move>(action); };
    return (is_move(a) && is_of_panel(b)) || (is_of_panel(a) && is_move(b));
}

std::vector<Input> parsed(std::string_view text) {
    constexpr std::string_view kSpaces = " \t";
    std::vector<Input> inputs;
    if (text == "none") return inputs;
    for (std::size_t at = text.find_first_not_of(kSpaces); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(kSpaces, at), text.size());
        inputs.push_back(input_named(text.substr(at, end - at)));
        if (is_reserved(inputs.back()))
            throw InputError("input", "'" + name_of(inputs.back()) + "' always opens the menu, expected another one");
        at = text.find_first_not_of(kSpaces, end);
    }
    if (inputs.size() > Bindings::kMostInputs)
        throw InputError("inputs", std::to_string(inputs.size()) + " of them, expected at most " +
                                       std::to_string(Bindings::kMostInputs));
    return inputs;
}

}  // namespace

std::span<const ActionNames> all_actions() {
    return kActions;
}

std::span<const Input> Bindings::inputs_of(Action action) const {
    return inputs_[index_of(action)];
}

void Bindings::bind(Action action, Input input) {
    std::vector<Input>& inputs = inputs_[index_of(action)];
    if (is_reserved(input) || std::find(inputs.begin(), inputs.end(), input) != inputs.end()) return;
    if (inputs.size() == kMostInputs) inputs.erase(inputs.begin());
    inputs.push_back(input);
}

void Bindings::unbind(Action action, Input input) {
    std::erase(inputs_[index_of(action)], input);
}

void Bindings::unbind_all(Action action) {
    inputs_[index_of(action)].clear();
}

std::vector<Conflict> conflicts_of(const Bindings& bindings) {
    std::vector<Conflict> all;
    for (const ActionNames& row : all_actions())
        for (const Input input : bindings.inputs_of(row.action)) {
            const auto known =
                std::find_if(all.begin(), all.end(), [&](const Conflict& c) { return c.input == input; });
            if (known == all.end())
                all.push_back({input, {row.action}});
            else
                known->actions.push_back(row.action);
        }
    std::erase_if(all, [](Conflict& conflict) {
        const auto clashes = [&](Action a) {
            return std::any_of(conflict.actions.begin(), conflict.actions.end(),
                               [&](Action b) { return a != b && !is_apart(a, b); });
        };
        return std::none_of(conflict.actions.begin(), conflict.actions.end(), clashes);
    });
    return all;
}

std::string inputs_to_text(const Bindings& bindings, Action action) {
    std::string text;
    for (const Input input : bindings.inputs_of(action)) {
        std::string name = name_of(input);
        std::replace(name.begin(), name.end(), ' ', '-');
        text += (text.empty() ? "" : " ") + name;
    }
    return text.empty() ? "none" : text;
}

void set_inputs(Bindings& bindings, Action action, std::string_view text) {
    const std::vector<Input> inputs = parsed(text);
    bindings.unbind_all(action);
    for (const Input input : inputs) bindings.bind(action, input);
}

}  // namespace oblong
