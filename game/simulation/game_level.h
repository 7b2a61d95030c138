#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/table.h"
#include "engine/level/level.h"
#include "game/simulation/box_tree.h"
#include "game/simulation/geometry.h"
#include "game/simulation/state.h"
#include "game/simulation/view_dials.h"

namespace oblong {

/// An index into GameLevel::targets, or kNoTarget.
using TargetIndex = std::int32_t;
inline constexpr TargetIndex kNoTarget = -1;

/// An index into GameLevel::messages, or kNoMessage.
using MessageIndex = std::int32_t;
inline constexpr MessageIndex kNoMessage = -1;

/// Begins a page of a message: its text before the first page is their heading.
inline constexpr char kNewPage = '\f';

/// In place of a number of ticks: for ever.
inline constexpr std::int32_t kForever = -1;

/// What an entity does when it fires: Quake's SUB_UseTargets.
struct Firing {
    TargetIndex target = kNoTarget;     ///< what it activates, unless it has `removed`
    TargetIndex removed = kNoTarget;    ///< what it removes ("killtarget")
    std::int32_t delay_ticks = 0;       ///< before it does all this
    MessageIndex message = kNoMessage;  ///< what it shows the player

    bool is_empty() const { return target == kNoTarget && removed == kNoTarget && message == kNoMessage; }
};

enum class ItemClass : std::uint8_t { Lens, Key, Health };

/// Bits of Progress::keys, whatever the level.
inline constexpr std::uint32_t kSilverKey = 1, kGoldKey = 2;

/// An item that the player takes by touching it.
struct Item {
    ItemClass item_class = ItemClass::Lens;
    Position position;
    Box box;                 ///< the player in here takes it
    std::uint32_t key = 0;   ///< its bit of Progress::keys
    std::int32_t heals = 0;  ///< the damage that it undoes
    std::size_t entity = 0;  ///< into Level::entities
    Firing fires;            ///< when it is taken
};

enum class MoverKind : std::uint8_t { Door, Button, Lift, SecretDoor, Train };

/// A straight part of a mover's way.
struct Leg {
    Vec3<World> from;              ///< offset of the model where the leg begins
    Vec3<World> way;               ///< from there to its end
    World length;                  ///< of `way`
    std::int32_t pause_ticks = 0;  ///< a train's, at the leg's end; kForever: it stays there
    std::uint32_t next = 0;        ///< a train's next leg; their count: none
};

/// What touching a mover does.
struct MoverTouch {
    std::optional<Box> box;                  ///< the player in here touches the mover
    bool opens = false;                      ///< a door, if the player has its keys
    std::uint32_t keys = 0;                  ///< that opening a door needs
    std::int32_t lenses = 0;                 ///< likewise
    MessageIndex message = kNoMessage;       ///< shown when the player touches the door before it opens
    MessageIndex keys_message = kNoMessage;  ///< shown to a player without the keys or lenses

    bool is_locked() const { return keys != 0 || lenses != 0; }
};

/// A brush model that travels: doors, lifts and buttons between the two ends of one leg, secret doors there and back
/// along two legs, trains round and round along many.
struct Mover {
    MoverKind kind = MoverKind::Door;
    ModelIndex model;
    std::size_t entity = 0;         ///< into Level::entities
    std::vector<Leg> legs;          ///< one or more
    World speed_per_tick;           ///< units; degrees for a door that turns, as its leg's length
    std::int32_t turns = 0;         ///< a door: 1 counter-clockwise, -1 clockwise (solid while shut); 0: no turning
    std::int32_t wait_ticks = 0;    ///< at the far end; kForever: it stays there
    std::int32_t damage = 0;        ///< to a player in its way: in each tick, a train's each half second
    bool turns_back = false;        ///< when the player is in its way; others wait for room
    bool starts_at_end = false;     ///< a lift that waits above until it is activated
    bool starts_by_itself = false;  ///< a train
    bool toggles = false;           ///< an open door closes when it is activated
    MoverTouch touch;
    std::uint32_t group = 0;                   ///< the first of the doors that open together; of other movers: itself
    std::vector<std::uint32_t> group_members;  ///< of a group's first door
    Firing fires;
};

enum class TriggerKind : std::uint8_t {
    Multiple,    ///< fires when touched or activated: once, or again after a wait
    Relay,       ///< fires when activated
    Counter,     ///< fires when it has been activated a number of times
    Teleport,    ///< takes the player to a place, and fires
    Push,        ///< gives the player a velocity
    Checkpoint,  ///< the player respawns here
    Exit,        ///< ends the level
    Hurt,        ///< takes health, each second
    Timer,       ///< fires again and again
    Ladder,      ///< the player climbs in it
    Lightning,   ///< Chthon's: see entity_specs.h
};

/// What a trigger_view or trigger_budget asks of the player's picture.
struct ViewCondition {
    std::optional<Position> point;        ///< to look at
    std::optional<Vec3<Unit>> direction;  ///< to look in, without a point
    Unit least_cosine;                    ///< of the angle between the look and the way to either
    std::array<std::optional<std::uint8_t>, kViewDials> dials;
    std::uint16_t least_work = 0, most_work = kNoLimit;  ///< TickInput::work

