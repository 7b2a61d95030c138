#include "game/simulation/level_builder.h"

#include <algorithm>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/table.h"
#include "engine/base/text.h"
#include "engine/level/entities.h"
#include "engine/scene/light_styles.h"
#include "engine/scene/placed_models.h"
#include "game/simulation/collision.h"
#include "game/simulation/items.h"

namespace oblong {
namespace {

constexpr int kStartsDark = 1;                 // spawnflag of lights
constexpr std::int64_t kFirstSwitchable = 32;  // light style
constexpr std::int32_t kFastestTurn = 360;     // of an intermission, degrees a second
constexpr std::int32_t kExitHeight = 27;       // of the player's origin over an info_teleport_destination

constexpr std::int32_t kMostHealth = 999;

using Kind = EntityRef::Kind;

std::string needed_lenses(std::int32_t count) {
    return count == 1 ? "You need a lens" : "You need " + std::to_string(count) + " lenses";
}

std::uint32_t number_of_last(std::size_t size) {
    return static_cast<std::uint32_t>(size - 1);
}

}  // namespace

LevelBuilder::LevelBuilder(const Level& bsp) : longest_travel_(longest_travel(bsp)) {
    level_.bsp = &bsp;
    for (const Entity& entity : bsp.entities) {
        if (is_left_out(entity)) continue;
        present_.push_back(&entity);
        if (const std::string its_name = entity.value("targetname"); !its_name.empty())
            by_name_.emplace(its_name, &entity);
    }
}

GameLevel LevelBuilder::build() {
    for (const Entity* entity : present_) add_entity(*entity);
    add_what_monsters_leave();
    add_start();
    if (const auto visit = target_of_.find(std::string(kVisitName)); visit != target_of_.end())
        level_.visit = visit->second;
    connect_movers();
    connect_triggers();
    connect_lightning();
    for (Item& item : level_.items)
        item.fires = firing_of(level_.bsp->entities[item.entity], default_message(level_, item));
    if (level_.health != 0) level_.died = message("You did not survive.");
    connect_doors();
    add_counter_messages();
    make_trees();
    return std::move(level_);
}

void LevelBuilder::add_entity(const Entity& entity) {
    const ClassRole role = role_of(entity);
    if (role == ClassRole::Worldspawn) {
        level_.title = level_text(entity.value("message"));
        level_.health = std::min(kMostHealth, whole_number_of(entity, "health"));
    }
    if (is_of_brushes(role) && !add_mover(entity)) add_wall(entity, role);
    add_trigger(entity);
    add_item(entity);
    if (role == ClassRole::Lamp) add_light(entity);
    if (role == ClassRole::Intermission) add_intermission(entity);
}

bool LevelBuilder::add_mover(const Entity& entity) {
    auto mover = mover_of(entity, *level_.bsp, longest_travel_);
    if (!mover) mover = train_of(entity, by_name_, *level_.bsp, longest_travel_);
    if (!mover) return false;
    if (level_.movers.size() == kMostMovers)
        throw InputError("entities", "more than 16,384 doors, lifts, buttons and trains, expected no more");
    mover->entity = index_of(entity);
    if (mover->touch.keys == 0) mover->touch.keys = key_named(entity.value("keyname"));
    level_.movers.push_back(std::move(*mover));
    mover_entities_.push_back(&entity);
    name(entity, Kind::Mover, level_.movers.size());
    return true;
}

void LevelBuilder::add_wall(const Entity& entity, ClassRole role) {
    const auto model = brush_model_of(entity, *level_.bsp);
    if (!model || role == ClassRole::OpenGate) return;
    level_.walls.push_back(*model);
    if (role == ClassRole::Passable) return;
    level_.solid_walls.push_back(number_of_last(level_.walls.size()));
    name(entity, Kind::Wall, level_.walls.size());
}

void LevelBuilder::add_trigger(const Entity& entity) {
    auto trigger = trigger_of(entity, *level_.bsp);
    if (!trigger || (trigger->kind == TriggerKind::Teleport && !find_exit(entity, *trigger))) return;
    if (trigger->kind == TriggerKind::Hurt && level_.health == 0) return;
    const Entity* const looked_at = find_placed(entity.value("look_at"), by_name_);
    if (trigger->view && looked_at) trigger->view->point = origin_of(*looked_at);
    level_.secrets += trigger->is_secret;
    trigger->entity = index_of(entity);
    level_.triggers.push_back(std::move(*trigger));
    trigger_entities_.push_back(&entity);
    const std::uint32_t number = number_of_last(level_.triggers.size());
    if (level_.triggers.back().kind == TriggerKind::Timer) level_.timers.push_back(number);
    if (level_.triggers.back().kind == TriggerKind::Ladder) level_.ladders.push_back(number);
    if (role_of(entity) == ClassRole::Breakable) level_.triggers.back().breaks = number_of_last(level_.walls.size());
    name(entity, Kind::Trigger, level_.triggers.size());
}

bool LevelBuilder::find_exit(const Entity& entity, Trigger& trigger) const {
    const Entity* const exit = find_placed(entity.value("target"), by_name_);
    if (!exit) return false;
    trigger.place = {*origin_of(*exit), yaw_of(*exit)};
    if (role_of(*exit) == ClassRole::TeleportExit) trigger.place.position.z += World::from_int(kExitHeight);
    trigger.place.position = free_place_near(level_, trigger.place.position);
    return true;
}

void LevelBuilder::add_item(const Entity& entity) {
    std::optional<Item> item = item_of(entity);
    if (!item || (item->item_class == ItemClass::Health && level_.health == 0)) return;
    if (item->item_class == ItemClass::Key && item->key == 0) item->key = key_named(entity.value("keyname"));
    item->entity = index_of(entity);
    level_.items.push_back(*item);
    name(entity, Kind::Item, level_.items.size());
}

// The first; Quake takes any.
void LevelBuilder::add_intermission(const Entity& entity) {
    const auto origin = origin_of(entity);
    if (!origin || level_.intermission) return;
    const auto angles = parse_world_vector(entity.value("mangle"));
    const auto angle = [](World degrees) { return degrees_to_angle(convert<Degrees>(degrees)); };
    level_.intermission = {*origin,
                           angles ? angle(angles->y) : yaw_of(entity),
                           angles ? angle(angles->x) : Angle{},
                           floor_of(number_of(entity, "speed", kFastestTurn)),
                           std::max(0, ticks_of(entity, "wait")),
                           message(level_text(entity.value("message")))};
}

// As in Quake, a light with a targetname and a style from 32 on can be switched; spawnflag 1: off at the start.
void LevelBuilder::add_light(const Entity& entity) {
    const std::string its_name = entity.value("targetname");
    const auto style = parse_decimal(entity.value("style"), 0);
    if (its_name.empty() || !style || *style < kFirstSwitchable || *style >= kLightStyleCount) return;
    const std::uint64_t bit = std::uint64_t{1} << *style;
    target_named(its_name).light_styles |= bit;
    if (has_flag(entity, kStartsDark)) level_.dark_styles |= bit;
}

void LevelBuilder::add_what_monsters_leave() {
    for (const Entity* entity : present_) {
        if (level_.health != 0 && role_of(*entity) == ClassRole::Health) continue;
        auto trigger = trigger_left_of(*entity, level_.triggers);
        if (!trigger || (trigger->kind != TriggerKind::Exit && firing_of(*entity).is_empty())) continue;
        trigger->entity = index_of(*entity);
        level_.triggers.push_back(std::move(*trigger));
        trigger_entities_.push_back(entity);
    }
}

void LevelBuilder::add_start() {
    const auto find_first = [&](ClassRole role) {
        const auto found =
            std::find_if(present_.begin(), present_.end(), [&](const Entity* each) { return role_of(*each) == role; });
        return found == present_.end() ? nullptr : *found;
    };
    const Entity* start = find_first(ClassRole::Start);
    if (start == nullptr) start = find_first(ClassRole::DeathmatchStart);
    if (start == nullptr) return;
    level_.start.position = origin_of(*start).value_or(Position{}) + world_vector(0, 0, 1);
    level_.start.yaw = yaw_of(*start);
}

// As in Quake, lifts and trains fire nothing.
void LevelBuilder::connect_movers() {
    link_doors(level_.movers, mover_entities_, *level_.bsp);
    for (std::size_t i = 0; i < level_.movers.size(); ++i) {
        Mover& mover = level_.movers[i];
        if (mover.kind == MoverKind::Lift || mover.kind == MoverKind::Train) continue;
        mover.fires = firing_of(*mover_entities_[i]);
        if (mover.kind == MoverKind::Button) continue;
        const MessageIndex said =
            std::exchange(mover.fires.message, kNoMessage);  // doors show it when they are touched
        if (said != kNoMessage) level_.movers[mover.group].touch.message = said;
        if (mover.touch.keys != 0)
            mover.touch.keys_message = message("You need the " + name_of_key(level_, mover.touch.keys));
        else if (mover.touch.lenses != 0 && said == kNoMessage)
            mover.touch.keys_message = message(needed_lenses(mover.touch.lenses));
    }
}

void LevelBuilder::connect_triggers() {
    for (std::size_t i = 0; i < level_.triggers.size(); ++i) {
        Trigger& trigger = level_.triggers[i];
        if (trigger.kind == TriggerKind::Push || trigger.kind == TriggerKind::Checkpoint ||
            role_of(*trigger_entities_[i]) == ClassRole::TimedSound)  // its "delay" means something else
            continue;
        const Entity& entity = *trigger_entities_[i];
        trigger.fires = firing_of(entity, trigger.is_secret ? kSecretMessage : std::string_view{});
        if (role_of(entity) == ClassRole::TriggerOnlyRegistered) trigger.fires.message = kNoMessage;
    }
}

// Lightning fires the targets of the level's first Chthon in its place.
void LevelBuilder::connect_lightning() {
    std::vector<std::uint32_t> electrodes = find_electrodes(mover_entities_);
    const auto boss = std::find_if(trigger_entities_.begin(), trigger_entities_.end(),
                                   [](const Entity* each) { return role_of(*each) == ClassRole::Boss; });
    if (electrodes.size() < 2 || boss == trigger_entities_.end()) return;
    Trigger& left_of_boss = item(level_.triggers, boss - trigger_entities_.begin());
    for (Trigger& trigger : level_.triggers) {
        if (trigger.kind != TriggerKind::Lightning) continue;
        trigger.fires = left_of_boss.fires;
        trigger.electrodes = electrodes;
        left_of_boss.box.reset();
    }
}

void LevelBuilder::connect_doors() {
    const std::vector<bool> is_activated = activated_movers();
    make_doors_touchable(level_.movers, mover_entities_, is_activated, *level_.bsp);
    for (std::size_t i = 0; i < level_.movers.size(); ++i)
        if (level_.movers[i].kind == MoverKind::SecretDoor && !is_activated[i]) level_.movers[i].touch.opens = true;
}

std::vector<bool> LevelBuilder::activated_movers() const {
    std::vector<bool> is_used(level_.targets.size());
    const auto use = [&](const Firing& fires) {
        if (fires.target != kNoTarget) item(is_used, fires.target) = true;
    };
    for (const Mover& mover : level_.movers) use(mover.fires);
    for (const Trigger& trigger : level_.triggers) use(trigger.fires);
    for (const Item& item : level_.items) use(item.fires);
    std::vector<bool> is_activated(level_.movers.size());
    for (std::size_t i = 0; i < is_used.size(); ++i) {
        if (!is_used[i]) continue;
        for (const EntityRef& entity : level_.targets[i].entities)
            if (entity.kind == Kind::Mover) is_activated[entity.index] = true;
    }
    return is_activated;
}

void LevelBuilder::add_counter_messages() {
    const bool is_counting = std::any_of(level_.triggers.begin(), level_.triggers.end(), [](const Trigger& trigger) {
        return trigger.kind == TriggerKind::Counter && !trigger.is_quiet;
    });
    if (!is_counting) return;
    for (const char* text :
         {"Sequence complete", "Only 1 more to go", "Only 2 more to go", "Only 3 more to go", "There are more to go"})
        level_.counter_messages.push_back(message(text));
}

void LevelBuilder::make_trees() {
    std::vector<BoxTree::Entry> touch_boxes, trigger_boxes, item_boxes, obstacles;
    const auto add = [](const Box& box, std::vector<BoxTree::Entry>& entries, std::size_t number) {
        entries.push_back({box, static_cast<std::uint32_t>(number)});
    };
    for (const std::uint32_t wall : level_.solid_walls)
        add(obstacle_box(level_, level_.walls[wall], {}), obstacles, obstacles.size());
    for (std::size_t i = 0; i < level_.movers.size(); ++i) {
        const Mover& mover = level_.movers[i];
        if (mover.touch.box) add(*mover.touch.box, touch_boxes, i);
        Box way = obstacle_box(level_, mover.model, mover.legs.front().from);
        for (const Leg& leg : mover.legs) way = way.united(obstacle_box(level_, mover.model, leg.from + leg.way));
        add(way, obstacles, obstacles.size());
    }
    for (std::size_t i = 0; i < level_.triggers.size(); ++i)
        if (level_.triggers[i].box) add(*level_.triggers[i].box, trigger_boxes, i);
    for (std::size_t i = 0; i < level_.items.size(); ++i) add(level_.items[i].box, item_boxes, i);
    level_.boxes.touch = BoxTree(std::move(touch_boxes));
    level_.boxes.triggers = BoxTree(std::move(trigger_boxes));
    level_.boxes.items = BoxTree(std::move(item_boxes));
    level_.boxes.obstacles = BoxTree(std::move(obstacles));
}

}  // namespace oblong
