#include "engine/measure/texel_error.h"

#include <algorithm>
#include <cmath>

#include "engine/frame/frame_record.h"

namespace oblong {

namespace {

/// std::hypot() takes ten times as long; nothing here over- or underflows.
double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

}  // namespace

TexelErrorMeter::TexelErrorMeter(const reference::Level& level, std::span<const PlacedModel> models,
                                 const Camera& camera, const ScreenMode& mode, bool correct_aspect)
    : level_(level),
      models_(models),
      camera_(reference::make_camera(reference_view(camera, mode, correct_aspect))),
      width_px_(mode.width_px),
      height_px_(mode.height_px),
      diagonal_px_(std::hypot(mode.width_px, mode.height_px)) {}

const reference::PlaneView& TexelErrorMeter::plane_of(const PixelRecord& pixel) {
    const std::int64_t key = std::int64_t{pixel.face.number()} << 32 | (pixel.model.number() + 1);
    if (const auto known = planes_.find(key); known != planes_.end()) return known->second;
    const reference::Vec offset =
        pixel.model.is_none() ? reference::Vec{} : vec_of(models_[pixel.model.position()].offset);
    const reference::PlaneView plane(level_, level_.face(pixel.face.number()), offset, camera_);
    return planes_.emplace(key, plane).first->second;
}

TexelError TexelErrorMeter::error_of(const PixelRecord& pixel, const reference::PlaneView& plane,
                                     reference::ScreenPoint centre) const {
    const reference::Texel exact = plane.texel_at(centre);
    if (!(exact.inverse_z > 0)) return {};
    const double u = number_of(pixel.u), v = number_of(pixel.v);
    const auto place = plane.place_of(u, v);
    if (!place && !plane.place_of(exact.u, exact.v))
        return {};  // the texture's axes do not separate the plane's points
    const double distance = place ? length(place->x - centre.x, place->y - centre.y) : diagonal_px_;
    return {static_cast<float>(std::min(distance, diagonal_px_)), static_cast<float>(length(u - exact.u, v - exact.v))};
}

std::vector<TexelError> TexelErrorMeter::measure(const FrameRecord& record) {
    const auto width = as_size(width_px_), height = as_size(height_px_);
    const std::size_t pitch = record.pixels.size() / height;
    std::vector<TexelError> errors(width * height);
    const reference::PlaneView* plane = nullptr;
    const PixelRecord* before = nullptr;
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t column = 0; column < width; ++column) {
            const PixelRecord& pixel = record.pixels[row * pitch + column];
            if (pixel.face.is_none() || pixel.mip < 0) continue;
            if (!before || before->face != pixel.face || before->model != pixel.model) plane = &plane_of(pixel);
            before = &pixel;
            const reference::ScreenPoint centre{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
            errors[row * width + column] = error_of(pixel, *plane, centre);
        }
    return errors;
}

std::vector<std::int32_t> true_faces(const reference::Level& level, std::span<const PlacedModel> models,
                                     const Camera& camera, const ScreenMode& mode, bool correct_aspect) {
    const reference::View view = reference_view(camera, mode, correct_aspect);
    std::vector<std::int32_t> faces;
    for (const reference::Pixel& pixel : reference::draw_with_close_calls(level, reference_models(models), view).pixels)
        faces.push_back(pixel.is_close_call ? -1 : pixel.face);
    return faces;
}

std::int64_t wrong_faces(const FrameRecord& record, std::span<const std::int32_t> faces) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) count += faces[i] >= 0 && faces[i] != record.pixels[i].face.number();
    return count;
}

reference::View reference_view(const Camera& camera, const ScreenMode& mode, bool correct_aspect) {
    reference::View view;
    view.eye = vec_of(camera.eye);
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
    for (const PlacedModel& model : models) placed.push_back({model.model.number(), vec_of(model.offset)});
    return placed;
}

}  // namespace oblong
