// Prints the operations of a level's cameras as tools/measure works them out: stage, additions, multiplications and
// divisions, a line for each stage of each camera. Then draws the same frames without counting,
// with the profile of the compiler reset before: what each block of the engine's code ran in them is left in the
// profile (../count_operations.py).
//   count_operations PALETTE LEVEL.bsp CAMERAS.csv DIAL=VALUE...
#include <cinttypes>
#include <cstdio>

#include "engine/files/arguments.h"
#include "engine/files/files.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/level/bsp_read.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/scene/placed_models.h"
#include "engine/surface/lit_surface.h"
#include "tools/measure/operations.h"
#include "tools/render/camera_list.h"

extern "C" void __gcov_reset();
extern "C" void __gcov_dump();

namespace {

using namespace oblong;

/// The operations of the frame that was counted last.
void print_stages(const FrameCounts& counts, const Accuracy& accuracy) {
    for (const StageOperations& stage : operations_by_stage(counts, accuracy)) {
        const Operations& operations = stage.operations;
        std::printf("%s,%" PRId64 ",%" PRId64 ",%" PRId64 "\n", std::string(stage.stage).c_str(),
                    operations.adds.total(), operations.multiplications.total(), operations.divisions.total());
    }
}

void draw(const Scene& scene, const std::vector<Camera>& cameras, const Accuracy& accuracy, FrameWorkspace& work) {
    const ScreenMode mode;
    Settings settings;
    settings.accuracy = accuracy;
    settings.kernels = find_kernels("plain");                                            // the code that is worked out
    settings.allowed_effects = EffectSet{}.with(Effect::Sky).with(Effect::BrushModels);  // those that are worked out
    std::vector<std::uint8_t> pixels(pixel_count(mode.width_px, mode.height_px));
    for (const Camera& camera : cameras) {
        draw_frame(scene, camera, mode, settings, work, {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
        if (work.observers.counts) print_stages(*work.observers.counts, accuracy);
    }
}

void count(const std::string& palette_path, const std::string& level_path, const std::string& cameras_path,
           std::span<const std::string> dials) {
    Accuracy accuracy;
    for (const std::string& dial : dials) parse_dial(dial, accuracy);
    const Level level = read_parsed(level_path, read_bsp);
    const Colormap colormap = make_colormap(read_parsed(palette_path, read_palette));
    const std::vector<PlacedModel> models = models_at_rest(level);
    const std::vector<Camera> cameras =
        read_parsed(cameras_path, [](const auto& bytes) { return parse_cameras(bytes, Degrees::from_int(90)); });
    const Scene scene{level, colormap, models};

    FrameWorkspace counting(level, {}), plain(level, {});
    FrameCounts counts;
    counting.observers.counts = &counts;
    draw(scene, cameras, accuracy, counting);
    __gcov_reset();
    draw(scene, cameras, accuracy, plain);
    __gcov_dump();
    __gcov_reset();
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("count_operations", [&] {
        if (argc < 4) throw UsageError("expected PALETTE LEVEL.bsp CAMERAS.csv DIAL=VALUE...");
        const std::vector<std::string> dials(argv + 4, argv + argc);
        count(argv[1], argv[2], argv[3], dials);
    });
}
