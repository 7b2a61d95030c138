#pragma once

#include <string>
#include <vector>

#include "engine/platform/platform.h"
#include "game/input/bindings.h"

namespace oblong {

/// The names of keys and buttons in texts for the player: as they are bound, and for the device in use. All texts use
/// it.
class KeyNames {
  public:
    /// All outlive it. `uses_pad`: the player's last input was a gamepad's.
    KeyNames(const Bindings& bindings, const Platform& platform, bool uses_pad)
        : bindings_(bindings), platform_(platform), uses_pad_(uses_pad) {}

    /// The first input of an action on the device in use, else on another device: "F2"; "none" if there is none.
    std::string of(Action action) const;
    /// Replaces the names of actions in braces by those of their keys: "{accuracy}" by "F4". {choose} and {accept} are
    /// the inputs of menus. Unknown names stay as they are.
    std::string in(const std::string& text) const;

  private:
    std::string of(std::string_view name) const;

    const Bindings& bindings_;
    const Platform& platform_;
    const bool uses_pad_;
};

/// A line on the page of keys.
struct KeyHelp {
    std::string label;  ///< "Walk"
    std::string keys;   ///< "W A S D"
};
std::vector<KeyHelp> game_help(const KeyNames& names);
std::vector<KeyHelp> gallery_help(const KeyNames& names);

}  // namespace oblong
