#pragma once

#include <string>
#include <vector>

#include "engine/platform/platform.h"

namespace oblong {

/// What keys do, as they are bound: a line for two of them, at most 51 columns.
std::vector<std::string> game_help(const Bindings& bindings, const Platform& platform);
std::vector<std::string> gallery_help(const Bindings& bindings, const Platform& platform);

/// The name of the first key, button or other input of an action: "F2"; "none".
std::string key_name_of(Action action, const Bindings& bindings, const Platform& platform);

/// A text of a level with the names of actions in braces replaced by those of their keys: "{accuracy}" by "F4". What
/// names no action stays as it is.
std::string with_key_names(const std::string& text, const Bindings& bindings, const Platform& platform);

}  // namespace oblong
