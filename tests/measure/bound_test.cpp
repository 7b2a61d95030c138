// The promise of `bounded`, held against the reference: no texel of a frame lies farther from its place than the bound.

#include <gtest/gtest.h>

#include <optional>

#include "engine/costs/costs.h"
#include "engine/measure/texel_error.h"
#include "engine/visibility/eye.h"
#include "tests/frame/holes.h"
#include "tests/support/random.h"

namespace oblong::test {
namespace {

struct MeasuredStage {
    Stage stage;
    reference::Level level;
};
MeasuredStage measured_real_stage(const std::string& name) {
    return {real_stage(name), reference::read_level(read_shared_file(name + ".bsp"))};
}

/// The rounding of a texture coordinate alone (engine/fixed/README.md): closer no texel can be to its place. Next to a
/// wall that the eye all but touches, where a texel is hundreds of pixels wide, it is more than the bound.
constexpr float kRounding_texels = 1.0f / 4096;

/// The largest error of a frame that is more than rounding, pixels.
double largest_error(MeasuredStage& measured, Camera camera, std::int32_t bound_256, ObservedWorkspace& work) {
    Stage& stage = measured.stage;
    stage.settings.accuracy.pixel_bound_256 = bound_256;
    work.keep_record();
    stage.draw(camera, work);
    camera.eye = place_eye(stage.level, camera.eye).position;
    TexelErrorMeter meter(measured.level, stage.models, camera, stage.mode);
    float largest = 0;
    for (const TexelError& error : meter.measure(work.record))
        if (error.texels > kRounding_texels) largest = std::max(largest, error.pixels);
    return largest;
}

/// An eye 1 to 16 units before the middle of some face of the world, looking anywhere; none if that is in a wall.
std::optional<Camera> camera_near_a_wall(const Level& level, std::mt19937& random) {
    const IndexRange<Face> faces = level.world().faces;
    const Face& face = level.faces[FaceIndex(faces.first.number() + random_below(random, faces.count))];
    const double distance = random_between(random, 1, 16) * (face.is_back ? -1 : 1);
    Point middle;
    for (const SurfEdge edge : level.edges_of(face))
        middle = middle + to_point(level.vertices[level.start_of(edge)]) * (1.0 / face.edges.count);
    Camera camera;
    camera.eye = to_world(middle + to_point(level.planes[face.plane].normal) * distance);
    camera.yaw = random_angle(random);
    camera.pitch = Angle::from_bam(random_below(random, 24000) - 12000);
    if (!is_open(level, camera.eye)) return std::nullopt;
    return camera;
}

/// Errors of the record itself: texels of 16.16, and of the reference's z.
constexpr double kMeasuring_px = 1e-3;

void expect_within_the_bound(MeasuredStage measured, int frames) {
    ObservedWorkspace work(measured.stage.level, measured.stage.mode);
    std::mt19937 random(7);
    double largest_part = 0;
    while (frames > 0) {
        const std::optional<Camera> camera = camera_near_a_wall(measured.stage.level, random);
        if (!camera) continue;
        --frames;
        const std::int32_t bound_256 = 24 << random() % 5;
        const double error = largest_error(measured, *camera, bound_256, work), bound = bound_256 / 256.0;
        EXPECT_LE(error, bound + kMeasuring_px) << describe(*camera, 0, 0);
        largest_part = std::max(largest_part, error / bound);
    }
    EXPECT_GT(largest_part, 0.9) << "the bound is never nearly reached: blocks are shorter than they need be";
}

TEST(Bound, HoldsNextToWallsOfTheDemoLevel) {
    const std::filesystem::path bsp = std::filesystem::path(test::build_folder()) / "assets" / "demo.bsp";
    expect_within_the_bound({demo_stage(), reference::read_level(read_file_bytes(bsp))}, 100);
}

TEST(Bound, HoldsNextToWallsOfRealLevels) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const std::string name : kRealLevels) {
        SCOPED_TRACE(name);
        expect_within_the_bound(measured_real_stage(name), 60);
    }
}

}  // namespace

/// What frames all around from the level's open places cost in each currency, and their largest error, pixels.
struct Measured {
    std::array<std::int64_t, kCurrencyCount> costs{};
    double largest_px = 0;
};

Measured measure(MeasuredStage& measured, Preset preset, ObservedWorkspace& work) {
    const Accuracy accuracy = measured.stage.settings.accuracy = accuracy_of(preset);
    const std::vector<Vec3<World>> places = open_origins(measured.stage.level);
    Measured sum;
    for (std::size_t i = 0; i < places.size(); i += 4) {
        const Camera camera{places[i], Angle::from_bam(static_cast<std::int32_t>(i * 9001 % 65536)), {}, {}};
        sum.largest_px =
            std::max<double>(sum.largest_px, largest_error(measured, camera, accuracy.pixel_bound_256, work));
        work.count();
        measured.stage.draw(camera, work);
        const Events events = events_of(work.counts, accuracy);
        for (std::size_t k = 0; k < kCurrencyCount; ++k) sum.costs[k] += cost_of(events, Currency(k));
    }
    return sum;
}

TEST(Bound, OfAPixelIsCheaperAndNearerThanDivisionsEvery16Pixels) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const std::string name : kRealLevels) {
        SCOPED_TRACE(name);
        MeasuredStage measured = measured_real_stage(name);
        ObservedWorkspace work(measured.stage.level, measured.stage.mode);
        const Measured pixel = measure(measured, Preset::Pixel, work),
                       of_1996 = measure(measured, Preset::Year1996, work);
        EXPECT_LT(pixel.largest_px, 1 + kMeasuring_px);
        EXPECT_GT(of_1996.largest_px, 1);
        for (std::size_t i = 0; i < kCurrencyCount; ++i) EXPECT_LT(pixel.costs[i], of_1996.costs[i] / 100 * 97) << i;
    }
}

}  // namespace oblong::test
