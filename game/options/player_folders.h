#pragma once

#include <string>

namespace oblong {

/// Where a player's files are kept; empty if the system names no folder for them.
struct PlayerFolders {
    std::string config_file;  ///< preferences
    std::string data;         ///< the folder of saved games
};

/// $XDG_CONFIG_HOME/oblong/oblong.cfg and $XDG_DATA_HOME/oblong, by the XDG Base Directory Specification; if these are
/// unset or not absolute, below ~/.config and ~/.local/share.
PlayerFolders desktop_folders();

/// Both in the folder oblong-data below the program's folder.
PlayerFolders portable_folders(const std::string& program_folder);

}  // namespace oblong
