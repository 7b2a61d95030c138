#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/sound/sound_file.h"

namespace oblong {
namespace {

/// Reads numbers of any number of bits, the highest bit first.
class BitReader {
  public:
    explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    /// `count` bits, 0 to 32.
    std::uint32_t take(int count) {
        const std::uint64_t bits = window();
        skip(as_size(count));
        return count == 0 ? 0 : static_cast<std::uint32_t>(bits >> (64 - count));
    }
    /// The same in two's complement; 1 to 32.
    std::int32_t take_signed(int count) {
        return static_cast<std::int32_t>(take(count) << (32 - count)) >> (32 - count);
    }
    /// The number of zero bits before the next one bit, which is taken, too.
    std::uint32_t take_zeros() {
        std::uint32_t zeros = 0;
        for (; window() >> 32 == 0; zeros += 32) skip(32);
        const int more = std::countl_zero(window());
        skip(as_size(more) + 1);
        return zeros + static_cast<std::uint32_t>(more);
    }
    void skip(std::size_t bits) {
        position_ += bits;
        expect(position_ <= bytes_.size() * 8, "the file ends within a number");
    }
    void align() { position_ = (position_ + 7) / 8 * 8; }

    std::size_t offset() const { return position_ / 8; }
    bool is_at_end() const { return offset() == bytes_.size(); }
    std::span<const std::uint8_t> since(std::size_t offset) const {
        return bytes_.subspan(offset, this->offset() - offset);
    }
    void expect(bool is_so, const char* what) const {
        if (!is_so)
            throw InputError("offset " + std::to_string(offset()),
                             what + std::string(", expected a whole FLAC file of one channel of 16 bits"));
    }

  private:
    /// The next 57 bits or more, from the top; zeros beyond the file's end.
    std::uint64_t window() const {
        std::uint64_t bits = 0;
        if (offset() + 8 <= bytes_.size()) {
            const std::uint8_t* const next = &bytes_[offset()];
            for (std::size_t i = 0; i < 8; ++i) bits = bits << 8 | next[i];
        } else {
            for (std::size_t i = 0; i < 8; ++i)
                bits = bits << 8 | (offset() + i < bytes_.size() ? bytes_[offset() + i] : 0);
        }
        return bits << position_ % 8;
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t position_ = 0;  // in bits
};

bool is_of_16_bits(std::int64_t sample) {
    return sample == static_cast<std::int16_t>(sample);
}

/// The change of a checksum by each value of its highest byte; polynomial x^16 + x^15 + x^2 + 1.
constexpr std::array<std::uint16_t, 256> kCrcOfByte = [] {
    std::array<std::uint16_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte << 8;
        for (int bit = 0; bit < 8; ++bit) crc = crc << 1 ^ ((crc & 0x8000) != 0 ? 0x8005u : 0);
        table[byte] = static_cast<std::uint16_t>(crc);
    }
    return table;
}();

/// The checksum at the end of a frame.
std::uint16_t crc16(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0;
    for (const std::uint8_t byte : bytes) crc = (crc << 8 & 0xffff) ^ kCrcOfByte[crc >> 8 ^ byte];
    return static_cast<std::uint16_t>(crc);
}

/// Linear prediction of a sample from the samples before it: coefficients from the last sample back, then a shift.
struct Prediction {
    std::array<std::int32_t, 32> coefficients{};
    std::size_t order = 0;
    int shift = 0;

