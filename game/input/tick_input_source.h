#pragma once

#include <optional>

#include "game/input/controls.h"
#include "game/simulation/demo.h"
#include "game/simulation/game_level.h"
#include "game/simulation/tick.h"

namespace oblong {

/// The player's settings of the input devices.
struct Steering {
    std::int32_t mouse_sensitivity_100 = 100;    ///< 10 to 1,000
    std::int32_t gamepad_sensitivity_100 = 100;  ///< of the stick that turns, 10 to 400
    std::int32_t gamepad_dead_zone_100 = 15;     ///< of a stick's range, 0 to 90
    bool inverts_look = false;                   ///< mouse or stick forward looks down
    bool always_runs = true;                     ///< false: walks slowly unless the key for it is held
    bool operator==(const Steering&) const = default;
};

/// Applies a dead zone: a circle around the middle of `dead_zone_100` percent (0 to 90) of the stick's range, in which
/// the result is 0. Outside, the length rises from 0 to full at 97 % of the range, which worn sticks still reach. The
/// direction stays.
Stick without_dead_zone(Stick stick, std::int32_t dead_zone_100);

/// Squares the length, as a fraction of the full length: finer control near the middle.
Stick squared(Stick stick);

/// A turn of the view that is drawn before a tick applies it, 65,536 to the circle.
struct LookOffset {
    std::int32_t yaw = 0, pitch = 0;
};

/// Turns the player's input into one TickInput a tick. Mouse motion is summed between ticks and drawn at once; keys and
/// sticks turn in ticks and are interpolated.
class LiveInput {
  public:
    void use(const Steering& steering) { steering_ = steering; }
    void gather(const Controls& controls);
    /// How the pictures are drawn from now on, and the work of the last one.
    void note_view(const ViewDials& view, std::uint16_t work) {
        view_ = view;
        work_ = work;
    }
    void visit() { wants_visit_ = true; }
    TickInput next();

    /// The turn to add to the angles of the last tick, `fraction_16` (65,536: a whole tick) after it.
    LookOffset look_offset(std::int32_t fraction_16) const;

  private:
    LookOffset turn_by(Moves moves) const;

    Steering steering_;
    Moves held_, held_before_, tapped_;  // now, at the last tick, at any time since that
    Stick walk_stick_, look_stick_;
    ViewDials view_ = kUsualView;
    std::uint16_t work_ = 0;
    bool wants_respawn_ = false, wants_visit_ = false;
    std::int32_t mouse_yaw_ = 0, mouse_pitch_ = 0;
    std::int32_t rest_yaw_100_ = 0, rest_pitch_100_ = 0;  // of the mouse: below one unit of the angles, in hundredths
    LookOffset last_turn_;                                // by keys and sticks
};

/// The source of a tick's input: a demo until it ends, then live input. Records all input on request.
class TickInputSource {
  public:
    /// `rules_hash`: of the level's rules. Throws InputError if the demo was recorded on another level, or by other
    /// rules.
    TickInputSource(const GameState& start, std::optional<Demo> replayed, bool records, std::uint64_t rules_hash = 0);

    void use(const Steering& steering) { live_.use(steering); }
    void gather(const Controls& controls) { live_.gather(controls); }
    /// The next tick activates GameLevel::visit.
    void visit() { live_.visit(); }
    void note_view(const ViewDials& view, std::uint16_t work) { live_.note_view(view, work); }

    /// Moves the state by a tick. Throws InputError if a replayed tick leads to another state than the recorded one.
    TickReport play_tick(const GameLevel& level, GameState& state);

    LookOffset look_offset(std::int32_t fraction_16) const;
    bool is_replaying() const { return replayed_ && next_ < replayed_->ticks.size(); }
    /// How the replayed demo's last tick was drawn; null without one.
    const ViewDials* replayed_view() const { return was_replayed_ ? &last_.view : nullptr; }
    bool records() const { return records_; }
    const Demo& recorded() const { return recorded_; }

  private:
    LiveInput live_;
    std::optional<Demo> replayed_;
    std::size_t next_ = 0;  // tick of the replayed demo
    TickInput last_;
    bool records_, was_replayed_ = false;
    Demo recorded_;
};

}  // namespace oblong
