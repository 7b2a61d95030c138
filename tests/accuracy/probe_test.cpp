// What frames show against what the probe answers for the same rows, measured apart: by the corners that it was asked
// about, not by the level.

#include "tools/probe/probe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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
    double inverse_z(double x) const { return inverse_z_ + (x - from_) * inverse_z_step_; }
    double u(double x) const { return (u_over_z_ + (x - from_) * u_over_z_step_) / inverse_z(x); }
    double u_slope(double x) const { return (u_over_z_step_ - u(x) * inverse_z_step_) / inverse_z(x); }
    /// The column that shows u.
    double place_of(double u) const {
        return from_ + (u * inverse_z_ - u_over_z_) / (u_over_z_step_ - u * inverse_z_step_);
    }

  private:
    double from_, inverse_z_, inverse_z_step_, u_over_z_, u_over_z_step_;
};

/// The u that the probe samples at each column.
std::vector<double> ask_for_u(const std::string& mode, const QueriedSpan& span, const Accuracy& accuracy = {}) {
    std::vector<double> found;
    for (const auto& texel : ask_for_texels(mode, accuracy, span.corners, span.row, span.first, span.end))
        found.push_back(texel.x);
    return found;
}

/// How far each texel of the probe's answer is from its place along the row, pixels.
std::vector<float> probed_displacements(const std::string& mode, const QueriedSpan& span) {
    const RowMapping row(span);
    std::vector<float> displacements;
    double centre = span.first + 0.5;
    for (const double u : ask_for_u(mode, span))
        displacements.push_back(static_cast<float>(std::abs(row.place_of(u) - centre++)));
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

/// A wall whose depths at two columns are 1:10.
QueriedSpan wall_1_to_10(std::mt19937& random, int columns) {
    const int first = static_cast<int>(random() % static_cast<unsigned>(318 - columns));
    const double near = 4 + static_cast<double>(random() % 6000) / 100;
    const bool is_near_left = random() % 2 != 0;
    const auto corner = [](double column, double slope, double depth, double u) {
        const double z = snapped(depth);
        return reference::TexturedCorner{
            {snapped((column - 160) / 160 * z), snapped(slope * z), z}, u, 32 + 32 * slope};
    };
    const double left = is_near_left ? near : near * 10, right = is_near_left ? near * 10 : near;
    return {{corner(first, -0.75, left, 0), corner(first + columns, 0.75, right, 256),
             corner(first + columns, -0.75, right, 256)},
            110,
            first + 1,
            first + columns - 1};
}

/// The error of a texel over the exact gradient at its pixel is not how far it is from its place: texels do not run
/// evenly. With w = 1/z, u a quotient of two linear functions, u(x') - u(x) over u'(x) is (x' - x) w(x) / w(x'): where
/// the depth changes by a tenth within 3/8 pixel, as it does at the far end of z 1:10 over a dozen columns, a texel 3/8
/// pixel off measures 0.417 so. Blocks of two pixels are cut there only with reciprocals from tables: else a frame, and
/// so the probe, divides at each pixel where blocks would be that short.
TEST(ReportAgainstProbe, TexelErrorOverTheGradientIsMoreThanTheDisplacementWhereDepthChangesFast) {
    std::mt19937 random(7);
    Accuracy by_tables;
    by_tables.reciprocal = ReciprocalMethod::Table256TwoNewton;
    double furthest = 0, most_over = 1;
    for (int i = 0; i < 1500; ++i) {
        const QueriedSpan span = wall_1_to_10(random, 6 + static_cast<int>(random() % 20));
        const RowMapping row(span);
        double centre = span.first + 0.5;
        for (const double u : ask_for_u("bounded", span, by_tables)) {
            const double displacement = row.place_of(u) - centre, quotient = (u - row.u(centre)) / row.u_slope(centre);
            const double ratio = row.inverse_z(centre) / row.inverse_z(centre + displacement);
            ASSERT_NEAR(quotient, displacement * ratio, 1e-6);
            furthest = std::max(furthest, std::abs(displacement));
            if (std::abs(displacement) > 0.25) most_over = std::max(most_over, ratio);
            ++centre;
        }
    }
    EXPECT_LE(furthest, 0.375);
    EXPECT_GT(most_over, 1.08) << "the walls are too tame to tell the two apart";
}

}  // namespace
}  // namespace oblong::test
