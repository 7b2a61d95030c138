#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/sound/tracker_module.h"

namespace oblong {

/// A vibrato or tremolo: its phase, in 64ths, its speed and its depth.
struct ModuleWave {
    std::int32_t at_64 = 0, speed = 0, depth = 0, form = 0;
    std::int32_t value_255() const;
    /// Sets speed and depth from the two halves of an effect's parameter; 0 keeps a value.
    void set(std::uint8_t parameter);
};

/// One channel of a tracker module. Periods are in clocks of a PAL Amiga; samples are interpolated.
struct ModuleChannel {
    static constexpr std::int32_t kRate_hz = 44'100;
    static constexpr std::int64_t kClock_hz = 3'546'895;

    const ModuleSample *sample = nullptr, *next_sample = nullptr;  // next_sample: from the next note on
    bool is_playing = false;
    std::uint64_t at_32 = 0;  // in the sample, 32 fraction bits
    std::int32_t period = 0, target = 0, slide = 0, volume_64 = 0, finetune_8 = 0;
    std::int32_t heard_period = 0, heard_volume_64 = 0, semitones = 0;
    std::size_t offset = 0;
    std::int32_t right_share_256 = 0;  // the share of the right side; the rest is on the left
    ModuleWave vibrato, tremolo;
    std::size_t loop_row = 0;
    std::int32_t loops_left = 0;
    ModuleNote note;

    /// Starts the next sample from its beginning, at a period.
    void strike(std::int32_t at_period);
    /// Adds the channel's samples to `sums`, left and right alternating, at ModulePlayer::add()'s volume.
    void add(std::span<std::int32_t> sums, std::int32_t volume_256);

  private:
    std::int32_t level_8() const;  // the interpolated sample, 8 fraction bits
    void advance(std::uint64_t step_32);
};

/// Plays a tracker module in a loop, with integers: the same samples on every machine. Effects are ProTracker's (0 to
/// 7, 9 to F, E1, E2, E4 to E7 and E9 to EE; with its three waveforms of vibrato and tremolo), and effect 8 of later
/// trackers, the panning of a channel from left, 00, to right, FF.
class ModulePlayer {
  public:
    static constexpr std::int32_t kRate_hz = ModuleChannel::kRate_hz;

    explicit ModulePlayer(TrackerModule module);
    ModulePlayer(const ModulePlayer&) = delete;
    ModulePlayer& operator=(const ModulePlayer&) = delete;

    /// Adds the next samples to `sums`, left and right alternating. At the full `volume_256`, 256, they stay within 16
    /// bits, unless more than four channels are loud at once.
    void add(std::span<std::int32_t> sums, std::int32_t volume_256);

    struct Place {
        std::size_t order = 0, row = 0;
        bool operator==(const Place&) const = default;
    };
    /// The row that is played.
    Place place() const { return place_; }

  private:
    void begin_tick();
    void begin_row();
    void begin_note(ModuleChannel& channel, const ModuleNote& note);
    void apply_at_row(ModuleChannel& channel);
    void apply_extended_at_row(ModuleChannel& channel);
    void apply_at_tick(ModuleChannel& channel);
    void apply_extended_at_tick(ModuleChannel& channel);
    void go_on();

    TrackerModule module_;
    std::vector<ModuleChannel> channels_;
    Place place_, next_;
    bool is_next_set_ = false;
    std::int32_t speed_ = 6, beats_ = 125, tick_ = 0, rows_held_ = 0;
    std::int32_t samples_left_ = 0, rest_ = 0;  // samples left in the tick; the remainder of its length
};

}  // namespace oblong
