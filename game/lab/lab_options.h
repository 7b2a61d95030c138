#pragma once

#include <cstdint>
#include <string>

#include "engine/accuracy/accuracy.h"
#include "engine/view/present_rect.h"
#include "game/input/controls.h"

namespace oblong {

/// The index in all_dials() of a name, which must exist.
std::size_t dial_index(std::string_view name);

/// The lab's state, set by keys: which parts are on, which dial is chosen, and what is compared.
struct LabOptions {
    bool shows_panel = false, maps_errors = false, splits = false, flips = false;
    std::size_t dial = dial_index("perspective");  ///< of all_dials(): the chosen one
    std::int32_t split_16 = 32'768;                ///< where the line is: 0 the left border, 65,536 the right
    Accuracy before = accuracy_of(Preset::Exact);  ///< the setting before the last change
};

/// Whether a part is on that needs the lab.
bool needs_lab(const LabOptions& options);

/// Whether a command turns a part of the lab on or off.
bool is_of_lab(Action command);

/// Runs a command of the lab; returns a message to the player, or "".
std::string apply_to_lab(Action command, LabOptions& options, Accuracy& accuracy);

/// Switches an option on or off; returns the message to the player.
std::string toggle(bool& is_on, const std::string& on = "", const std::string& off = "");

/// Changes the setting, and remembers the previous one.
void change_setting(const Accuracy& wanted, LabOptions& options, Accuracy& accuracy);

/// While a mouse button is held, the mouse moves the split line instead of the view. `shown`: where the picture is.
void drag_split(const PresentRect& shown, LabOptions& options, Controls& controls);

/// The setting to draw with: the current one, or while flipping, every other half second, the previous one.
const Accuracy& shown_setting(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us);

/// A preset's name, with the dials that differ: "1996", "1996, shades 32", "1996, 3 dials changed". The preset is the
/// one with the fewest differences.
std::string setting_name(const Accuracy& accuracy);

/// Whether another dial's value makes this one unused: a bound without bounded perspective, for example.
bool is_idle(const Dial& dial, const Accuracy& accuracy);

}  // namespace oblong
