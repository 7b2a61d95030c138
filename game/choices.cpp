#include "game/choices.h"

namespace oblong {
namespace {

constexpr int kPresetCount = static_cast<int>(Preset::Exact) + 1;

// The next value of an enumeration of `count`, the first after the last.
template <class Enum>
Enum next_of(Enum value, int count) {
    return static_cast<Enum>((static_cast<int>(value) + 1) % count);
}

std::string shape_of(const ScreenMode& mode) {
    return std::to_string(mode.display.numerator) + ":" + std::to_string(mode.display.denominator);
}

std::string describe_display(const Choices& choices, const ScreenMode& mode, WindowSize window) {
    const std::string size = describe(layout(window, mode, choices.shown_as, choices.scaling), mode);
    switch (choices.shown_as) {
        case ShownAs::OnDisplay:
            return "F3 Display: " + shape_of(mode) + " (" + size + ")";
        case ShownAs::SquarePixels:
            return "F3 Display: square pixels (" + size + ")";
        default:
            return "F3 Display: fill the window (" + size + ")";
    }
}

}  // namespace

Settings settings_of(const Choices& choices) {
    Settings settings;
    settings.accuracy = accuracy_of(choices.preset);
    settings.correct_aspect = choices.corrects_projection;
    return settings;
}

std::string apply(Command command, Choices& choices, const ScreenMode& mode, WindowSize window) {
    switch (command) {
        case Command::ShowHelp:
            choices.shows_help = !choices.shows_help;
            return "";
        case Command::FrameCost:
            choices.shows_cost = !choices.shows_cost;
            return "";
        case Command::ProjectionAspect:
            choices.corrects_projection = !choices.corrects_projection;
            return choices.corrects_projection ? "F2 Projection: for " + shape_of(mode)
                                               : "F2 Projection: for square pixels";
        case Command::DisplayAspect:
            choices.shown_as = next_of(choices.shown_as, kShownAsCount);
            return describe_display(choices, mode, window);
        case Command::AccuracyTier:
            choices.preset = next_of(choices.preset, kPresetCount);
            return "F4 Accuracy: " + std::string(name_of(choices.preset));
        case Command::ScalingMode:
            choices.scaling = next_of(choices.scaling, kScalingCount);
            return std::string("F5 Scaling: ") + name_of(choices.scaling) + " (" +
                   describe(layout(window, mode, choices.shown_as, choices.scaling), mode) + ")";
        default:
            return "";
    }
}

}  // namespace oblong
