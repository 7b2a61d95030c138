#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/little_endian.h"
#include "game/simulation/state.h"

namespace oblong {

/// The fields of a state as bytes, in the order of visit_fields() (game/simulation/state_fields.h): each number in its
/// own width, each list after its length (u32).
void append_state(std::vector<std::uint8_t>& bytes, const GameState& state);

/// Reads such fields. Throws InputError if they end early, or for an impossible list or bool; is_consistent() checks
/// the state against a level.
GameState read_state(LittleEndianReader& reader);

/// A hash of the kinds of all fields. It differs if a build's state has other fields.
std::uint64_t state_layout();

}  // namespace oblong
