#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace oblong {

/// Follows the source of a level while it is played, where a system can compile levels.
class LevelWatch {
  public:
    virtual ~LevelWatch() = default;

    /// The compiled level.
    virtual const std::string& level_file() const = 0;

    /// The result of a compilation.
    struct Result {
        bool has_level = false;  ///< level_file() is new
        std::string fault;       ///< the compiler's message, if it failed
    };

    /// Starts a due compilation, or returns the result of one that has ended, without delay. Reads files at most five
    /// times a second. Throws FileError where something fails that may not the next time: it is tried again.
    virtual std::optional<Result> poll(std::uint64_t now_us) = 0;
    /// The level's fault, every few seconds until it is fixed; empty: none, or not due.
    virtual std::string due_reminder(std::uint64_t now_us) = 0;
    /// Sets a fault that the compiler does not know of.
    virtual void remind_of(std::string fault) = 0;
};

}  // namespace oblong
