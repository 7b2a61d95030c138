#include "game/view/view_times.h"

namespace oblong {

void ViewTimes::time(const GameView& view, const Settings& settings, GameRenderer& renderer) {
    const ViewSpec spec = spec_of(view, settings);
    if (spec != view_ || settings != settings_) times_.clear();
    view_ = spec;
    settings_ = settings;
    renderer.draw_and_time(view, settings, times_);
}

}  // namespace oblong
