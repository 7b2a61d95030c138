#include "game/painter.h"

namespace oblong {

Painter::Painter(const GameData& data, const Stage& stage, const ScreenMode& mode)
    : data_(data),
      stage_(stage),
      mode_(mode),
      work_(data.level, mode),
      pixels_(static_cast<std::size_t>(mode.width_px) * static_cast<std::size_t>(mode.height_px)) {}

void Painter::draw(const Moment& moment, const Camera& camera, const Settings& settings) {
    const std::vector<PlacedModel> models = models_at(stage_, moment);
    const Scene scene{data_.level, data_.colormap, models, time_ms_at(moment)};
    draw_frame(scene, camera, mode_, settings, work_, canvas());
}

Framebuffer Painter::canvas() {
    return {pixels_.data(), mode_.width_px, mode_.height_px, mode_.width_px};
}

}  // namespace oblong
