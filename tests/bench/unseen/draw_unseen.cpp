// Draws a level from places, all around, each picture twice: as usual, and with only the effects that own pixels of it.
// What either takes is counted from outside, by the names of the functions that draw (../unseen_costs.py).
//   draw_unseen LEVEL.bsp CAMERAS.csv PALETTE DIRECTIONS

#include "engine/base/input_error.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/models/level_models.h"
#include "engine/programs/arguments.h"
#include "engine/scene/placed_models.h"
#include "tools/render/camera_list.h"

namespace {

using namespace oblong;

/// The scene's time: lanterns and rain are on their way; and that of the frame before, so that what moves is elsewhere.
constexpr std::int64_t kTime_ms = 2900, kEarlier_ms = 2850;

/// What draws a level in one way. What the frame before left in it never comes from the other way.
class Drawing {
  public:
    Drawing(const Scene& scene, const LevelModels& models) : work_(scene.level, {}), scene_(scene), models_(models) {}

    void draw(const Camera& camera, EffectSet allowed, std::int64_t time_ms = kTime_ms) {
        Settings settings;
        settings.allowed_effects = allowed;
        scene_.time_ms = time_ms;
        place_models(models_, scene_.time_ms, {}, meshes_);
        scene_.meshes = meshes_;
        const ScreenMode mode;
        pixels.resize(pixel_count(mode.width_px, mode.height_px));
        draw_frame(scene_, camera, mode, settings, work_,
                   {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
    }
    /// Of the frame drawn last, what its mirrors show left out.
    EffectSet owning() const { return work_.plan.effects; }

    std::vector<std::uint8_t> pixels;

  private:
    FrameWorkspace work_;
    Scene scene_;
    const LevelModels& models_;
    std::vector<PlacedMesh> meshes_;
};

/// The effects that own pixels of the picture that `usual` drew last: those on its plan and, of others, those in
/// mirrors, without which the picture is another one.
EffectSet find_owning(const Camera& camera, const Drawing& usual, Drawing& other) {
    EffectSet owning = usual.owning();
    other.draw(camera, owning);
    if (other.pixels == usual.pixels) return owning;
    for (std::size_t i = 0; i < kEffectCount; ++i) {
        const auto effect = static_cast<Effect>(i);
        other.draw(camera, EffectSet::all().without(effect));
        if (other.pixels != usual.pixels) owning = owning.with(effect);
    }
    other.draw(camera, owning);
    if (other.pixels != usual.pixels) throw InputError("a picture", "shows effects that own no pixel of it");
    return owning;
}

}  // namespace

// What unseen_costs.py finds by name.
extern "C" {
[[gnu::noinline]] void draw_all_effects(Drawing& drawing, const Camera& camera) {
    drawing.draw(camera, EffectSet::all());
}
[[gnu::noinline]] void draw_owning_effects(Drawing& drawing, const Camera& camera, EffectSet owning) {
    drawing.draw(camera, owning);
}
[[gnu::noinline]] void end_place() {
    asm volatile("");  // or no call of it is left
}
}

namespace {

void draw_all_around(Camera camera, int directions, Drawing& usual, Drawing& owning) {
    for (int direction = 0; direction < directions; ++direction) {
        usual.draw(camera, EffectSet::all());
        const EffectSet effects = find_owning(camera, usual, owning);
        usual.draw(camera, EffectSet::all(), kEarlier_ms);
        draw_all_effects(usual, camera);
        owning.draw(camera, effects, kEarlier_ms);
        draw_owning_effects(owning, camera, effects);
        camera.yaw = camera.yaw + Angle::from_bam(65536 / directions);
    }
    end_place();
}

void draw_level(const std::string& level_path, const std::string& cameras_path, const std::string& palette_path,
                int directions) {
    const Palette palette = read_parsed(palette_path, read_palette);
    const Colormap colormap = make_colormap(palette);
    const Level level = read_parsed(level_path, read_bsp);
    const LevelModels level_models = read_level_models(level, palette, {level_path, ""});
    const std::vector<PlacedModel> models = models_at_rest(level);
    const Scene scene{level, colormap, models, kTime_ms};
    Drawing usual(scene, level_models), owning(scene, level_models);
    for (const Camera& camera :
         read_parsed(cameras_path, [](const auto& bytes) { return parse_cameras(bytes, Degrees::from_int(90)); }))
        draw_all_around(camera, directions, usual, owning);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("draw_unseen", [&] {
        if (argc != 5) throw UsageError("expected LEVEL.bsp CAMERAS.csv PALETTE DIRECTIONS");
        draw_level(argv[1], argv[2], argv[3], std::stoi(argv[4]));
    });
}
