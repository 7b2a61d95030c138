// Draws each camera by each setting, twice with its surfaces built, then once without; the system call
// getppid() before and after tells the plugin what to count. Prints the events of each drawing: setting, "warm" or
// "cold", then their numbers. A setting is preset[+DIAL=VALUE]...[+none]; none: no effects.
//   draw_frames PALETTE LEVEL.bsp CAMERAS.csv FIRST STRIDE SETTING...
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "engine/costs/costs.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/programs/arguments.h"
#include "engine/scene/placed_models.h"
#include "tools/render/camera_list.h"

namespace {

using namespace oblong;

class Drawing {
  public:
    Drawing(const Scene& scene, const std::string& setting) : scene_(scene), name_(setting), work_(scene.level, {}) {
        for (std::size_t begin = 0, end = 0; end < setting.size(); begin = end + 1) {
            end = std::min(setting.find('+', begin), setting.size());
            const std::string word = setting.substr(begin, end - begin);
            if (begin == 0)
                settings_.accuracy = accuracy_of(parse_preset(word));
            else if (word == "none")
                settings_.allowed_effects = EffectSet{};
            else
                parse_dial(word, settings_.accuracy);
        }
    }

    void draw_both(const Camera& camera) {
        draw(camera);
        draw_counted(camera, "warm", false);
        draw_counted(camera, "cold", true);
    }

  private:
    void draw(const Camera& camera) {
        const ScreenMode mode;
        draw_frame(scene_, camera, mode, settings_, work_, {pixels_.data(), 320, 200, 320});
    }

    void draw_counted(const Camera& camera, const char* name, bool forgets) {
        FrameCounts counts;
        work_.observers.counts = &counts;
        if (forgets) work_.cache.surfaces.clear();
        draw(camera);
        work_.observers.counts = nullptr;
        if (forgets) work_.cache.surfaces.clear();
        getppid();
        draw(camera);
        getppid();
        std::printf("%s %s", name_.c_str(), name);
        for (const std::int64_t events : events_of(counts, settings_.accuracy))
            std::printf(" %lld", static_cast<long long>(events));
        std::printf("\n");
    }

    const Scene& scene_;
    std::string name_;
    FrameWorkspace work_;
    Settings settings_;
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(64000);
};

}  // namespace

int main(int argc, char** argv) {
    return run_program("draw_frames", [&] {
        if (argc < 7) throw UsageError("expected PALETTE LEVEL.bsp CAMERAS.csv FIRST STRIDE SETTING...");
        const Level level = read_parsed(argv[2], read_bsp);
        const Colormap colormap = make_colormap(read_parsed(argv[1], read_palette));
        const std::vector<PlacedModel> models = models_at_rest(level);
        const std::vector<Camera> cameras =
            read_parsed(argv[3], [](const auto& bytes) { return parse_cameras(bytes, Degrees::from_int(90)); });
        const Scene scene{level, colormap, models};
        for (int i = 6; i < argc; ++i) {
            Drawing drawing(scene, argv[i]);
            for (std::size_t k = std::strtoul(argv[4], nullptr, 10); k < cameras.size();
                 k += std::strtoul(argv[5], nullptr, 10))
                drawing.draw_both(cameras[k]);
        }
    });
}