    static constexpr std::uint16_t kNoLimit = 0xffff;
    bool asks_for_work() const { return least_work != 0 || most_work != kNoLimit; }
};

/// A volume that affects a player who enters it, or a trigger without a volume, which can only be activated.
struct Trigger {
    TriggerKind kind = TriggerKind::Multiple;
    std::size_t entity = 0;  ///< into Level::entities
    std::optional<Box> box;  ///< none: it can't be touched
    Firing fires;
    std::int32_t wait_ticks = 0;          ///< between two firings; kForever: it fires once
    std::int32_t random_ticks = 0;        ///< by which a timer's wait varies up or down
    std::int32_t damage = 0;              ///< of what hurts
    std::int32_t lenses = 0;              ///< that the player must have taken
    std::int32_t count = 0;               ///< a counter's, or the strokes of lightning; of what can be switched: 1
    bool starts_off = false;              ///< of what can be switched
    std::int32_t found = 0;               ///< above 0: it sounds as the item that was taken as number `found`
    std::optional<Vec3<Unit>> facing;     ///< fires only if the player looks this way, within a quarter turn
    std::optional<ViewCondition> view;    ///< fires only if it holds
    bool is_secret = false;               ///< counts in Progress::found_secrets
    bool is_quiet = false;                ///< a counter that doesn't say how many are left
    std::optional<std::uint32_t> breaks;  ///< the wall that goes when it fires: into GameLevel::walls
    std::optional<Position> sounds_from;  ///< of a sound at a place; none: it is heard everywhere
    bool needs_activation = false;        ///< a teleporter that works for 0.2 s after it was activated
    Place place;                          ///< of a teleporter's exit, or a checkpoint
    Velocity push;
    std::string next_map;                   ///< where an exit leads, as "e1m2"; may be empty
    std::vector<std::uint32_t> electrodes;  ///< of lightning: movers
};

/// The most doors, lifts, buttons and trains of a level; Quake allows 255 brush models, its successors some thousands.
inline constexpr std::size_t kMostMovers = 16'384;

/// All that has one targetname.
struct Target {
    std::vector<EntityRef> entities;  ///< in their order in the file
    std::uint64_t light_styles = 0;   ///< a bit for each style of its lights, switched off and on by turns
};

/// Trees for finding what a box overlaps.
struct LevelBoxes {
    BoxTree touch;      ///< MoverTouch::box, by the indices of movers
    BoxTree triggers;   ///< by their indices
    BoxTree items;      ///< by their indices
    BoxTree obstacles;  ///< all places of solid walls, then of movers, numbered in this order
};

/// Where the level is seen from after its end: an info_intermission.
struct Intermission {
    Position eye;
    Angle yaw, pitch;
    std::int32_t turn_degrees = 0;  ///< of the yaw, a second
    std::int32_t wait_ticks = 0;    ///< before the end's page
    MessageIndex message = kNoMessage;
};

/// The part of a game that never changes: what the game needs of a level.
struct GameLevel {
    const Level* bsp = nullptr;  ///< outlives the game level
    std::string title;           ///< worldspawn's message; may be empty
    std::vector<Mover> movers;
    std::vector<ModelIndex> walls;  ///< brush models that stand still
    std::vector<Trigger> triggers;
    std::vector<Item> items;
    std::vector<std::uint32_t> timers, ladders;  ///< into `triggers`
    std::vector<Target> targets;
    std::vector<std::string> messages;
    std::vector<std::string> key_names = {"silver key", "gold key"};
    std::int32_t health = 0;                     ///< the player's at the start; 0: nothing hurts
    MessageIndex died = kNoMessage;              ///< shown when the player dies
    std::vector<MessageIndex> counter_messages;  ///< [n]: n more activations to go, for counters of this level
    std::int32_t secrets = 0;                    ///< how many there are to be found
    std::uint64_t dark_styles = 0;               ///< GameState::dark_styles at the start
    std::vector<std::uint32_t> solid_walls;      ///< into `walls`
    LevelBoxes boxes;
    Place start;                    ///< the player's
    TargetIndex visit = kNoTarget;  ///< kVisitName
    std::optional<Intermission> intermission;
    std::string word_for_lens = "a lens", word_for_lenses = "lenses";  ///< make_game_level() leaves them as they are

