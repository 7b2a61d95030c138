#pragma once

#include <string>
#include <string_view>

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

}  // namespace oblong::map
