#pragma once

#include <string>

namespace oblong::map {

inline constexpr const char* kTrenchBroomFolder =  ///< where the editor looks for games that it does not come with
#ifdef __APPLE__
    "~/Library/Application Support/TrenchBroom/games/Oblong";
#else
    "~/.TrenchBroom/games/Oblong";
#endif

/// Writes what the editor has to know of the game into a folder: its configuration, classes, palette, models, icon,
/// ways to compile and a first level (assets/trenchbroom). Ways to compile that were changed there are kept as
/// *.cfg.old. "~/" stands for the user's folder; `called_as` is argv[0]. Throws FileError.
void install_trenchbroom(const std::string& folder, const char* called_as);

}  // namespace oblong::map