    const Target& target(TargetIndex index) const { return item(targets, index); }
    const SubModel& model(ModelIndex index) const { return bsp->models[index]; }
};

/// Reads the entities of a single-player game at normal skill (no spawnflag 512), and turns them into what Quake's own
/// game code does:
/// - info_player_start, info_teleport_destination;
/// - func_door, func_door_rotating, func_door_secret, func_button, func_plat, func_train with its path_corners; what
///   would have to be shot ("health", an untargeted secret door) answers to touch; so does a door whose name nothing
///   activates;
/// - func_wall, func_breakable (answers to touch, or to its name), func_illusionary; func_episodegate and func_bossgate
/// are open; any other func_ stands still;
/// - trigger_once, trigger_multiple, trigger_secret, trigger_onlyregistered (every copy is), trigger_counter,
///   trigger_relay, trigger_push, trigger_teleport, trigger_changelevel; trigger_setskill and trigger_monsterjump do
///   nothing, as there are no monsters;
/// - trigger_hurt, item_health, lava, slime and what shuts on the player, only if worldspawn has "health";
/// - lights with a targetname and a style from 32 on;
/// - item_key1, item_key2; of monsters and other items only what they fire is left: see entity_specs.h. From Quake's
///   successors there are func_timer, item_key_custom, trigger_ladder, play_sound and play_sound_triggered, and of
///   Oblong's own item_lens and info_checkpoint ("origin", "angle", "size" of its volume, 128 128 112): the respawn
///   button leads back to the one passed last, and so does death. Who dies before any has lost.
///
/// Throws InputError for more than kMostMovers movers: doors that overlap are compared in pairs; and for more than 31
/// names of keys.
GameLevel make_game_level(const Level& bsp);

/// The state in which a level begins.
GameState start_of(const GameLevel& level);

/// The dial that the place of the player asks for, a trigger_view's first; none: the place asks for none.
std::optional<ViewDialKind> asked_dial(const GameLevel& level, const GameState& state);
/// Whether TickInput::work matters where the player is.
bool asks_for_work(const GameLevel& level, const GameState& state);

/// "machine" of a button that reached its end in the tick between two states: a lever; may be empty.
std::string pulled_machine(const GameLevel& level, const GameState& before, const GameState& after);

/// The name of the first of some keys: bits of Progress::keys, one or more.
inline const std::string& name_of_key(const GameLevel& level, std::uint32_t keys) {
    return item(level.key_names, std::countr_zero(keys));
}

/// The map that follows the ended level, as "e1m2"; empty if its exit names none or the level has not ended.
std::string_view next_map(const GameLevel& level, const GameState& state);

/// The message of the exit that ended the level, or of the player's death; may be empty.
std::string_view end_message(const GameLevel& level, const GameState& state);

/// The level's names of secrets that were not found: "NAME, NAME"; may be empty.
std::string missed_secrets(const GameLevel& level, const GameState& state);

/// The box of a model at an offset, grown by 2 units: compilers write boxes up to a unit too small.
Box obstacle_box(const GameLevel& level, ModelIndex model, const Vec3<World>& offset);

/// The current offset of a mover's model.
Vec3<World> offset_of(const Mover& mover, const MoverState& state);

/// The angle by which a mover's model is turned: 0 except for doors that turn.
Angle turn_of(const Mover& mover, World travelled);

inline bool is_removed(const MoverState& mover) {
    return mover.phase == MoverState::Phase::Removed;
}

inline bool is_moving(const MoverState& mover) {
    return mover.phase == MoverState::Phase::Leaving || mover.phase == MoverState::Phase::Returning;
}

/// True for a mover that does not change until something activates it: ticks do not step it.
inline bool is_at_rest(const MoverState& mover) {
    return !is_moving(mover) && (mover.phase != MoverState::Phase::AtEnd || mover.wait_ticks == kForever);
}

/// The movers that are not at rest, ascending.
std::vector<std::uint32_t> movers_in_motion(const GameState& state);

/// True if a mover shows the alternative frames of its textures: a pressed button.
inline bool shows_other_frames(const Mover& mover, const MoverState& state) {
    return mover.kind == MoverKind::Button && state.phase == MoverState::Phase::AtEnd;
}

/// The error in a state from outside, as "movers: 3, expected 4"; empty if the game can continue from it: every list
/// has the level's length, every index is in range, every number is one that the game can produce.
std::string find_inconsistency(const GameLevel& level, const GameState& state);

}  // namespace oblong
