#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "game/sound/audible.h"

namespace oblong {

using CaptionTexts = std::map<Sound, std::string>;

/// A line of text for each sound that begins to be heard, for who can't hear it. Counts its own ticks: those noted.
class Captions {
  public:
    static constexpr std::size_t kMostLines = 3;

    /// `own`: other words for some sounds.
    explicit Captions(CaptionTexts own = {}) : own_(std::move(own)) {}

    /// Notes what is heard in a tick. One-shots are noted in the tick in which they begin.
    void note_tick(std::span<const AudibleSound> sounds);
    /// Those shown now, oldest first: "wind", "door, to the left".
    std::vector<std::string> lines() const;

  private:
    struct Line {
        std::string text;
        Sound sound;
        std::int64_t ends_tick;
    };
    bool is_due(const AudibleSound& sound);
    void show(const AudibleSound& sound);

    CaptionTexts own_;
    std::int64_t tick_ = 0;
    std::uint32_t last_serial_ = 0;
    std::array<std::int64_t, kSoundCount> heard_until_{};  // by sound; 0: never
    std::vector<Line> lines_;
};

/// "door, to the left"; "" for a sound without a caption.
std::string caption_of(const std::string& text, Direction direction);

}  // namespace oblong
