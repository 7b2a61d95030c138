#include "game/view_options.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "game/aspect_guide.h"

namespace oblong {
namespace {

constexpr std::array<const char*, kMapViewCount> kMapMessages{"Tab Map: off", "Tab Map: turns with you",
                                                              "Tab Map: north is up"};
constexpr std::array<const char*, kWireframeCount> kWireframeMessages{
    "E Edges: off", "E Edges: of the faces that own pixels", "E Edges: by themselves"};
// Fields of view, degrees, between which keys step.
constexpr std::int32_t kNarrowestZoom = 10, kUnzoomed = 90, kWidestZoom = 120, kZoomStep = 10;

constexpr int kPresetCount = static_cast<int>(kPresets.size());

// The next value of an enumeration of `count`, the first after the last.
template <class Enum>
Enum next_of(Enum value, int count) {
    return static_cast<Enum>((static_cast<int>(value) + 1) % count);
}

// The next value of those that a key steps through; the last ones are the limits of --brightness.
std::int32_t next_brightness(std::int32_t brightness_100, bool is_brighter) {
    constexpr std::array<std::int32_t, 11> kValues{25, 35, 50, 70, 100, 140, 200, 280, 400, 560, 800};
    if (is_brighter) {
        const auto above = std::upper_bound(kValues.begin(), kValues.end(), brightness_100);
        return above == kValues.end() ? kValues.back() : *above;
    }
    const auto from = std::lower_bound(kValues.begin(), kValues.end(), brightness_100);
    return from == kValues.begin() ? kValues.front() : *(from - 1);
}

// Zoom against dolly starts at 90 degrees, where it is off, and ends at its limits.
std::string zoom(bool is_narrower, ViewOptions& options) {
    const std::int32_t degrees = options.zoom_degrees == 0 ? kUnzoomed : options.zoom_degrees;
    const std::int32_t changed =
        std::clamp(degrees + (is_narrower ? -kZoomStep : kZoomStep), kNarrowestZoom, kWidestZoom);
    options.zoom_degrees = changed == kUnzoomed ? 0 : changed;
    if (options.zoom_degrees == 0) return "[ ] Zoom against dolly: off";
    return "[ ] Zoom against dolly: " + std::to_string(changed) + " degrees";
}

// Switches an option on or off; the message that tells the user.
std::string toggle(bool& is_on, const char* on = "", const char* off = "") {
    is_on = !is_on;
    return is_on ? on : off;
}

std::string describe_display(const ViewOptions& options, const ScreenMode& mode, WindowSize window) {
    const std::string size = describe(layout(window, mode, options.shown_as, options.scaling), mode);
    switch (options.shown_as) {
        case ShownAs::OnDisplay:
            return "F3 Display: " + display_name(mode) + " (" + size + ")";
        case ShownAs::SquarePixels:
            return "F3 Display: square pixels (" + size + ")";
        default:
            return "F3 Display: fill the window (" + size + ")";
    }
}

}  // namespace

Settings settings_of(const ViewOptions& options) {
    Settings settings;
    settings.accuracy = options.accuracy;
    settings.brightness_100 = options.brightness_100;
    settings.flashes = options.flashes;
    settings.correct_aspect = options.corrects_projection;
    return settings;
}

std::string apply(Command command, ViewOptions& options, const ScreenMode& mode, WindowSize window) {
    switch (command) {
        case Command::ShowHelp:
            return toggle(options.shows_help);
        case Command::FrameCost:
            return toggle(options.shows_cost);
        case Command::ProjectionAspect:
            options.corrects_projection = !options.corrects_projection;
            return options.corrects_projection ? "F2 Projection: for " + display_name(mode)
                                               : "F2 Projection: for square pixels";
        case Command::DisplayAspect:
            options.shown_as = next_of(options.shown_as, kShownAsCount);
            return describe_display(options, mode, window);
        case Command::AccuracyTier:
            options.preset = next_of(options.preset, kPresetCount);
            change_setting(accuracy_of(options.preset), options.lab, options.accuracy);
            return "F4 Accuracy: " + std::string(name_of(options.preset));
        case Command::ScalingMode:
            options.scaling = next_of(options.scaling, kScalingCount);
            return std::string("F5 Scaling: ") + name_of(options.scaling) + " (" +
                   describe(layout(window, mode, options.shown_as, options.scaling), mode) + ")";
        case Command::Darker:
        case Command::Brighter:
            options.brightness_100 = next_brightness(options.brightness_100, command == Command::Brighter);
            return "Brightness " + std::to_string(options.brightness_100) + " %";
        case Command::Torch:
            return toggle(options.has_torch, "L Torch", "L Torch: off");
        case Command::CrtLook:
            return toggle(options.has_crt_look, "C Tube: scanlines, mask, glow", "C Tube: off");
        case Command::Inspect:
            return toggle(options.inspects);
        case Command::Log:
            options.log = next_channels(options.log);
            return "O Log: " + names_of(options.log) + (options.log.is_empty() ? "" : ", on standard error");
        case Command::Automap:
            options.map = next_of(options.map, kMapViewCount);
            return at(kMapMessages, options.map);
        case Command::Wireframe:
            options.wireframe = next_of(options.wireframe, kWireframeCount);
            return at(kWireframeMessages, options.wireframe);
        case Command::Isometric:
            return toggle(options.is_isometric, "I Isometric: you are in the middle", "I Isometric: off");
        case Command::ZoomIn:
        case Command::ZoomOut:
            return zoom(command == Command::ZoomIn, options);
        case Command::AspectGuide:
            return toggle(options.shows_aspect_guide);
        case Command::FourAspects:
            return toggle(options.shows_four_aspects);
        default:
            return apply_to_lab(command, options.lab, options.accuracy);
    }
}

}  // namespace oblong
