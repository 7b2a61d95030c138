#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// The item that an entity describes: item_lens, item_key1 (silver), item_key2 (gold), item_key_custom, item_health,
/// each with an origin; nothing for any other. `fires`, and `key` of an item_key_custom, are left empty.
std::optional<Item> item_of(const Entity& entity);

/// The message for an item without its own; may be empty.
std::string default_message(const GameLevel& level, const Item& item);

/// How many items of a class a level has, and how many of them the player has taken.
struct ItemCount {
    std::int32_t taken = 0, all = 0;

    bool operator==(const ItemCount&) const = default;
};
ItemCount count_items(const GameLevel& level, const GameState& state, ItemClass item_class);

/// Whether the player has taken so many lenses.
inline bool has_lenses(const GameLevel& level, const GameState& state, std::int32_t count) {
    return count == 0 || count_items(level, state, ItemClass::Lens).taken >= count;
}

/// True while an item is in its place: it is drawn and can be taken.
inline bool is_there(const GameState& state, std::size_t item) {
    return state.items[item] == ItemState::There;
}

/// The goal of a level as shown to the player: its lenses. All strings are empty if there are no lenses.
struct Goal {
    std::string title;  ///< "Lenses"
    std::string count;  ///< "5 of 12"
    std::string hint;   ///< when few are missing: "Missing: RAIN (north-east), FOG (north)"
    std::string list;   ///< a line for each lens: its name and whether it is found; for the last ones where they are
};
Goal goal_of(const GameLevel& level, const GameState& state);

/// A line of what the player has: "Health 75  Coins 1 of 3  red key". Health only where something hurts, the rest if
/// `has_counts`; may be empty.
std::string status_text(const GameLevel& level, const GameState& state, bool has_counts);

/// The message after a tick that has taken lenses: "Lenses: 9 of 12. Missing: ..."; empty if none was taken.
std::string found_text(const GameLevel& level, const GameState& before, const GameState& after);

/// A tick's message to the player; usually empty.
std::string message_of(const GameLevel& level, const GameState& before, const GameState& after);

/// The missing lenses, if they are so few that the player gets hints; empty before that.
std::vector<std::size_t> last_lenses(const GameLevel& level, const GameState& state);

/// The direction of a place from another: "north", "south-west"; "above" or "below" if the difference in height is
/// larger.
std::string direction_of(const Position& from, const Position& to);

}  // namespace oblong
