#include "engine/measure/texel_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/fixed/trig.h"
#include "engine/frame/frame_record.h"
#include "tests/support/bsp_writer.h"

namespace oblong {
namespace {

constexpr ScreenMode kMode;
constexpr std::size_t kPitch = 320;

/// The tiny level's floor, z = 8, where u = x + 4 and v = -y.
reference::Level tiny_level() {
    return reference::read_level(test::join_lumps(29, test::make_tiny_lumps()));
}

Texel texel(double value) {
    return Texel::from_raw(std::llround(value * 65536));
}

Camera camera_at(int x, int y, int z, int pitch_degrees) {
    Camera camera;
    camera.eye = {World::from_int(x), World::from_int(y), World::from_int(z)};
    camera.pitch = degrees_to_angle(Degrees::from_int(pitch_degrees));
    return camera;
}

/// A record whose only pixel with texels is this one.
FrameRecord record_of(std::size_t column, std::size_t row, double u, double v) {
    FrameRecord record;
    record.pixels.resize(kPitch * 200);
    PixelRecord& pixel = record.pixels[row * kPitch + column];
    pixel.face = FaceIndex(0);
    pixel.mip = 0;
    pixel.u = texel(u);
    pixel.v = texel(v);
    return record;
}

TexelError error_at(const Camera& camera, std::size_t column, std::size_t row, double u, double v) {
    const reference::Level level = tiny_level();
    TexelErrorMeter meter(level, {}, camera, kMode);
    const std::vector<TexelError> errors = meter.measure(record_of(column, row, u, v));
    for (std::size_t i = 0; i < errors.size(); ++i) EXPECT_EQ(errors[i].is_measured(), i == row * kPitch + column);
    return errors[row * kPitch + column];
}

/// From 160 units above the floor, looking straight down with x up the screen: a column is a unit of -y, a row 1.2
/// units of -x.
TEST(TexelError, LookingStraightDownItIsTheShiftOverTheUnitsAPixel) {
    const Camera above = camera_at(16, 8, 168, 90);
    const std::size_t column = 165, row = 90;
    const double u = 16 + 4 + 1.2 * 9.5, v = -8 + 5.5;
    EXPECT_NEAR(error_at(above, column, row, u, v).pixels, 0, 1e-4);
    EXPECT_NEAR(error_at(above, column, row, u, v + 3).pixels, 3, 1e-4);
    EXPECT_NEAR(error_at(above, column, row, u - 2.4, v).pixels, 2, 1e-4);
    const TexelError both = error_at(above, column, row, u + 3.6, v - 4);
    EXPECT_NEAR(both.pixels, 5, 1e-4);
    EXPECT_NEAR(both.texels, std::hypot(3.6, 4), 1e-4);
}

/// From 48 units above the floor toward the horizon, a row shows the depth 48 * (400 / 3) / (row + 1/2 - 100), and a
/// column v as far from that of the middle as (column + 1/2 - 160) * depth / 160.
TEST(TexelError, OnAFloorTheTexelOfAnotherPlaceIsAsManyPixelsOff) {
    const Camera level_view = camera_at(-200, 8, 56, 0);
    const auto depth_at = [](double row) { return 6400 / (row + 0.5 - 100); };
    const auto error_for = [&](double columns, double rows) {
        const double depth = depth_at(120 + rows);
        return error_at(level_view, 200, 120, -200 + 4 + depth, -8 + (40.5 + columns) * depth / 160);
    };
    for (const double rows : {-8.0, -0.25, 0.0, 1.0, 30.0}) {
        EXPECT_NEAR(error_for(0, rows).pixels, std::abs(rows), 2e-4) << rows;
        EXPECT_NEAR(error_for(3, rows).pixels, std::hypot(3, rows), 2e-4) << rows;
        const double u_error = depth_at(120 + rows) - depth_at(120);
        EXPECT_NEAR(error_for(0, rows).texels, std::abs(u_error) * std::hypot(1, 40.5 / 160), 1e-4) << rows;
    }
}

TEST(TexelError, AModelsTexelsMoveWithIt) {
    const reference::Level level = tiny_level();
    const std::vector<PlacedModel> models{{kWorldModel, {World::from_int(5), {}, World::from_int(-40)}}};
    TexelErrorMeter meter(level, models, camera_at(16, 8, 128, 90), kMode);
    FrameRecord record = record_of(160, 100, 16 - 5 + 4 - 0.6, -8 + 0.5);
    record.pixels[100 * kPitch + 160].model = PlacedIndex(0);
    EXPECT_NEAR(meter.measure(record)[100 * kPitch + 160].pixels, 0, 1e-4);
}

/// A texel that belongs behind the eye is nowhere on the screen.
TEST(TexelError, IsAtMostThePicturesDiagonal) {
    const Camera level_view = camera_at(-200, 8, 56, 0);
    EXPECT_FLOAT_EQ(error_at(level_view, 160, 120, -300, -8).pixels, static_cast<float>(std::hypot(320, 200)));
    EXPECT_FLOAT_EQ(error_at(level_view, 160, 120, -195.99, -8000).pixels, static_cast<float>(std::hypot(320, 200)));
}

TEST(TexelError, SkipsWhatHasNoTexels) {
    const reference::Level level = tiny_level();
    TexelErrorMeter meter(level, {}, camera_at(16, 8, 168, 90), kMode);
    FrameRecord record = record_of(10, 10, 0, 0);
    record.pixels[10 * kPitch + 10].mip = -1;
    EXPECT_EQ(summarize_pixels(meter.measure(record)).count, 0);
}

/// A pitch wider than the picture: 64 bytes behind each row.
TEST(TexelError, SkipsThePitch) {
    const reference::Level level = tiny_level();
    TexelErrorMeter meter(level, {}, camera_at(16, 8, 168, 90), kMode);
    FrameRecord record;
    record.pixels.assign(std::size_t{384} * 200, {});
    PixelRecord& pixel = record.pixels[90 * 384 + 165];
    pixel = record_of(0, 0, 20 + 1.2 * 9.5, -8 + 5.5).pixels[0];
    EXPECT_NEAR(meter.measure(record)[90 * kPitch + 165].pixels, 0, 1e-4);
}

TEST(ErrorSummary, OfAHundredAndOfNone) {
    std::vector<float> errors;
    for (int i = 100; i > 0; --i) errors.push_back(static_cast<float>(i));
    const ErrorSummary summary = summarize_errors(errors);
    EXPECT_EQ(summary.count, 100);
    EXPECT_DOUBLE_EQ(summary.rms, std::sqrt(338350.0 / 100));
    EXPECT_EQ(summary.p99, 99);
    EXPECT_EQ(summary.max, 100);
    EXPECT_EQ(summarize_errors({}).max, 0);
}

}  // namespace
}  // namespace oblong
