#include "game/simulation/items.h"

#include <algorithm>
#include <array>

#include "engine/level/entity_classes.h"
#include "game/simulation/entity_keys.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

struct ItemClassRow {
    ClassRole role;
    ItemClass item_class;
    std::string_view message;
};

constexpr std::array kItemClasses{
    ItemClassRow{ClassRole::Lens, ItemClass::Lens, ""},
    ItemClassRow{ClassRole::SilverKey, ItemClass::SilverKey, "You have the silver key"},
    ItemClassRow{ClassRole::GoldKey, ItemClass::GoldKey, "You have the gold key"},
};

std::uint8_t key_of(ItemClass item_class) {
    if (item_class == ItemClass::SilverKey) return kSilverKey;
    return item_class == ItemClass::GoldKey ? kGoldKey : std::uint8_t{0};
}

}  // namespace

std::optional<Item> item_of(const Entity& entity) {
    const auto row = std::find_if(kItemClasses.begin(), kItemClasses.end(),
                                  [role = role_of(entity)](const ItemClassRow& each) { return each.role == role; });
    const auto origin = row == kItemClasses.end() ? std::nullopt : origin_of(entity);
    if (!origin) return {};
    Item item;
    item.item_class = row->item_class;
    item.position = *origin;
    item.box = player_box(*origin);  // Quake's box of keys
    return item;
}

std::string_view default_message(ItemClass item_class) {
    const auto row = std::find_if(kItemClasses.begin(), kItemClasses.end(),
                                  [&](const ItemClassRow& each) { return each.item_class == item_class; });
    return row->message;
}

ItemCount count_items(const GameLevel& level, const GameState& state, ItemClass item_class) {
    ItemCount count;
    for (std::size_t i = 0; i < level.items.size(); ++i) {
        if (level.items[i].item_class != item_class) continue;
        ++count.all;
        count.taken += state.items[i] == ItemState::Taken;
    }
    return count;
}

void touch_items(const GameLevel& level, GameState& state, Activations& activations) {
    const Box player = player_box(state.player.position);
    for (const std::uint32_t i : activations.touched(level.boxes.items, player, state.backlog.next_item_box)) {
        if (!is_there(state, i)) continue;
        state.items[i] = ItemState::Taken;
        state.progress.keys |= key_of(level.items[i].item_class);
        activations.fire({EntityRef::Kind::Item, i});
    }
}

}  // namespace oblong
