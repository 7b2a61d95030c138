#pragma once

#include "tests/game/logic_level.h"
#include "tests/support/script.h"

namespace oblong::test {

/// A level and what a player does in it, in lines of text:
///
///     + func_door 200 -64 0 216 64 128 angle=-1 wait=2      an entity: its class, the box of its brush if it has one,
///                                                           its keys
///     + e1m7.bsp                                            one of Quake's own levels, without any other entity
///     + solid 0 0 0 100 100 18                              a block of the world; no_floor, water Z (lava, slime)
///     + 5x item_lens origin="{300+40i} 0 24"                five of them, i = 0 to 4
///                                                           (who targets `count`, `door` or `light` has one of these,
///                                                           kUsualTargets, without a line)
///     stand 150 0; wait 34: phase0 = end, message = "Hm"    what is done, then what must hold
///     each 70 ahead: feet >= travelled0+8                   what must hold after each of so many ticks
///     # a note
///
/// The player starts with feet at (0, 0, 0) on a floor of 4096 units square and looks along +x. What can be done and
/// asked is named in the tables of scenario.cpp: a number after a name says which mover, wall or item is meant.
using Scenario = Script;

/// The level of its entities' words, from "+" on.
ToyLevel level_of(const std::vector<Words>& entities);

/// Fails at each line that does not hold.
void play(const Scenario& scenario);

}  // namespace oblong::test

#define OBLONG_SCENARIOS(Suite, rows) OBLONG_SCRIPTS(Suite, rows, oblong::test::play)
