#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
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
    void advance() { at_64 = (at_64 + speed) % 64; }
};

/// Values of a sample that are played one after the other; none, if `begin` is not below `end`.
struct ModuleStretch {
    const ModuleSample* sample = nullptr;
    std::size_t begin = 0, end = 0;
    bool is_empty() const { return begin >= end; }
};

/// One channel of a tracker module. Periods are in 256ths of clocks of a PAL Amiga, and of the pitch that is heard: a
/// sample's finetune is in them. As the Amiga's sound chip, a channel plays a stretch to its end, and then again and
/// again what the loop is by then: of a new sample, if a note named one without a pitch. Samples are interpolated.
struct ModuleChannel {
    static constexpr std::int32_t kRate_hz = 44'100;
    static constexpr std::int64_t kClock_hz = 3'546'895;

    ModuleStretch playing, next, loop;  ///< next: what a note begins with
    std::uint64_t at_32 = 0;            ///< in the sample of `playing`, 32 fraction bits
    std::int32_t period_8 = 0, target_8 = 0, slide_8 = 0, volume_64 = 0, finetune_8 = 0;
    std::int32_t heard_period_8 = 0, heard_volume_64 = 0;
    std::size_t offset = 0;
    std::int32_t right_share_256 = 0;  ///< the share of the right side; the rest is on the left
    bool slides_by_semitones = false;
    ModuleWave vibrato, tremolo;
    std::size_t loop_row = 0;
    std::int32_t loops_left = 0;
    ModuleNote note;

    /// Takes a sample for the next note.
    void take(const ModuleSample& sample);
    /// Takes its loop for the end of what is playing; where nothing is, that begins.
    void swap();
    /// Begins the next note `offset` values later.
    void skip() { next.begin = std::min(next.begin + offset, next.end); }
    /// Starts the next note's sample at the channel's period.
    void strike();
    /// A note's period with the channel's finetune.
    std::int32_t tuned_8(std::int32_t period) const;
    /// The channel's period, some semitones higher: 0 to 15. ProTracker's table ends with B-3: there follow a period of
    /// 0, which counts as 65,536, and the lowest notes of the next finetune.
    std::int32_t raised_8(std::int32_t semitones, bool is_protrackers) const;
    /// The nearest semitone that is not below the channel's period.
    std::int32_t stepped_8() const;
    /// Adds the channel's samples to `sums`, left and right alternating, at ModulePlayer::add()'s volume.
    void add(std::span<std::int32_t> sums, std::int32_t volume_256);

  private:
    bool has_value();              // goes on with the loop at the end of a stretch
    std::int32_t level_8() const;  // the interpolated sample, 8 fraction bits
};

/// Plays a tracker module in a loop, with integers: the same samples on every machine. Effects are ProTracker's, in the
/// order and at the ticks of its own player (0 to 7, 9 to F, E1 to E7 and E9 to EE; with its three waveforms of vibrato
/// and tremolo), and effect 8 of later trackers, the panning of a channel from left, 00, to right, FF.
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
    void apply_at_tick(ModuleChannel& channel);
    void apply_extended(ModuleChannel& channel);
    void bend(ModuleChannel& channel);
    void slide(ModuleChannel& channel, std::int32_t by) const;
    void find_next();
    void go_on();

    TrackerModule module_;
    std::vector<ModuleChannel> channels_;
    Place place_, next_;
    std::optional<std::size_t> order_to_, row_to_, loop_to_;  // asked for by jumps, breaks and loops of the row
    std::int32_t speed_ = 6, beats_ = 125, tick_ = 0;
    std::int32_t rows_asked_ = 0, rows_left_ = 0;  // times that a row is played, all and from the next on
    std::int32_t samples_left_ = 0, rest_ = 0;     // samples left in the tick; the remainder of its length
};

}  // namespace oblong
