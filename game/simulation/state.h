#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "engine/fixed/trig.h"
#include "game/simulation/geometry.h"

namespace oblong {

/// How deep the player stands in a liquid.
enum class Depth : std::uint8_t { Dry, Feet, Waist, Eyes };

/// A place where the player appears, and the direction of the view there.
struct Place {
    Position position;
    Angle yaw;
    bool operator==(const Place&) const = default;
};

struct Player {
    Position position;  ///< in a box of 32x32x56: 16 from its sides, 24 above its bottom
    Velocity velocity;
    Angle yaw;                        ///< counter-clockwise from +x
    std::int32_t pitch = 0;           ///< 65,536 to the circle, down positive, +-kSteepestPitch
    World eye_lag;                    ///< how far the eye is below its usual height, after a step up
    std::int32_t ground = kNoGround;  ///< the model that the player stands on, 0: the world
    Depth depth = Depth::Dry;
    bool holds_jump = false;  ///< the button must be released before the next jump

    static constexpr std::int32_t kNoGround = -1;
    static constexpr std::int32_t kSteepestPitch = 16'000;
    bool operator==(const Player&) const = default;
};

/// What the player has done so far.
struct Progress {
    std::int32_t found_secrets = 0;    ///< of GameLevel::secrets
    std::vector<std::uint32_t> taken;  ///< items, in the order in which they were taken
    std::uint32_t keys = 0;            ///< a bit for each of GameLevel::key_names
    Place respawn;                     ///< where kRespawnButton leads

    bool operator==(const Progress&) const = default;
};

/// A mover's position on its path.
struct MoverState {
    enum class Phase : std::uint8_t { AtStart, Leaving, AtEnd, Returning, Removed };
    Phase phase = Phase::AtStart;  ///< a train leaves once, and is AtEnd while it waits at a corner
    std::uint32_t leg = 0;         ///< into Mover::legs
    World travelled;               ///< from the leg's start, 0 to Leg::length
    std::int32_t wait_ticks = 0;   ///< before it goes on; kForever: until it is activated
    std::int64_t next_touch = 0;   ///< the first tick in which a touch of its group counts again
    bool has_been_fired = false;   ///< a door's group: its touch message is not shown again

    bool operator==(const MoverState&) const = default;
};

struct TriggerState {
    std::int64_t ready_tick = 0;  ///< the first tick in which it may fire again; kNever: it is gone
    std::int64_t open_until = 0;  ///< the tick in which an activated teleporter closes
    std::int32_t left = 0;        ///< activations until a counter fires; strokes of lightning left; 1: it is on

    static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
    bool operator==(const TriggerState&) const = default;
};

/// The state of an item of the level.
enum class ItemState : std::uint8_t { There, Taken, Removed };

enum class WallState : std::uint8_t { There, ShowsOtherFrames, Removed };

/// Something that can be activated, or removed.
struct EntityRef {
    enum class Kind : std::uint8_t { Mover, Wall, Trigger, Item };
    Kind kind = Kind::Mover;
    std::uint32_t index = 0;  ///< into the list of its kind in GameLevel and GameState

    bool operator==(const EntityRef&) const = default;
};

/// An entity that will fire after its delay.
struct DelayedFiring {
    std::int64_t tick = 0;
    EntityRef by;

    bool operator==(const DelayedFiring&) const = default;
};

/// A target whose entities are being activated, or removed, one after the other.
struct WaitingFiring {
    std::int32_t target = 0;  ///< into GameLevel::targets
    std::uint32_t next = 0;   ///< the next of the target's entities
    bool removes = false;

    bool operator==(const WaitingFiring&) const = default;
};

/// Work beyond the bounds of a tick (tick.h), which continues in the next ones. Empty except in levels made to exceed
/// them.
struct Backlog {
    std::vector<WaitingFiring> waiting;                                         ///< the next one last
    std::uint32_t next_mover = 0;                                               ///< the first mover of the next tick
    std::uint32_t next_touch_box = 0, next_trigger_box = 0, next_item_box = 0;  ///< BoxTree::Part::next

    bool operator==(const Backlog&) const = default;
    bool is_empty() const { return *this == Backlog{}; }
};

/// What the player has suffered.
struct Harm {
    std::int32_t damage = 0;  ///< 0 to GameLevel::health, at which the player dies

