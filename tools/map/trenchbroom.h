#pragma once

#include <map>
#include <string>
#include <string_view>

#include "engine/programs/game_definition.h"

namespace oblong::map {

inline constexpr std::string_view kFgdBeginning = "// Oblong's classes and keys";

/// The classes that a game defines, by name.
using OwnClasses = std::map<std::string, OwnClass>;

/// entity_classes() and a game's own as an FGD file for TrenchBroom and Valve's editors. Leaves out families, which
/// editors cannot place, and the keys `classname` and `origin`, which editors define.
std::string fgd_text(const OwnClasses& own = {});

inline constexpr const char* kTrenchBroomFolder =  ///< the editor's folder for additional games
#ifdef __APPLE__
    "~/Library/Application Support/TrenchBroom/games/Oblong";
#else
    "~/.TrenchBroom/games/Oblong";
#endif

/// Writes the editor's files on the game into a folder: configuration, classes, palette, models, icon, compilation
/// profiles and a first level (assets/trenchbroom). Changed profiles are kept as *.cfg.old. "~/" stands for the
/// user's folder; `called_as` is argv[0]. Throws FileError.
void install_trenchbroom(const std::string& folder, const char* called_as, const OwnClasses& own = {});

}  // namespace oblong::map
