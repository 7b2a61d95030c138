#include "game/sound/sound_scene.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "game/simulation/tick_input.h"

namespace oblong {

SoundScene::SoundScene(const GameLevel& level, const LevelSounds* own)
    : level_(level), own_(own), ambience_(*level.bsp), starts_(level, own) {}

std::int32_t SoundScene::length_ticks(const SoundSource& source) const {
    if (source.own == LevelSounds::kNone) return row_of(source.sound).length_ticks;
    const SoundSamples& samples = item(own_->sounds, source.own).samples;
    const std::int64_t ticks = std::ssize(samples.samples) * kTicksPerSecond / samples.rate_hz + 1;
    return static_cast<std::int32_t>(std::min<std::int64_t>(ticks, std::numeric_limits<std::int32_t>::max()));
}

void SoundScene::note_tick(const GameState& before, const GameState& after, const TickReport& report) {
    const Listener listener = listener_of(after.player);
    std::vector<SoundSource> sources;
    starts_.note_tick(before, after, report, sources);
    for (const SoundSource& source : sources)
        if (source.serial != 0) one_shots_.push_back({source, length_ticks(source)});
    std::erase_if(sources, [](const SoundSource& source) { return source.serial != 0; });
    for (const OneShot& one_shot : one_shots_) sources.push_back(one_shot.source);
    ambience_.collect(listener.ear, sources);
    if (listener.is_under_water) {
        SoundSource source;
        source.sound = Sound::UnderWater;
        sources.push_back(source);
    }
    heard_from_.start_tick();
    audible_ = audible_sounds(level_, after, listener, sources, heard_from_);
    keep_heard();
}

// A one-shot that is not in range at its start, or leaves it, is not resumed.
void SoundScene::keep_heard() {
    std::erase_if(one_shots_, [&](OneShot& one_shot) {
        return --one_shot.ticks_left <= 0 ||
               std::none_of(audible_.sounds.begin(), audible_.sounds.end(),
                            [&](const AudibleSound& sound) { return sound.serial == one_shot.source.serial; });
    });
}

}  // namespace oblong
