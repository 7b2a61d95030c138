// Sounds (FLAC): decoded.

#include "engine/sound/sound_file.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {
namespace {

constexpr std::size_t kSignature = 4, kBlockHeader = 4, kChecksum = 2;

// Where the frames begin: behind the blocks that say what the file is.
std::size_t frames_at(const Bytes& file) {
    std::size_t at = kSignature;
    while (at + kBlockHeader <= file.size()) {
        const bool is_last = file[at] >= 0x80;
        at += kBlockHeader + (std::size_t{file[at + 1]} << 16) + (std::size_t{file[at + 2]} << 8) + file[at + 3];
        if (is_last) break;
    }
    return at;
}

// CRC-16 of the polynomial x^16 + x^15 + x^2 + 1 (RFC 9639, 9.3).
std::uint16_t crc16(Input bytes) {
    std::uint32_t crc = 0;
    for (const std::uint8_t byte : bytes)
        for (int bit = 7; bit >= 0; --bit) {
            const bool differs = (crc >> 15 & 1) != (byte >> bit & 1u);
            crc = (crc << 1 & 0xffff) ^ (differs ? 0x8005 : 0);
        }
    return static_cast<std::uint16_t>(crc);
}

}  // namespace

// All that is behind the first blocks is one frame, and has its checksum.
void mutate(Bytes& input, std::minstd_rand& random) {
    mutate_bytes(input);
    const std::size_t first = frames_at(input);
    if (input.size() < first + kChecksum || below(16, random) == 0) return;
    const std::size_t end = input.size() - kChecksum;
    const std::uint16_t crc = crc16(Input(input).subspan(first, end - first));
    input[end] = static_cast<std::uint8_t>(crc >> 8);
    input[end + 1] = static_cast<std::uint8_t>(crc);
}

void read(Input input) {
    decode_flac(input);
}

void run(Input input) {
    const SoundSamples sound = decode_flac(input);
    expect(sound.rate_hz > 0 && !sound.samples.empty(), "samples at some rate");
    expect(decode_flac(input).samples == sound.samples, "the same samples again");
}

}  // namespace oblong::fuzz
