#include "engine/files/sound_file.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/refusal.h"

namespace oblong {
namespace {

// RIFF WAVE by the description of Microsoft and IBM (1991), written by hand.
std::string little(std::uint32_t number, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 255);
    return text;
}
std::string chunk(const std::string& name, const std::string& content) {
    return name + little(static_cast<std::uint32_t>(content.size()), 4) + content +
           std::string(content.size() % 2, '\0');
}
std::string format(std::uint32_t kind, std::uint32_t channels, std::uint32_t rate_hz, std::uint32_t bits) {
    const std::uint32_t frame = channels * bits / 8;
    return chunk("fmt ", little(kind, 2) + little(channels, 2) + little(rate_hz, 4) + little(rate_hz * frame, 4) +
                             little(frame, 2) + little(bits, 2));
}
std::string wav(const std::string& chunks) {
    return "RIFF" + little(static_cast<std::uint32_t>(chunks.size()) + 4, 4) + "WAVE" + chunks;
}
SoundSamples decoded(const std::string& file) {
    return decode_sound(std::span(reinterpret_cast<const std::uint8_t*>(file.data()), file.size()));
}

TEST(Wav, SamplesOf16BitsAreThoseOfTheFile) {
    const SoundSamples sound =
        decoded(wav(format(1, 1, 22'050, 16) + chunk("LIST", "odd") +
                    chunk("data", little(0, 2) + little(0x7fff, 2) + little(0x8000, 2) + little(0xffff, 2))));
    EXPECT_EQ(sound.rate_hz, 22'050);
    EXPECT_EQ(sound.samples, (std::vector<std::int16_t>{0, 32'767, -32'768, -1}));
}

TEST(Wav, SamplesOf8BitsAreUnsigned) {
    const SoundSamples sound =
        decoded(wav(format(1, 1, 11'025, 8) + chunk("data", std::string("\x80\xff\x00\x40", 4))));
    EXPECT_EQ(sound.samples, (std::vector<std::int16_t>{0, 127 * 256, -32'768, -64 * 256}));
}

TEST(Wav, FaultsAreNamedWithTheirOffset) {
    const std::string data = chunk("data", "abcd");
    struct Case {
        std::string file, said;
    };
    for (const auto& [file, said] : {
             Case{wav(format(3, 1, 8000, 16) + data), "offset 20: format 3, expected 1: PCM"},
             Case{wav(format(1, 2, 8000, 16) + data), "offset 22: 2 channels, expected one"},
             Case{wav(format(1, 1, 0, 16) + data), "offset 24: 0 Hz, expected 1 to 192000"},
             Case{wav(format(1, 1, 8000, 24) + data), "offset 34: 24 bits a sample, expected 8 or 16"},
             Case{wav(data), "offset 12: samples, expected the chunk \"fmt \" before them"},
             Case{wav(format(1, 1, 8000, 16) + chunk("data", "")), "offset 40: no samples, expected one or more"},
             Case{wav(format(1, 1, 8000, 16)), "offset 36: 0 bytes are left, expected 4"},
             Case{wav(format(1, 1, 8000, 16) + data).substr(0, 46), "offset 44: 2 bytes are left, expected 4"},
             Case{wav(chunk("fmt ", "ab")), "offset 22: 0 bytes are left, expected 2"},
             Case{"RIFF1234AVI ", "offset 8: no sound, expected WAVE"},
         })
        EXPECT_EQ(test::refusal([&, &bytes = file] { decoded(bytes); }), said);
}

}  // namespace
}  // namespace oblong
