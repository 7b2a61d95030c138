#include "game/lab/lab_options.h"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::uint64_t kFlipEvery_us = 500'000;

// The panel has no row for explanations, so a dial is explained when it is chosen.
std::string describe(const Dial& dial) {
    std::string text = std::string(dial.caption) + ": " + std::string(dial.about);
    if (!dial.changes_work) text += " Its error is real, and it saves no time.";
    return text;
}

std::string choose_dial(int steps, LabOptions& options) {
    const auto count = static_cast<int>(all_dials().size());
    options.dial = as_size((static_cast<int>(options.dial) + steps + count) % count);
    return describe(all_dials()[options.dial]);
}

void turn_dial(int steps, LabOptions& options, Accuracy& accuracy) {
    Accuracy turned = accuracy;
    turn(all_dials()[options.dial], steps, turned);
    change_setting(turned, options, accuracy);
}

std::string apply_to_dials(Action command, LabOptions& options, Accuracy& accuracy) {
    if (command == Action::DialUp || command == Action::DialDown)
        return choose_dial(command == Action::DialUp ? -1 : 1, options);
    if (command == Action::DialCoarser || command == Action::DialFiner)
        turn_dial(command == Action::DialCoarser ? -1 : 1, options, accuracy);
    return "";
}

std::vector<const Dial*> turned_dials(const Accuracy& accuracy, Preset preset) {
    const Accuracy own = accuracy_of(preset);
    std::vector<const Dial*> turned;
    for (const Dial& dial : all_dials())
        if (dial.get(accuracy) != dial.get(own)) turned.push_back(&dial);
    return turned;
}

}  // namespace

std::string toggle(bool& is_on, const std::string& on, const std::string& off) {
    is_on = !is_on;
    return is_on ? on : off;
}

std::size_t dial_index(std::string_view name) {
    return as_size(dial_named(name) - all_dials().data());
}

bool needs_lab(const LabOptions& options) {
    return options.shows_panel || options.maps_errors || options.splits || options.flips;
}

bool is_of_lab(Action command) {
    constexpr std::array kParts{Action::LabPanel, Action::ErrorMap, Action::SplitView, Action::FlipSettings};
    return std::find(kParts.begin(), kParts.end(), command) != kParts.end();
}

std::string apply_to_lab(Action command, LabOptions& options, Accuracy& accuracy) {
    switch (command) {
        case Action::LabPanel:
            return toggle(options.shows_panel,
                          "{dial-up} {dial-down} choose a dial, {dial-coarser} {dial-finer} turn it. " +
                              describe(all_dials()[options.dial]));
        case Action::ErrorMap:
            return toggle(options.maps_errors, "{error-map} How far each texel is from its place",
                          "{error-map} Error map: off");
        case Action::SplitView:
            return toggle(options.splits, "{split} Hold a mouse button to move the line", "{split} Split: off");
        case Action::FlipSettings:
            return toggle(options.flips, "{flip} Twice a second: this setting, the one before", "{flip} Flip: off");
        default:
            return options.shows_panel ? apply_to_dials(command, options, accuracy) : "";
    }
}

void change_setting(const Accuracy& wanted, LabOptions& options, Accuracy& accuracy) {
    if (wanted == accuracy) return;
    options.before = accuracy;
    accuracy = wanted;
}

void drag_split(const PresentRect& shown, LabOptions& options, Controls& controls) {
    if (!options.splits || !controls.holds_button) return;
    const std::int64_t moved_16 = std::int64_t{controls.mouse_x} * 65'536 / std::max(shown.width_px, 1);
    options.split_16 = static_cast<std::int32_t>(std::clamp<std::int64_t>(options.split_16 + moved_16, 0, 65'536));
    controls.mouse_x = controls.mouse_y = 0;
}

const Accuracy& shown_setting(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us) {
    return options.flips && now_us / kFlipEvery_us % 2 == 1 ? options.before : accuracy;
}

std::string setting_name(const Accuracy& accuracy) {
    const auto nearest = std::min_element(kPresets.begin(), kPresets.end(), [&](Preset a, Preset b) {
        return turned_dials(accuracy, a).size() < turned_dials(accuracy, b).size();
    });
    const std::vector<const Dial*> turned = turned_dials(accuracy, *nearest);
    const std::string name(name_of(*nearest));
    if (turned.empty()) return name;
    if (turned.size() > 1) return name + ", " + std::to_string(turned.size()) + " dials changed";
    const Dial& dial = *turned.front();
    return name + ", " + std::string(dial.caption) + " " + value_text(dial, dial.get(accuracy));
}

bool is_idle(const Dial& dial, const Accuracy& accuracy) {
    if (dial.name == "pixel-bound") return accuracy.texturing != Texturing::Bounded;
    if (dial.name == "texel-bound") return accuracy.texturing != Texturing::BoundedTexels;
    return dial.name == "mip-bias" && accuracy.mip == MipSelection::None;
}

}  // namespace oblong
