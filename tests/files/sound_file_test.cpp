#include "engine/sound/sound_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/io/files.h"
#include "tests/support/folders.h"
#include "tests/support/refusal.h"

namespace oblong::test {
namespace {

/// MD5 (RFC 1321): what a FLAC file says of its samples.
std::array<std::uint8_t, 16> md5(std::vector<std::uint8_t> bytes) {
    const std::uint64_t bits = bytes.size() * 8;
    bytes.push_back(0x80);
    while (bytes.size() % 64 != 56) bytes.push_back(0);
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> 8 * i));
    constexpr int kTurns[4][4] = {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}};
    std::array<std::uint32_t, 4> sum{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
    for (std::size_t block = 0; block < bytes.size(); block += 64) {
        auto [a, b, c, d] = sum;
        for (std::uint32_t i = 0; i < 64; ++i) {
            const std::uint32_t mixes[4] = {(b & c) | (~b & d), (d & b) | (~d & c), b ^ c ^ d, c ^ (b | ~d)};
            const std::uint32_t words[4] = {i, 5 * i + 1, 3 * i + 5, 7 * i};
            std::uint32_t word = 0;
            for (std::size_t k = 4; k-- > 0;) word = word << 8 | bytes[block + words[i / 16] % 16 * 4 + k];
            const auto sine = static_cast<std::uint32_t>(std::floor(std::abs(std::sin(i + 1.0)) * 4294967296.0));
            const std::uint32_t turned = std::rotl(a + mixes[i / 16] + sine + word, kTurns[i / 16][i % 4]);
            a = d, d = c, c = b, b += turned;
        }
        sum[0] += a, sum[1] += b, sum[2] += c, sum[3] += d;
    }
    std::array<std::uint8_t, 16> result{};
    for (std::size_t i = 0; i < 16; ++i) result[i] = static_cast<std::uint8_t>(sum[i / 4] >> 8 * (i % 4));
    return result;
}

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

TEST(Wav, TwoChannelsBecomeTheirMean) {
    const std::string loud = little(0x7fff, 2), low = little(0x8000, 2), some = little(100, 2), none = little(0, 2);
    EXPECT_EQ(
        decoded(wav(format(1, 2, 8000, 16) + chunk("data", loud + loud + low + low + some + none + some))).samples,
        (std::vector<std::int16_t>{32'767, -32'768, 50}));
}

