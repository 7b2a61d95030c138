#pragma once

#include <optional>
#include <string_view>

#include "game/simulation/game_level.h"
#include "game/simulation/state.h"

namespace oblong {

/// The item that an entity describes: item_lens, item_key1 (silver), item_key2 (gold), each with an origin; nothing for
/// any other. `fires` is left empty.
std::optional<Item> item_of(const Entity& entity);

/// The message of a class of items, for items without their own; may be empty.
std::string_view default_message(ItemClass item_class);

/// How many items of a class a level has, and how many of them the player has taken.
struct ItemCount {
    std::int32_t taken = 0, all = 0;

    bool operator==(const ItemCount&) const = default;
};
ItemCount count_items(const GameLevel& level, const GameState& state, ItemClass item_class);

/// True while an item is in its place: it is drawn and can be taken.
inline bool is_there(const GameState& state, std::size_t item) {
    return state.items[item] == ItemState::There;
}

}  // namespace oblong