    /// `order` samples precede `next`.
    std::int64_t of(const std::int32_t* next) const {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < order; ++i) sum += std::int64_t{coefficients[i]} * *(next - 1 - i);
        return sum >> shift;
    }
};

/// The format's fixed predictions, by order: of zero, a constant, a line, and so on.
constexpr std::array<Prediction, 5> kFixedPredictions{
    {{{}, 0}, {{1}, 1}, {{2, -1}, 2}, {{3, -3, 1}, 3}, {{4, -6, 4, -1}, 4}}};

/// Adds the differences between prediction and samples: small numbers in parts, Rice-coded with a number of low bits
/// for each part.
void add_residual(BitReader& bits, const Prediction& prediction, std::span<std::int32_t> block) {
    const std::uint32_t method = bits.take(2);
    bits.expect(method < 2, "an unknown way of writing residuals");
    const int low_bits_size = method == 0 ? 4 : 5;
    const std::uint32_t escape = method == 0 ? 15 : 31, part_order = bits.take(4);
    const std::size_t part = block.size() >> part_order;
    bits.expect(part << part_order == block.size() && part >= prediction.order,
                "parts of a residual that do not fill their block");
    std::size_t at = prediction.order;
    for (std::size_t end = part; end <= block.size() && part > 0; end += part) {
        const std::uint32_t low_bits = bits.take(low_bits_size);
        const int plain_bits = low_bits == escape ? static_cast<int>(bits.take(5)) : 0;
        for (; at < end; ++at) {
            std::int64_t difference = plain_bits > 0 ? bits.take_signed(plain_bits) : 0;
            if (low_bits != escape) {
                const std::uint64_t high = bits.take_zeros();
                const std::uint64_t folded = high << low_bits | bits.take(static_cast<int>(low_bits));
                difference = static_cast<std::int64_t>(folded >> 1) ^ -static_cast<std::int64_t>(folded & 1);
            }
            const std::int64_t sample = prediction.of(&block[at]) + difference;
            bits.expect(is_of_16_bits(sample), "a sample of more than 16 bits");
            block[at] = static_cast<std::int32_t>(sample);
        }
    }
}

Prediction read_prediction(BitReader& bits, std::size_t order) {
    Prediction prediction;
    prediction.order = order;
    const int size = static_cast<int>(bits.take(4)) + 1;
    prediction.shift = bits.take_signed(5);
    bits.expect(size < 16 && prediction.shift >= 0, "a prediction out of range");
    for (std::size_t i = 0; i < order; ++i) prediction.coefficients[i] = bits.take_signed(size);
    return prediction;
}

/// Reads the samples of a block. `size_bits`: the size of a written sample.
void read_subframe(BitReader& bits, std::span<std::int32_t> block) {
    bits.expect(bits.take(1) == 0, "no subframe");
    const std::uint32_t type = bits.take(6);
    const int zeros = bits.take(1) != 0 ? static_cast<int>(bits.take_zeros()) + 1 : 0;  // below each sample
    bits.expect(zeros < 16, "samples without a bit");
    const int size_bits = 16 - zeros;
    const bool is_fixed = type >= 8 && type < 13, is_predicted = is_fixed || type >= 32;
    bits.expect(type < 2 || is_predicted, "a subframe of an unknown type");
    if (type == 0) std::fill(block.begin(), block.end(), bits.take_signed(size_bits));
    const std::size_t order = type == 1 ? block.size() : is_fixed ? type - 8 : is_predicted ? type - 31 : 0;
    bits.expect(order <= block.size(), "a block of fewer samples than its prediction needs");
    for (std::size_t i = 0; i < order; ++i) block[i] = bits.take_signed(size_bits);
    if (is_predicted) add_residual(bits, is_fixed ? kFixedPredictions[order] : read_prediction(bits, order), block);
    for (std::int32_t& sample : block) {
        sample *= 1 << zeros;
        bits.expect(is_of_16_bits(sample), "a sample of more than 16 bits");
    }
}

std::size_t block_size(BitReader& bits, std::uint32_t code) {
    bits.expect(code != 0, "a block of no known size");
    if (code == 1) return 192;
    if (code < 6) return std::size_t{576} << (code - 2);
    if (code < 8) return std::size_t{bits.take(code == 6 ? 8 : 16)} + 1;
    return std::size_t{256} << (code - 8);
}

/// Reads a frame: a header, one subframe (for one channel), a checksum.
void read_frame(BitReader& bits, std::vector<std::int16_t>& samples) {
    const std::size_t start = bits.offset();
    bits.expect(bits.take(15) == 0x7ffc, "no frame");
    bits.skip(1);  // the numbering of frames
    const std::uint32_t size_code = bits.take(4), rate_code = bits.take(4), channels = bits.take(4),
                        depth = bits.take(3);
    bits.expect(channels == 0 && (depth == 0 || depth == 4) && bits.take(1) == 0, "a frame of other channels or bits");
    const int more_bytes_of_number = std::countl_one(static_cast<std::uint8_t>(bits.take(8)));
    bits.skip(more_bytes_of_number > 1 ? 8 * as_size(more_bytes_of_number - 1) : 0);
    std::vector<std::int32_t> block(block_size(bits, size_code));
    bits.skip(rate_code == 12 ? 8 : rate_code == 13 || rate_code == 14 ? 16 : 0);
    bits.skip(8);  // the header's checksum: the frame's checksum covers it, too
    read_subframe(bits, block);
    bits.align();
    const std::uint16_t expected = crc16(bits.since(start));
    bits.expect(bits.take(16) == expected, "a frame whose checksum is not that of its bytes");
    samples.insert(samples.end(), block.begin(), block.end());
}

}  // namespace

SoundSamples decode_flac(std::span<const std::uint8_t> file) {
    BitReader bits(file);
    expect_at(0, file.size() >= 4 && bits.take(32) == 0x664c6143, "no \"fLaC\", expected a FLAC or WAV file");
    SoundSamples sound;
    std::uint64_t sample_count = 0;
    bool is_last = false;
    for (bool is_first = true; !is_last; is_first = false) {
        is_last = bits.take(1) != 0;
        const std::uint32_t type = bits.take(7);
        const std::size_t size = bits.take(24), end = bits.offset() + size;
        bits.expect((type == 0) == is_first, "metadata out of order");
        if (is_first) {
            bits.skip(16 + 16 + 24 + 24);  // least and greatest sizes of blocks and frames
            sound.rate_hz = static_cast<std::int32_t>(bits.take(20));
            const std::uint32_t channels = bits.take(3) + 1, depth = bits.take(5) + 1;
            bits.expect(sound.rate_hz > 0, "a rate of no samples a second");
            bits.expect(channels == 1 && depth == 16, "other channels or bits a sample");
            const std::uint64_t upper = bits.take(4);
            sample_count = upper << 32 | bits.take(32);
        }
        bits.expect(bits.offset() <= end, "metadata shorter than its contents");
        bits.skip((end - bits.offset()) * 8);
    }
    // A frame of some bytes may stand for 65,536 samples. The memory is bounded: 32 MB, or 32 bytes of each of the
    // file.
    const std::uint64_t most = std::max<std::uint64_t>(std::uint64_t{1} << 24, 16 * file.size());
    bits.expect(sample_count <= most, "far more samples than so few bytes hold");
    const bool is_known = sample_count > 0;  // not where the encoder wrote into a pipe
    sound.samples.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(sample_count, 1 << 24)));
    while (!bits.is_at_end() && sound.samples.size() <= (is_known ? sample_count : most))
        read_frame(bits, sound.samples);
    bits.expect(!sound.samples.empty() && (is_known ? sound.samples.size() == sample_count : bits.is_at_end()),
                "not as many samples as the file's head says, or far more than so few bytes hold");
    return sound;
}

}  // namespace oblong