TEST(Wav, SamplesOf8BitsAreUnsigned) {
    const SoundSamples sound =
        decoded(wav(format(1, 1, 11'025, 8) + chunk("data", std::string("\x80\xff\x00\x40", 4))));
    EXPECT_EQ(sound.samples, (std::vector<std::int16_t>{0, 127 * 256, -32'768, -64 * 256}));
}

// Microsoft's WAVEFORMATEXTENSIBLE (2001): the format's number begins an identifier of 16 bytes.
std::string extensible(std::uint32_t kind) {
    const std::string plain = format(0xfffe, 1, 8000, 16).substr(8);
    return chunk("fmt ", plain + little(22, 2) + little(16, 2) + little(4, 4) + little(kind, 2) +
                             std::string("\0\0\0\0\x10\0\x80\0\0\xaa\0\x38\x9b\x71", 14));
}

TEST(Wav, HeadsOfPipesAndOfLaterProgramsAreRead) {
    const std::string head = format(1, 1, 8000, 16), samples = little(1, 2) + little(0xfffe, 2);
    const auto piped = [&](std::uint32_t riff, std::uint32_t data) {
        return "RIFF" + little(riff, 4) + "WAVE" + head + "data" + little(data, 4) + samples;
    };
    for (const std::string& file :
         {wav(extensible(1) + chunk("data", samples)),
          wav(extensible(1) + chunk("fact", "abcd") + chunk("data", samples)), piped(0xffff'ffff, 0xffff'ffff),
          piped(0, 0), piped(0x7fff'f024, 0x7fff'f000), piped(0, 4), piped(0, 0) + "a", piped(36, 0),
          piped(0xffff'ffff, 0), wav(head + chunk("odd ", "a") + chunk("data", samples + "a") + chunk("LIST", "abc"))})
        EXPECT_EQ(decoded(file).samples, (std::vector<std::int16_t>{1, -2}));
}

TEST(Wav, FaultsAreNamedWithTheirOffset) {
    const std::string data = chunk("data", "abcd");
    struct Case {
        std::string file, said;
    };
    for (const auto& [file, said] : {
             Case{wav(format(3, 1, 8000, 16) + data), "offset 20: format 3, expected 1: PCM"},
             Case{wav(extensible(3) + data), "offset 20: format 3, expected 1: PCM"},
             Case{wav(format(1, 3, 8000, 16) + data), "offset 22: 3 channels, expected 1 or 2"},
             Case{wav(format(1, 1, 0, 16) + data), "offset 24: 0 Hz, expected 1 to 192000"},
             Case{wav(format(1, 1, 8000, 24) + data), "offset 34: 24 bits a sample, expected 8 or 16"},
             Case{wav(data), "offset 12: samples, expected the chunk \"fmt \" before them"},
             Case{wav(format(1, 1, 8000, 16) + chunk("data", "")), "offset 40: no samples, expected one or more"},
             Case{wav(format(1, 1, 8000, 16) + chunk("data", "") + chunk("LIST", "abc")),
                  "offset 40: no samples, expected one or more"},
             Case{wav(format(1, 1, 8000, 16)), "offset 36: 0 bytes are left, expected 4"},
             Case{wav(format(1, 1, 8000, 16) + data).substr(0, 46), "offset 44: 2 bytes are left, expected 4"},
             Case{wav(chunk("fmt ", "ab")), "offset 22: 0 bytes are left, expected 2"},
             Case{"RIFF1234AVI ", "offset 8: no sound, expected WAVE"},
         })
        EXPECT_EQ(test::refusal([&, &bytes = file] { decoded(bytes); }), said);
}

using Bytes = std::vector<std::uint8_t>;

/// Writes numbers of any count of bits, by RFC 9639 and not by the decoder's code.
class BitWriter {
  public:
    BitWriter& put(std::uint64_t value, int count) {
        for (int bit = count; bit-- > 0; ++size_) {
            if (size_ % 8 == 0) bytes.push_back(0);
            bytes.back() = static_cast<std::uint8_t>(bytes.back() | (value >> bit & 1) << (7 - size_ % 8));
        }
        return *this;
    }
    BitWriter& align() { return put(0, static_cast<int>((8 - size_ % 8) % 8)); }

    Bytes bytes;

  private:
    std::size_t size_ = 0;
};

/// The remainder of the division by x^16 + x^15 + x^2 + 1, bit by bit.
std::uint32_t remainder_of(const Bytes& bytes) {
    std::uint32_t rest = 0;
    for (const std::uint8_t byte : bytes)
        for (int bit = 8; bit-- > 0;) {
            const bool carries = (rest >> 15 & 1) != (byte >> bit & 1u);
            rest = (rest << 1 & 0xffff) ^ (carries ? 0x8005 : 0);
        }
    return rest;
}

/// A file of one frame with 8 samples; `write` adds its subframe.
template <class Write>
Bytes file_of(Write write, std::uint32_t channels = 1, std::uint64_t samples = 8) {
    BitWriter frame;
    frame.put(0x7ffc, 15).put(0, 1).put(6, 4).put(0, 4).put(channels - 1, 4).put(4, 3).put(0, 1);
    frame.put(0, 8).put(7, 8).put(0, 8);  // the first frame, of 7 + 1 samples, and the header's checksum
    write(frame);
    frame.align();
    frame.put(remainder_of(frame.bytes), 16);
    BitWriter file;
    file.put(0x664c6143, 32).put(0, 1).put(0, 7).put(34, 24);
    file.put(8, 16).put(8, 16).put(0, 48).put(22'050, 20).put(channels - 1, 3).put(15, 5).put(samples, 36);
    for (int i = 0; i < 16; ++i) file.put(0, 8);
    file.put(1, 1).put(1, 7).put(2, 24).put(0xffff, 16);  // padding
    file.bytes.insert(file.bytes.end(), frame.bytes.begin(), frame.bytes.end());
    return file.bytes;
}

void write_constant(BitWriter& frame) {
    frame.put(0, 8).put(0x10000 - 300, 16);
}

using Samples = std::vector<std::int16_t>;

std::string fault_in(const Bytes& file) {
    return test::refusal([&] { decode_flac(file); });
}

TEST(Flac, HasSubframesOfOneSampleAndNeedsNoNumberOfSamplesInItsHead) {
    for (const std::uint64_t said : {8, 0}) {
        const SoundSamples sound = decode_flac(file_of(write_constant, 1, said));
        EXPECT_EQ(sound.rate_hz, 22'050);
        EXPECT_EQ(sound.samples, Samples(8, -300)) << said;
    }
}

TEST(Flac, HasSubframesOfSamplesAsTheyAre) {
    const Samples samples{0, 1, -1, 32'767, -32'768, 5, -6, 7};
    const auto write = [&](BitWriter& frame) {
        frame.put(1 << 1, 8);
        for (const std::int16_t sample : samples) frame.put(static_cast<std::uint16_t>(sample), 16);
    };
    EXPECT_EQ(decode_flac(file_of(write)).samples, samples);
}

TEST(Flac, HasLowBitsThatAreZeroInAllSamples) {
    const auto write = [](BitWriter& frame) {
        frame.put(1 << 1 | 1, 8).put(1, 3);  // three of them: a one behind two zeros
        for (int i = 0; i < 8; ++i) frame.put(static_cast<std::uint64_t>(i), 13);
    };
    EXPECT_EQ(decode_flac(file_of(write)).samples, (Samples{0, 8, 16, 24, 32, 40, 48, 56}));
}

TEST(Flac, LeavesEachSampleABit) {
    const auto one_bit_each = [](std::uint64_t zeros) {
        return file_of(
            [=](BitWriter& frame) { frame.put(1 << 1 | 1, 8).put(1, static_cast<int>(zeros)).put(0b01100101, 8); });
    };
    EXPECT_EQ(decode_flac(one_bit_each(15)).samples, (Samples{0, -32'768, -32'768, 0, 0, -32'768, 0, -32'768}));
    EXPECT_EQ(fault_in(one_bit_each(16)),
              "offset 58: samples without a bit, expected a whole FLAC file of one channel of 16 bits");
}

// A residual as Rice's code with two low bits: its sign folded into the lowest.
void put_residual(BitWriter& frame, int value) {
    const auto folded = static_cast<std::uint64_t>(value < 0 ? -2 * value - 1 : 2 * value);
    frame.put(1, static_cast<int>(folded / 4) + 1).put(folded % 4, 2);
}

TEST(Flac, PredictsByALineAndAddsWhatIsLeft) {
    const Samples samples{10, 20, 31, 40, 40, 45, 41, 42};
    const auto write = [&](BitWriter& frame) {
        frame.put((8 + 2) << 1, 8).put(10, 16).put(20, 16).put(0, 2).put(1, 4);  // two parts of four samples
        for (std::size_t i = 2; i < 8; ++i) {
            if (i == 2 || i == 4) frame.put(2, 4);
            put_residual(frame, samples[i] - 2 * samples[i - 1] + samples[i - 2]);
        }
    };
    EXPECT_EQ(decode_flac(file_of(write)).samples, samples);
}

TEST(Flac, PredictsByCoefficientsWithAShift) {
    const Samples samples{100, -60, 33, 0, 5, -9, 12, 3};
    const auto write = [&](BitWriter& frame) {
        frame.put((31 + 1) << 1, 8).put(100, 16);
        frame.put(7, 4).put(2, 5).put(0x100 - 3, 8);     // one coefficient of 8 bits, -3, over 2^2
        frame.put(1, 2).put(0, 4).put(31, 5).put(9, 5);  // the residual as it is, 9 bits each
        for (std::size_t i = 1; i < 8; ++i) {
            const double predicted = std::floor(-3 * samples[i - 1] / 4.0);
            frame.put(static_cast<std::uint64_t>(static_cast<std::int64_t>(samples[i] - predicted)) & 511, 9);
        }
    };
    EXPECT_EQ(decode_flac(file_of(write)).samples, samples);
}

TEST(Flac, NamesWhatItDoesNotTake) {
    EXPECT_NE(fault_in({}).find("fLaC"), std::string::npos);
    EXPECT_EQ(fault_in({'R', 'I', 'F', 'F', 0, 0, 0, 0}), "offset 0: no \"fLaC\", expected a FLAC or WAV file");
    EXPECT_NE(fault_in(file_of(write_constant, 2)).find("other channels"), std::string::npos);
    EXPECT_NE(fault_in(file_of(write_constant, 1, 9)).find("samples"), std::string::npos);
    Bytes short_head = file_of(write_constant);
    short_head[7] = 17;  // of 34, or 18 that are read
    EXPECT_NE(fault_in(short_head).find("metadata shorter than"), std::string::npos);
}

/// Frames of 65,536 samples of silence; `promised`: the number in the head.
Bytes silence(std::size_t frames, std::uint64_t promised) {
    BitWriter frame;
    frame.put(0x7ffc, 15).put(0, 1).put(7, 4).put(0, 4).put(0, 4).put(4, 3).put(0, 1);
    frame.put(0, 8).put(0xffff, 16).put(0, 8).put(0, 8).put(0, 16);
    frame.put(remainder_of(frame.bytes), 16);
    Bytes file = file_of(write_constant, 1, promised);
    file.resize(file.size() - 12);
    for (std::size_t i = 0; i < frames; ++i) file.insert(file.end(), frame.bytes.begin(), frame.bytes.end());
    return file;
}

// Of 8,000 frames, 100 KB: a gigabyte.
TEST(Flac, StandsForNoMoreThanItsHeadSaysAndItsSizeAllows) {
    constexpr std::uint64_t kFrame = 65'536;
    EXPECT_EQ(decode_flac(silence(200, 200 * kFrame)).samples.size(), 200 * kFrame);
    EXPECT_EQ(decode_flac(silence(200, 0)).samples.size(), 200 * kFrame);
    // Where it is given up: behind the frame that is one too many.
    const std::size_t head = silence(0, 0).size(), frame = silence(1, 0).size() - head;
    for (const auto& [promised, read] : {std::pair{std::uint64_t{8'000}, 1},
                                         {3 * kFrame, 4},
                                         {std::uint64_t{0}, 257},
                                         {8'000 * kFrame, 0},
                                         {(std::uint64_t{1} << 36) - 1, 0}})
        EXPECT_TRUE(fault_in(silence(8'000, promised))
                        .starts_with("offset " + std::to_string(head + frame * static_cast<std::size_t>(read)) + ": "))
            << fault_in(silence(8'000, promised));
}

TEST(Flac, NoPartOfAFileIsAFile) {
    expect_no_prefix_is_read(file_of(write_constant), [](const Bytes& part) {
        const std::string fault = fault_in(part);
        EXPECT_TRUE(fault.empty() || fault.find(", expected ") != std::string::npos) << fault;
        return fault;
    });
}

TEST(Flac, NoBitOfAFrameCanBeWrong) {
    const Bytes whole = file_of(write_constant);
    const std::size_t frame = whole.size() - 12;
    ASSERT_EQ(whole[frame], 0xff);
    for (std::size_t bit = frame * 8; bit < whole.size() * 8; ++bit) {
        Bytes damaged = whole;
        damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ 0x80 >> bit % 8);
        EXPECT_NE(fault_in(damaged), "") << bit;
    }
}

TEST(Md5, IsThatOfItsDescription) {
    const std::string text = "message digest";
    const Bytes wanted{0xf9, 0x6b, 0x69, 0x7d, 0x7c, 0xb7, 0x93, 0x8d, 0x52, 0x5a, 0x2f, 0x31, 0xaa, 0xf1, 0x61, 0xd0};
    EXPECT_TRUE(std::ranges::equal(test::md5({text.begin(), text.end()}), wanted));
}

/// What the encoder has noted of the samples it was given.
TEST(Flac, TheGamesSoundsAreThoseThatWereEncoded) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() + "/assets/sounds")) {
        const Bytes file = read_file(entry.path().string());
        Bytes samples;
        for (const std::int16_t sample : decode_flac(file).samples)
            samples.insert(samples.end(), {static_cast<std::uint8_t>(sample), static_cast<std::uint8_t>(sample >> 8)});
        EXPECT_TRUE(std::ranges::equal(test::md5(samples), std::span(file).subspan(26, 16))) << entry.path();
        ++files;
    }
    EXPECT_GT(files, 50);
}

}  // namespace
}  // namespace oblong::test
