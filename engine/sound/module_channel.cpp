#include <array>

#include "engine/base/table.h"
#include "engine/sound/module_player.h"

namespace oblong {
namespace {

constexpr std::int32_t kLoudness_256 = 128;  // of a channel: two on a side reach the full range of 16 bits

// 65,536 * 2^(n/12): the factors of a rate for n semitones.
constexpr std::array<std::int64_t, 16> kSemitones_16{65'536,  69'433,  73'562,  77'936,  82'570,  87'480,
                                                     92'682,  98'193,  104'032, 110'218, 116'772, 123'715,
                                                     131'072, 138'866, 147'123, 155'872};
// 65,536 * 2^(n/96), n from -8 to 7.
constexpr std::array<std::int64_t, 16> kFinetunes_16{61'858, 62'306, 62'757, 63'212, 63'670, 64'132, 64'596, 65'065,
                                                     65'536, 66'011, 66'489, 66'971, 67'456, 67'945, 68'438, 68'933};
// ProTracker's half sine.
constexpr std::array<std::int32_t, 32> kSine_255{0,   24,  49,  74,  97,  120, 141, 161, 180, 197, 212,
                                                 224, 235, 244, 250, 253, 255, 253, 250, 244, 235, 224,
                                                 212, 197, 180, 161, 141, 120, 97,  74,  49,  24};

}  // namespace

std::int32_t ModuleWave::value_255() const {
    const std::int32_t half = at_64 % 32;
    const bool is_second = at_64 >= 32;
    switch (form & 3) {
        case 0:
            return is_second ? -item(kSine_255, half) : item(kSine_255, half);
        case 1:  // a ramp down
            return is_second ? 255 - half * 8 - 256 : 255 - half * 8;
        default:
            return is_second ? -255 : 255;
    }
}

void ModuleWave::set(std::uint8_t parameter) {
    if (parameter >> 4 != 0) speed = parameter >> 4;
    if ((parameter & 15) != 0) depth = parameter & 15;
}

// The sample after the last one of a loop is its first one.
std::int32_t ModuleChannel::level_8() const {
    const auto at = static_cast<std::size_t>(at_32 >> 32);
    const auto share_8 = static_cast<std::int32_t>(at_32 >> 24 & 255);
    std::size_t next = at + 1;
    if (sample->loop_length > 0 && next == sample->loop_start + sample->loop_length) next = sample->loop_start;
    const std::int32_t here = sample->samples[at], there = next < sample->samples.size() ? sample->samples[next] : 0;
    return here * 256 + (there - here) * share_8;
}

void ModuleChannel::advance(std::uint64_t step_32) {
    at_32 += step_32;
    const std::uint64_t loop_end = sample->loop_start + sample->loop_length;
    if (sample->loop_length > 0) {
        if (at_32 >> 32 >= loop_end)
            at_32 -= ((at_32 >> 32) - sample->loop_start) / sample->loop_length * sample->loop_length << 32;
    } else if (at_32 >> 32 >= sample->samples.size()) {
        is_playing = false;
    }
}

void ModuleChannel::strike(std::int32_t at_period) {
    period = heard_period = at_period;
    at_32 = 0;
    sample = next_sample;
    is_playing = sample != nullptr && !sample->samples.empty();
    if (vibrato.form < 4) vibrato.at_64 = 0;
    if (tremolo.form < 4) tremolo.at_64 = 0;
}

void ModuleChannel::add(std::span<std::int32_t> sums, std::int32_t volume_256) {
    if (!is_playing || heard_period <= 0) return;
    const std::int64_t tuned_16 = item(kFinetunes_16, finetune_8 + 8);
    const std::int64_t raised_16 = tuned_16 * item(kSemitones_16, semitones) >> 16;
    const auto step_32 = static_cast<std::uint64_t>((kClock_hz * raised_16 << 16) / (heard_period * kRate_hz));
    const std::int32_t loudness_256 = volume_256 * heard_volume_64 * kLoudness_256 / (256 * kMostModuleVolume_64);
    const std::int32_t right_256 = loudness_256 * right_share_256 / 256, left_256 = loudness_256 - right_256;
    for (std::size_t at = 0; at < sums.size() && is_playing; at += 2) {
        const std::int32_t level = level_8();
        sums[at] += level * left_256 / 256;
        sums[at + 1] += level * right_256 / 256;
        advance(step_32);
    }
}

}  // namespace oblong
