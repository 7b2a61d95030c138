#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/entity_classes.h"
#include "engine/level/level.h"

namespace oblong {

/// A range of palette indices.
struct ColourRamp {
    std::uint8_t first = 0, last = 0;
};

/// The keys of an entity as checked numbers. Missing and invalid values become the defaults of entity_classes();
/// invalid ones add a warning that names entity and key.
class EntityValues {
  public:
    /// `index` is the entity's index in the level. The arguments must outlive this.
    EntityValues(const Entity& entity, std::size_t index, std::vector<std::string>& warnings)
        : entity_(entity), index_(index), warnings_(warnings) {}

    std::string text(const std::string& key) const { return entity_.value(key); }
    /// By the range of the class's key, or any.
    World number(const std::string& key) const { return number(key, range_of(key)); }
    std::int32_t whole_number(const std::string& key) const { return floor_of(number(key)); }
    World number(const std::string& key, const NumberRange& range) const;
    std::int32_t whole_number(const std::string& key, std::int32_t least, std::int32_t most) const;
    /// "period": seconds, in milliseconds.
    std::int32_t period_ms() const;
    /// Three numbers; the default, or none, if the key is missing (no warning) or invalid.
    std::optional<Vec3<World>> vector(const std::string& key) const { return vector(key, range_of(key)); }
    std::optional<Vec3<World>> vector(const std::string& key, const NumberRange& range) const;
    /// One colour, or the first and last of a ramp.
    ColourRamp colours(const std::string& key) const;
    /// The entity's position; none, with a warning, if it is missing or a coordinate is beyond 65,536.
    std::optional<Vec3<World>> origin() const;

    void warn(const std::string& what) const;

  private:
    NumberRange range_of(const std::string& key) const;
    std::string_view usual(const std::string& key) const;
    void warn_of(const std::string& key, const std::string& expected) const;

    const Entity& entity_;
    std::size_t index_;
    std::vector<std::string>& warnings_;
};

}  // namespace oblong
