#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/sound/module_player.h"

namespace oblong {
namespace {

constexpr std::int32_t kLoudness_256 = 128;  // of a channel: two on a side reach the full range of 16 bits

// 65,536 * 2^(n/12): the factors of a rate for n semitones.
constexpr std::array<std::int32_t, 16> kSemitones_16{65'536,  69'433,  73'562,  77'936,  82'570,  87'480,
                                                     92'682,  98'193,  104'032, 110'218, 116'772, 123'715,
                                                     131'072, 138'866, 147'123, 155'872};
// 65,536 * 2^(n/96), n from -8 to 7.
constexpr std::array<std::int32_t, 16> kFinetunes_16{61'858, 62'306, 62'757, 63'212, 63'670, 64'132, 64'596, 65'065,
                                                     65'536, 66'011, 66'489, 66'971, 67'456, 67'945, 68'438, 68'933};
// ProTracker's half sine.
constexpr std::array<std::int32_t, 32> kSine_255{0,   24,  49,  74,  97,  120, 141, 161, 180, 197, 212,
                                                 224, 235, 244, 250, 253, 255, 253, 250, 244, 235, 224,
                                                 212, 197, 180, 161, 141, 120, 97,  74,  49,  24};

/// A period at a rate that is so many times as high.
std::int32_t at_rate(std::int64_t period_8, std::int64_t factor_16) {
    return static_cast<std::int32_t>((period_8 * 65'536 + factor_16 / 2) / factor_16);
}

}  // namespace

std::int32_t ModuleWave::value_255() const {
    const std::int32_t half = at_64 % 32;
    const bool is_second = at_64 >= 32;
    switch (form & 3) {
        case 0:
            return is_second ? -item(kSine_255, half) : item(kSine_255, half);
        case 1:  // a ramp up, of periods
            return is_second ? half * 8 - 255 : half * 8;
        default:
            return is_second ? -255 : 255;
    }
}

void ModuleWave::set(std::uint8_t parameter) {
    if (parameter >> 4 != 0) speed = parameter >> 4;
    if ((parameter & 15) != 0) depth = parameter & 15;
}

void ModuleChannel::take(const ModuleSample& sample) {
    next = {&sample, 0, sample.played};
    volume_64 = sample.volume_64;
    finetune_8 = sample.finetune_8;
}

void ModuleChannel::swap() {
    if (next.sample == nullptr) return;
    const std::size_t start = next.sample->loop_start;
    loop = {next.sample, start, start + next.sample->loop_length};
    if (playing.sample != nullptr || loop.is_empty()) return;
    playing = {next.sample, 0, loop.end};
    at_32 = 0;
}

void ModuleChannel::strike() {
    heard_period_8 = period_8;
    swap();
    playing = next;
    at_32 = std::uint64_t{playing.begin} << 32;
}

std::int32_t ModuleChannel::tuned_8(std::int32_t period) const {
    return at_rate(std::int64_t{period} * 256, item(kFinetunes_16, finetune_8 + 8));
}

std::int32_t ModuleChannel::raised_8(std::int32_t semitones, bool is_protrackers) const {
    const auto raised = [&](std::int32_t by) { return at_rate(period_8, item(kSemitones_16, by)); };
    const std::int32_t end_8 = tuned_8(kLeastPeriod) / 32 * 31;  // less than a semitone beyond the last note
    std::int32_t beyond = 0;
    while (is_protrackers && beyond < semitones && raised(semitones - beyond) < end_8) ++beyond;
    if (beyond == 0) return raised(semitones);
    constexpr std::int32_t kPeriodOf0 = 65'536;
    if (beyond == 1) return kPeriodOf0 * 256;
    const std::int32_t next_finetune = (finetune_8 + 1) & 15;
    const std::int32_t factor_16 = item(kFinetunes_16, next_finetune < 8 ? next_finetune + 8 : next_finetune - 8);
    return at_rate(at_rate(std::int64_t{kMostPeriod} * 256, factor_16), item(kSemitones_16, beyond - 2));
}

std::int32_t ModuleChannel::stepped_8() const {
    constexpr std::int32_t kLowestPeriod = 2 * 1'712, kSemitones = 12;
    std::int32_t octave_8 = tuned_8(kLowestPeriod);
    while (octave_8 / 2 > period_8) octave_8 /= 2;
    for (std::int32_t i = 0; i < kSemitones; ++i)
        if (at_rate(octave_8, item(kSemitones_16, i)) <= period_8) return at_rate(octave_8, item(kSemitones_16, i));
    return octave_8 / 2;
}

bool ModuleChannel::has_value() {
    if (at_32 >> 32 < playing.end) return true;
    if (loop.is_empty()) {
        playing = {};
        return false;
    }
    const std::uint64_t beyond_32 = playing.is_empty() ? 0 : at_32 - (std::uint64_t{playing.end} << 32);
    at_32 = (std::uint64_t{loop.begin} << 32) + beyond_32 % (std::uint64_t{loop.end - loop.begin} << 32);
    playing = loop;
    return true;
}

std::int32_t ModuleChannel::level_8() const {
    const auto at = static_cast<std::size_t>(at_32 >> 32);
    const auto share_8 = static_cast<std::int32_t>(at_32 >> 24 & 255);
    const std::int32_t here = playing.sample->samples[at];
    const std::int32_t there = at + 1 < playing.end ? playing.sample->samples[at + 1]
                               : loop.is_empty()    ? 0
                                                    : loop.sample->samples[loop.begin];
    return here * 256 + (there - here) * share_8;
}

void ModuleChannel::add(std::span<std::int32_t> sums, std::int32_t volume_256) {
    if (heard_period_8 <= 0) return;
    const auto step_32 = static_cast<std::uint64_t>((kClock_hz << 40) / (std::int64_t{heard_period_8} * kRate_hz));
    const std::int32_t loudness_256 = volume_256 * heard_volume_64 * kLoudness_256 / (256 * kMostModuleVolume_64);
    const std::int32_t right_256 = loudness_256 * right_share_256 / 256, left_256 = loudness_256 - right_256;
    for (std::size_t at = 0; at < sums.size() && has_value(); at += 2) {
        const std::int32_t level = level_8();
        sums[at] += level * left_256 / 256;
        sums[at + 1] += level * right_256 / 256;
        at_32 += step_32;
    }
}

}  // namespace oblong
