#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace oblong {

/// What the player is told: one message at a time, the newest, for as long as it takes to read. All are kept in a list.
class Messages {
  public:
    /// Takes the place of the message that is up.
    void show(std::string text);

    /// The lines to show from `now_us` on, at most `most_lines` of so many columns. The time of those that were
    /// returned last passes until then. A message with more lines than that is shown in parts, one after the other.
    std::vector<std::string> lines(std::uint64_t now_us, std::int32_t columns, std::size_t most_lines);

    /// Whether nothing is up.
    bool is_empty() const { return parts_.empty(); }

    /// What was told, the newest first, each text once; the oldest are forgotten.
    const std::vector<std::string>& told() const { return told_; }

    /// How long a text stays: 2.5 s at least, and 60 ms a letter.
    static std::uint64_t reading_time_us(const std::string& text);

  private:
    struct Part {
        std::string text;
        std::uint64_t left_us;
    };
    void pass_time(std::uint64_t now_us);
    void split_first(std::int32_t columns, std::size_t most_lines);

    std::vector<Part> parts_;  // of the newest message: the first is up or will be, the others follow it
    std::vector<std::string> told_;
    bool is_up_ = false;
    std::uint64_t last_us_ = 0;
};

}  // namespace oblong
