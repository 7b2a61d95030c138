#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/map/source/map_file.h"

namespace oblong::map {

/// Something in a map source that is compiled all the same, but hardly as it is meant.
struct Warning {
    int line = 0;
    std::string what;
};

/// Collects warnings: what is said again is counted.
class Warnings {
  public:
    void add(int line, const std::string& what);
    /// By their lines, with the number of further ones of the same text, at most 200; none are left.
    std::vector<Warning> take();

  private:
    std::vector<Warning> warnings_;
    std::map<std::string, int> known_;
};

/// What is odd about the entities of a source: classes and keys that entity_classes() does not know, values that are
/// none of theirs, entities without what their class takes, targets that nobody has.
void find_warnings(const std::vector<MapEntity>& entities, Warnings& warnings);

}  // namespace oblong::map
