#pragma once

#include <cstddef>
#include <string>

namespace oblong {

/// A progress line on standard error; none if `is_shown` is false.
class Progress {
  public:
    explicit Progress(bool is_shown) : is_shown_(is_shown) {}
    ~Progress();
    Progress(const Progress&) = delete;

    /// Begins a part of the work with `steps` steps, from `from` to `to` per cent of the whole.
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
