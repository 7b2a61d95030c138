#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "game/simulation/tick.h"

namespace oblong {

struct GameState;

/// One recorded tick and the hash of the state that it led to.
struct DemoTick {
    TickInput input;
    std::uint64_t state_hash = 0;
    bool operator==(const DemoTick&) const = default;
};

/// A recorded game: the inputs of every tick from the start of a level.
struct Demo {
    std::uint64_t start_hash = 0;  ///< start_hash_of() the state before the first tick; differs from level to level
    std::vector<DemoTick> ticks;
    bool operator==(const Demo&) const = default;
};

/// What a demo that begins in this state is known by. `rules_hash`: of the game's rules (GameDefinition).
std::uint64_t start_hash_of(const GameState& start, std::uint64_t rules_hash);

/// The file, little-endian: "OBLGDEMO", version (u32: 2), ticks a second (u32: 35), start hash (u64), number of ticks
/// (u32), and for each tick forward, right (i8), yaw, pitch (i16), buttons (u8), view (6 u8), work (u16; version 1 has
/// neither), state hash (u64).
std::vector<std::uint8_t> encode_demo(const Demo& demo);

/// Parses such bytes. Throws InputError unless they are a whole demo.
Demo decode_demo(std::span<const std::uint8_t> bytes);

}  // namespace oblong
