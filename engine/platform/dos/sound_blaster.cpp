#include "engine/platform/dos/sound_blaster.h"

#include <array>
#include <cstdlib>

#include "engine/platform/dos/kernel/ports.h"

// The card's processor (DSP) gets its samples through the DMA controller (8237), which reads memory itself. (Creative
// Labs, "Sound Blaster Series Hardware Programming Guide".)

namespace oblong::dos {
namespace {

constexpr int kReset = 0x6, kRead = 0xa, kWrite = 0xc, kHasByte = 0xe;  // ports, relative to the card's base
constexpr int kLongestWait = 2000;                                      // reads of a port, a microsecond each
constexpr std::uint8_t kVersion = 0xe1, kSpeakerOn = 0xd1, kTimeConstant = 0x40, kRate = 0x41;
constexpr std::uint8_t kBlockSize = 0x48, kPlayAgainAndAgain = 0x1c;

// Of the DMA controller.
constexpr std::uint16_t kMask = 0x0a, kMode = 0x0b, kClearFlipFlop = 0x0c;
constexpr std::uint8_t kMasked = 4, kReadsAgainAndAgain = 0x58;
constexpr std::array<std::uint16_t, 4> kPages{0x87, 0x83, 0x81, 0x82};  // ports, by channel

std::uint8_t byte_of(std::uint32_t value, int number) {
    return static_cast<std::uint8_t>(value >> 8 * number);
}

// A setting of BLASTER: the number after a letter.
std::uint32_t setting(const char* blaster, char letter, int base, std::uint32_t usual) {
    for (const char* at = blaster; at != nullptr && *at != 0; ++at)
        if (*at == letter && (at == blaster || at[-1] == ' '))
            return static_cast<std::uint32_t>(std::strtoul(at + 1, nullptr, base));
    return usual;
}

}  // namespace

std::optional<SoundBlaster> SoundBlaster::find(const char* blaster) {
    const std::uint32_t base = setting(blaster, 'A', 16, 0x220), channel = setting(blaster, 'D', 10, 1);
    if (base > 0x280 || base < 0x210 || channel == 2 || channel > 3) return std::nullopt;
    SoundBlaster card(static_cast<std::uint16_t>(base), static_cast<std::uint8_t>(channel));
    if (!card.reset()) return std::nullopt;
    card.tell(kVersion);
    card.version_ = card.heard();
    card.heard();
    if (card.version_ < 2) return std::nullopt;
    return card;
}

bool SoundBlaster::reset() const {
    constexpr std::uint8_t kReady = 0xaa;
    write_port(port(kReset), 1);
    for (int i = 0; i < 10; ++i) read_port(port(kHasByte));
    write_port(port(kReset), 0);
    return heard() == kReady;
}

void SoundBlaster::tell(std::uint8_t byte) const {
    constexpr std::uint8_t kIsBusy = 0x80;
    for (int i = 0; i < kLongestWait && (read_port(port(kWrite)) & kIsBusy) != 0; ++i) {
    }
    write_port(port(kWrite), byte);
}

std::uint8_t SoundBlaster::heard() const {
    constexpr std::uint8_t kIsThere = 0x80;
    for (int i = 0; i < kLongestWait; ++i)
        if ((read_port(port(kHasByte)) & kIsThere) != 0) return read_port(port(kRead));
    return 0;
}

void SoundBlaster::start(std::span<const std::uint8_t> ring, std::int32_t rate_hz) {
    ring_size_ = ring.size();
    const auto address = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(ring.data()));
    const auto last = static_cast<std::uint32_t>(ring.size() - 1);
    const auto rate = static_cast<std::uint32_t>(rate_hz);
    const auto address_port = static_cast<std::uint16_t>(2 * channel_);
    const auto count_port = static_cast<std::uint16_t>(2 * channel_ + 1);
    write_port(kMask, kMasked | channel_);
    write_port(kMode, kReadsAgainAndAgain | channel_);
    write_port(kClearFlipFlop, 0);
    for (int i = 0; i < 2; ++i) write_port(address_port, byte_of(address, i));
    write_port(kPages[channel_], byte_of(address, 2));
    for (int i = 0; i < 2; ++i) write_port(count_port, byte_of(last, i));
    write_port(kMask, channel_);
    tell(kSpeakerOn);
    if (version_ >= 4) {
        for (const std::uint8_t byte : {kRate, byte_of(rate, 1), byte_of(rate, 0)}) tell(byte);
    } else {
        for (const std::uint8_t byte : {kTimeConstant, byte_of(256 - 1'000'000 / rate, 0)}) tell(byte);
    }
    for (const std::uint8_t byte : {kBlockSize, byte_of(last, 0), byte_of(last, 1), kPlayAgainAndAgain}) tell(byte);
}

// The controller's count changes while its two bytes are read, so it is read until two values agree.
std::size_t SoundBlaster::position() const {
    read_port(port(kHasByte));  // acknowledges the card's interrupt
    const auto count_port = static_cast<std::uint16_t>(2 * channel_ + 1);
    const auto left = [count_port] {
        write_port(kClearFlipFlop, 0);
        const std::size_t low = read_port(count_port);
        return low | std::size_t{read_port(count_port)} << 8;
    };
    std::size_t last = left(), now = left();
    for (int i = 0; i < 10 && (last < now || last - now > 4); ++i) last = now, now = left();
    return (ring_size_ - 1 - now) % ring_size_;
}

void SoundBlaster::stop() {
    reset();
    write_port(kMask, kMasked | channel_);
}

}  // namespace oblong::dos
