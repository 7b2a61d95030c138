#pragma once

#include <cstddef>
#include <string>

namespace oblong {

/// A line on standard error that says how far a program is; none where `is_shown` is false.
class Progress {
  public:
    explicit Progress(bool is_shown) : is_shown_(is_shown) {}
    ~Progress();
    Progress(const Progress&) = delete;

    /// A part of the work, of so many steps, that begins at `from` per cent of the whole and ends at `to`.
    void begin(const std::string& what, std::size_t steps, int from, int to);
    void step();

  private:
    void show();

    bool is_shown_;
    std::string what_;
    std::size_t steps_ = 1, done_ = 0;
    int from_ = 0, to_ = 0, shown_ = -1;
};

}  // namespace oblong
