#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/fixed/fixed.h"

namespace oblong {

inline constexpr std::string_view kRelease = "0.1";  ///< the first release

/// The type of a key's value.
enum class KeyKind : std::uint8_t {
    Text,
    Numbers,  ///< `least` to `most` of them
    Whole,    ///< an integer
    Choice,   ///< one of `values`
    Flags,    ///< the sum of some of `values`
    Name,     ///< targeted by other entities
    Target,   ///< the name of other entities
    Place,    ///< the name of another entity with an origin
    Texture,  ///< a texture with holes: its name begins with '{'
};

/// A value of a key, or a bit of its flags.
struct KeyValue {
    std::string_view value, does;
};

/// The range of a key's numbers.
struct NumberRange {
    World least, most;
};

struct EntityKey {
    std::string_view name;  ///< a final '#' stands for digits
    KeyKind kind = KeyKind::Text;
    std::string_view usual;  ///< the default; empty: none
    std::string_view does;   ///< empty: one of Quake's, without effect here
    std::span<const KeyValue> values = {};
    std::uint8_t least = 1, most = 1;  ///< how many numbers
    bool is_required = false;
    std::string_view since = kRelease;      ///< the first release with it
    std::optional<NumberRange> range = {};  ///< of its numbers; none: any
};

enum class ClassShape : std::uint8_t {
    WorldModel,  ///< the level's brushes
    Point,       ///< has an origin
    Brush,       ///< has brushes
    Either,      ///< an origin, brushes or neither
};

/// The function of an entity, for programs that read levels.
enum class ClassRole : std::uint8_t {
    None,  ///< a place used by others, a sound, or without effect
    Worldspawn,
    Start,
    DeathmatchStart,
    TeleportExit,
    Checkpoint,
    Intermission,
    Lamp,
    // From here to Train: made of brushes; a wall while it does not move.
    BrushGroup,
    Detail,
    PassableDetail,
    PlainWall,
    Breakable,
    Passable,  ///< visible, not solid
    OpenGate,
    Door,
    TurningDoor,
    SecretDoor,
    Button,
    Lift,
    Train,
    // From here to OtherTrigger: an invisible volume.
    TriggerOnce,
    TriggerMultiple,
    TriggerSecret,
    TriggerOnlyRegistered,
    TriggerRelay,
    TriggerCounter,
    TriggerTeleport,
    TriggerPush,
    TriggerExit,
    TriggerView,
    TriggerHurt,
    TriggerLadder,
    Timer,
    TimedSound,
    OtherTrigger,
    Lightning,
    Lens,
    SilverKey,
    GoldKey,
    CustomKey,
    Rain,
    Dust,
    Sparks,
    Bubbles,
    Billboard,
    FlyingLamp,
    TriangleModel,
    Rotating,  ///< brushes shown as a triangle model, not solid
    Monster,
    Boss,         ///< killed by Lightning
    LastBoss,     ///< its death ends the game
    Health,       ///< a Pickup where nothing hurts
    Pickup,       ///< Quake's weapons, health ...
    ExternalMap,  ///< the brushes of another map source; the compiler turns it into another class
};

constexpr bool is_of_brushes(ClassRole role) {
    return role >= ClassRole::BrushGroup && role <= ClassRole::Train;
}
constexpr bool is_trigger(ClassRole role) {
    return role >= ClassRole::TriggerOnce && role <= ClassRole::OtherTrigger;
}

/// The targetname that "Visit" on the title activates: what is shut to who only wants to walk.
inline constexpr std::string_view kVisitName = "visit";

/// The box of an entity around its origin, in units, for the simulation and editors.
struct ClassBox {
    std::array<std::int16_t, 3> mins = {}, maxs = {};
};

/// The `over_floor` of a model that stays at its entity's origin. Other values are heights over the floor in units:
/// items drop to the floor at the game's start.
inline constexpr std::int32_t kStays = -1;

/// One of Quake's models for a class; the first with matching flags and world type is shown.
struct ClassModel {
    std::string_view file;         ///< ".bsp": brushes, not shown; instead a file of this name with ".mdl"
    std::int32_t spawn_flags = 0;  ///< required flags of the entity
    std::int32_t world_type = -1;  ///< 0 medieval, 1 metal, 2 base; -1: any
    std::uint32_t frame = 0, skin = 0;
};

/// Oblong's model of a class.
struct OwnModel {
    std::string_view file;  ///< empty: none; enlarged by the key `scale`
    std::int32_t over_floor = kStays;
};

struct EntityClass {
    std::string_view name;  ///< a final '*' matches all names that begin so
    ClassShape shape = ClassShape::Point;
    ClassRole role = ClassRole::None;
    std::string_view does;  ///< empty: one of Quake's, without effect here
    std::array<std::span<const EntityKey>, 5> keys = {};
    ClassBox box = {};
    std::span<const ClassModel> models = {};
    std::int32_t over_floor = kStays;  ///< of `models`
    OwnModel own_model = {};
    std::string_view sound = {};        ///< looping sound: name of its file
    std::string_view since = kRelease;  ///< the first release with it

    constexpr bool is_family() const { return name.ends_with('*'); }
};

/// All classes of Oblong and Quake, and their keys. This table is used for the compiler's warnings, for roles and
/// defaults in effects, sounds and simulation, for the page of classes and for the editor's file.
std::span<const EntityClass> entity_classes();

/// The row of a class, or of its family; null if it is unknown.
const EntityClass* find_entity_class(std::string_view class_name);

/// The role of an entity; None if its class is unknown.
template <class Entity>
ClassRole role_of(const Entity& entity) {
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    return its_class ? its_class->role : ClassRole::None;
}

/// Quake's model of an entity with these spawnflags, in a world of this type; null if its class has none (monsters and
/// everything else that moves by itself).
const ClassModel* find_class_model(const EntityClass& its_class, std::int64_t flags, std::int64_t world_type);

/// The row of a key of a class; null if it is unknown. "_light" is "light", "_wateralpha" is "wateralpha" ...; other
/// names of "_sun_mangle" are "_sun_angle" and "_sunlight_mangle", of "_anglescale" "_anglesense".
const EntityKey* find_entity_key(const EntityClass& its_class, std::string_view key);

/// What a value of a key should be, such as "a whole number"; empty if it is. Values that name other entities, files or
/// textures without holes are not checked. In key_values.cpp.
std::string expected_instead_of(const std::string& value, const EntityKey& key);

/// With up to three decimals: "0.05".
std::string decimal_text(World value);
/// "0.05 to 3600".
std::string range_text(const NumberRange& range);

/// " (since 0.2)"; empty for the first release.
std::string since_text(std::string_view since);

/// The keys of every class.
std::span<const EntityKey> keys_of_all();

/// The default of a key of a class, as text; empty if none.
std::string_view usual_text(std::string_view class_name, std::string_view key);

}  // namespace oblong
