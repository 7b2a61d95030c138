#pragma once

#include <cstdint>
#include <string>

#include "engine/accuracy/accuracy.h"
#include "engine/accuracy/dials.h"
#include "engine/view/present_rect.h"
#include "game/input/controls.h"

namespace oblong {

/// The place of a dial in all_dials(), which must have one of this name.
std::size_t dial_index(std::string_view name);

/// What keys set in the lab: what of it is on, which dial they turn, and what it compares.
struct LabOptions {
    bool shows_panel = false, maps_errors = false, splits = false, flips = false;
    std::size_t dial = dial_index("perspective");  ///< of all_dials(): the one that is turned
    std::int32_t split_16 = 32'768;                ///< where the line is: 0 the left border, 65,536 the right
    Accuracy before = accuracy_of(Preset::Exact);  ///< the setting before the last change
};

/// Whether anything is on that needs more than the game's own picture.
bool needs_lab(const LabOptions& options);

/// Carries out a command of the lab on it and on the setting; the message that tells the user ("" where there is none).
std::string apply_to_lab(Action command, LabOptions& options, Accuracy& accuracy);

/// Changes the setting, and remembers the one before.
void change_setting(const Accuracy& wanted, LabOptions& options, Accuracy& accuracy);

/// Moves the line by the mouse while a button is held, instead of the view. `shown`: where the picture is.
void drag_split(const PresentRect& shown, LabOptions& options, Controls& controls);

/// The setting to draw with: the current one, or while flipping, each other half second, the one before.
const Accuracy& shown_setting(const LabOptions& options, const Accuracy& accuracy, std::uint64_t now_us);

/// A preset's name where all dials are its own, else with the dials turned: "1996, shades 32", "1996, 3 dials turned".
/// Of the preset from which the fewest are turned.
std::string setting_name(const Accuracy& accuracy);

/// Whether another dial's value makes this one meaningless: a bound without bounded perspective, say.
bool is_idle(const Dial& dial, const Accuracy& accuracy);

}  // namespace oblong
