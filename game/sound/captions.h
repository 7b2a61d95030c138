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

/// A line of text for each sound that begins, for players who cannot hear it. Its clock is the number of ticks noted.
class Captions {
  public:
    static constexpr std::size_t kMostLines = 3;

    /// `own`: other texts for some sounds; `own_sounds`: texts for the level's own sounds; empty: the text of the sound
    /// that they replace.
    explicit Captions(CaptionTexts own = {}, std::vector<std::string> own_sounds = {})
        : own_(std::move(own)), own_sounds_(std::move(own_sounds)) {}

    /// Notes the sounds of a tick. One-shots count in their first tick.
    void note_tick(std::span<const AudibleSound> sounds);
    /// Those shown now, oldest first: "wind", "door, to the left".
    std::vector<std::string> lines() const;

  private:
    struct Line {
        std::string text;
        Sound sound;
        std::int32_t own;
        std::int64_t ends_tick;
    };
    bool is_due(const AudibleSound& sound);
    void show(const AudibleSound& sound);

    std::string text_of(const AudibleSound& sound) const;

    CaptionTexts own_;
    std::vector<std::string> own_sounds_;
    std::int64_t tick_ = 0;
    std::uint32_t last_serial_ = 0;
    std::array<std::int64_t, kSoundCount> heard_until_{};  // by sound; 0: never
    std::vector<Line> lines_;
};

/// "door, to the left"; "" for a sound without a caption.
std::string caption_of(const std::string& text, Direction direction);

}  // namespace oblong
