#include "game/simulation/items.h"

#include <algorithm>
#include <array>

#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "game/simulation/entity_specs.h"
#include "game/simulation/step.h"

namespace oblong {
namespace {

struct ItemClassRow {
    ClassRole role;
    ItemClass item_class;
    std::uint32_t key = 0;
};

constexpr std::array kItemClasses{
    ItemClassRow{ClassRole::Lens, ItemClass::Lens},
    ItemClassRow{ClassRole::SilverKey, ItemClass::Key, kSilverKey},
    ItemClassRow{ClassRole::GoldKey, ItemClass::Key, kGoldKey},
    ItemClassRow{ClassRole::CustomKey, ItemClass::Key},
    ItemClassRow{ClassRole::Health, ItemClass::Health},
};

constexpr int kHealsLittle = 1, kHealsAll = 2;  // spawnflags
constexpr std::int32_t kFew = 4;
constexpr std::int64_t kTangent_12 = 29;  // 12 times that of 67.5 degrees

bool is_lens(const GameLevel& level, std::size_t item) {
    return level.items[item].item_class == ItemClass::Lens;
}

std::string name_of(const GameLevel& level, std::size_t item) {
    const std::string name = level_text(level.bsp->entities[level.items[item].entity].value("netname"));
    return name.empty() ? level.word_for_lens : name;
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
    item.key = row->key;
    if (item.item_class != ItemClass::Health) return item;
    item.box = box_of_class(find_entity_class(entity.value("classname"))->box).moved(*origin);
    item.heals = has_flag(entity, kHealsAll) ? 100 : has_flag(entity, kHealsLittle) ? 15 : 25;
    return item;
}

std::string default_message(const GameLevel& level, const Item& item) {
    if (item.item_class == ItemClass::Health) return "You receive " + std::to_string(item.heals) + " health";
    return item.key == 0 ? "" : "You have the " + name_of_key(level, item.key);
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
        const Item& item = level.items[i];
        if (!is_there(state, i) || (item.heals > 0 && state.harm.damage == 0)) continue;
        state.items[i] = ItemState::Taken;
        state.progress.taken.push_back(i);
        state.progress.keys |= item.key;
        state.harm.damage = std::max(0, state.harm.damage - item.heals);
        activations.fire({EntityRef::Kind::Item, i});
    }
}

std::string direction_of(const Position& from, const Position& to) {
    const auto [east, north, up] = widening_difference(to, from);
    const WorldWide across = absolute(east), along = absolute(north);
    if (absolute(up) > std::max(across, along)) return up > WorldWide{} ? "above" : "below";
    const std::string first = north >= WorldWide{} ? "north" : "south", second = east >= WorldWide{} ? "east" : "west";
    if (along * 12 > across * kTangent_12) return first;
    return across * 12 > along * kTangent_12 ? second : first + "-" + second;
}

std::vector<std::size_t> last_lenses(const GameLevel& level, const GameState& state) {
    const ItemCount count = count_items(level, state, ItemClass::Lens);
    std::vector<std::size_t> missing;
    if (count.all - count.taken > std::min(kFew, count.all / 2)) return missing;
    for (std::size_t i = 0; i < level.items.size(); ++i)
        if (is_lens(level, i) && is_there(state, i)) missing.push_back(i);
    return missing;
}

Goal goal_of(const GameLevel& level, const GameState& state) {
    const ItemCount count = count_items(level, state, ItemClass::Lens);
    Goal goal;
    if (count.all == 0) return goal;
    const std::vector<std::size_t> last = last_lenses(level, state);
    const auto where = [&](std::size_t item) {
        return " (" + direction_of(state.player.position, level.items[item].position) + ")";
    };
    goal.title = in_capitals(level.word_for_lenses, 1);
    goal.count = std::to_string(count.taken) + " of " + std::to_string(count.all);
    for (const std::size_t lens : last)
        goal.hint += (goal.hint.empty() ? "Missing: " : ", ") + name_of(level, lens) + where(lens);
    for (std::size_t i = 0; i < level.items.size(); ++i) {
        if (!is_lens(level, i)) continue;
        goal.list += (goal.list.empty() ? "" : "\n") + name_of(level, i);
        goal.list += !is_there(state, i) ? ": found" : last.empty() ? ": missing" : ": missing" + where(i);
    }
    return goal;
}

std::string status_text(const GameLevel& level, const GameState& state, bool has_counts) {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "  ") + part; };
    if (level.health != 0) add("Health " + std::to_string(level.health - state.harm.damage));
    if (!has_counts) return text;
    if (const Goal goal = goal_of(level, state); !goal.count.empty()) add(goal.title + " " + goal.count);
    for (std::size_t i = 0; i < level.key_names.size(); ++i)
        if ((state.progress.keys >> i & 1) != 0) add(level.key_names[i]);
    return text;
}

std::string found_text(const GameLevel& level, const GameState& before, const GameState& after) {
    const ItemCount count = count_items(level, after, ItemClass::Lens);
    if (count.taken <= count_items(level, before, ItemClass::Lens).taken) return "";
    const Goal goal = goal_of(level, after);
    return goal.title + ": " + goal.count + (goal.hint.empty() ? "" : ". " + goal.hint);
}

std::string message_of(const GameLevel& level, const GameState& before, const GameState& after) {
    const bool is_new = after.message.shown != before.message.shown || after.message.tick != before.message.tick;
    std::string text;
    if (is_new && after.message.shown >= 0) text = item(level.messages, after.message.shown);
    if (after.exit != before.exit && level.intermission && level.intermission->message != kNoMessage)
        text = item(level.messages, level.intermission->message);
    if (after.items != before.items) text += (text.empty() ? "" : "\n") + found_text(level, before, after);
    return text;
}

}  // namespace oblong