    bool operator==(const Harm&) const = default;
    bool is_empty() const { return *this == Harm{}; }
};

/// The last message that the player was shown.
struct MessageState {
    std::int32_t shown = -1;  ///< into GameLevel::messages; -1: none yet
    std::int64_t tick = 0;    ///< in which it was shown

    bool operator==(const MessageState&) const = default;
};

/// Everything that changes from tick to tick, and nothing else: what a demo must reproduce.
struct GameState {
    std::int64_t tick = 0;
    Player player;
    Progress progress;
    std::vector<MoverState> movers;            ///< in the order of GameLevel::movers
    std::vector<std::uint32_t> active_movers;  ///< not at rest, ascending: only these are stepped
    std::vector<WallState> walls;              ///< in the order of GameLevel::walls
    std::vector<TriggerState> triggers;        ///< in the order of GameLevel::triggers
    std::vector<ItemState> items;              ///< in the order of GameLevel::items
    std::vector<DelayedFiring> delayed;        ///< by tick, ascending
    std::uint64_t dark_styles = 0;             ///< a bit for each light style that is switched off
    MessageState message;
    bool has_ended = false;
    std::int32_t exit = -1;  ///< the trigger that ended the level: into GameLevel::triggers
    Backlog backlog;
    Harm harm;

    bool operator==(const GameState&) const = default;
    bool is_lost() const { return has_ended && exit < 0; }  ///< it ended by the player's death
};

/// FNV-1a over the fields in order, without an empty backlog or harm; equal states have equal hashes on every machine.
std::uint64_t hash_of(const GameState& state);

template <class Field, class Struct>
concept MaybeConst = std::is_same_v<std::remove_const_t<Field>, Struct>;

// visit_fields(): calls visit(field) for every field of a state, in one order that the hash and saved games share:
// numbers (integers, enumerations, bool, World, Angle), lists, and structs with their own visit_fields(). A field that
// is not here is neither hashed nor saved.

void visit_each(auto& visit, auto&... fields) {
    (visit(fields), ...);
}

void visit_fields(MaybeConst<GameState> auto& state, auto& visit) {
    auto& player = state.player;
    auto& respawn = state.progress.respawn;
    visit_each(visit, state.tick, player.position.x, player.position.y, player.position.z, player.velocity.x,
               player.velocity.y, player.velocity.z, player.yaw, player.pitch, player.eye_lag, player.ground,
               player.depth, player.holds_jump, state.movers, state.active_movers, state.walls, state.triggers,
               state.items, state.delayed, state.dark_styles, state.progress.found_secrets, state.progress.taken,
               state.progress.keys, respawn.position.x, respawn.position.y, respawn.position.z, respawn.yaw,
               state.message.shown, state.message.tick, state.has_ended, state.exit, state.backlog, state.harm);
}

void visit_fields(MaybeConst<MoverState> auto& mover, auto& visit) {
    visit_each(visit, mover.phase, mover.leg, mover.travelled, mover.wait_ticks, mover.next_touch,
               mover.has_been_fired);
}

void visit_fields(MaybeConst<TriggerState> auto& trigger, auto& visit) {
    visit_each(visit, trigger.ready_tick, trigger.open_until, trigger.left);
}

void visit_fields(MaybeConst<DelayedFiring> auto& delayed, auto& visit) {
    visit_each(visit, delayed.tick, delayed.by.kind, delayed.by.index);
}

void visit_fields(MaybeConst<Harm> auto& harm, auto& visit) {
    visit_each(visit, harm.damage);
}

void visit_fields(MaybeConst<WaitingFiring> auto& waiting, auto& visit) {
    visit_each(visit, waiting.target, waiting.next, waiting.removes);
}

void visit_fields(MaybeConst<Backlog> auto& backlog, auto& visit) {
    visit_each(visit, backlog.waiting, backlog.next_mover, backlog.next_touch_box, backlog.next_trigger_box,
               backlog.next_item_box);
}

template <class Struct>
concept HasFields = requires(Struct& each, int& visit) {
    visit_fields(each, visit);
};

}  // namespace oblong
