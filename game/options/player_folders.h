#pragma once

#include <string>

namespace oblong {

/// Where a player's files are kept; empty where the system names no place for them.
struct PlayerFolders {
    std::string config_file;  ///< preferences
    std::string data;         ///< the folder of saved games
};

/// $XDG_CONFIG_HOME/oblong/oblong.cfg and $XDG_DATA_HOME/oblong, as the XDG Base Directory Specification says: without
/// them, or where they are no absolute paths, in ~/.config and ~/.local/share.
PlayerFolders desktop_folders();

/// Both in the folder oblong-data below the program's: nothing is left on a machine.
PlayerFolders portable_folders(const std::string& program_folder);

}  // namespace oblong
