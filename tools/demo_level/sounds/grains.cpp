#include "tools/demo_level/sounds/grains.h"

namespace oblong::synth {

Samples strike(std::int32_t ms, std::int32_t half_life_ms, std::int32_t brightness_hz, std::uint32_t seed) {
    return shaped(low_passed(noise(ms, seed), brightness_hz), 1, half_life_ms);
}

Samples struck(const Samples& strike, std::initializer_list<Mode> modes, std::int32_t pitch_percent) {
    Samples sum(strike.size());
    for (const Mode& mode : modes)
        add(sum, ringing(strike, mode.hz * pitch_percent / 100, mode.half_life_ms), 0, mode.percent);
    return sum;
}

Samples bubble(std::int32_t ms, std::int32_t hz) {
    return shaped(tone(ms, hz * 100, hz * 190), 3, ms / 5);
}

}  // namespace oblong::synth
