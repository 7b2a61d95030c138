#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// The range of a key's value.
struct NumberRange {
    World least, most;
};

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
    World number(const std::string& key, const NumberRange& range) const;
    std::int32_t whole_number(const std::string& key, std::int32_t least, std::int32_t most) const;
    /// "period": seconds, from 0.05 to 3,600, in milliseconds.
    std::int32_t period_ms() const;
    /// Three numbers from `least` to `most`; the default, or none, if the key is missing (no warning) or invalid.
    std::optional<Vec3<World>> vector(const std::string& key, World least, World most) const;
    /// One colour, or the first and last of a ramp.
    ColourRamp colours(const std::string& key) const;
    /// The entity's position; none, with a warning, if it is missing or a coordinate is beyond 65,536.
    std::optional<Vec3<World>> origin() const;

    void warn(const std::string& what) const;

  private:
    std::string_view usual(const std::string& key) const;
    void warn_of(const std::string& key, const std::string& expected) const;

    const Entity& entity_;
    std::size_t index_;
    std::vector<std::string>& warnings_;
};

}  // namespace oblong
