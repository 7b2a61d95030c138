#pragma once

#include <string>
#include <vector>

#include "engine/platform/platform.h"
#include "game/input/bindings.h"

namespace oblong {

/// What keys and buttons are called to the player: as they are bound, and of the device that is in use. All that the
/// program says of a key comes from here.
class KeyNames {
  public:
    /// All outlive it. `uses_pad`: the player's last input was a gamepad's.
    KeyNames(const Bindings& bindings, const Platform& platform, bool uses_pad)
        : bindings_(bindings), platform_(platform), uses_pad_(uses_pad) {}

    /// The first input of an action on the device in use; on another device where it has none there: "F2"; "none".
    std::string of(Action action) const;
    /// A text with the names of actions in braces replaced by those of their keys: "{accuracy}" by "F4". {choose} and
    /// {accept} are what works a menu. What names no action stays as it is.
    std::string in(const std::string& text) const;

  private:
    std::string of(std::string_view name) const;

    const Bindings& bindings_;
    const Platform& platform_;
    const bool uses_pad_;
};

/// What some keys do, on the page of keys.
struct KeyHelp {
    std::string label;  ///< "Walk"
    std::string keys;   ///< "W A S D"
};
std::vector<KeyHelp> game_help(const KeyNames& names);
std::vector<KeyHelp> gallery_help(const KeyNames& names);

}  // namespace oblong
