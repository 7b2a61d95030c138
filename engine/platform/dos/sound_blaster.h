#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace oblong::dos {

/// A Sound Blaster 2.0 or a later one.
class SoundBlaster {
  public:
    /// The card at the address in DOS's variable BLASTER ("A220 I5 D1"); null: at the usual address.
    static std::optional<SoundBlaster> find(const char* blaster);

    /// Plays these bytes in a loop until stop(): samples around 128, `rate_hz` a second. They are below 1 MB and cross
    /// no 64 KB boundary.
    void start(std::span<const std::uint8_t> ring, std::int32_t rate_hz);
    /// The index of the byte of the ring that is played.
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

}  // namespace oblong::dos
