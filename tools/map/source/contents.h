#pragma once

#include <string_view>

#include "engine/level/level.h"

namespace oblong::map {

/// Which contents hide which where brushes overlap: the higher rank stays.
constexpr int contents_rank(int filling) {
    switch (filling) {
        case contents::kSolid:
            return 5;
        case contents::kSky:
            return 4;
        case contents::kWater:
            return 3;
        case contents::kSlime:
            return 2;
        case contents::kLava:
            return 1;
        default:
            return 0;
    }
}

constexpr bool is_liquid(int filling) {
    return contents_rank(filling) >= 1 && contents_rank(filling) <= 3;
}

/// Opaque and impassable: solid and sky.
constexpr bool is_opaque(int filling) {
    return contents_rank(filling) >= 4;
}

/// By the name of a brush's texture: *lava..., *slime..., other *..., sky..., or else solid.
constexpr int contents_of_texture(std::string_view name) {
    if (name.starts_with("*lava")) return contents::kLava;
    if (name.starts_with("*slime")) return contents::kSlime;
    if (name.starts_with("*")) return contents::kWater;
    if (name.starts_with("sky")) return contents::kSky;
    return contents::kSolid;
}

/// Textures that only say something to the compiler: their faces are not drawn.
constexpr bool is_undrawn_texture(std::string_view name) {
    return name == "clip" || name == "skip" || name == "trigger";
}

/// Full of holes (texels of index 255), through which one sees, and light falls.
constexpr bool is_fence_texture(std::string_view name) {
    return name.starts_with("{");
}

/// Other engines turn a brush entity around the middle of a brush with this one.
constexpr bool is_origin_texture(std::string_view name) {
    return name == "origin";
}

/// A brush with one of these on any side advises other compilers where to cut the tree; it fills nothing.
constexpr bool is_hint_texture(std::string_view name) {
    return name == "hint" || name == "hintskip";
}

}  // namespace oblong::map
