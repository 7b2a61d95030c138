#include "game/level/loaded_level.h"

#include "engine/files/files.h"

namespace oblong {

LoadedLevel::LoadedLevel(const LevelFiles& named)
    : files(named),
      data(load_game(files)),
      level(naming_file(data.level_file, [&] { return make_game_level(data.level); })) {}

}  // namespace oblong
