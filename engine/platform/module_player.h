#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/platform/module_channel.h"
#include "engine/platform/tracker_module.h"

namespace oblong {

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
