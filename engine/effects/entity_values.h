#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// The least and the greatest number that a key may have.
struct NumberRange {
    World least, most;
};

/// Colours of the palette, from one to another.
struct ColourRamp {
    std::uint8_t first = 0, last = 0;
};

/// The keys of an entity as checked numbers. Absent ones are what entity_classes() says; so are bad ones, which add a
/// warning that names entity and key.
class EntityValues {
  public:
    /// `index` is the entity's in the level's list. The arguments must outlive it.
    EntityValues(const Entity& entity, std::size_t index, std::vector<std::string>& warnings)
        : entity_(entity), index_(index), warnings_(warnings) {}

    std::string text(const std::string& key) const { return entity_.value(key); }
    World number(const std::string& key, const NumberRange& range) const;
    std::int32_t whole_number(const std::string& key, std::int32_t least, std::int32_t most) const;
    /// "period": seconds, from 0.05 to 3,600, in milliseconds.
    std::int32_t period_ms() const;
    /// Three numbers from `least` to `most`; the usual ones, or none, if the key is missing (no warning) or bad.
    std::optional<Vec3<World>> vector(const std::string& key, World least, World most) const;
    /// One colour, or the first and the last one of a ramp.
    ColourRamp colours(const std::string& key) const;
    /// Where the entity is; none, with a warning, if that is missing or farther than 65,536 from the world's origin.
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
