#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/map/source/map_file.h"

namespace oblong::map {

/// Finds the name nearest to a misspelt one, with at most two errors of typing. The names must outlive it.
class NearestName {
  public:
    explicit NearestName(std::string_view wanted) : wanted_(wanted) {}

    void add(std::string_view name);

    /// ", perhaps 'NAME' is meant", or nothing.
    std::string text() const;

  private:
    std::string_view wanted_, name_;
    std::size_t least_ = 3;
};

/// A part of a map source that is compiled, but probably not as intended.
struct Warning {
    int line = 0;
    std::string what;
    bool is_unread = false;  ///< of a key or class that nothing reads
};

/// Collects warnings and counts repeated ones.
class Warnings {
  public:
    void add(int line, const std::string& what, bool is_unread = false);
    /// Returns and removes the warnings, at most 200, sorted by line, those of what nothing reads last, each with the
    /// number of further ones of the same text.
    std::vector<Warning> take();

  private:
    std::vector<Warning> warnings_;
    std::map<std::string, int> known_;
};

/// Warns of oddities of a source's entities: classes and keys that are not in entity_classes(), invalid values, missing
/// required keys, and targets without an entity.
void find_warnings(const std::vector<MapEntity>& entities, Warnings& warnings);

}  // namespace oblong::map
