#pragma once

#include <cstdint>
#include <string_view>

#include "engine/level/level.h"

namespace oblong {

/// What the entities of a class of Quake's show.
struct ModelClass {
    std::string_view name;
    std::string_view file;  ///< ".bsp": brushes, which are not shown; a file of that name ending in ".mdl" is
    std::uint32_t frame = 0, skin = 0;
    std::int32_t over_floor = kStays;  ///< units: items drop to the floor as the game starts
    std::int32_t spawn_flags = 0;      ///< the entity has these
    std::int32_t world_type = -1;      ///< the world's: 0 medieval, 1 metal, 2 base; -1: any

    static constexpr std::int32_t kStays = -1;
};

/// The class of an entity; null for those that show no model here (monsters and all that moves by itself).
const ModelClass* model_class_of(const Entity& entity, std::int32_t world_type);

}  // namespace oblong
