#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace oblong {

inline constexpr std::string_view kRelease = "0.1";  ///< the first one

/// What the value of a key is.
enum class KeyKind : std::uint8_t {
    Text,
    Numbers,  ///< from `least` to `most` of them
    Whole,    ///< a whole number
    Choice,   ///< one of `values`
    Flags,    ///< the sum of some of `values`
    Name,     ///< that others target
    Target,   ///< the name of others
    Place,    ///< the name of another that has an origin
    Texture,  ///< with holes: its name begins with '{'
};

/// A value that a key may have, or a bit of its flags.
struct KeyValue {
    std::string_view value, does;
};

struct EntityKey {
    std::string_view name;  ///< digits may follow one that ends in '#'
    KeyKind kind = KeyKind::Text;
    std::string_view usual;  ///< what an absent one counts as; empty: nothing
    std::string_view does;   ///< empty: Quake's, which has no effect here
    std::span<const KeyValue> values = {};
    std::uint8_t least = 1, most = 1;  ///< how many numbers
    bool is_required = false;
    std::string_view since = kRelease;  ///< the release that brought it
};

enum class ClassShape : std::uint8_t {
    WorldModel,  ///< the brushes of the level itself
    Point,       ///< has an origin
    Brush,       ///< has brushes
    Either,      ///< needs no place
};

/// What an entity of a class is to the programs that read levels.
enum class ClassRole : std::uint8_t {
    None,  ///< a place for others, a sound, or without effect
    Worldspawn,
    Start,
    DeathmatchStart,
    TeleportExit,
    Checkpoint,
    Lamp,
    // From here to Train: made of brushes, and where it does not move a wall.
    BrushGroup,
    Detail,
    PassableDetail,
    PlainWall,
    Passable,  ///< is seen, and stops nobody
    OpenGate,
    Door,
    TurningDoor,
    SecretDoor,
    Button,
    Lift,
    Train,
    // From here to OtherTrigger: a space that is not seen.
    TriggerOnce,
    TriggerMultiple,
    TriggerSecret,
    TriggerOnlyRegistered,
    TriggerRelay,
    TriggerCounter,
    TriggerTeleport,
    TriggerPush,
    TriggerExit,
    OtherTrigger,
    Lightning,
    Lens,
    SilverKey,
    GoldKey,
    Rain,
    Dust,
    Sparks,
    Bubbles,
    Billboard,
    FlyingLamp,
    TriangleModel,
    Rotating,  ///< brushes that are shown as a model of triangles, and stop nobody
    Monster,
    Boss,         ///< whose lightning is Lightning
    LastBoss,     ///< whose end is the game's
    Pickup,       ///< of Quake's: weapons, health ...
    ExternalMap,  ///< another source's brushes; the compiler makes another class of it
};

constexpr bool is_of_brushes(ClassRole role) {
    return role >= ClassRole::BrushGroup && role <= ClassRole::Train;
}
constexpr bool is_trigger(ClassRole role) {
    return role >= ClassRole::TriggerOnce && role <= ClassRole::OtherTrigger;
}

/// The box around an entity's origin that the simulation and editors take it for, in units.
struct ClassBox {
    std::array<std::int16_t, 3> mins = {}, maxs = {};
};

/// How far over the floor a model is shown, in units: items drop to it as the game starts. Or where its entity is.
inline constexpr std::int32_t kStays = -1;

/// A model of Quake's that entities of a class show: the first whose flags and world fit.
struct ClassModel {
    std::string_view file;         ///< ".bsp": brushes, which are not shown; a file of that name ending in ".mdl" is
    std::int32_t spawn_flags = 0;  ///< the entity has these
    std::int32_t world_type = -1;  ///< the world's: 0 medieval, 1 metal, 2 base; -1: any
    std::uint32_t frame = 0, skin = 0;
};

/// Oblong's own model of a class.
struct OwnModel {
    std::string_view file;   ///< empty: it has none
    std::int32_t scale = 1;  ///< units a unit of the OBJ
    std::int32_t over_floor = kStays;
};

struct EntityClass {
    std::string_view name;  ///< ending in '*': all others that begin so
    ClassShape shape = ClassShape::Point;
    ClassRole role = ClassRole::None;
    std::string_view does;  ///< empty: Quake's, which has no effect here
    std::array<std::span<const EntityKey>, 5> keys = {};
    ClassBox box = {};
    std::span<const ClassModel> models = {};
    std::int32_t over_floor = kStays;  ///< of those
    OwnModel own_model = {};
    std::string_view sound = {};        ///< that goes on, by the name of its file
    std::string_view since = kRelease;  ///< the release that brought it

    constexpr bool is_family() const { return name.ends_with('*'); }
};

/// All classes that Oblong or Quake's game knows, and their keys. The compiler's warnings, what the effects, the sounds
/// and the simulation take an entity for, what they take where a key is absent, the page of classes and the editor's
/// file of them are all this table.
std::span<const EntityClass> entity_classes();

/// The row of a class, or else of its family; null if it is unknown.
const EntityClass* find_entity_class(std::string_view class_name);

/// What an entity is by its class; None if that is unknown.
template <class Entity>
ClassRole role_of(const Entity& entity) {
    const EntityClass* const its_class = find_entity_class(entity.value("classname"));
    return its_class ? its_class->role : ClassRole::None;
}

/// Quake's model of an entity with these spawnflags, in a world of this type; null where its class has none (monsters
/// and all that moves by itself).
const ClassModel* find_class_model(const EntityClass& its_class, std::int64_t flags, std::int64_t world_type);

/// The row of a key of a class; null where nothing reads it. "_light" is "light", "_wateralpha" is "wateralpha" ...
const EntityKey* find_entity_key(const EntityClass& its_class, std::string_view key);

/// " (since 0.2)"; empty for what the first release has.
std::string since_text(std::string_view since);

/// The rows that every class has.
std::span<const EntityKey> keys_of_all();

/// What an absent key of a class counts as: a text, empty if nothing.
std::string_view usual_text(std::string_view class_name, std::string_view key);

}  // namespace oblong
