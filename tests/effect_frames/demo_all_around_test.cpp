// The demo level from the places of its cameras, in 72 directions each: what owns no pixel is hardly worked for.

#include "engine/files/level_models.h"
#include "engine/surface/palette.h"
#include "tests/frame/frame_fixture.h"
#include "tools/render/camera_list.h"

namespace oblong::test {
namespace {

constexpr int kDirections = 72;

/// What frames did for effects that own no pixel of them, in all.
struct InVain {
    int frames = 0, with_particles = 0, with_depth = 0;
};

class DemoAllAround : public testing::Test {
  protected:
    void draw(Camera camera, int direction) {
        camera.yaw = Angle::from_bam(direction * 65536 / kDirections);
        Scene scene = stage_.scene();
        scene.meshes = meshes_;
        draw_frame(scene, camera, stage_.mode, stage_.settings, work_, {stage_.pixels.data(), 320, 200, 320});
    }
    void expect_that_passes_have_pixels() const {
        for (std::size_t i = 0; i < kPassCount; ++i)
            EXPECT_EQ(work_.plan.passes[i], work_.counts.pass_pixels[i] > 0) << kPasses[i].name;
    }
    void add_what_was_in_vain(InVain& sum) const {
        const FrameCounts& counts = work_.counts;
        const bool has_particles = counts.of(Effect::Particles) > 0;
        const bool has_depth = has_particles || counts.of(Effect::Sprites) > 0 || counts.of(Effect::Meshes) > 0;
        ++sum.frames;
        sum.with_particles += !has_particles && counts.stages.particles > 0;
        sum.with_depth += !has_depth && work_.view.depth.is_wanted();
    }

    Stage stage_ = demo_stage();
    LevelModels models_ =
        read_level_models(stage_.level, read_palette(read_file_bytes(build_folder() + "/assets/palette.lmp")),
                          {build_folder() + "/assets/demo.bsp", ""});
    std::vector<Camera> cameras_ = parse_cameras(
        read_file_bytes(source_folder() + std::string("/assets/demo_cameras.csv")), Degrees::from_int(90));
    std::vector<PlacedMesh> meshes_;
    ObservedWorkspace work_{stage_.level, stage_.mode};
};

TEST_F(DemoAllAround, NoPassRunsWithoutPixelsAndLittleIsDoneInVain) {
    place_models(models_, 0, {}, meshes_);
    work_.count();
    InVain sum;
    for (std::size_t place = 0; place < cameras_.size(); ++place)
        for (int direction = 0; direction < kDirections; ++direction) {
            SCOPED_TRACE("camera " + std::to_string(place) + ", direction " + std::to_string(direction));
            draw(cameras_[place], direction);
            expect_that_passes_have_pixels();
            add_what_was_in_vain(sum);
        }
    EXPECT_EQ(sum.frames, 39 * kDirections);
    EXPECT_LE(sum.with_particles, 141);
    EXPECT_LE(sum.with_depth, 130);
}

}  // namespace
}  // namespace oblong::test
