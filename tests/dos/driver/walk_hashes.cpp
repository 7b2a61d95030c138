// The first ticks of the recorded walk as the game for DOS prints them (game/dos/main.cpp, hashes=N): the hash of the
// state after each, and of its picture.    walk_hashes ASSETS TICKS PICTURE.ppm PICTURE.ppm is the last one, as a VGA
// shows it: 6 bits a colour.
#include <cinttypes>
#include <cstdio>
#include <string>

#include "engine/base/checksum.h"
#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "game/level/load.h"
#include "game/simulation/demo.h"
#include "game/simulation/step.h"
#include "game/view/game_renderer.h"

namespace {

using namespace oblong;

void write_picture(const std::string& path, Framebuffer canvas, const Palette& palette) {
    std::string text = "P6\n" + std::to_string(canvas.width_px) + " " + std::to_string(canvas.height_px) + "\n255\n";
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        for (std::int32_t x = 0; x < canvas.width_px; ++x) {
            const Rgb8 colour = palette.colours[canvas.row(y)[x]];
            for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) text += static_cast<char>(part);
        }
    write_file(path, text);
}

void print_hashes(const std::string& assets, std::size_t ticks, const std::string& picture) {
    LevelFiles files;
    files.level = assets + "/demo.bsp";
    files.assets = assets;
    const LoadedLevel loaded(files);
    const Demo demo = read_parsed(assets + "/walk.demo", decode_demo);
    GameRenderer renderer(loaded.data, loaded.level, ScreenMode{}, nullptr);
    Settings settings;
    settings.accuracy = accuracy_of(Preset::Pixel);
    GameState state = start_of(loaded.level);
    for (std::size_t tick = 0; tick < ticks && tick < demo.ticks.size(); ++tick) {
        step(loaded.level, state, demo.ticks[tick].input);
        const InterpolatedState frame{state, state, 0};
        renderer.draw({frame, camera_at(frame, {}, Degrees::from_int(90))}, settings);
        const Framebuffer canvas = renderer.canvas();
        Fnv1a hash;
        for (std::int32_t y = 0; y < canvas.height_px; ++y)
            hash.add(std::span(canvas.row(y), static_cast<std::size_t>(canvas.width_px)));
        std::printf("tick %u state %016" PRIx64 " picture %016" PRIx64 "\n", static_cast<unsigned>(tick + 1),
                    hash_of(state), hash.value());
    }
    write_picture(picture, renderer.canvas(), loaded.data.palette);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("walk_hashes", [&] {
        if (argc != 4) throw UsageError("expected ASSETS TICKS PICTURE.ppm");
        print_hashes(argv[1], static_cast<std::size_t>(std::stoi(argv[2])), argv[3]);
    });
}
