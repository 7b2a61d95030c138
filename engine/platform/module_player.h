#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/platform/tracker_module.h"

namespace oblong {

/// Plays a tracker module again and again, with integers: the same samples on every machine. Periods count the clock
/// of a PAL Amiga; what is between two samples is interpolated. Its effects are ProTracker's (0 to 7, 9 to F, E1, E2,
/// E4 to E7 and E9 to EE; waveforms of vibrato and tremolo are its three) and 8 of later trackers, where on the way
/// from left, 00, to right, FF, a channel is.
class ModulePlayer {
  public:
    static constexpr std::int32_t kRate_hz = 44'100;
    static constexpr std::int64_t kClock_hz = 3'546'895;

    explicit ModulePlayer(TrackerModule module);
    ModulePlayer(const ModulePlayer&) = delete;
    ModulePlayer& operator=(const ModulePlayer&) = delete;

    /// Adds the next samples to `sums`, left and right by turns: within 16 bits at the full `volume_256`, 256, but
    /// where more than four channels are loud at once.
    void add(std::span<std::int32_t> sums, std::int32_t volume_256);

    struct Place {
        std::size_t order = 0, row = 0;
        bool operator==(const Place&) const = default;
    };
    /// The row that sounds.
    Place place() const { return place_; }

  private:
    /// A vibrato or tremolo: where in its wave it is, 64ths, how fast it goes and how far.
    struct Wave {
        std::int32_t at_64 = 0, speed = 0, depth = 0, form = 0;
        std::int32_t value_255() const;
        void set(std::uint8_t parameter);
    };
    struct Channel {
        const ModuleSample *sample = nullptr, *next_sample = nullptr;  // the next one from the next note on
        bool is_playing = false;
        std::uint64_t at_32 = 0;  // in the sample, 32 fraction bits
        std::int32_t period = 0, target = 0, slide = 0, volume_64 = 0, finetune_8 = 0;
        std::int32_t heard_period = 0, heard_volume_64 = 0, semitones = 0;
        std::size_t offset = 0;
        std::int32_t right_256 = 0;  // how much of it is heard there; what is left, on the left
        Wave vibrato, tremolo;
        std::size_t loop_row = 0;
        std::int32_t loops_left = 0;
        ModuleNote note;
        std::int32_t level_8() const;  // the sample at its place, interpolated, 8 fraction bits
        void advance(std::uint64_t step_32);
    };

    void begin_tick();
    void begin_row();
    void begin_note(Channel& channel, const ModuleNote& note);
    void strike(Channel& channel, std::int32_t period);
    void apply_at_row(Channel& channel);
    void apply_extended_at_row(Channel& channel);
    void apply_at_tick(Channel& channel);
    void apply_extended_at_tick(Channel& channel);
    void go_on();
    void add_channel(Channel& channel, std::span<std::int32_t> sums, std::int32_t volume_256) const;

    TrackerModule module_;
    std::vector<Channel> channels_;
    Place place_, next_;
    bool is_next_set_ = false;
    std::int32_t speed_ = 6, beats_ = 125, tick_ = 0, rows_held_ = 0;
    std::int32_t samples_left_ = 0, rest_ = 0;  // of the tick; of its length, which is a fraction
};

}  // namespace oblong
