#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/map/source/map_file.h"

namespace oblong::map {

/// A part of a map source that is compiled, but probably not as intended.
struct Warning {
    int line = 0;
    std::string what;
};

/// Collects warnings and counts repeated ones.
class Warnings {
  public:
    void add(int line, const std::string& what);
    /// Returns and removes the warnings, at most 200, sorted by line, each with the number of further ones of the same
    /// text.
    std::vector<Warning> take();

  private:
    std::vector<Warning> warnings_;
    std::map<std::string, int> known_;
};

/// Warns of oddities of a source's entities: classes and keys that are not in entity_classes(), invalid values, missing
/// required keys, and targets without an entity.
void find_warnings(const std::vector<MapEntity>& entities, Warnings& warnings);

}  // namespace oblong::map
