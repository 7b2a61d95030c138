#pragma once

#include <array>
#include <string>

#include "tools/demo_level/map/draft.h"

namespace oblong::map_source {

/// The exhibits that have a lens to be found.
inline constexpr int kLensCount = 12;

/// Names of what the level's entities activate.
inline constexpr const char* kLensCounter = "lenses";
inline constexpr const char* kTowerGate = "tower_gate";

/// The exhibits that have one, in the order of a visit.
inline constexpr std::array<const char*, kLensCount> kExhibits{"ASPECT",
                                                               "the VANISHING POINT",
                                                               "LIGHT AND SHADOW",
                                                               "DUST",
                                                               "SPARKS",
                                                               "AXONOMETRY",
                                                               "ANY PLANE",
                                                               "FIELD OF VIEW",
                                                               "RAIN",
                                                               "FOG",
                                                               "FORCED PERSPECTIVE",
                                                               "ACCURACY"};

/// What the lens of an exhibit activates: its window on the tower, and the counter.
std::string lens_target(std::size_t exhibit);

/// The lens of an exhibit, above `floor`, which is in reach of everybody who walks.
void add_lens(Draft& draft, const Point& floor, const std::string& exhibit);

/// What the game says, once, to who enters a box: one or two lines of up to 50 characters. The game puts
/// the name of a key in the place of "{accuracy}": the name of what it does (engine/platform/bindings.h).
void add_caption(Draft& draft, const Box& box, const std::string& first, const std::string& second = "");

/// What counts the lenses and opens the tower's gates.
void add_lens_counter(Draft& draft);

}  // namespace oblong::map_source
