#pragma once

#include <array>

#include "engine/surface/palette.h"
#include "game/options/preferences.h"

namespace oblong {

inline constexpr std::size_t kErrorBands = 7;

/// The colours of signs over the picture. No sign depends on its colour alone: steps are broken lines, doors have
/// crosses, the player is an arrow, and the bands of the error have a legend.
struct SignColours {
    Rgb8 wall, step, door, hidden, player, lens;  ///< of the map
    Rgb8 edges;                                   ///< of faces
    std::array<Rgb8, kErrorBands> errors;         ///< of the map of the error, from the smallest
};

const SignColours& sign_colours_of(ColourScheme scheme);

}  // namespace oblong
