#pragma once

#include <string_view>

#include "engine/level/level.h"
#include "game/simulation/game_level.h"
#include "game/sound/sound_table.h"

namespace oblong {

/// The sound of a step on a texture, by words in its name; stone if no word is known.
Sound step_sound_of_texture(std::string_view name);

/// The sound of a step where the player stands: in water if the feet are in a liquid, else by the face below.
Sound step_sound(const GameLevel& level, const GameState& state);

/// The sounds of a moving brush model.
struct MoverSounds {
    Sound start, move, stop;
};

/// By the class of the mover's entity, and the texture of its first face.
MoverSounds mover_sounds(const Level& bsp, ModelIndex model);

}  // namespace oblong
