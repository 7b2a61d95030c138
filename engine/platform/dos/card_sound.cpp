#include "engine/platform/dos/card_sound.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "engine/platform/dos/calls.h"
#include "engine/platform/dos/sound_blaster.h"
#include "engine/platform/small_mixer.h"

namespace oblong::dos {
namespace {

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
