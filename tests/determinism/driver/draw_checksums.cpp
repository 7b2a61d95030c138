// Draws the cameras of a list as oblong-render does, and prints the checksum of each picture, a line each. Without any
// library but the compiler's own, so that it is built for other processors by their compiler alone, and soon.
//   draw_checksums PALETTE LEVEL.bsp CAMERAS.csv [--accuracy PRESET] [--mode WxH] [--display W:H] [--fov DEGREES]
//                  [--time SECONDS] [--mdl FILE]
// With --mdl, three of that model stand before each camera, one in each kind of shading.
#include <cstdio>
#include <map>

#include "engine/frame/frame.h"
#include "engine/frame/frame_counts.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/mesh/mesh.h"
#include "engine/methods/hidden_surfaces.h"
#include "engine/methods/transforms.h"
#include "engine/programs/arguments.h"
#include "engine/scene/placed_models.h"
#include "tools/render/camera_list.h"

namespace {

using namespace oblong;

/// zlib's CRC-32, a bit at a time.
std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
    }
    return ~crc;
}

using Options = std::map<std::string, std::string>;

Options parse_options(std::span<char* const> arguments) {
    Options options{{"--accuracy", "bounded"}, {"--mode", "320x200"}, {"--display", "4:3"}, {"--fov", "90"},
                    {"--time", "0"},           {"--dial", ""},        {"--mdl", ""}};
    if (arguments.size() % 2 != 0) throw UsageError("expected an option and its value");
    for (std::size_t i = 0; i < arguments.size(); i += 2) {
        const auto option = options.find(arguments[i]);
        if (option == options.end()) throw UsageError(std::string("no option ") + arguments[i]);
        option->second = arguments[i + 1];
    }
    return options;
}

/// Three of a mesh, 80 units before a camera.
std::vector<PlacedMesh> meshes_before(const Camera& camera, const Mesh& mesh) {
    const Basis axes = view_basis(camera.yaw, camera.pitch, camera.roll);
    const auto steps = [](Unit component, int units) {
        return convert<WorldWide>(bounded_product(component, WorldWide::from_int(units)));
    };
    std::vector<PlacedMesh> placed;
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        PlacedMesh one;
        one.mesh = &mesh;
        one.shading = shading;
        one.highlight = 120;
        one.yaw = camera.yaw;
        const int right = (static_cast<int>(shading) - 1) * 40;
        const auto moved = [&](World from, Unit ahead, Unit across) {
            return saturating_convert<World>(convert<WorldWide>(from) + steps(ahead, 80) + steps(across, right));
        };
        one.position = {moved(camera.eye.x, axes.forward.x, axes.right.x),
                        moved(camera.eye.y, axes.forward.y, axes.right.y),
                        moved(camera.eye.z, axes.forward.z, axes.right.z)};
        placed.push_back(one);
    }
    return placed;
}

void draw(const std::string& palette_path, const std::string& level_path, const std::string& cameras_path,
          const Options& options) {
    ScreenMode mode;
    parse_mode_size(options.at("--mode"), mode);
    mode.display = parse_display(options.at("--display"));
    Settings settings;
    settings.accuracy = accuracy_of(parse_preset(options.at("--accuracy")));
    if (!options.at("--dial").empty()) parse_dial(options.at("--dial"), settings.accuracy);
    const Degrees field_of_view = parse_field_of_view(options.at("--fov"));
    const std::int64_t time_ms = parse_number("--time", options.at("--time"), 20) * 1000 / (1 << 20);

    const Level level = read_parsed(level_path, read_bsp);
    const Colormap colormap = make_colormap(read_parsed(palette_path, read_palette));
    const std::vector<PlacedModel> models = models_at_rest(level);
    const std::vector<Camera> cameras =
        read_parsed(cameras_path, [&](const auto& bytes) { return parse_cameras(bytes, field_of_view); });

    std::optional<Mesh> mesh;
    if (const std::string& file = options.at("--mdl"); !file.empty())
        mesh = read_parsed(file, [](const auto& bytes) { return read_mdl(bytes); });

    Scene scene{level, colormap, models, time_ms};
    FrameWorkspace work(level, mode);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(mode.width_px) *
                                     static_cast<std::size_t>(mode.height_px));
    const Framebuffer out{pixels.data(), mode.width_px, mode.height_px, mode.width_px};
    for (const Camera& camera : cameras) {
        std::vector<PlacedMesh> meshes;
        if (mesh) meshes = meshes_before(camera, *mesh);
        scene.meshes = meshes;
        FrameCounts counts;
        work.observers.counts = &counts;
        draw_frame(scene, camera, mode, settings, work, out);
        work.observers.counts = nullptr;
        draw_frame(scene, camera, mode, settings, work, out);
        std::printf("%08lx", static_cast<unsigned long>(crc32(pixels)));
        std::vector<NamedCount> all = named_counts(counts);
        // Of methods that no frame runs by itself: those of the span buffer, as oblong-render reports them.
        const std::vector<NamedCount> methods = named_counts(HiddenSurfaceCounts{});
        all.insert(all.end(), methods.begin(), methods.end());
        for (const NamedCount& count : all) std::printf(" %lld", static_cast<long long>(count.count));
        std::printf("\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("draw_checksums", [&] {
        if (argc < 4) throw UsageError("expected PALETTE LEVEL.bsp CAMERAS.csv");
        draw(argv[1], argv[2], argv[3], parse_options(std::span(argv + 4, argv + argc)));
    });
}
