#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/sound/module_player.h"

namespace oblong::test {

inline constexpr std::int32_t kTickFrames = ModulePlayer::kRate_hz / 50;  // at 125 beats a minute
inline constexpr std::int32_t kRowFrames = 6 * kTickFrames;

/// A module of four channels as its file has it.
class ModuleFile {
  public:
    explicit ModuleFile(std::vector<std::uint8_t> orders = {0}, std::size_t patterns = 1, std::size_t channels = 4)
        : channels_(channels), bytes_(1084 + patterns * 64 * 4 * channels) {
        bytes_[950] = static_cast<std::uint8_t>(orders.size());
        std::copy(orders.begin(), orders.end(), bytes_.begin() + 952);
        bytes_[952 + 127] = static_cast<std::uint8_t>(patterns - 1);  // also patterns that are not played are there
        const std::string signature = channels == 4 ? "M.K." : std::to_string(channels) + "CHN";
        std::copy(signature.begin(), signature.end(), bytes_.begin() + 1080);
    }

    /// Samples in the order of their numbers; lengths are even.
    ModuleFile& sample(const std::vector<int>& values, int finetune = 0, std::size_t loop_start = 0,
                       std::size_t loop_length = 2) {
        const std::size_t at = 20 + 30 * samples_++;
        const auto put_words = [&](std::size_t place, std::size_t count) {
            bytes_[at + place] = static_cast<std::uint8_t>(count / 2 / 256);
            bytes_[at + place + 1] = static_cast<std::uint8_t>(count / 2 % 256);
        };
        put_words(22, values.size());
        bytes_[at + 24] = static_cast<std::uint8_t>(finetune & 15);
        bytes_[at + 25] = 64;
        put_words(26, loop_start);
        put_words(28, loop_length);
        for (const int value : values) bytes_.push_back(static_cast<std::uint8_t>(value));
        return *this;
    }
    ModuleFile& note(std::size_t pattern, std::size_t row, std::size_t channel, int sample, int period,
                     int effect = 0) {
        const std::size_t at = 1084 + ((pattern * 64 + row) * channels_ + channel) * 4;
        bytes_[at] = static_cast<std::uint8_t>((sample & 0xf0) | period >> 8);
        bytes_[at + 1] = static_cast<std::uint8_t>(period & 255);
        bytes_[at + 2] = static_cast<std::uint8_t>((sample & 15) << 4 | effect >> 8);
        bytes_[at + 3] = static_cast<std::uint8_t>(effect & 255);
        return *this;
    }
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  private:
    std::size_t channels_, samples_ = 0;
    std::vector<std::uint8_t> bytes_;
};

inline std::vector<int> square(int length) {
    std::vector<int> values;
    for (int i = 0; i < length; ++i) values.push_back(i < length / 2 ? 100 : -100);
    return values;
}

/// The left side of what is played next.
inline std::vector<std::int32_t> heard(ModulePlayer& player, std::int32_t frames, std::size_t side = 0) {
    std::vector<std::int32_t> sums(2 * static_cast<std::size_t>(frames)), left;
    player.add(sums, 256);
    for (std::size_t i = side; i < sums.size(); i += 2) left.push_back(sums[i]);
    return left;
}

inline int rises(const std::vector<std::int32_t>& wave) {
    int count = 0;
    for (std::size_t i = 1; i < wave.size(); ++i) count += wave[i - 1] < 0 && wave[i] >= 0;
    return count;
}

}  // namespace oblong::test
