#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace oblong {

enum class MessageKind : std::uint8_t {
    Answer,  ///< to a key: the next one takes its place
    Level    ///< what the level says: none is lost
};

/// What the player is told, each for as long as it takes to read. What has no room waits.
class Messages {
  public:
    /// Appends a message. One that says the same as another that is up or waits prolongs it.
    void show(std::string text, MessageKind kind);

    /// The lines to show from `now_us` on, at most `most_lines` of so many columns: the oldest messages that fit. The
    /// time of those that were returned last passes until then. A message with more lines than that is shown in parts.
    std::vector<std::string> lines(std::uint64_t now_us, std::int32_t columns, std::size_t most_lines);

    bool is_empty() const { return messages_.empty(); }

    /// How long a text stays: 2.5 s at least, and 60 ms a letter.
    static std::uint64_t reading_time_us(const std::string& text);

  private:
    struct Message {
        std::string text;
        MessageKind kind;
        std::uint64_t left_us;
    };
    void pass_time(std::uint64_t now_us);
    void split_first(std::int32_t columns, std::size_t most_lines);

    std::vector<Message> messages_;  // oldest first
    std::size_t up_ = 0;             // how many of them are shown
    std::uint64_t last_us_ = 0;
};

}  // namespace oblong
