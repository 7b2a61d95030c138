#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace oblong {

/// The subjects of log lines. A channel is chosen by subject, not by importance, and is off by default.
enum class LogChannel : std::uint8_t { Level, Memory, Matrices, Clip, Spans, Cache };
inline constexpr std::size_t kLogChannelCount = 6;
inline constexpr std::array<std::string_view, kLogChannelCount> kLogChannelNames{"level", "memory", "matrices",
                                                                                 "clip",  "spans",  "cache"};

/// A set of channels.
class LogChannels {
  public:
    static constexpr LogChannels all() { return LogChannels((1u << kLogChannelCount) - 1); }
    static constexpr LogChannels only(LogChannel channel) { return LogChannels(1u << static_cast<unsigned>(channel)); }
    constexpr LogChannels() = default;

    constexpr bool has(LogChannel channel) const { return (bits_ >> static_cast<unsigned>(channel) & 1) != 0; }
    constexpr bool is_empty() const { return bits_ == 0; }
    constexpr LogChannels operator|(LogChannels other) const { return LogChannels(bits_ | other.bits_); }
    constexpr bool operator==(const LogChannels&) const = default;

  private:
    constexpr explicit LogChannels(unsigned bits) : bits_(bits) {}
    unsigned bits_ = 0;
};

/// "matrices,clip": names with commas between them. Throws UsageError that names the known ones.
LogChannels parse_log_channels(const std::string& text);
/// The names of a set, with commas between them; "off" for none.
std::string names_of(LogChannels channels);
/// The next set for the log key: off, each channel alone, all of them.
LogChannels next_channels(LogChannels channels);

}  // namespace oblong
