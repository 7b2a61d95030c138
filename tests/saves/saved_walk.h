#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "game/saves/saved_game.h"
#include "tests/game/logic_level.h"

namespace oblong::test {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint64_t kToyLevelHash = 0x0123456789abcdef;

/// A toy level with all that a state has lists of: a door, a lift, switched lights, a targeted teleporter, items with
/// messages, an end far away.
inline ToyLevel level_of_all_kinds() {
    ToyLevel toy;
    toy.add_model(floor_and({{300, -500, 0, 900, 500, 16}}));
    toy.add_model({{200, -64, 0, 216, 64, 128}}).add_model({{400, 100, 0, 500, 200, 64}});
    toy.add_model({{-200, -64, 0, -150, 64, 64}}).add_model({{60, -400, 0, 90, 400, 64}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*1"}, {"angle", "-1"}});
    toy.add_entity({{"classname", "func_door"}, {"model", "*2"}, {"angle", "90"}, {"targetname", "gate"}});
    toy.add_entity({{"classname", "trigger_teleport"}, {"model", "*3"}, {"targetname", "gate"}, {"target", "far"}});
    toy.add_entity({{"classname", "info_teleport_destination"}, {"targetname", "far"}, {"origin", "-900 -900 32"}});
    toy.add_entity({{"classname", "trigger_multiple"}, {"model", "*4"}, {"target", "gate"}});
    toy.add_entity({{"classname", "light"}, {"targetname", "gate"}, {"style", "33"}, {"origin", "0 0 64"}});
    toy.add_entity({{"classname", "item_lens"}, {"origin", "120 0 24"}, {"message", "A lens"}, {"target", "gate"}});
    toy.add_entity({{"classname", "item_key1"}, {"origin", "160 10 24"}});
    return toy;
}

/// Ahead with jumps, turns now and then.
inline TickInput walk_input(int tick) {
    TickInput input;
    input.forward = tick % 100 < 80 ? std::int8_t{127} : std::int8_t{0};
    input.yaw = tick % 100 < 80 ? std::int16_t{0} : std::int16_t{-700};
    input.pitch = tick % 7 == 0 ? std::int16_t{90} : std::int16_t{-15};
    if (tick % 60 == 30) input.buttons = kJumpButton;
    return input;
}

/// A picture whose pixels all differ from their neighbours.
inline Thumbnail some_picture() {
    Thumbnail picture;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const auto byte = [i](std::size_t factor) { return static_cast<std::uint8_t>(i * factor); };
        picture.pixels[i] = {byte(7), byte(3), byte(5)};
    }
    return picture;
}

/// A walk in that level and what is saved of it.
struct SavedWalk {
    explicit SavedWalk(int ticks = 150) {
        for (int tick = 0; tick < ticks; ++tick) step(game.level, game.state, walk_input(tick));
    }
    SavedGame saved() const {
        SavedLevel level{"/levels/toy.bsp",  "/levels/its.lmp",
                         "/models",          {"/game", "/game/id1"},
                         kToyLevelHash,      hash_of(start_of(game.level)),
                         0xfedcba9876543210, 77};
        return {std::move(level), {3, 12}, game.state, some_picture()};
    }
    ToyGame game{level_of_all_kinds()};
};

/// FNV-1a (its authors' description: 64 bits, offset basis, exclusive or, then the prime), written once more.
inline std::uint64_t checksum_of(std::span<const std::uint8_t> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const std::uint8_t byte : bytes) {
        hash ^= byte;
        hash *= 0x100000001b3;
    }
    return hash;
}

/// Makes a file's size and checksum right for what it holds, as someone who alters it on purpose does.
inline void forge(Bytes& bytes) {
    for (std::size_t i = 0; i < 4; ++i) bytes[12 + i] = static_cast<std::uint8_t>(bytes.size() >> (8 * i));
    const std::size_t end = bytes.size() - 8;
    const std::uint64_t checksum = checksum_of(std::span(bytes).first(end));
    for (std::size_t i = 0; i < 8; ++i) bytes[end + i] = static_cast<std::uint8_t>(checksum >> (8 * i));
}

}  // namespace oblong::test
