#include "game/sound/captions.h"

#include <algorithm>

#include "engine/base/table.h"
#include "game/simulation/tick.h"

namespace oblong {
namespace {

constexpr std::int64_t kShown_ticks = 3 * kTicksPerSecond;
constexpr std::int64_t kSilence_ticks = 15 * kTicksPerSecond;  // after which a continuing sound is captioned again
constexpr std::int32_t kFaintestNamed_256 = 24;                // the sum of both sides below which loops get no caption

}  // namespace

std::string caption_of(const std::string& text, Direction direction) {
    constexpr std::array<const char*, 5> kDirections{"", ", ahead", ", to the left", ", to the right", ", behind you"};
    return text.empty() ? text : text + item(kDirections, direction);
}

// Loops and frequent sounds are captioned only after a silence; others in their first tick.
bool Captions::is_due(const AudibleSound& sound) {
    const SoundRow& row = row_of(sound.sound);
    const bool is_new = sound.serial > last_serial_;
    if (!row.is_loop() && !is_new) return false;
    if (row.caption_rule == CaptionRule::Always) return true;
    if (row.is_loop() && sound.levels.left_256 + sound.levels.right_256 < kFaintestNamed_256) return false;
    std::int64_t& until = item(heard_until_, sound.sound);
    const bool was_silent = until == 0 || tick_ > until + kSilence_ticks;
    until = tick_;
    return was_silent;
}

std::string Captions::text_of(const AudibleSound& sound) const {
    if (sound.own != LevelSounds::kNone && !item(own_sounds_, sound.own).empty()) return item(own_sounds_, sound.own);
    const auto own = own_.find(sound.sound);
    return own == own_.end() ? row_of(sound.sound).caption : own->second;
}

void Captions::show(const AudibleSound& sound) {
    const std::string text = caption_of(text_of(sound), sound.direction);
    if (text.empty()) return;
    std::erase_if(lines_, [&](const Line& line) { return line.sound == sound.sound && line.own == sound.own; });
    lines_.push_back({text, sound.sound, sound.own, tick_ + kShown_ticks});
    if (lines_.size() > kMostLines) lines_.erase(lines_.begin());
}

void Captions::note_tick(std::span<const AudibleSound> sounds) {
    ++tick_;
    std::erase_if(lines_, [&](const Line& line) { return line.ends_tick <= tick_; });
    std::uint32_t serial = last_serial_;
    for (const AudibleSound& sound : sounds) {
        if (is_due(sound)) show(sound);
        serial = std::max(serial, sound.serial);
    }
    last_serial_ = serial;
}

std::vector<std::string> Captions::lines() const {
    std::vector<std::string> texts;
    for (const Line& line : lines_) texts.push_back(line.text);
    return texts;
}

}  // namespace oblong
