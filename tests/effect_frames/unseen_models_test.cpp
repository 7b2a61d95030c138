// A model changes its own pixels only, so that one without any changes no picture: in each preset, from the cameras of
// the demo level and of the real ones.

#include "tests/effect_frames/effect_stage.h"
#include "tests/frame/frame_fixture.h"
#include "tests/mesh/mesh_picture.h"
#include "tools/render/camera_list.h"

namespace oblong::test::unseen_models_test {
namespace {

std::vector<Camera> cameras_of(const std::string& level) {
    const std::filesystem::path file = level == "demo"
                                           ? std::filesystem::path(source_folder()) / "assets/demo_cameras.csv"
                                           : find_shared_folder() / "levels/cameras" / (level + ".csv");
    const std::vector<Camera> all = parse_cameras(read_file_bytes(file), Degrees::from_int(90));
    const int turns = level == "demo" ? 8 : 1;
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 60)
        for (int turn = 0; turn < turns; ++turn) {
            Camera camera = all[i];
            camera.yaw = camera.yaw + Angle::from_bam(turn * 65536 / turns);
            cameras.push_back(camera);
        }
    return cameras;
}

/// Slivers at the top and the bottom of the view, between two rows of pixel centres; relative to the eye.
Mesh slivers_around(const Camera& camera) {
    constexpr double kDistance = 20, kHeight = 0.2;
    const TrueCamera view(camera);
    MeshBuilder builder;
    const auto corner = [&](double x, double y) { return builder.add(to_world(view.through(x, y) * kDistance)); };
    for (const double row : {1, 199}) builder.triangle(corner(1, row), corner(319, row), corner(160, row + kHeight));
    return builder.done();
}

class UnseenModels : public OfLevel {};

TEST_P(UnseenModels, ChangeNoPictureAndSeenOnesOnlyTheirPixels) {
    Stage stage = stage_named(GetParam());
    stage.settings.allowed_effects = EffectSet::all().without(Effect::Underwater);  // its waves show pixels twice
    ObservedWorkspace work(stage.level, stage.mode);
    work.count();
    const Mesh ball = ball_mesh(1, 6, plain_skin(60));
    int compared = 0;
    for (const Camera& camera : cameras_of(GetParam())) {
        const Mesh slivers = slivers_around(camera);
        // Seen, so that what is seen through is compared with models.
        const std::array meshes{placed_at(ball, camera.eye + to_world(TrueCamera(camera).ahead * 12)),
                                placed_at(slivers, camera.eye)};
        const auto draw = [&](std::size_t count) {
            Scene scene = stage.scene();
            scene.meshes = std::span(meshes).first(count);
            draw_frame(scene, camera, stage.mode, stage.settings, work, {stage.pixels.data(), 320, 200, 320});
            return work.counts.of(Effect::Meshes);
        };
        for (const Preset preset : kPresets) {
            stage.settings.accuracy = accuracy_of(preset);
            draw(0);
            const Picture bare = stage.pixels;
            const std::int64_t seen = draw(1);
            // In others, texels depend on where spans end, and a model ends spans of what is seen through.
            if (preset == Preset::Exact) {
                ASSERT_LE(changed_pixels(bare, stage.pixels), seen) << "from " << to_point(camera.eye).x;
            }
            const Picture without = stage.pixels;
            if (seen == 0 || draw(2) != seen) continue;
            ++compared;
            ASSERT_EQ(changed_pixels(without, stage.pixels), 0)
                << name_of(preset) << " from " << to_point(camera.eye).x << ", yaw " << camera.yaw.bam;
        }
    }
    EXPECT_GT(compared, 300);
}

OBLONG_FOR_ALL_LEVELS(UnseenModels);

}  // namespace
}  // namespace oblong::test::unseen_models_test
