#pragma once

#include <cstddef>
#include <cstdint>

#include "game/options/preferences.h"

namespace oblong {

/// Chooses what a slow machine draws, by the times of its first pictures: the first rung of a ladder of sizes and
/// presets that takes it less than kMost_us. Ends there, and when the player sets another one.
class ViewChoice {
  public:
    static constexpr std::uint64_t kMost_us = 95'000;  ///< ten pictures a second, with all that is not drawing

    bool is_on() const { return is_on_; }
    /// Sets the first rung's preferences.
    void begin(Preferences& preferences);
    /// Notes that a picture with these preferences was drawn in `drawing_us`; may change them.
    void note(std::uint64_t drawing_us, Preferences& preferences);

  private:
    bool is_on_ = false;
    std::size_t rung_ = 0;
    int pictures_ = 0;  ///< of this rung, the first of which also light surfaces
    std::uint64_t total_us_ = 0;
};

}  // namespace oblong
