// What frames show against what the probe answers for the same rows, measured apart: by the corners that it was asked
// about, not by the level.

#include "tools/probe/probe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/accuracy/probed_texels.h"
#include "tests/accuracy/scenes_fixture.h"

namespace oblong::test {
namespace {

/// Columns of a row on the plane through three corners in viewspace.
struct QueriedSpan {
    Triangle corners;
    int row = 0, first = 0, end = 0;
};

/// u along a row: u/z and 1/z are linear.
class RowMapping {
  public:
    explicit RowMapping(const QueriedSpan& span) : from_(span.first + 0.5) {
        const double y = span.row + 0.5, length = span.end - span.first;
        const auto at = [&](double x) { return texel_at(span.corners, reference::Projection{}, {x, y}); };
        const reference::Texel first = at(from_), last = at(from_ + length);
        inverse_z_ = first.inverse_z;
        inverse_z_step_ = (last.inverse_z - first.inverse_z) / length;
        u_over_z_ = first.u * first.inverse_z;
        u_over_z_step_ = (last.u * last.inverse_z - u_over_z_) / length;
    }
    /// The column that shows u.
    double place_of(double u) const {
        return from_ + (u * inverse_z_ - u_over_z_) / (u_over_z_step_ - u * inverse_z_step_);
    }

  private:
    double from_, inverse_z_, inverse_z_step_, u_over_z_, u_over_z_step_;
};

/// How far each texel of the probe's answer is from its place along the row, pixels.
std::vector<float> probed_displacements(const std::string& mode, const QueriedSpan& span) {
    const RowMapping row(span);
    std::vector<float> displacements;
    double centre = span.first + 0.5;
    for (const auto& texel : ask_for_texels(mode, {}, span.corners, span.row, span.first, span.end))
        displacements.push_back(static_cast<float>(std::abs(row.place_of(texel.x) - centre++)));
    return displacements;
}

/// A corner near a place on the screen, on whole 1/256 units, with its texel.
reference::TexturedCorner corner_at(const reference::PlaneView& plane, reference::ScreenPoint place) {
    const reference::Projection projection;
    const double z = snapped(1 / plane.inverse_z(place));
    const reference::Vec position{snapped((place.x - 160) / projection.multiplier_x * z),
                                  snapped((100 - place.y) / projection.multiplier_y * z), z};
    const reference::Texel texel = plane.texel_at(project(position, projection), 1 / z);
    return {position, texel.u, texel.v};
}

/// The runs of pixels of one face in a row, longer than a few.
std::vector<QueriedSpan> spans_of(const MeasuredLevel& level, const Camera& camera, const FrameRecord& record,
                                  int row) {
    const reference::Camera exact = reference::make_camera(reference_view(camera, kMeasuredMode));
    std::vector<QueriedSpan> spans;
    for (int first = 0, end = 0; first < 320; first = end) {
        const auto pixel = [&](int column) { return record.pixels[static_cast<std::size_t>(row * 320 + column)]; };
        while (end < 320 && pixel(end).face == pixel(first).face) ++end;
        if (end - first < 8) continue;
        const reference::PlaneView plane(level.exact, level.exact.face(pixel(first).face.number()), {}, exact);
        const double middle = (first + end) / 2.0;
        spans.push_back({{corner_at(plane, {first - 3.0, row - 30.0}), corner_at(plane, {end + 3.0, row - 30.0}),
                          corner_at(plane, {middle, row + 90.0})},
                         row,
                         first,
                         end});
    }
    return spans;
}

/// The stated spread is 0.5 % and a little: the query's corners are rounded to 1/256 unit.
TEST(ReportAgainstProbe, WallsAreAsFarOffInFramesAsTheProbeSays) {
    const Scenes scenes(1);
    const MeasuredLevel& level = scenes.named("wall, z 1:10");
    const Camera& camera = level.cameras[0];
    LevelFrames frames(level, scenes.colormap);
    TexelErrorMeter meter(level.exact, level.models, camera, kMeasuredMode);
    for (const auto& [mode, texturing] :
         {std::pair{"affine", Texturing::Affine}, {"every16", Texturing::Every16}, {"bounded", Texturing::Bounded}}) {
        const FrameRecord& record = frames.record(camera, textured_by(texturing));
        const std::vector<TexelError> errors = meter.measure(record);
        std::vector<float> in_frame, probed;
        for (const int row : {60, 100, 110, 150})
            for (const QueriedSpan& span : spans_of(level, camera, record, row)) {
                const std::vector<float> more = probed_displacements(mode, span);
                probed.insert(probed.end(), more.begin(), more.end());
                for (int column = span.first; column < span.end; ++column)
                    in_frame.push_back(errors[static_cast<std::size_t>(row * 320 + column)].pixels);
            }
        ASSERT_GT(probed.size(), 1000u);
        const ErrorSummary frame = summarize_errors(in_frame), probe = summarize_errors(probed);
        EXPECT_NEAR(frame.rms, probe.rms, 0.002 + 0.005 * probe.rms) << mode;
        EXPECT_NEAR(frame.max, probe.max, 0.005 + 0.005 * probe.max) << mode;
    }
}

}  // namespace
}  // namespace oblong::test
