#include "game/sound/sound_scene.h"

#include <algorithm>

namespace oblong {

SoundScene::SoundScene(const GameLevel& level) : level_(level), ambience_(*level.bsp), starts_(level) {}

void SoundScene::note_tick(const GameState& before, const GameState& after) {
    const Listener listener = listener_of(after.player);
    std::vector<SoundSource> sources;
    starts_.note_tick(before, after, sources);
    for (const SoundSource& source : sources)
        if (source.serial != 0) one_shots_.push_back({source, row_of(source.sound).length_ticks});
    std::erase_if(sources, [](const SoundSource& source) { return source.serial != 0; });
    for (const OneShot& one_shot : one_shots_) sources.push_back(one_shot.source);
    ambience_.collect(listener.ear, sources);
    if (listener.is_under_water) {
        SoundSource source;
        source.sound = Sound::UnderWater;
        sources.push_back(source);
    }
    audible_ = audible_sounds(level_, after, listener, sources);
    keep_heard();
}

// A sound that was out of range when it began, or left it, does not come back in the middle.
void SoundScene::keep_heard() {
    std::erase_if(one_shots_, [&](OneShot& one_shot) {
        return --one_shot.ticks_left <= 0 ||
               std::none_of(audible_.sounds.begin(), audible_.sounds.end(),
                            [&](const AudibleSound& sound) { return sound.serial == one_shot.source.serial; });
    });
}

}  // namespace oblong
