#include "tools/measure/reference_view.h"

namespace oblong {

reference::Vec reference_vec(const Vec3<World>& world) {
    return {number_of(world.x), number_of(world.y), number_of(world.z)};
}

reference::View reference_view(const Camera& camera, const ScreenMode& mode, bool correct_aspect) {
    reference::View view;
    view.eye = reference_vec(camera.eye);
    view.yaw = camera.yaw.bam;
    view.pitch = camera.pitch.bam;
    view.roll = camera.roll.bam;
    view.field_of_view = number_of(camera.field_of_view);
    view.width_px = mode.width_px;
    view.height_px = mode.height_px;
    view.display = static_cast<double>(mode.display.numerator) / static_cast<double>(mode.display.denominator);
    view.correct_aspect = correct_aspect;
    return view;
}

std::vector<reference::PlacedModel> reference_models(std::span<const PlacedModel> models) {
    std::vector<reference::PlacedModel> placed;
    for (const PlacedModel& model : models) placed.push_back({model.model.number(), reference_vec(model.offset)});
    return placed;
}

}  // namespace oblong
