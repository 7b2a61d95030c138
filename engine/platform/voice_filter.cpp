#include "engine/platform/voice_filter.h"

#include <algorithm>

namespace oblong {
namespace {

constexpr std::int32_t kOne_16 = 1 << 16;
constexpr std::int32_t kGainStep_16 = kOne_16 / 882;     // from silence to full in 20 ms
constexpr std::int32_t kMuffled_16 = 5'600;              // 1 - exp(-2 pi 625 Hz / 44,100 Hz)
constexpr std::int32_t kCutoffStep_16 = kOne_16 / 2205;  // between muffled and not in 50 ms

std::int32_t towards(std::int32_t from, std::int32_t to, std::int32_t step) {
    return from < to ? std::min(from + step, to) : std::max(from - step, to);
}

std::int32_t cutoff_of(bool is_muffled) {
    return is_muffled ? kMuffled_16 : kOne_16;
}

std::int32_t low_passed(std::int32_t& state_8, std::int32_t input_8, std::int32_t cutoff_16) {
    state_8 += static_cast<std::int32_t>(std::int64_t{input_8 - state_8} * cutoff_16 / kOne_16);
    return state_8;
}

}  // namespace

void VoiceFilter::begin(const VoiceLevels& levels, bool fades_in) {
    set(levels);
    cutoff_16_ = cutoff_of(levels.is_muffled);
    for (std::size_t i = 0; i < sides_.size(); ++i) sides_[i] = Side{fades_in ? 0 : wanted_256_[i] * 256};
}

void VoiceFilter::set(const VoiceLevels& levels) {
    wanted_256_[0] = std::clamp(levels.left_256, 0, 256);
    wanted_256_[1] = std::clamp(levels.right_256, 0, 256);
    is_muffled_ = levels.is_muffled;
}

std::int16_t VoiceFilter::filtered(Side& side, std::int16_t sample, std::int32_t cutoff_16) const {
    const std::int32_t once = low_passed(side.first_8, sample * 256, cutoff_16);
    const std::int32_t twice = low_passed(side.second_8, once, cutoff_16);
    return static_cast<std::int16_t>(std::int64_t{twice} * side.gain_16 / (std::int64_t{256} * kOne_16));
}

void VoiceFilter::apply(std::span<std::int16_t> samples) {
    const std::array<std::int32_t, kSides> wanted_16{wanted_256_[0] * 256, wanted_256_[1] * 256};
    const std::int32_t wanted_cutoff = cutoff_of(is_muffled_);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t side = i % kSides;
        if (side == 0) cutoff_16_ = towards(cutoff_16_, wanted_cutoff, kCutoffStep_16);
        sides_[side].gain_16 = towards(sides_[side].gain_16, wanted_16[side], kGainStep_16);
        samples[i] = filtered(sides_[side], samples[i], cutoff_16_);
    }
}

}  // namespace oblong
