#include "engine/platform/dos/sound_blaster.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>

#include "engine/platform/dos/calls.h"
#include "engine/platform/dos/kernel/ports.h"
#include "engine/sound/small_mixer.h"

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

// A Sound Blaster 2.0 or a later one.
class SoundBlaster {
  public:
    // The card at the address in DOS's variable BLASTER ("A220 I5 D1"); null: at the usual address.
    static std::optional<SoundBlaster> find(const char* blaster);

    // Plays these bytes in a loop until stop(): samples around 128, `rate_hz` a second. They are below 1 MB and cross
    // no 64 KB boundary.
    void start(std::span<const std::uint8_t> ring, std::int32_t rate_hz);
    // The index of the byte of the ring that is played.
    std::size_t position() const;
    void stop();

  private:
    SoundBlaster(std::uint16_t base, std::uint8_t channel) : base_(base), channel_(channel) {}
    std::uint16_t port(int offset) const { return static_cast<std::uint16_t>(base_ + offset); }
    bool reset() const;
    void tell(std::uint8_t byte) const;
    std::uint8_t heard() const;

    std::uint16_t base_;
    std::uint8_t channel_;  // of the DMA controller
    std::uint8_t version_ = 0;
    std::size_t ring_size_ = 0;
};

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

constexpr std::size_t kLead = 1024;  // samples that are mixed in advance, 93 ms
constexpr std::uint32_t kEvery = 8;  // interrupts of the timer: 27 ms

/// Fills the card's ring buffer in interrupts, so that slow pictures do not interrupt the sound.
class CardSound final : public SmallMixer {
  public:
    CardSound(SoundBlaster card, std::shared_ptr<Recordings> kept) : card_(card), kept_(std::move(kept)) {
        std::fill(ring_.begin(), ring_.end(), kSilence);
        card_.start(ring_, kRate_hz);
        TimerHook hook{[](void* sound) { static_cast<CardSound*>(sound)->fill_sometimes(); }, this};
        call(Call::Timer, &hook);
    }
    ~CardSound() override {
        TimerHook none;
        call(Call::Timer, &none);
        card_.stop();
        *kept_ = std::move(recordings_);
    }
    /// An emptied file stands for a kept recording.
    SoundNumber add_sound(std::span<const std::int16_t> samples, std::int32_t rate_hz) override {
        const std::size_t number = recordings_.size();
        if (!samples.empty() || number >= kept_->size()) return SmallMixer::add_sound(samples, rate_hz);
        recordings_.push_back(std::move((*kept_)[number]));
        return static_cast<SoundNumber>(number);
    }
    CardSound(const CardSound&) = delete;
    CardSound& operator=(const CardSound&) = delete;

  private:
    void fill_sometimes() {
        if (++interrupts_ % kEvery == 0) fill();
    }

    // Overwrites played samples with silence, so that they are not repeated while DOS is called.
    void fill() {
        const std::size_t playing = card_.position();
        for_each_part(played_, playing, [](std::span<std::uint8_t> part) {
            std::fill(part.begin(), part.end(), kSilence);
            return true;
        });
        const std::size_t ready = distance(played_, end_), passed = distance(played_, playing);
        played_ = playing;
        if (passed > ready) end_ = playing;  // nothing was ready
        const std::size_t end = (playing + kLead) % ring_.size();
        if (distance(playing, end_) < kLead &&
            for_each_part(end_, end, [this](std::span<std::uint8_t> part) { return mix(part); }))
            end_ = end;
    }

    std::size_t distance(std::size_t from, std::size_t to) const { return (to - from) % ring_.size(); }

    // The range may wrap around the ring's end.
    template <class Use>
    bool for_each_part(std::size_t from, std::size_t to, Use use) {
        if (from <= to) return use(ring_.subspan(from, to - from));
        return use(ring_.subspan(from)) && use(ring_.first(to));
    }

    SoundBlaster card_;
    std::shared_ptr<Recordings> kept_;  // while the device is closed
    std::span<std::uint8_t> ring_{reinterpret_cast<std::uint8_t*>(call(Call::LowMemory)), kLowMemory};
    std::uint32_t interrupts_ = 0;
    std::size_t played_ = 0, end_ = 0;  // in the ring: the end of the silence, the end of the samples
};

}  // namespace

OpenSound sound_of_card() {
    const auto card = SoundBlaster::find(std::getenv("BLASTER"));
    if (!card) return nullptr;
    auto kept = std::make_shared<SmallMixer::Recordings>();
    return [card = *card, kept = std::move(kept)] { return std::make_unique<CardSound>(card, kept); };
}

}  // namespace oblong::dos
