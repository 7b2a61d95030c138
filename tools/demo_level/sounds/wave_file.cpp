#include <string_view>

#include "tools/demo_level/sounds/sounds.h"
#include "tools/demo_level/sounds/synth.h"

namespace oblong::sound_source {
namespace {

void put(std::vector<std::uint8_t>& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

void put(std::vector<std::uint8_t>& bytes, std::uint32_t number, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i) & 0xff));
}

}  // namespace

std::vector<std::uint8_t> encode_wave(const std::vector<std::int16_t>& samples) {
    constexpr std::uint32_t kPcm = 1, kChannels = 1, kBits = 16, kFormatSize = 16, kHeaderSize = 36;
    const auto size = static_cast<std::uint32_t>(samples.size() * 2);
    std::vector<std::uint8_t> bytes;
    put(bytes, "RIFF");
    put(bytes, kHeaderSize + size, 4);
    put(bytes, "WAVEfmt ");
    put(bytes, kFormatSize, 4);
    put(bytes, kPcm, 2);
    put(bytes, kChannels, 2);
    put(bytes, synth::kRate_hz, 4);
    put(bytes, synth::kRate_hz * kChannels * kBits / 8, 4);
    put(bytes, kChannels * kBits / 8, 2);
    put(bytes, kBits, 2);
    put(bytes, "data");
    put(bytes, size, 4);
    for (const std::int16_t sample : samples) put(bytes, static_cast<std::uint16_t>(sample), 2);
    return bytes;
}

}  // namespace oblong::sound_source
