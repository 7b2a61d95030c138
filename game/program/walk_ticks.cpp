#include "game/program/walk_ticks.h"

#include <utility>

namespace oblong {

WalkTicks::WalkTicks(const GameLevel& level, TickInputSource input)
    : level_(level), input_(std::move(input)), before_(start_of(level)), after_(before_) {}

void WalkTicks::advance(std::uint64_t elapsed_us, std::int32_t speed_100, const AfterTick& after_tick) {
    for (int due = clock_.advance(elapsed_us, speed_100); due > 0; --due) {
        before_ = after_;
        const TickReport report = input_.play_tick(level_, after_);
        after_tick(before_, after_, report);
    }
}

Camera WalkTicks::camera(Degrees field_of_view) const {
    return camera_at(shown(), input_.look_offset(clock_.fraction_16()), field_of_view);
}

}  // namespace oblong
