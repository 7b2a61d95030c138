#include "engine/io/files.h"
#include "game/level/load.h"

namespace oblong {

LoadedLevel::LoadedLevel(const LevelFiles& named)
    : files(named), data(files.load(files)), level(naming_file(data.level_file, [&] {
          GameLevel made = make_game_level(data.level);
          if (files.game) made.lens_names = {own_words(*files.game, kOneLens), own_words(*files.game, kLenses)};
          return made;
      })) {}

}  // namespace oblong
