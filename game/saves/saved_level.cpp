#include "game/saves/saved_level.h"

#include <filesystem>

#include "tools/common/game_files.h"

namespace oblong {

SavedLevel saved_level_of(const GameData& data, const GameLevel& level) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const bool is_file = fs::exists(data.level_file, ignored) || path_in_pak(data.level_file);
    const std::string name = is_file ? fs::absolute(data.level_file, ignored).string() : data.level_file;
    return {name, data.level_hash, hash_of(start_of(level))};
}

}  // namespace oblong
