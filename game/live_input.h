#pragma once

#include <cstdint>

#include "engine/platform/controls.h"
#include "game/tick_input.h"

namespace oblong {

/// A turn of the view that a picture shows before the world knows of it, 65,536 to the circle.
struct ViewLead {
    std::int32_t yaw = 0, pitch = 0;
};

/// Gathers what the hands do into one TickInput a tick. The mouse is gathered between ticks and its rest shown at once;
/// keys turn by the tick and are shown in between.
class LiveInput {
  public:
    void gather(const Controls& controls);
    TickInput next();

    /// What to add to the angles of the last tick, `fraction_16` into the next.
    ViewLead lead(std::int32_t fraction_16) const;

  private:
    Controls held_;
    bool has_jumped_ = false;
    std::int32_t mouse_yaw_ = 0, mouse_pitch_ = 0;
    ViewLead last_keys_;
};

/// The same for a recorded tick: the whole turn is spread over it.
ViewLead lead_of(const TickInput& last, std::int32_t fraction_16);

}  // namespace oblong
