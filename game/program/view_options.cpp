#include "game/program/view_options.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/table.h"
#include "engine/programs/arguments.h"
#include "game/lab/aspects.h"
#include "game/options/preference_table.h"

namespace oblong {
namespace {

constexpr std::array<const char*, kMapViewCount> kMapMessages{"{map} Map: off", "{map} Map: turns with you",
                                                              "{map} Map: north is up"};
constexpr std::array<const char*, kWireframeCount> kWireframeMessages{
    "{wireframe} Wireframe: off", "{wireframe} Wireframe: over the picture", "{wireframe} Wireframe: alone"};
// Fields of view of the dolly zoom, degrees.
constexpr std::int32_t kNarrowestZoom = 10, kUnzoomed = 90, kWidestZoom = 120, kZoomStep = 10;

constexpr int kPresetCount = static_cast<int>(kPresets.size());

// The horizontal field of view, to the nearest binary angle, of a picture of `shape` with this vertical one.
Degrees across(Ratio shape, Degrees vertical) {
    const SineCosine60 half = sine_cosine(vertical / 2);
    const Angle angle = arctangent2(half.sine.raw / shape.denominator * shape.numerator, half.cosine.raw);
    return Degrees::from_int(720) / 65536 * angle.bam;
}

// The next value of an enumeration of `count`, cyclic.
template <class Enum>
Enum next_of(Enum value, int count) {
    return static_cast<Enum>((static_cast<int>(value) + 1) % count);
}

// The dolly zoom starts at 90 degrees, where it is off. The isometric view, where nothing would change, ends.
std::string zoom(bool is_narrower, ViewOptions& options) {
    options.is_isometric = false;
    const std::int32_t degrees = options.zoom_degrees == 0 ? kUnzoomed : options.zoom_degrees;
    std::int32_t changed = std::max(degrees + (is_narrower ? -kZoomStep : kZoomStep), kNarrowestZoom);
    if (changed > kWidestZoom) changed = kUnzoomed;  // the exhibit's one button leads out again
    options.zoom_degrees = changed == kUnzoomed ? 0 : changed;
    if (options.zoom_degrees == 0) return "{zoom-in} {zoom-out} Zoom against dolly: off";
    return "{zoom-in} {zoom-out} Zoom against dolly: " + std::to_string(changed) +
           (changed < kUnzoomed ? " degrees, as far as there is room behind you" : " degrees");
}

// What a key shows is seen: the four aspects, which cover the whole picture, end.
void uncover(Action command, ViewOptions& options) {
    constexpr std::array kCovered{Action::FrameCost, Action::Inspect,     Action::Log,      Action::Automap,
                                  Action::Wireframe, Action::AspectGuide, Action::LabPanel, Action::ErrorMap,
                                  Action::SplitView, Action::FlipSettings};
    if (std::find(kCovered.begin(), kCovered.end(), command) != kCovered.end()) options.shows_four_aspects = false;
}

// The map's next view; the lab's panel, which covers the map, makes room for it.
const char* turn_map(ViewOptions& options) {
    const bool was_covered = std::exchange(options.lab.shows_panel, false);
    if (!was_covered || options.map == MapView::Off) options.map = next_of(options.map, kMapViewCount);
    return item(kMapMessages, options.map);
}

// The shape of a sphere in the middle of the picture, in the window.
std::string describe_sphere(const PicturePreferences& preferences, WindowSize window) {
    const ScreenMode mode = picture_in(window, preferences).mode;
    const Ratio pixel = shown_pixel(shown_rect(preferences, window), mode);
    return "spheres " + describe_shape(sphere_shape(mode, preferences.corrects_projection, pixel));
}

std::string describe_projection(const PicturePreferences& preferences, WindowSize window) {
    return "{projection-aspect} Drawn for " +
           (preferences.corrects_projection ? display_name(picture_in(window, preferences).mode)
                                            : std::string("square pixels")) +
           ": " + describe_sphere(preferences, window);
}

std::string describe_display(const PicturePreferences& preferences, WindowSize window) {
    return "{display-aspect} Shown " + shown_name(preferences.shown_as, picture_in(window, preferences).mode) + ": " +
           describe_sphere(preferences, window);
}

std::string describe_scaling(const PicturePreferences& preferences, WindowSize window) {
    constexpr std::array<const char*, kScalingCount> kWords{
        "all pixels of one size, their borders blended", "rows of one height, borders of columns blended",
        "nothing blended, the shape as near as whole pixels allow", "nothing blended, some rows and columns are wider"};
    return std::string("{scaling} Scaling ") + name_of(preferences.scaling) + ": " + item(kWords, preferences.scaling) +
           " (" + describe(shown_rect(preferences, window), picture_in(window, preferences).mode) + ")";
}

std::string describe_machine(const Preferences& preferences) {
    return "{machine} Machine: " + std::string(preferences.machine ? name_of(*preferences.machine) : "today's");
}

// Changes an option by `steps`, as the options menu does; returns the message to the player.
std::string change(const std::string& name, int steps, Preferences& preferences) {
    const Preference& row = preference_named(name);
    row.change(preferences, steps);
    return row.label + " " + row.shown(preferences);
}

}  // namespace

ViewDials view_dials_of(const ViewOptions& options) {
    const Preferences& preferences = options.preferences;
    const bool is_preset = preferences.accuracy == accuracy_of(preferences.preset);
    const auto number = [](auto value) { return static_cast<std::uint8_t>(value); };
    return {number(is_preset ? static_cast<int>(preferences.preset) : kPresetCount),
            number(preferences.corrects_projection),
            number(preferences.shown_as),
            number(options.is_isometric),
            number(options.wireframe),
            number(options.zoom_degrees / kZoomStep)};
}

void follow_view(const ViewDials& before, const ViewDials& after, ViewOptions& options) {
    Preferences& preferences = options.preferences;
    const auto if_turned = [&](ViewDialKind kind, auto turn) {
        if (item(after, kind) != item(before, kind)) turn(item(after, kind));
    };
    if_turned(ViewDialKind::Accuracy, [&](int value) {
        if (value < kPresetCount) preferences.preset = static_cast<Preset>(value);
        preferences.accuracy = accuracy_of(preferences.preset);
    });
    if_turned(ViewDialKind::Projection, [&](int value) { preferences.corrects_projection = value != 0; });
    if_turned(ViewDialKind::Display, [&](int value) { preferences.shown_as = static_cast<ShownAs>(value); });
    if_turned(ViewDialKind::Isometric, [&](int value) { options.is_isometric = value != 0; });
    if_turned(ViewDialKind::Wireframe, [&](int value) { options.wireframe = static_cast<Wireframe>(value); });
    if_turned(ViewDialKind::Zoom, [&](int value) { options.zoom_degrees = value * kZoomStep; });
}

std::string choose_machine(const std::string& name, Preferences& preferences) {
    try {
        preference_named("machine").parse(preferences, name);
    } catch (const UsageError&) {
        return "";  // the map's compiler has warned of it
    }
    return describe_machine(preferences);
}

Settings settings_of(const Preferences& preferences) {
    Settings settings;
    settings.accuracy = preferences.accuracy;
    settings.brightness_100 = preferences.light().brightness_100;
    settings.flashes = preferences.flashes;
    settings.correct_aspect = preferences.corrects_projection;
    settings.kernels = preferences.kernels;
    return settings;
}

WindowSettings window_settings_of(const WindowPreferences& preferences) {
    return {preferences.fills_screen, preferences.waits_for_display, preferences.frame_cap_hz};
}

PicturePreferences picture_in(WindowSize window, PicturePreferences preferences) {
    constexpr ScreenMode kUsual, kUpright{kUsual.height_px, kUsual.width_px, {9, 16}};
    if (window.height_px <= window.width_px || preferences.mode != kUsual) return preferences;
    preferences.mode = kUpright;
    preferences.field_of_view = across(kUpright.display, preferences.field_of_view);
    return preferences;
}

PresentRect shown_rect(const PicturePreferences& preferences, WindowSize window) {
    PresentRect rect = layout(window, picture_in(window, preferences).mode, preferences.shown_as, preferences.scaling);
    rect.has_crt_look = preferences.has_crt_look;
    return rect;
}

std::string apply(Action command, ViewOptions& options, WindowSize window) {
    Preferences& preferences = options.preferences;
    uncover(command, options);
    switch (command) {
        case Action::FrameCost:
            ++options.cost_page;
            return "";
        case Action::ProjectionAspect:
            preferences.corrects_projection = !preferences.corrects_projection;
            return describe_projection(preferences, window);
        case Action::DisplayAspect:
            preferences.shown_as =
                preferences.shown_as == ShownAs::OnDisplay ? ShownAs::SquarePixels : ShownAs::OnDisplay;
            return describe_display(preferences, window);
        case Action::AccuracyTier:
            preferences.preset = next_of(preferences.preset, kPresetCount);
            change_setting(accuracy_of(preferences.preset), options.lab, preferences.accuracy);
            return "{accuracy} Accuracy: " + std::string(name_of(preferences.preset));
        case Action::Machine:
            change("machine", 1, preferences);
            return describe_machine(preferences);
        case Action::ScalingMode:
            preferences.scaling = next_of(preferences.scaling, kScalingCount);
            return describe_scaling(preferences, window);
        case Action::SmallerView:
        case Action::LargerView:
            return change("view-size", command == Action::LargerView ? 1 : -1, preferences);
        case Action::Darker:
        case Action::Brighter:
            return change("brightness", command == Action::Brighter ? 1 : -1, preferences);
        case Action::Torch:
            return toggle(options.has_torch, "{torch} Torch: on", "{torch} Torch: off");
        case Action::CrtLook:
            return toggle(preferences.has_crt_look, "{crt} CRT look: scanlines, mask, glow", "{crt} CRT look: off");
        case Action::Inspect:
            return toggle(options.inspects);
        case Action::Log:
            options.log = next_channels(options.log);
            return "{log} Log: " + names_of(options.log) + (options.log.is_empty() ? "" : ", also on standard error");
        case Action::Automap:
            return turn_map(options);
        case Action::Wireframe:
            options.wireframe = next_of(options.wireframe, kWireframeCount);
            return item(kWireframeMessages, options.wireframe);
        case Action::Isometric:
            return toggle(options.is_isometric, "{isometric} Isometric view: you are in the middle",
                          "{isometric} Isometric view: off");
        case Action::ZoomIn:
        case Action::ZoomOut:
            return zoom(command == Action::ZoomIn, options);
        case Action::AspectGuide:
            return toggle(options.shows_aspect_guide);
        case Action::FourAspects:
            return toggle(options.shows_four_aspects);
        default:
            return apply_to_lab(command, options.lab, preferences.accuracy);
    }
}

}  // namespace oblong
