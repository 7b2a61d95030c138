#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace oblong {

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
};

enum class ClassShape : std::uint8_t {
    Worldspawn,
    Point,   ///< has an origin
    Brush,   ///< has brushes
    Either,  ///< needs no place
};

struct EntityClass {
    std::string_view name;  ///< of a whole family where it ends in '_'
    ClassShape shape = ClassShape::Point;
    std::string_view does;  ///< empty: Quake's, which has no effect here
    std::array<std::span<const EntityKey>, 4> keys = {};
};

/// All classes that Oblong or Quake's game knows, and their keys: what the compiler warns of, what the effects and the
/// simulation take where a key is absent, and what the pages for mappers list, are this table.
std::span<const EntityClass> entity_classes();

/// The row of a class, or else of its family; null if it is unknown.
const EntityClass* find_entity_class(std::string_view class_name);

/// The row of a key of a class; null where nothing reads it. "_light" is "light", "_wateralpha" is "wateralpha" ...
const EntityKey* find_entity_key(const EntityClass& its_class, std::string_view key);

/// The rows that every class has.
std::span<const EntityKey> keys_of_all();

/// What an absent key of a class counts as: a text, empty if nothing.
std::string_view usual_text(std::string_view class_name, std::string_view key);

}  // namespace oblong
